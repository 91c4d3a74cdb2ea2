# What is installed of the application (component `application`): program, man page, bash's completion, documents and
# examples, and the libraries and laws it runs with, so that this component alone is whole.
#   cmake --install build --component application
# `cpack` in the build folder makes a Debian package of it, whose dependencies dpkg-shlibdeps finds.
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME application)
set(share_doc ${CMAKE_INSTALL_DATAROOTDIR}/doc/frictionbeam)
install(TARGETS frictionbeam RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS laws contact plugin LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} NAMELINK_SKIP)
install(TARGETS check_law RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY ${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/frictionbeam-laws
  ${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/frictionbeam-codes
  DESTINATION ${CMAKE_INSTALL_LIBDIR})
if(TARGET frictionbeam_sampling)
  install(TARGETS frictionbeam_sampling LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
endif()
install(FILES ${man_page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${completion} DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
  RENAME frictionbeam)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/CITATION.cff ${PROJECT_SOURCE_DIR}/README.md
  ${PROJECT_SOURCE_DIR}/CHANGELOG.md DESTINATION ${share_doc})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${share_doc} RENAME copyright) # where Debian looks
install(DIRECTORY ${PROJECT_SOURCE_DIR}/doc/ DESTINATION ${share_doc} FILES_MATCHING
  PATTERN "*.md" PATTERN "*.svg" PATTERN "*.png" PATTERN "*.prm")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/prm/example ${PROJECT_SOURCE_DIR}/prm/cookbook
  ${PROJECT_SOURCE_DIR}/prm/verification DESTINATION ${share_doc}/prm)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME frictionbeam)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "FrictionBeam <frictionbeam@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Pipe lines with Coulomb friction supports")
set(CPACK_PACKAGE_DESCRIPTION
  "Piping and lines on supports that slide, lift off and strike, solved from parameter files: statics, modes,\n spectra, transients, large displacements, sections that yield; a report that opens in a browser.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL application)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS libopenblas0) # solids take four times as long with the plain BLAS
set(CPACK_STRIP_FILES ON)
include(CPack)
