# Tables, code checks and nozzles of a transient step are those of its worst instants (it was the last one:
# nozzle 72.9 %, SL at A 8.09 MPa). The references are in the test's own text.
add_test(NAME "repro/quake_with_code" COMMAND test_envelope_files quake $<TARGET_FILE:frictionbeam>
  ${CMAKE_CURRENT_SOURCE_DIR}/quake_with_code.prm)
set_tests_properties("repro/quake_with_code" PROPERTIES TIMEOUT ${FRICTIONBEAM_TEST_SECONDS})
# The restraint summary showed "0.00 kN" of a stop that takes 33 kN s.
add_test(NAME "repro/whip_peak_tables" COMMAND test_envelope_files struck $<TARGET_FILE:frictionbeam>
  ${PROJECT_SOURCE_DIR}/tests/repro/whip_peak.prm)
