# cmake -P: exact contact and laws, built without deal.II and used without it.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

set(prefix ${WORK}/prefix)
# By the compiler of this build: GCC takes three times as long over the templates.
run(${CMAKE_COMMAND} -S ${ROOT} -B ${WORK}/build -DFRICTIONBEAM_CONTACT_ONLY=ON -DCMAKE_CXX_COMPILER=${COMPILER}
  -DCMAKE_DISABLE_FIND_PACKAGE_deal.II=ON -DFRICTIONBEAM_WARNINGS_AS_ERRORS=ON
  -DCMAKE_INSTALL_PREFIX=${prefix})
file(STRINGS ${WORK}/build/CMakeCache.txt lines REGEX "(deal.II|GMSH)[A-Z_]*DIR:")
if(lines)
  message(FATAL_ERROR "contact alone looks for more than it needs: ${lines}")
endif()
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${CMAKE_COMMAND} --install ${WORK}/build)
file(GLOB_RECURSE library ${prefix}/libfrictionbeam-contact.so)
needs_nothing(${library} "libfrictionbeam-contact|")
if(EXISTS ${prefix}/include/frictionbeam/contact/deal_ii.h OR EXISTS ${prefix}/include/frictionbeam/fe_line.h)
  message(FATAL_ERROR "headers are installed that need deal.II")
endif()
build_law_host(${prefix})
build_contact_host(${prefix})
refused("no component 'plugin'" ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/flavour -B ${WORK}/refused
  -DCMAKE_PREFIX_PATH=${prefix})
