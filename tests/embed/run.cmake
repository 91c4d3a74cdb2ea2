# cmake -P: install the plugin into an empty folder, build the project in this folder, as it was
# installed among the examples, against it, run.
# Wants BUILD (FrictionBeam's build folder), WORK (a scratch folder), TYPE.
cmake_minimum_required(VERSION 3.18)
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK}/build)
find_program(GOLD ld.gold) # GNU's takes a minute for the 200 libraries of Debian's deal.II
if(GOLD)
  set(ENV{LDFLAGS} -fuse-ld=gold)
endif()
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result WORKING_DIRECTORY ${WORK}/build)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "failed (${result}): ${ARGV}")
  endif()
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --component plugin --prefix ${WORK}/prefix)
# All of them in debug, whose assertions look at what they do, without the symbols that deal.II's flags ask for: a fifth
# of the time. In release one, for its compiling takes a minute.
if(TYPE STREQUAL "Release")
  set(target --target beam_on_support --target my_law)
else()
  set(fast "-DCMAKE_CXX_COMPILE_OBJECT=<CMAKE_CXX_COMPILER> <DEFINES> <INCLUDES> <FLAGS> -g0 -o <OBJECT> -c <SOURCE>")
endif()
run(${CMAKE_COMMAND} -S ${WORK}/prefix/share/doc/frictionbeam/examples -B ${WORK}/build -DCMAKE_BUILD_TYPE=${TYPE}
  -DCMAKE_PREFIX_PATH=${WORK}/prefix -DCMAKE_CXX_FLAGS=-Werror ${fast})
run(${CMAKE_COMMAND} --build ${WORK}/build ${target})
# By its name alone, as a user in that folder would.
run(${WORK}/prefix/bin/frictionbeam-check-law my_law.so)
run(${WORK}/build/beam_on_support my_law.so)
if(TYPE STREQUAL "Release")
  return()
endif()
run(${WORK}/build/heated_line)
set(ENV{OMPI_ALLOW_RUN_AS_ROOT} 1)
set(ENV{OMPI_ALLOW_RUN_AS_ROOT_CONFIRM} 1)
foreach(program block_on_floor pipe_on_block)
  run(${WORK}/build/${program})
  run(mpirun -np 2 --oversubscribe ${WORK}/build/${program})
endforeach()
