# SPDX-License-Identifier: GPL-3.0-or-later
include(GoogleTest)

# sonde_test(NAME [SOURCES file...] [LIBRARIES target...] [LABELS label...] [DISPLAY] [ALONE]
#            [LAUNCHER command...])
#
# One test program `test_NAME`, of the *_test.cpp files given (default: all below it),
# with every GoogleTest case registered in ctest.
#   LABELS     ci (default): runs in CI. full, soak, fuzz: longer ones, each by `ctest -L LABEL`.
#   LIBRARIES  beside sonde::engine and GoogleTest.
#   DISPLAY    the tests open windows: they need an X server, and run one at a time, beside tests
#              that open no window: they mostly wait.
#   ALONE      nothing runs beside them: they count what is late.
#   LAUNCHER   the program is run by this command, which gets it as its argument.
# Cases whose names hold a label after a dot-free prefix (Full_, Soak_, Fuzz_) get that label
# instead: TEST(Suite, Full_name) runs under `full` alone.
function(sonde_test NAME)
  cmake_parse_arguments(ARG "DISPLAY;ALONE" "" "SOURCES;LIBRARIES;LABELS;LAUNCHER" ${ARGN})
  if(NOT ARG_SOURCES)
    file(GLOB_RECURSE ARG_SOURCES CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*_test.cpp")
  endif()
  if(NOT ARG_SOURCES)
    return()
  endif()
  if(NOT ARG_LABELS)
    set(ARG_LABELS ci)
  endif()
  add_executable(test_${NAME} ${ARG_SOURCES} $<TARGET_OBJECTS:sonde_test_crash_trace>)
  target_link_libraries(test_${NAME} PRIVATE sonde::engine sonde_options sonde_test_support
                                             ${ARG_LIBRARIES} GTest::gmock GTest::gtest_main)
  # Half the time of compiling, a fifth of a whole build; what is tested is compiled as it ships.
  target_compile_options(test_${NAME} PRIVATE $<$<CONFIG:Release>:-O1>)
  # CMake's word for whatever runs a program.
  set_target_properties(test_${NAME} PROPERTIES CROSSCOMPILING_EMULATOR "${ARG_LAUNCHER}")
  set(properties LABELS "${ARG_LABELS}" TIMEOUT 600)
  if(ARG_DISPLAY)
    list(APPEND properties RESOURCE_LOCK display)
  endif()
  if(ARG_ALONE)
    list(APPEND properties RUN_SERIAL TRUE)
  endif()
  gtest_discover_tests(test_${NAME} TEST_PREFIX "${NAME}." DISCOVERY_TIMEOUT 60
                       TEST_FILTER "-*.Full_*:*.Soak_*:*.Fuzz_*" PROPERTIES ${properties})
  foreach(label Full Soak Fuzz)
    string(TOLOWER ${label} lower)
    gtest_discover_tests(test_${NAME} TEST_PREFIX "${NAME}." TEST_SUFFIX "" DISCOVERY_TIMEOUT 60
                         TEST_FILTER "*.${label}_*" TEST_LIST ${NAME}_${label}
                         PROPERTIES LABELS ${lower} TIMEOUT 5400)
  endforeach()
endfunction()
