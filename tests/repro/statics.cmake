# Examples, which are a user's to read, have no lines of tests: their accounts of energy count springs with preload
# from where they begin (it was 3 % to 49 % off).
foreach(case plant pump_line)
  case_test("repro/energy ${case}" "" prm/example/${case}.prm --check energy 1e-9)
endforeach()
