# For the tests of what is installed. BUILD is FrictionBeam's build folder, ROOT its sources, WORK a
# scratch folder, GENERATOR what CMake writes for.
cmake_minimum_required(VERSION 3.18)
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
set(ENV{CMAKE_GENERATOR} ${GENERATOR})

# run(COMMAND...): it shall succeed; what it printed is in `output`.
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text
    WORKING_DIRECTORY ${WORK})
  string(REPLACE ";" " " command "${ARGV}")
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "failed (${result}): ${command}\n${text}")
  endif()
  message(STATUS "${command}")
  set(output "${text}" PARENT_SCOPE)
endfunction()

# refused(PATTERN COMMAND...): it shall fail and say why.
function(refused pattern)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text
    WORKING_DIRECTORY ${WORK})
  string(REGEX REPLACE "[ \n]+" " " text "${text}")
  if(result EQUAL 0 OR NOT text MATCHES "${pattern}")
    message(FATAL_ERROR "should fail with '${pattern}': ${ARGN}\n${text}")
  endif()
endfunction()

function(exists)
  foreach(file ${ARGN})
    if(NOT EXISTS ${file})
      message(FATAL_ERROR "is not installed: ${file}")
    endif()
  endforeach()
endfunction()

# libraries_of(FILE): the names of libraries that it asks for, and its own, in `libraries`.
function(libraries_of file)
  run(readelf -d ${file})
  if(NOT output MATCHES "\\(NEEDED\\)|\\(SYMTAB\\)")
    message(FATAL_ERROR "readelf says nothing of ${file}")
  endif()
  string(REGEX MATCHALL "\\[[^]\n]*\\.so[^]\n]*\\]" libraries "${output}")
  set(libraries ${libraries} PARENT_SCOPE)
endfunction()

# needs_nothing(FILE ["LIBRARY|"]): it asks for C++, the laws' library and that one alone.
function(needs_nothing file)
  libraries_of(${file})
  foreach(name ${libraries})
    if(NOT name MATCHES "^.(${ARGN}libfrictionbeam-laws|libstdc.*|libm|libgcc_s|libc|libdl|ld-linux.*)\\.so")
      message(FATAL_ERROR "${file} needs ${name}, and should do with C++ and the laws")
    endif()
  endforeach()
endfunction()

# flags(PACKAGE FOLDER): what pkg-config says to compile and link with, in `flags`.
function(flags package folder)
  file(GLOB_RECURSE file ${folder}/${package}.pc)
  get_filename_component(path "${file}" DIRECTORY)
  set(ENV{PKG_CONFIG_PATH} ${path})
  run(pkg-config --cflags --libs ${package})
  separate_arguments(words UNIX_COMMAND "${output}")
  run(pkg-config --variable=libdir frictionbeam-laws)
  string(STRIP "${output}" path)
  set(flags ${words} -Wl,-rpath,${path} PARENT_SCOPE)
endfunction()

# A host of laws, as the examples have it, in a world without deal.II.
function(build_law_host prefix)
  set(host ${WORK}/law-host)
  file(REMOVE_RECURSE ${host})
  run(${CMAKE_COMMAND} -S ${prefix}/share/doc/frictionbeam/examples/law_host -B ${host}
    -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_DISABLE_FIND_PACKAGE_deal.II=ON
    -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON -DCMAKE_CXX_FLAGS=-Werror)
  run(${CMAKE_COMMAND} --build ${host})
  run(${host}/law_host)
  run(${host}/law_host ${host}/my_law.so)
  needs_nothing(${host}/law_host)
endfunction()

# A host of contact, likewise.
function(build_contact_host prefix)
  run(${CMAKE_COMMAND} -S ${prefix}/share/doc/frictionbeam/examples/contact_host -B ${WORK}/contact-host
    -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_DISABLE_FIND_PACKAGE_deal.II=ON -DCMAKE_CXX_FLAGS=-Werror)
  run(${CMAKE_COMMAND} --build ${WORK}/contact-host)
  run(${WORK}/contact-host/contact_host)
endfunction()
