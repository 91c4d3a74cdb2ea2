# cmake -P: the installed plugin, as a project finds it that has none of our sources.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

# Without the application nobody asks for gmsh.
run(${CMAKE_COMMAND} -S ${ROOT} -B ${WORK}/plugin-alone -DFRICTIONBEAM_APPLICATION=OFF
  -DCMAKE_BUILD_TYPE=RelWithDebInfo)
file(STRINGS ${WORK}/plugin-alone/CMakeCache.txt lines REGEX "GMSH")
if(lines)
  message(FATAL_ERROR "the plugin alone looks for gmsh: ${lines}")
endif()
file(STRINGS ${WORK}/plugin-alone/CMakeCache.txt lines REGEX "^CMAKE_BUILD_TYPE:.*=RelWithDebInfo$")
if(NOT lines)
  message(FATAL_ERROR "the build type was changed")
endif()
# By default in both flavours, and what `all` makes is what is installed.
run(${CMAKE_COMMAND} --build ${WORK}/plugin-alone --target help)
foreach(target plugin plugin_debug laws check_law)
  if(NOT output MATCHES "${target}")
    message(FATAL_ERROR "the plugin alone does not build ${target}")
  endif()
endforeach()
if(output MATCHES "application")
  message(FATAL_ERROR "the plugin alone builds the application")
endif()

set(prefix ${WORK}/prefix)
run(${CMAKE_COMMAND} --install ${BUILD} --component plugin --prefix ${prefix})
file(GLOB library_folder ${prefix}/lib*)
set(doc ${prefix}/share/doc/frictionbeam)
exists(${doc}/LICENSE ${doc}/embedding.md ${doc}/contact_library.md ${doc}/deal_ii_versions.md
  ${doc}/examples/CMakeLists.txt ${doc}/examples/beam_on_support.cc ${doc}/examples/solid.h
  ${doc}/examples/law_host/CMakeLists.txt ${prefix}/share/frictionbeam/law_skeleton.cc
  ${prefix}/include/frictionbeam/contact/solver.h)
if(EXISTS ${doc}/examples/run.cmake)
  message(FATAL_ERROR "our tests are installed as examples")
endif()
foreach(name frictionbeam frictionbeam.g frictionbeam-contact frictionbeam-laws)
  file(GLOB_RECURSE library ${prefix}/lib${name}.so)
  exists(${library}.${VERSION})
  libraries_of(${library})
  string(REGEX REPLACE "\\.[0-9]+$" "" minor ${VERSION})
  if(NOT "[lib${name}.so.${minor}]" IN_LIST libraries)
    message(FATAL_ERROR "lib${name}.so names itself otherwise than lib${name}.so.${minor}: ${libraries}")
  endif()
endforeach()
file(GLOB_RECURSE library ${prefix}/libfrictionbeam-laws.so)
needs_nothing(${library})
file(GLOB_RECURSE library ${prefix}/libfrictionbeam-contact.so)
needs_nothing(${library} "libfrictionbeam-contact|")
needs_nothing(${prefix}/bin/frictionbeam-check-law)
build_law_host(${prefix})

# Exact contact, without deal.II
build_contact_host(${prefix})
# Flags by which Eigen aligns or allocates otherwise than in the library: those of a sanitizer do no harm
# by the target; those of another processor are refused, and work where the library has them, too.
set(host ${WORK}/contact-host-sanitized)
run(${CMAKE_COMMAND} -S ${doc}/examples/contact_host -B ${host} -DCMAKE_PREFIX_PATH=${prefix}
  -DCMAKE_DISABLE_FIND_PACKAGE_deal.II=ON "-DCMAKE_CXX_FLAGS=-Werror -fsanitize=address")
run(${CMAKE_COMMAND} --build ${host})
run(${host}/contact_host)
execute_process(COMMAND uname -m OUTPUT_VARIABLE machine OUTPUT_STRIP_TRAILING_WHITESPACE)
set(compile g++ -std=c++17 -fsyntax-only -I${prefix}/include -isystem ${EIGEN})
set(source ${doc}/examples/contact_host/contact_host.cc)
refused("Build FrictionBeam with this program's flags" ${compile} -fsanitize=address ${source})
if(machine STREQUAL "x86_64")
  refused("Build FrictionBeam with this program's flags" ${compile} -mavx ${source})
  run(${CMAKE_COMMAND} -S ${ROOT} -B ${WORK}/with-avx -DFRICTIONBEAM_APPLICATION=OFF -DCMAKE_CXX_FLAGS=-mavx)
  file(GLOB_RECURSE package ${WORK}/with-avx/frictionbeam.pc)
  file(READ ${package} text)
  if(NOT text MATCHES "-DFRICTIONBEAM_EIGEN_ALIGNMENT=32")
    message(FATAL_ERROR "built with -mavx the package does not say how Eigen aligns: ${text}")
  endif()
  run(${compile} -mavx -DEIGEN_MALLOC_ALREADY_ALIGNED=0 -DFRICTIONBEAM_EIGEN_ALIGNMENT=32 ${source})
endif()

# GNU's linker takes a minute for a program that is linked with the 200 libraries of Debian's deal.II;
# by hand, below, one is linked with it.
find_program(GOLD ld.gold)
if(GOLD)
  set(ENV{LDFLAGS} -fuse-ld=gold)
endif()
# The flavour is that of the build type, and a program never loads both.
set(project ${CMAKE_CURRENT_LIST_DIR}/flavour)
foreach(pair Debug:frictionbeam.g debug:frictionbeam.g RelWithDebInfo:frictionbeam)
  string(REGEX REPLACE ":.*" "" type ${pair})
  string(REGEX REPLACE ".*:" "" name ${pair})
  set(build ${WORK}/flavour-${type})
  run(${CMAKE_COMMAND} -S ${project} -B ${build} -DCMAKE_BUILD_TYPE=${type}
    -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_CXX_FLAGS=-Werror)
  run(${CMAKE_COMMAND} --build ${build})
  run(${build}/flavour)
  string(REGEX REPLACE "\\.[0-9]+$" "" minor ${VERSION})
  foreach(program flavour flavour_by_function)
    libraries_of(${build}/${program})
    list(FILTER libraries INCLUDE REGEX "libfrictionbeam[.]")
    if(NOT libraries STREQUAL "[lib${name}.so.${minor}]")
      message(FATAL_ERROR "${type}: ${program} links ${libraries}")
    endif()
  endforeach()
endforeach()

# By hand
flags(frictionbeam-contact ${prefix})
run(g++ -std=c++17 -o contact-by-hand ${source} ${flags})
run(${WORK}/contact-by-hand)
libraries_of(${WORK}/contact-by-hand)
if(libraries MATCHES "libfrictionbeam[.]|deal_II")
  message(FATAL_ERROR "frictionbeam-contact.pc links ${libraries}")
endif()
# The command lines of doc/cookbook/own_law.md, in the folder of the sources
foreach(line "c++ -std=c++17 -O2 -shared -fPIC -I ../../include wearing_pad.cc -o ${WORK}/wearing_pad.so"
    "cc -std=c99 -O2 -shared -fPIC -I ../../include coulomb_in_c.c -o ${WORK}/coulomb_in_c.so -lm")
  run(sh -c "cd ${prefix}/share/frictionbeam && ${line}")
endforeach()
run(${prefix}/bin/frictionbeam-check-law wearing_pad.so)
run(${prefix}/bin/frictionbeam-check-law coulomb_in_c.so)
flags(frictionbeam ${prefix})
run(g++ -std=c++17 -o flavour-by-hand ${project}/flavour.cc ${flags})
run(${WORK}/flavour-by-hand)

# Another deal.II than the one it was built with
file(WRITE ${WORK}/other/deal.IIConfig.cmake "set(DEAL_II_VERSION 9.99.1)\nset(DEAL_II_PATH /other)\n")
file(WRITE ${WORK}/other/deal.IIConfigVersion.cmake
  "set(PACKAGE_VERSION 9.99.1)\nset(PACKAGE_VERSION_COMPATIBLE TRUE)\n")
refused("was built with deal.II 9[.0-9]+, .* and deal.II 9.99.1, .*/other.* was found" ${CMAKE_COMMAND}
  -S ${project} -B ${WORK}/refused -DCMAKE_PREFIX_PATH=${prefix} -Ddeal.II_DIR=${WORK}/other)
