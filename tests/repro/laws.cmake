# Laws whose closed form is not their own (liar.cc, wild.cc): the tool and the program refuse them.
include(${PROJECT_SOURCE_DIR}/plugin/FrictionBeamAddLaw.cmake)
foreach(fault LIAR WILD)
  frictionbeam_add_law(test_law_${fault} ${CMAKE_CURRENT_SOURCE_DIR}/laws/other_coulomb.cc)
  target_include_directories(test_law_${fault} PRIVATE ${PROJECT_SOURCE_DIR}/include)
  target_compile_definitions(test_law_${fault} PRIVATE ${fault})
  set_target_properties(test_law_${fault} PROPERTIES
    LIBRARY_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
  set(LAW ${CMAKE_CURRENT_BINARY_DIR}/test_law_${fault}.so)
  if(fault STREQUAL "WILD") # refused when it is loaded
    set(EXPECTED "cannot be used: its closed form has the place slip_y outside of the state")
  else()
    set(EXPECTED "a law that does not contradict itself: its closed form")
  endif()
  foreach(scene law body)
    configure_file(${CMAKE_CURRENT_SOURCE_DIR}/laws/${scene}.prm
      ${CMAKE_CURRENT_BINARY_DIR}/${scene}_${fault}.prm @ONLY)
    add_test(NAME "repro/${scene} ${fault}" COMMAND check_case $<TARGET_FILE:frictionbeam>
      ${CMAKE_CURRENT_BINARY_DIR}/${scene}_${fault}.prm --exit 1 --message)
  endforeach()
  add_test(NAME "repro/law ${fault}, frictionbeam-check-law"
    COMMAND $<TARGET_FILE:check_law> $<TARGET_FILE:test_law_${fault}>)
endforeach()
set_tests_properties("repro/law LIAR, frictionbeam-check-law" PROPERTIES
  PASS_REGULAR_EXPRESSION "other does not conform")
set_tests_properties("repro/law WILD, frictionbeam-check-law" PROPERTIES
  PASS_REGULAR_EXPRESSION "place slip_y outside of the state, which has 4 internal variables, read 77")

# A law of sections of a user's own, chosen by a Section: half as stiff as its figures.
frictionbeam_add_law(test_law_springy ${CMAKE_CURRENT_SOURCE_DIR}/laws/springy_section.cc)
target_include_directories(test_law_springy PRIVATE ${PROJECT_SOURCE_DIR}/include)
set_target_properties(test_law_springy PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
set(LAW ${CMAKE_CURRENT_BINARY_DIR}/test_law_springy.so)
foreach(scene section weight)
  configure_file(${CMAKE_CURRENT_SOURCE_DIR}/laws/${scene}.prm ${CMAKE_CURRENT_BINARY_DIR}/${scene}.prm @ONLY)
endforeach()
add_test(NAME "repro/law of sections" COMMAND check_case $<TARGET_FILE:frictionbeam>
  ${CMAKE_CURRENT_BINARY_DIR}/section.prm --errors 1e-9)
add_test(NAME "repro/law of sections under weight" COMMAND check_case $<TARGET_FILE:frictionbeam>
  ${CMAKE_CURRENT_BINARY_DIR}/weight.prm --errors 1e-6)
