# sightline_test(NAME name SOURCES a.cpp ... LIBRARIES target ... [LABEL slow] [AS_ONE] [RUNS program])
#   SIGHTLINE_TEST_DATA  is defined as the absolute path of tests/data
#   SIGHTLINE_SOURCE_DIR is defined as the root of the repository
#   SIGHTLINE_COMMAND    is, of a test that RUNS a program, the path of it
#   LABEL release_only: only where code is optimised; AS_ONE: run by one process, sharing what takes long to make
# What is under test is optimised in its own library; the tests themselves need less, and compile faster for it.
if(CMAKE_BUILD_TYPE STREQUAL "Release" AND CMAKE_CXX_FLAGS_RELEASE MATCHES "-O2")
  set(SIGHTLINE_TEST_OPTIONS -O1)
endif()

function(sightline_test)
  cmake_parse_arguments(ARG "AS_ONE" "NAME;LABEL;RUNS" "SOURCES;LIBRARIES" ${ARGN})
  if(NOT ARG_LABEL)
    set(ARG_LABEL fast)
  endif()
  if(ARG_LABEL STREQUAL "release_only" AND SIGHTLINE_SANITIZE)
    return()
  endif()
  add_executable(${ARG_NAME} ${ARG_SOURCES})
  target_link_libraries(${ARG_NAME} PRIVATE ${ARG_LIBRARIES} sightline_test_support GTest::gtest_main)
  target_precompile_headers(${ARG_NAME} REUSE_FROM sightline_test_headers)
  target_compile_options(${ARG_NAME} PRIVATE ${SIGHTLINE_TEST_OPTIONS})
  if(ARG_RUNS)
    target_compile_definitions(${ARG_NAME} PRIVATE SIGHTLINE_COMMAND="$<TARGET_FILE:${ARG_RUNS}>")
    add_dependencies(${ARG_NAME} ${ARG_RUNS})
  endif()
  # With checks in every line a program takes long to begin: once for all of its tests.
  if(ARG_AS_ONE OR SIGHTLINE_SANITIZE)
    add_test(NAME ${ARG_NAME} COMMAND ${ARG_NAME})
    set_tests_properties(${ARG_NAME} PROPERTIES LABELS ${ARG_LABEL} TIMEOUT 900)
  else()
    gtest_discover_tests(${ARG_NAME} PROPERTIES LABELS ${ARG_LABEL} TIMEOUT 900 DISCOVERY_TIMEOUT 60)
  endif()
endfunction()
