# What is installed, as a package of CMake (find_package(FrictionBeam)) and of pkg-config.
# `cmake --install . --component plugin` installs it without the application.
include(CMakePackageConfigHelpers)
set(package_directory ${CMAKE_INSTALL_LIBDIR}/cmake/FrictionBeam)
set(package_has_plugin ${FRICTIONBEAM_WITH_DEAL_II})
set(package_has_contact TRUE)
if(FRICTIONBEAM_LAWS_ONLY)
  set(package_has_contact FALSE)
endif()
configure_package_config_file(FrictionBeamConfig.cmake.in
  ${PROJECT_BINARY_DIR}/FrictionBeamConfig.cmake INSTALL_DESTINATION ${package_directory}
  PATH_VARS CMAKE_INSTALL_INCLUDEDIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/FrictionBeamConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME plugin)
install(FILES ${PROJECT_BINARY_DIR}/FrictionBeamConfig.cmake
  ${PROJECT_BINARY_DIR}/FrictionBeamConfigVersion.cmake FrictionBeamAddLaw.cmake
  DESTINATION ${package_directory})
install(DIRECTORY bridge DESTINATION ${package_directory} FILES_MATCHING # laws of other programs
  PATTERN AddBridge.cmake PATTERN umat_law.cc PATTERN mgis_law.c)

# For pkg-config: found from where the file lies, so that the folder may be moved.
file(RELATIVE_PATH path_to_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" path_to_prefix ${path_to_prefix})
configure_file(frictionbeam-laws.pc.in ${PROJECT_BINARY_DIR}/frictionbeam-laws.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/frictionbeam-laws.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
if(package_has_contact)
  string(REPLACE ";" " -D" eigen_flags "-D${eigen_layout}")
  configure_file(frictionbeam-contact.pc.in ${PROJECT_BINARY_DIR}/frictionbeam-contact.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/frictionbeam-contact.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endif()
if(package_has_plugin)
  # Directories and definitions of deal.II are asked of the target that uses it: versions keep them in
  # different variables. The compiler's own /usr/include is behind its headers, and must stay there.
  set(directories $<TARGET_PROPERTY:plugin,INCLUDE_DIRECTORIES>)
  set(directories "$<FILTER:$<REMOVE_DUPLICATES:${directories}>,EXCLUDE,^(/usr|${PROJECT_SOURCE_DIR})/include$>")
  set(deal_ii_flags "-D$<JOIN:$<TARGET_PROPERTY:plugin,COMPILE_DEFINITIONS>, -D>")
  string(APPEND deal_ii_flags " -isystem $<JOIN:${directories}, -isystem >")
  set(deal_ii_library $<TARGET_FILE:${DEAL_II_TARGET_RELEASE}>)
  configure_file(frictionbeam.pc.in ${PROJECT_BINARY_DIR}/frictionbeam.pc.in @ONLY)
  file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/frictionbeam.pc INPUT ${PROJECT_BINARY_DIR}/frictionbeam.pc.in)
  install(FILES ${PROJECT_BINARY_DIR}/frictionbeam.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endif()

# Libraries, laws, the tool
install(TARGETS laws EXPORT FrictionBeamLaws LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT FrictionBeamLaws NAMESPACE FrictionBeam:: DESTINATION ${package_directory})
if(package_has_contact)
  install(TARGETS contact EXPORT FrictionBeamContact LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(EXPORT FrictionBeamContact NAMESPACE FrictionBeam:: DESTINATION ${package_directory})
endif()
if(package_has_plugin)
  list(REMOVE_ITEM plugin_libraries laws contact)
  install(TARGETS ${plugin_libraries} EXPORT FrictionBeamTargets
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(EXPORT FrictionBeamTargets NAMESPACE FrictionBeam:: DESTINATION ${package_directory})
endif()
install(TARGETS check_law RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY ${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/frictionbeam-laws
  ${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/frictionbeam-codes
  DESTINATION ${CMAKE_INSTALL_LIBDIR})

# Headers: those of the laws need nothing of others.
set(headers ${PROJECT_SOURCE_DIR}/include/frictionbeam)
if(package_has_plugin)
  install(DIRECTORY ${headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
else()
  foreach(header law law_c law_library law_conformance law_closed_form bound_law disc_projection
      stress_code stress_code_library)
    install(FILES ${headers}/${header}.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/frictionbeam)
  endforeach()
  if(package_has_contact)
    install(DIRECTORY ${headers}/contact DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/frictionbeam
      FILES_MATCHING PATTERN "*.h" PATTERN deal_ii.h EXCLUDE)
  endif()
endif()

# Licence, pages, examples
set(share ${CMAKE_INSTALL_DATAROOTDIR}/frictionbeam)
set(share_doc ${CMAKE_INSTALL_DATAROOTDIR}/doc/frictionbeam)
set(cookbook ${PROJECT_SOURCE_DIR}/prm/cookbook)
install(FILES law_skeleton.cc codes/stress_skeleton.cc ${cookbook}/own_law.prm ${cookbook}/wearing_pad.cc
  ${cookbook}/coulomb_in_c.c ${cookbook}/bilinear_section.f90 DESTINATION ${share})
install(FILES ${PROJECT_SOURCE_DIR}/doc/cookbook/own_law.md DESTINATION ${share_doc}/cookbook)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/CITATION.cff
  ${PROJECT_SOURCE_DIR}/doc/embedding.md ${PROJECT_SOURCE_DIR}/doc/contact_library.md
  ${PROJECT_SOURCE_DIR}/doc/deal_ii_versions.md ${PROJECT_SOURCE_DIR}/doc/theory.md
  ${PROJECT_SOURCE_DIR}/doc/stress_codes.md
  DESTINATION ${share_doc})
install(FILES ${PROJECT_SOURCE_DIR}/doc/picture/block.svg DESTINATION ${share_doc}/picture)
set(examples ${PROJECT_SOURCE_DIR}/tests/embed)
install(DIRECTORY ${examples}/law_host DESTINATION ${share_doc}/examples)
if(package_has_plugin)
  install(DIRECTORY ${examples}/ DESTINATION ${share_doc}/examples
    PATTERN "*.cmake" EXCLUDE PATTERN law_host EXCLUDE)
else()
  install(FILES ${examples}/my_law.cc DESTINATION ${share_doc}/examples)
  if(package_has_contact)
    install(DIRECTORY ${examples}/contact_host DESTINATION ${share_doc}/examples)
  endif()
endif()
