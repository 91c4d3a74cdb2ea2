# frictionbeam_add_law(NAME SOURCES...): build a constitutive law into NAME.so, a shared library to
# be named in a parameter file or handed to LawLibrary::load(). It links no deal.II.
function(frictionbeam_add_law name)
  add_library(${name} MODULE ${ARGN})
  set_target_properties(${name} PROPERTIES PREFIX "" SUFFIX ".so" CXX_STANDARD 17
    CXX_STANDARD_REQUIRED ON CXX_VISIBILITY_PRESET hidden)
  if(FrictionBeam_INCLUDE_DIR)
    target_include_directories(${name} PRIVATE ${FrictionBeam_INCLUDE_DIR})
  endif()
endfunction()
