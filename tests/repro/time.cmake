# Histories, steps of time and what Accuracy makes of them. Files of ../cases/time beside those of this
# folder.
function(time_case name file)
  case_test("repro/${name}" "" tests/cases/time/${file}.prm ${ARGN})
endfunction()

set(integrators newmark generalized_alpha moreau_jean nonsmooth_alpha)

# The record counts from the step's beginning; the same with the run's time and a record shifted by the
# static step's second.
repro("quake from zero" quake_from_zero --error uy 2e-3 --same-as
  ${CMAKE_CURRENT_SOURCE_DIR}/quake_shifted.prm 1e-9)

# Steps end at the corners of tables: pulses shorter than the step, jumps within it.
foreach(integrator ${integrators})
  set(by --set "Time/Integrator = ${integrator}")
  repro("pulse in table, ${integrator}" pulse_in_table ${by} --error u 1e-4)
  repro("pulse in table, ${integrator}, Accuracy" pulse_in_table ${by} --set "Accuracy = 1e-2"
    --error u 1e-2)
  repro("table jump, ${integrator}" table_jump ${by} --errors 3e-3)
  time_case("history of two steps, ${integrator}" history_of_two_steps ${by} --errors 5e-5)
endforeach()
foreach(integrator moreau_jean nonsmooth_alpha)
  time_case("still after statics, ${integrator}" still_after_statics --set
    "Time/Integrator = ${integrator}" --errors 1e-9)
endforeach()
foreach(integrator newmark generalized_alpha) # elements of 1e9 N swing by some of 1e-7 m
  time_case("still after statics, ${integrator}" still_after_statics --set
    "Time/Integrator = ${integrator}" --error friction_S_end 2e-2 --error friction_L_end 2e-2
    --error normal_end 2e-2 --error least_normal 3e-2 --error at_S 1e-7 --error at_L 1e-5
    --error least_at_L 1e-5 --error speed 1e-4 --error sinks 1e-4)
endforeach()
repro("table jump, event" table_jump --errors 5e-5)
time_case("history of two steps, event" history_of_two_steps --set "Time/Integrator = event"
  --errors 1e-10)
time_case("still after statics, event" still_after_statics --set "Time/Integrator = event"
  --errors 1e-9)
foreach(integrator moreau_jean generalized_alpha)
  time_case("snubber lets go, ${integrator}" snubber_lets_go --set
    "Time/Integrator = ${integrator}" --errors 1e-6)
endforeach()

# What an integrator cannot do is said with the support's name.
foreach(integrator newmark generalized_alpha)
  repro("belt, ${integrator}" belt_static_dynamic --set "Time/Integrator = ${integrator}" --expect
    "${integrator} may not let stick where static friction holds: at c,")
endforeach()
repro("belt, moreau_jean" belt_static_dynamic --set "Time/Integrator = moreau_jean" --set
  "Time/Step = 2e-4" --errors 2e-3)
repro("whip peak" whip_peak --expect
  "Quantity fmax is the largest force of a rigid support that was struck" --expect
  "Rigid supports were struck: stop")

# Accuracy sees the events that the loads promise.
repro("wear near stick, Accuracy" wear_near_stick --set "Time/Integrator = moreau_jean" --set
  "Accuracy = 1e-3" --error P 1e-3)
repro("slip along a curve, Accuracy" slip_along_curve --set "Accuracy = 1e-3" --errors 1e-3)
repro("max of event zero, Accuracy" max_of_event_zero --set "Accuracy = 1e-3" --errors 1e-3)
