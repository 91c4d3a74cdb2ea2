# Event-driven integration, with settings that have a semicolon, which a test line cannot have. References are closed
# forms or high-precision integrations, said in the files.

# repro_with NAME FILE SETTING QUANTITY TOLERANCE: a quantity, with its reference, in a changed scene.
function(repro_with name file setting quantity tolerance)
  add_test(NAME "repro/${name}" COMMAND check_case $<TARGET_FILE:frictionbeam>
    ${PROJECT_SOURCE_DIR}/${file}.prm --set "${setting}" --set "${quantity}" --errors ${tolerance})
  set_tests_properties("repro/${name}" PROPERTIES TIMEOUT ${FRICTIONBEAM_TEST_SECONDS})
endfunction()

repro_with("impact into a corner, nearly at once" tests/repro/event_corner
  "Support wall/Gap = 0.30000000001" "Quantities/vx = vx at P; reference -0.5" 1e-9)
repro_with("fastest before an impact" prm/verification/bouncing_ball "Time/Step = 0.07"
  "Quantities/falls = min vz at ball; reference -4" 1e-12)
repro_with("fastest after an impact" prm/verification/bouncing_ball "Time/Step = 0.07"
  "Quantities/rises = max vz at ball; reference 2" 1e-12)
repro_with("largest force of static friction" prm/verification/belt "Time/Step = 0.7"
  "Quantities/ft = max |ft1| at belt; reference 1" 1e-12)

# A history with jumps and corners, also on instants of output, ends, and is right: u'' + u = F(t), so that
# u(1) = int_0^1 sin(1 - s) F(s) ds.
function(history name formula value)
  repro_with("history ${name}" tests/repro/event_hang "Load f/History = ${formula}"
    "Quantities/u = ux at P; reference ${value}" 1e-10)
endfunction()
history("if, other side" "if(t<=0.5,1,0)" 0.337280256022233)
history("if at the end" "if(t<1,1,0)" 0.459697694131860)
history("if between instants" "if(t<0.73,1,0)" 0.423468590497751)
history("floor" "floor(t/0.3)" 0.319092653434602)
history("rounded" "rint(3*t)" 0.463861962463645)
history("abs" "abs(sin(2*pi*3*t))" 0.292798966943345)
history("min" "min(t,0.5)" 0.137954553796307)
history("pulse" "if(t>0.5 && t<0.50001,1e5,0)" 0.479421150681222)
