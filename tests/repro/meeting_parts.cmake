# The scene shall be the same whether the support's element has three unknowns or six: averaged
# rotations with an arm of a micrometre put no moment on the pipe.
repro("rest_at_bend_end" rest_at_bend_end --same-as
  ${CMAKE_CURRENT_SOURCE_DIR}/rest_at_bend_end_six.prm 1e-5)
# 2134.3 N and 856.6 N: with bends of 40 pieces, and with the rest 1 mm away.
repro("rest_at_bend_end, its numbers" rest_at_bend_end --error fzB 2e-4 --error fzC 2e-4)

# A skirt (L = 3 m, EI, GA) clamped at its foot, with a nozzle (l = 2 m, ei, ga) that hangs in it
# from its top: under F at the nozzle's end
#   u_T = F L^3/3EI + F L/GA - F l L^2/2EI, theta_T = F L^2/2EI - F l L/EI,
#   u_M = u_T - theta_T l + F l^3/3ei + F l/ga.
repro("pipes_cross" pipes_cross --errors 1e-10
  --expect "Overlap: pipes 'skirt' and 'nozzle' overlap on one axis and are two pipes there, joined only at 'T' (0, 0, 3)")

repro("back_to_back_elbows" back_to_back_elbows
  --expect "0.6 mm more than there is"
  --expect "point 2 304.5 mm instead of 304.8 mm, point 3 304.5 mm instead of 304.8 mm")

# The stop's frequency is that of the pipe on a Spring beside it.
repro("stop_stiffness_modes" stop_stiffness_modes --error f3 1e-5 --error f4 1e-5)
