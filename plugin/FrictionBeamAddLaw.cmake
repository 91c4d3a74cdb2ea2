# frictionbeam_add_law(NAME SOURCES...): build a constitutive law into NAME.so, a shared library to
# be named in a parameter file or handed to LawLibrary::load(). It links no deal.II. It is optimized, whatever
# the build type and its flags, for it is called millions of times; options that are added later win, so
# target_compile_options(NAME PRIVATE -O0 -g) after it is for a debugger.
function(frictionbeam_add_law name)
  add_library(${name} MODULE ${ARGN})
  set_target_properties(${name} PROPERTIES PREFIX "" SUFFIX ".so" CXX_STANDARD 17
    CXX_STANDARD_REQUIRED ON CXX_VISIBILITY_PRESET hidden C_VISIBILITY_PRESET hidden)
  target_compile_options(${name} PRIVATE -O2)
  if(FrictionBeam_INCLUDE_DIR)
    target_include_directories(${name} PRIVATE ${FrictionBeam_INCLUDE_DIR})
  endif()
endfunction()
# frictionbeam_add_stress_code(NAME SOURCES...): likewise a stress code, for Stress/Code libraries.
function(frictionbeam_add_stress_code name)
  frictionbeam_add_law(${name} ${ARGN})
endfunction()
include(${CMAKE_CURRENT_LIST_DIR}/bridge/AddBridge.cmake)
