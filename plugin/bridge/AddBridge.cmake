# Laws that others wrote for other programs, see doc/cookbook/own_law.md:
#   frictionbeam_add_umat(NAME KIND support|section SOURCES x.f... [LIBRARIES x.so...] [STATES n] ...)
set(FRICTIONBEAM_BRIDGE_DIRECTORY ${CMAKE_CURRENT_LIST_DIR})

# What they read: name, kind, reference. Sets IS_SECTION and REFERENCE in the caller.
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
  foreach(text "${REFERENCE}" "${a_PARAMETERS}")
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
