# Laws that others wrote for other programs, see doc/cookbook/own_law.md:
#   frictionbeam_add_umat(NAME KIND support|section SOURCES x.f... [LIBRARIES x.so...] [STATES n] ...)
#   frictionbeam_add_mgis(NAME KIND support|section LIBRARY libX.so BEHAVIOUR X ...)
set(FRICTIONBEAM_BRIDGE_DIRECTORY ${CMAKE_CURRENT_LIST_DIR})

# What both read: name, kind, reference. Sets IS_SECTION and REFERENCE in the caller.
macro(frictionbeam_bridge_check function name)
  if(a_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "${function}(${name}): '${a_UNPARSED_ARGUMENTS}' is no option of it.")
  endif()
  if(a_KIND STREQUAL "section")
    set(IS_SECTION 1)
  elseif(a_KIND STREQUAL "support")
    set(IS_SECTION 0)
  else()
    message(FATAL_ERROR "${function}(${name}): KIND is '${a_KIND}', expected support or section.")
  endif()
  set(REFERENCE "${a_REFERENCE}")
  if(NOT REFERENCE)
    set(REFERENCE "${function}(${name})")
  endif()
  foreach(text "${REFERENCE}" "${a_PARAMETERS}" "${a_DEFAULTS}")
    if(text MATCHES "[\"\\]")
      message(FATAL_ERROR "${function}(${name}): '${text}' has a quotation mark or a backslash. Leave it out.")
    endif()
  endforeach()
endmacro()

# frictionbeam_add_umat(NAME KIND support|section SOURCES FILES... | LIBRARIES FILES...
#   [PARAMETERS "name|unit|default|minimum|maximum|meaning"...]  in the order of PROPS
#   [STATES n]                                                  NSTATV, 0 if not given
#   [SYMBOL umat_] [REFERENCE "where it is from"] [SYMMETRIC])
# builds NAME.so, the law NAME, from an Abaqus-type UMAT. Fortran sources need the language Fortran in
# project() or enable_language().
function(frictionbeam_add_umat name)
  cmake_parse_arguments(a "SYMMETRIC" "KIND;STATES;SYMBOL;REFERENCE" "SOURCES;LIBRARIES;PARAMETERS" ${ARGN})
  frictionbeam_bridge_check(frictionbeam_add_umat ${name})
  if(NOT a_SOURCES AND NOT a_LIBRARIES)
    message(FATAL_ERROR "frictionbeam_add_umat(${name}): give SOURCES, or LIBRARIES that have the UMAT.")
  endif()
  if(NOT a_STATES)
    set(a_STATES 0)
  endif()
  if(NOT a_STATES MATCHES "^[0-9]+$")
    message(FATAL_ERROR "frictionbeam_add_umat(${name}): STATES is '${a_STATES}', expected a number of state variables.")
  endif()
  if(NOT a_SYMBOL)
    set(a_SYMBOL umat_)
  endif()
  set(parameters)
  foreach(parameter IN LISTS a_PARAMETERS)
    if(NOT parameter MATCHES "^([^|]+)[|]([^|]+)[|]([^|]+)[|]([^|]+)[|]([^|]+)[|]([^|]+)$")
      message(FATAL_ERROR "frictionbeam_add_umat(${name}): the parameter '${parameter}' is not "
        "'name|unit|default|minimum|maximum|meaning', as in 'Yield stress|Pa|2e8|0|1e300|at which it flows'.")
    endif()
    string(APPEND parameters ", {\"${CMAKE_MATCH_1}\", \"${CMAKE_MATCH_2}\", ${CMAKE_MATCH_3}, ${CMAKE_MATCH_4}, ${CMAKE_MATCH_5}, \"${CMAKE_MATCH_6}\"}")
  endforeach()
  set(is_symmetric false)
  if(a_SYMMETRIC)
    set(is_symmetric true)
  endif()
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${name}_umat)
  file(CONFIGURE OUTPUT ${folder}/frictionbeam_umat.h CONTENT
"#define FRICTIONBEAM_UMAT_NAME \"${name}\"
#define FRICTIONBEAM_UMAT_REFERENCE \"${REFERENCE}\"
#define FRICTIONBEAM_UMAT_SYMBOL ${a_SYMBOL}
#define FRICTIONBEAM_UMAT_IS_SECTION ${IS_SECTION}
#define FRICTIONBEAM_UMAT_IS_SYMMETRIC ${is_symmetric}
#define FRICTIONBEAM_UMAT_STATES ${a_STATES}
#define FRICTIONBEAM_UMAT_PARAMETERS ${parameters}
")
  foreach(file aba_param.inc ABA_PARAM.INC) # what UMATs include, in either spelling
    file(CONFIGURE OUTPUT ${folder}/${file} CONTENT
"      implicit real*8(a-h,o-z)
      parameter (nprecd=2)
")
  endforeach()
  frictionbeam_add_law(${name} ${FRICTIONBEAM_BRIDGE_DIRECTORY}/umat_law.cc ${a_SOURCES})
  target_include_directories(${name} PRIVATE ${folder})
  target_link_libraries(${name} PRIVATE ${a_LIBRARIES})
endfunction()

# frictionbeam_add_mgis(NAME KIND support|section LIBRARY FILE BEHAVIOUR NAME
#   [DEFAULTS "YoungModulus=2e11"...]  of material properties
#   [GRADIENTS n...]                   components of each gradient, if there are several: 3 3 for two vectors
#   [HYPOTHESIS Tridimensional] [REFERENCE "where it is from"])
# builds NAME.so, the law NAME, from a behaviour that 'mfront --interface=generic' built into FILE.
# Needs MGIS with its bindings to C, and the language C in project().
function(frictionbeam_add_mgis name)
  cmake_parse_arguments(a "" "KIND;LIBRARY;BEHAVIOUR;HYPOTHESIS;REFERENCE" "DEFAULTS;GRADIENTS" ${ARGN})
  frictionbeam_bridge_check(frictionbeam_add_mgis ${name})
  foreach(option LIBRARY BEHAVIOUR)
    if(NOT a_${option})
      message(FATAL_ERROR "frictionbeam_add_mgis(${name}): give ${option}.")
    endif()
  endforeach()
  if(NOT TARGET mgis::MFrontGenericInterface-c)
    find_package(MFrontGenericInterface QUIET)
    find_package(MFrontGenericInterface-c QUIET)
  endif()
  if(NOT TARGET mgis::MFrontGenericInterface-c)
    message(FATAL_ERROR "frictionbeam_add_mgis(${name}): MGIS and its bindings to C are not found. Build MGIS "
      "with -Denable-c-bindings=ON, and name where it is installed in CMAKE_PREFIX_PATH.")
  endif()
  if(NOT CMAKE_C_COMPILER)
    message(FATAL_ERROR "frictionbeam_add_mgis(${name}): this needs the language C. Add it to project().")
  endif()
  if(NOT a_HYPOTHESIS)
    set(a_HYPOTHESIS Tridimensional)
  endif()
  set(components 3)
  if(IS_SECTION)
    set(components 6)
  endif()
  if(NOT a_GRADIENTS)
    set(a_GRADIENTS ${components})
  endif()
  string(REPLACE ";" ", " gradients "${a_GRADIENTS}")
  string(REPLACE ";" "+" sum "${a_GRADIENTS}")
  if(NOT sum MATCHES "^[0-9]+([+][0-9]+)*$")
    message(FATAL_ERROR "frictionbeam_add_mgis(${name}): GRADIENTS is '${a_GRADIENTS}', expected numbers.")
  endif()
  math(EXPR sum "${sum}")
  if(NOT sum EQUAL components)
    message(FATAL_ERROR "frictionbeam_add_mgis(${name}): GRADIENTS have ${sum} components, a law of kind ${a_KIND} "
      "has ${components}.")
  endif()
  set(defaults)
  foreach(word IN LISTS a_DEFAULTS)
    if(NOT word MATCHES "^([^=]+)=([^=]+)$")
      message(FATAL_ERROR "frictionbeam_add_mgis(${name}): '${word}' is not name=value.")
    endif()
    string(APPEND defaults "{\"${CMAKE_MATCH_1}\", ${CMAKE_MATCH_2}}, ")
  endforeach()
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${name}_mgis)
  file(CONFIGURE OUTPUT ${folder}/frictionbeam_mgis.h CONTENT
"#define FRICTIONBEAM_MGIS_NAME \"${name}\"
#define FRICTIONBEAM_MGIS_REFERENCE \"${REFERENCE}\"
#define FRICTIONBEAM_MGIS_IS_SECTION ${IS_SECTION}
#define FRICTIONBEAM_MGIS_LIBRARY \"${a_LIBRARY}\"
#define FRICTIONBEAM_MGIS_BEHAVIOUR \"${a_BEHAVIOUR}\"
#define FRICTIONBEAM_MGIS_HYPOTHESIS \"${a_HYPOTHESIS}\"
#define FRICTIONBEAM_MGIS_GRADIENTS ${gradients}
#define FRICTIONBEAM_MGIS_DEFAULTS ${defaults}
")
  frictionbeam_add_law(${name} ${FRICTIONBEAM_BRIDGE_DIRECTORY}/mgis_law.c)
  set_target_properties(${name} PROPERTIES C_STANDARD 99)
  target_include_directories(${name} PRIVATE ${folder})
  target_link_libraries(${name} PRIVATE mgis::MFrontGenericInterface-c)
endfunction()
