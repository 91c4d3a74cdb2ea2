# Statics: what a support stands on, stiffness of rigid contacts, no load and no scale, accounts.

# A support on a point obeys its Normal and its Length, wherever that point is.
repro("ground_normal" ground_normal --errors 1e-9 --expect "beside its Ground G")
repro("force_at_point" force_at_point --errors 1e-6)
repro("force_of_pair" force_of_pair --errors 1e-9)
repro("ground_length" ground_length --errors 1e-9)
repro("ground_arm" ground_arm --errors 1e-9 --expect "by a rigid arm")
repro("ground_of_springs" ground_of_springs --errors 1e-9 --expect "That point has no rotations")
foreach(entry "Torsion = true" "Rotations = pipe" "Rotations = averaged")
  repro("ground_of_springs ${entry}" ground_of_springs --set "Support shoe/${entry}" --expect "fn = 900 N"
    --expect "uz = -0.009 m" --expect "That point has no rotations")
endforeach()

# Methods that need a stiffness take one that is rigid beside the line.
repro("newton_rigid" newton_rigid --set "Solver/Method = newton" --errors 1e-6)
repro("newton_rigid elastic" newton_rigid --set "Solver/Method = elastic"
  --expect "Rigid supports are not rigid here")
repro("newton_rigid exact" newton_rigid --errors 1e-8)

# One increment is 9.5 % off the tractrix, and the run says so; so it does of 16, which are 0.9 % off.
repro("tractrix in one increment" tractrix_one_increment --error ux 0.11 --error uy 0.07
  --expect "load increments 15 %" --expect "Displacements are known to about 15 %")
repro("tractrix in 16 increments" tractrix_one_increment --set "Step a/Increments = 16"
  --set "Step b/Increments = 16" --error ux 0.012 --error uy 0.012 --expect "load increments 1.1 %")

# Friction 2 at a limit of 1, where a guide holds a third direction.
repro("unique_guide" unique_guide --expect "Several equilibria are possible at the end of s0, s1"
  --expect "c (f = 2, limit 1)")

# Two rigid supports that stick hold one motion of one point: the share of each is one of many.
repro("rest_and_guide" rest_and_guide --value ux 1e-12
  --expect "Statics does not determine how these rigid supports share their forces"
  --expect "at the end of press, pull, for they hold the same motion: rest, guide.minus")
repro("rest_and_guide elastic" rest_and_guide --set "Support rest/Axial rigidity = 1e9"
  --set "Support guide/Axial rigidity = 1e9" --set "Support rest/Shear rigidity = 1e8"
  --set "Support guide/Shear rigidity = 1e8" --expect "ux = 8.33333e-07 m" --expect "f1 = -83.3333 N"
  --expect "f2 = -83.3333 N")

# Back at zero load, by symmetry of the load's course and without friction forces, nothing is left.
foreach(friction 0.3 0)
  repro("heat_without_weight f=${friction}" heat_without_weight
    --set "Support r/Friction coefficient = ${friction}" --set "Quantities/ux = ux at B"
    --set "Quantities/uy = uy at B" --value ux 1e-12 --value uy 1e-12)
endforeach()
repro("no load at all" heat_without_weight --set "Load hot/Temperature = 20"
  --set "Quantities/ux = ux at B" --value ux 0)

# A real section on soft springs: the line's forces have larger rounding than their cap. What has no
# more digits ends within 1000 iterations and says so.
repro("ssnl130_real_section" ssnl130_real_section --errors 1e-6)
repro("ssnl130 without digits" ssnl130_real_section --set "Section s/Inertia = 2.25e2" --exit 2
  --status failed --expect "rounding of the line's forces")
repro("ssnl130 newton" ssnl130_real_section --set "Solver/Method = newton" --exit 2 --status failed
  --expect "rounding of the line's forces")
repro("stiff_support" stiff_support --error R 1e-9 --error e 1e-6 --error uz 1e-5 --value u0 1e-15)

# The moment of friction against twist is among a support's results.
repro("moment_of_friction" moment_of_friction --errors 1e-9)

# A hinged bar of 16 cells swings through: EA/l makes more of rounding than 1e-8 of the weight.
repro("swinging_bar" swinging_bar --errors 5e-3 --energy left_over 0 1e-5)

# The account of energy counts springs with preload from where they begin: it was 3 % to 49 % off.
foreach(case tests/cases/piping/hanger prm/example/plant prm/example/pump_line)
  case_test("repro/energy ${case}" "" ${case}.prm --check energy 1e-9)
endforeach()

repro("torn_off" torn_off --errors 1e-9 --expect "pad went from sticking to open")
repro("length of a file in mm" stiff_support --set "Units = mm N"
  --expect "Support middle: its Length is not given and is 1 m, 1000 mm")
# A hanger that travels less than a spring can be sized for says what it was sized for.
case_test("repro/hanger of a small travel" "" tests/cases/piping/hanger_sized.prm
  --set "Load lift/Displacements = A uz 0.001" --expect "travel 0.001 m. For so little it was sized as for 0.005 m")

# A scene without an entry for its increments has none that Accuracy could refine.
repro("rack, Accuracy" rack_accuracy --set "Accuracy = 1e-2" --errors 1e-9)
# What large displacements leave to the length of cells is said, and of compressed cells that it is not known.
repro("cells of an elastica" cells_of_an_elastica --error uy 1e-3 --error ux 0.05
  --expect "cells 0.88 %")
repro("cells of an elastica, compressed" cells_of_an_elastica
  --set "Load P/Forces = end -2000 100 0" --expect "cells not estimated")

# What is asked of all supports may be asked of one part.
repro("sum_of_one" sum_of_one --errors 1e-12)
