# Examples, which are a user's to read, have no lines of tests: their accounts of energy count springs with preload
# from where they begin (it was 3 % to 49 % off), and what cancels in them is summed in extended precision (it left
# 3e-10 to 2e-9 of a plant's, by the last bits of its sections).
foreach(case plant pump_line)
  case_test("repro/energy ${case}" "" prm/example/${case}.prm --check energy 1e-10)
endforeach()
