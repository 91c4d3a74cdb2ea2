# cmake -P: install the plugin into an empty folder, build the laws in this folder against it, check them
# with the installed tool. Wants BUILD (FrictionBeam's build folder), ROOT (its sources), WORK (a scratch
# folder), FORTRAN (ON or OFF).
cmake_minimum_required(VERSION 3.18)
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK}/build)
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result WORKING_DIRECTORY ${WORK}/build)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "failed (${result}): ${ARGV}")
  endif()
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --component plugin --prefix ${WORK}/prefix)
run(${CMAKE_COMMAND} -S ${ROOT}/tests/bridge/installed -B ${WORK}/build -DCMAKE_BUILD_TYPE=Release
  -DCMAKE_PREFIX_PATH=${WORK}/prefix -DROOT=${ROOT} -DFORTRAN=${FORTRAN})
run(${CMAKE_COMMAND} --build ${WORK}/build)
if(FORTRAN)
  run(${WORK}/prefix/bin/frictionbeam-check-law bilinear_section.so "Yield moment=2e4" pad.so)
else()
  run(${WORK}/prefix/bin/frictionbeam-check-law coulomb_in_c.so pad.so "Contact area=0.01")
endif()
