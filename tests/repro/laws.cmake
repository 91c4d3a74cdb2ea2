# Laws whose closed form is not their own (liar.cc, wild.cc): the tool and the program refuse them.
include(${PROJECT_SOURCE_DIR}/plugin/FrictionBeamAddLaw.cmake)
foreach(fault LIAR WILD)
  frictionbeam_add_law(test_law_${fault} ${CMAKE_CURRENT_SOURCE_DIR}/laws/other_coulomb.cc)
  target_include_directories(test_law_${fault} PRIVATE ${PROJECT_SOURCE_DIR}/include)
  target_compile_definitions(test_law_${fault} PRIVATE ${fault})
  set_target_properties(test_law_${fault} PROPERTIES
    LIBRARY_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
  set(LAW ${CMAKE_CURRENT_BINARY_DIR}/test_law_${fault}.so)
  configure_file(${CMAKE_CURRENT_SOURCE_DIR}/laws/law.prm
    ${CMAKE_CURRENT_BINARY_DIR}/law_${fault}.prm @ONLY)
  add_test(NAME "repro/law ${fault}" COMMAND check_case $<TARGET_FILE:frictionbeam>
    ${CMAKE_CURRENT_BINARY_DIR}/law_${fault}.prm --exit 1 --message)
  add_test(NAME "repro/law ${fault}, frictionbeam-check-law"
    COMMAND $<TARGET_FILE:check_law> $<TARGET_FILE:test_law_${fault}>)
  set_tests_properties("repro/law ${fault}, frictionbeam-check-law" PROPERTIES
    PASS_REGULAR_EXPRESSION "other does not conform")
endforeach()
