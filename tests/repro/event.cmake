# Event-driven integration: extremes between events, impacts at one instant, slip along a curve, histories with
# jumps. References are closed forms or high-precision integrations, said in the files.

# repro_with NAME FILE SETTING QUANTITY TOLERANCE: a quantity, with its reference, in a changed scene.
function(repro_with name file setting quantity tolerance)
  add_test(NAME "repro/${name}" COMMAND check_case $<TARGET_FILE:frictionbeam>
    ${PROJECT_SOURCE_DIR}/${file}.prm --set "${setting}" --set "${quantity}" --errors ${tolerance})
  set_tests_properties("repro/${name}" PROPERTIES TIMEOUT 300)
endfunction()

# Extremes are those of the motion, not of the instants of output (they were 0, and 16 % low).
repro("max of event" max_of_event --errors 1e-10)
repro("max of event, one bounce" max_of_event_zero --errors 1e-10)
repro("max of event, Accuracy" max_of_event --set "Accuracy = 1e-4" --errors 1e-10)
repro("max of event, one bounce, Accuracy" max_of_event_zero --set "Accuracy = 1e-3" --errors 1e-10)
repro("extremes of event" event_extremes --errors 1e-10)
repro("extremes of event, long steps" event_extremes --set "Time/Step = 3" --errors 1e-10)

# Contacts that close at one instant strike as one problem: what is symmetric stays so (39.2 and 46.9 N s), and
# restitution 1 loses nothing.
foreach(e 0 0.5 1)
  repro("simultaneous impacts e=${e}" event_simultaneous_e${e}
    --same-as ${PROJECT_SOURCE_DIR}/tests/repro/event_simultaneous_e${e}_mirrored.prm 1e-9)
endforeach()
repro("simultaneous impacts keep energy" event_simultaneous_e1 --energy impact 0 1e-10
  --energy left_over 0 1e-9)
repro("impact into a corner" event_corner --errors 1e-11)
repro_with("impact into a corner, nearly at once" tests/repro/event_corner
  "Support wall/Gap = 0.30000000001" "Quantities/vx = vx at P; reference -0.5" 1e-9)
# Friction turns the disc (vx was 0.7366).
repro("disc with spin" disc_with_spin --error vx 1e-9 --error wy 1e-9)

# Slip along a curve is integrated to rounding (40 steps of moreau_jean: 2e-3).
repro("slip along a curve" slip_along_curve --errors 1e-11)
repro("slip along a curve, long steps" slip_along_curve --set "Time/Step = 3" --errors 1e-11)
# On a rigid rest too (it was left to 40 steps of moreau_jean, first order).
repro("slip along a curve on a rest" slip_on_rest --errors 1e-10 --check energy 1e-9)
repro("slip along a curve on a rest, long steps" slip_on_rest --set "Time/Step = 1" --errors 1e-10)

# Slip that begins and ends 100 times a second is no accumulation of events (wear was 34 % low).
repro("stick and slip do not accumulate" event_accumulate --errors 1e-10)
repro("stick and slip do not accumulate, Accuracy" event_accumulate --set "Accuracy = 1e-3" --errors 1e-10)
repro("stick and slip do not accumulate, default step" event_accumulate_nostep --errors 1e-10)
repro("wear near stick" wear_near_stick --errors 1e-9)
repro("start of slip together" start_of_slip_together --errors 1e-8 --check energy 1e-9)
repro("belt with static friction" belt_static_dynamic --errors 1e-9)

# Bounces end where their intervals' geometric sum does: the impulse until t is m g t.
repro("bounces accumulate" event_bounces --errors 1e-12 --energy impact 8 1e-9)
repro_with("fastest before an impact" prm/verification/bouncing_ball "Time/Step = 0.07"
  "Quantities/falls = min vz at ball; reference -4" 1e-12)
repro_with("fastest after an impact" prm/verification/bouncing_ball "Time/Step = 0.07"
  "Quantities/rises = max vz at ball; reference 2" 1e-12)
repro_with("largest force of static friction" prm/verification/belt "Time/Step = 0.7"
  "Quantities/ft = max |ft1| at belt; reference 1" 1e-12)

# A history with jumps and corners, also on instants of output, ends, and is right: u'' + u = F(t), so that
# u(1) = int_0^1 sin(1 - s) F(s) ds.
repro("history if" event_hang --errors 1e-12)
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

# The jump of an imposed velocity acts on the free nodes, and the account of energy has it.
repro("imposed velocity jumps" event_imposed_jump --errors 1e-9 --check energy 1e-10)

# Against an independent time-stepping code (random scenes; it has seen 140 of them).
foreach(seed 35 38 135 500)
  repro("event on random scene ${seed}" event_random_${seed} --errors 2e-5 --check energy 1e-10)
endforeach()

repro("least_of_sum" least_of_sum --errors 1e-12)
