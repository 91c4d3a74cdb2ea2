# cmake -P: laws alone, built without deal.II and used without it.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

set(prefix ${WORK}/prefix)
run(${CMAKE_COMMAND} -S ${ROOT} -B ${WORK}/build -DFRICTIONBEAM_LAWS_ONLY=ON
  -DCMAKE_DISABLE_FIND_PACKAGE_deal.II=ON -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON
  -DFRICTIONBEAM_WARNINGS_AS_ERRORS=ON -DCMAKE_INSTALL_PREFIX=${prefix})
file(STRINGS ${WORK}/build/CMakeCache.txt lines REGEX "(deal.II|Eigen3|GMSH)[A-Z_]*DIR:")
if(lines)
  message(FATAL_ERROR "laws alone look for more than they need: ${lines}")
endif()
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${CMAKE_COMMAND} --install ${WORK}/build)
needs_nothing(${prefix}/bin/frictionbeam-check-law)
file(GLOB_RECURSE libraries ${prefix}/*.so)
list(LENGTH libraries n)
if(NOT n EQUAL 11) # the library, nine laws and a stress code
  message(FATAL_ERROR "installed are: ${libraries}")
endif()
foreach(library ${libraries})
  needs_nothing(${library})
endforeach()
exists(${prefix}/share/doc/frictionbeam/LICENSE ${prefix}/share/frictionbeam/law_skeleton.cc
  ${prefix}/share/frictionbeam/stress_skeleton.cc)

build_law_host(${prefix})
# The same by hand.
flags(frictionbeam-laws ${prefix})
run(g++ -std=c++17 -o by-hand ${prefix}/share/doc/frictionbeam/examples/law_host/law_host.cc ${flags})
run(${WORK}/by-hand)
refused("no component 'plugin'" ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/flavour -B ${WORK}/refused
  -DCMAKE_PREFIX_PATH=${prefix})
