# cmake -P: the installed application, and the Debian package of it where there is dpkg.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)
set(root ${WORK}/root)
set(prefix ${root}/usr)
run(${CMAKE_COMMAND} --install ${BUILD} --component application --prefix ${prefix})
set(doc ${prefix}/share/doc/frictionbeam)
exists(${prefix}/bin/frictionbeam ${prefix}/bin/frictionbeam-check-law ${prefix}/share/man/man1/frictionbeam.1
  ${prefix}/share/bash-completion/completions/frictionbeam ${doc}/LICENSE ${doc}/copyright ${doc}/README.md
  ${doc}/quantities.md ${doc}/cookbook/own_law.md ${doc}/prm/example/plant.prm ${doc}/prm/verification/lift_off.prm)

# It runs on what stands beside it.
run(${prefix}/bin/frictionbeam ${doc}/prm/verification/lift_off.prm --output-directory ${WORK}/run)
if(NOT output MATCHES "Results are in")
  message(FATAL_ERROR "the installed program says: ${output}")
endif()
file(GLOB_RECURSE libraries ${prefix}/*.so*)
foreach(file ${prefix}/bin/frictionbeam ${libraries})
  run(readelf -d ${file})
  if(output MATCHES "R(UN)?PATH[^\n]*${BUILD}")
    message(FATAL_ERROR "${file} looks for libraries in the build folder")
  endif()
endforeach()

find_program(CPACK cpack)
find_program(SHLIBDEPS dpkg-shlibdeps)
if(NOT CPACK OR NOT SHLIBDEPS)
  message(STATUS "no dpkg-shlibdeps here: the Debian package is not made")
  return()
endif()
# As `cpack` in the build folder does, of what is installed above: it would build everything first.
run(${CPACK} --config ${BUILD}/CPackConfig.cmake -D CPACK_INSTALL_CMAKE_PROJECTS=
  -D CPACK_DEB_COMPONENT_INSTALL=OFF -D CPACK_COMPONENTS_ALL= -D CPACK_STRIP_FILES=OFF
  -D "CPACK_INSTALLED_DIRECTORIES=${root}\;/" -B ${WORK}/package)
file(GLOB package ${WORK}/package/frictionbeam_${VERSION}_*.deb)
run(dpkg-deb -f ${package} Depends)
foreach(library libdeal.ii libgmsh libc6)
  if(NOT output MATCHES "${library}")
    message(FATAL_ERROR "the package does not depend on ${library}: ${output}")
  endif()
endforeach()
if(output MATCHES "-dev")
  message(FATAL_ERROR "the package depends on what only who compiles needs: ${output}")
endif()
run(dpkg-deb -c ${package})
foreach(file usr/bin/frictionbeam usr/share/man/man1/frictionbeam.1 usr/lib/frictionbeam-laws/law_coulomb.so)
  if(NOT output MATCHES "${file}")
    message(FATAL_ERROR "the package has no ${file}")
  endif()
endforeach()
