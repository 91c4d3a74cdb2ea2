# Two runs of a case with another load shall be told apart, and two equal ones shall be the same.
#   cmake -DPROGRAM=<frictionbeam> -DCASE=<prm> -DWORK=<folder> -P compare.cmake
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
function(run)
  execute_process(COMMAND ${PROGRAM} ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE text
    ERROR_VARIABLE text)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN}: exit status ${status}\n${text}")
  endif()
  set(text "${text}" PARENT_SCOPE)
endfunction()
# The comparison says each of these.
function(says)
  foreach(part ${ARGN})
    if(NOT text MATCHES "${part}")
      message(SEND_ERROR "'${part}' is not in the comparison:\n${text}")
    endif()
  endforeach()
endfunction()
run(${CASE} --output-directory ${WORK}/a)
run(${CASE} --output-directory ${WORK}/b)
run(${CASE} --output-directory ${WORK}/c --set "Load up/Forces = B 0 0 60")
run(compare ${WORK}/a ${WORK}/b)
if(text MATCHES "->" OR NOT text MATCHES "the same")
  message(SEND_ERROR "equal runs are told apart:\n${text}")
endif()
run(compare ${WORK}/a ${WORK}/c)
says("lifted_uz: 0.0[0-9]+ -> " "open -> stick" "fn: by [0-9.]+ at rest, lifted")
# In other units the quantities are the same; units of a file's own cannot be converted.
foreach(name si mm own)
  set(units "si")
  set(force 10)
  set(stiffness 1000)
  set(unit "")
  if(name STREQUAL mm)
    set(units "mm kN")
    set(force 0.01)
    set(stiffness 1e-3)
  elseif(name STREQUAL own)
    set(unit "; scale 100; unit cm")
  endif()
  file(WRITE ${WORK}/${name}.prm "set Units = ${units}\nset Free motions = uz\n
subsection Point P\n set Position = 0 0 0\nend
subsection Spring k\n set At = P\n set Stiffness = 0 0 ${stiffness}\nend
subsection Load f\n set Kind = force\n set Forces = P 0 0 ${force}\nend
subsection Step s\n set Loads = f\nend
subsection Quantities\n set uz = uz at P${unit}\n set fz = fz at k\nend\n")
  run(${WORK}/${name}.prm --output-directory ${WORK}/${name})
endforeach()
run(compare ${WORK}/si ${WORK}/mm)
if(NOT text MATCHES "2 are the same")
  message(SEND_ERROR "one answer in two units is told apart:\n${text}")
endif()
execute_process(COMMAND ${PROGRAM} compare ${WORK}/si ${WORK}/own RESULT_VARIABLE status
  OUTPUT_VARIABLE text ERROR_VARIABLE text)
if(NOT status EQUAL 1 OR NOT text MATCHES "units that cannot be converted.*read: +m and cm")
  message(SEND_ERROR "units that cannot be converted are compared:\n${text}")
endif()
# So are the tables; runs of other numbers of increments meet at the ends of their steps.
file(WRITE ${WORK}/line.prm "subsection Material steel
 set Young's modulus = 2e11\n set Density = 7850\n set Expansion = 1.2e-5\nend
subsection Section s\n set Outer diameter = 0.2\n set Wall = 0.008\nend
subsection Pipe p\n set Route = A 0 0 0; C 3 0 0; B 3 4 0\nend
subsection Support a\n set Kind = anchor\n set At = A\nend
subsection Support r\n set Kind = rest\n set At = C\n set Friction coefficient = 0.3\nend
subsection Load w\n set Kind = weight\nend
subsection Load h\n set Kind = temperature\n set Temperature = 200\nend
subsection Step w\n set Loads = w\nend
subsection Step h\n set Loads = w, h\n set Increments = 2\nend
subsection Quantities\n set q = fn at r\nend\n")
file(READ ${WORK}/line.prm line)
string(REPLACE "2e11" "2e8" kilo "set Units = m kN\n${line}")
string(REPLACE "7850" "7.85" kilo "${kilo}")
file(WRITE ${WORK}/kilo.prm "${kilo}")
run(${WORK}/line.prm --output-directory ${WORK}/line)
run(${WORK}/kilo.prm --output-directory ${WORK}/kilo)
run(${WORK}/line.prm --output-directory ${WORK}/finer --set "Step h/Increments = 4")
run(compare ${WORK}/line ${WORK}/kilo)
if(text MATCHES "->" OR text MATCHES "only" OR NOT text MATCHES "Line:\n  the same")
  message(SEND_ERROR "one line in two units is told apart:\n${text}")
endif()
run(compare ${WORK}/line ${WORK}/finer)
if(text MATCHES "->" OR text MATCHES "only" OR NOT text MATCHES "Line:\n  the same")
  message(SEND_ERROR "two and four increments do not meet at the end of the step:\n${text}")
endif()
# A run that has failed is no run of the whole case, and says so; so does what is no number.
file(READ ${WORK}/a/summary.json summary)
string(REPLACE "\"converged\"" "\"no_equilibrium\"" summary "${summary}")
file(COPY ${WORK}/a/ DESTINATION ${WORK}/stopped)
file(WRITE ${WORK}/stopped/summary.json "${summary}")
run(compare ${WORK}/a ${WORK}/stopped)
if(NOT text MATCHES "stopped has ended with 'no_equilibrium'")
  message(SEND_ERROR "nothing is said of a run that has failed:\n${text}")
endif()
file(READ ${WORK}/a/reactions.csv table)
string(REGEX REPLACE "\n([^,\n]*,[^,\n]*,[^,\n]*,[^,\n]*),[^,\n]*," "\n\\1,12x," table "${table}")
file(WRITE ${WORK}/stopped/reactions.csv "${table}")
execute_process(COMMAND ${PROGRAM} compare ${WORK}/a ${WORK}/stopped RESULT_VARIABLE status
  OUTPUT_VARIABLE text ERROR_VARIABLE text)
if(NOT status EQUAL 1 OR NOT text MATCHES "no number in column fx.*read: +'12x'")
  message(SEND_ERROR "a text is compared as a number (${status}):\n${text}")
endif()
# A check that fails, modes that are others, and tables whose numbers are not compared, are told.
file(WRITE ${WORK}/modes.prm "${line}
subsection Modes\n set Number = 2\nend
subsection Nozzle n\n set Support = a\n set Allowed = 1e9 1e9 1e9 1e9 1e9 1e9\nend\n")
run(${WORK}/modes.prm --output-directory ${WORK}/modes)
run(${WORK}/modes.prm --output-directory ${WORK}/loaded --set "Material steel/Density = 2000"
  --set "Nozzle n/Allowed = 1 1 1 1 1 1")
run(compare ${WORK}/modes ${WORK}/loaded)
says("allowable loads of n[^\n]* fails in the second run only" "Modes:\n  frequency: by " "nozzles.csv[^\n]* differ")
