# sightline_tests(NAME name LIBRARIES target ... [FAST a.cpp ...] [SLOW b.cpp ...] [RELEASE_ONLY c.cpp ...] [AS_ONE] [RUNS program])
# One call per folder makes one test program per label: NAME_test, NAME_slow_test and NAME_release_test. Every GoogleTest case
# becomes
# one ctest entry with the label `fast`, `slow` or `release_only`.
#   SIGHTLINE_TEST_DATA  is defined as the absolute path of tests/data
#   SIGHTLINE_SOURCE_DIR is defined as the root of the repository
#   RUNS: the tests run that program; it is built before them.
#   RELEASE_ONLY: tests that take more than a few seconds without optimisation; they are not built with sanitizers.
#   AS_ONE: the program runs once for all its tests, because they share a costly preparation.
function(sightline_tests)
  cmake_parse_arguments(ARG "AS_ONE" "NAME;RUNS" "FAST;SLOW;RELEASE_ONLY;LIBRARIES" ${ARGN})
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "sightline_tests(${ARG_NAME}): unknown argument ${ARG_UNPARSED_ARGUMENTS}")
  endif()
  if(ARG_FAST)
    sightline_test_program(${ARG_NAME}_test fast "${ARG_FAST}")
  endif()
  if(ARG_SLOW)
    sightline_test_program(${ARG_NAME}_slow_test slow "${ARG_SLOW}")
  endif()
  if(ARG_RELEASE_ONLY AND NOT SIGHTLINE_SANITIZE)
    sightline_test_program(${ARG_NAME}_release_test release_only "${ARG_RELEASE_ONLY}")
  endif()
endfunction()

# Called by sightline_tests, whose arguments ARG_LIBRARIES, ARG_RUNS and ARG_AS_ONE it reads.
function(sightline_test_program program label sources)
  add_executable(${program} ${sources})
  target_link_libraries(${program} PRIVATE ${ARG_LIBRARIES} sightline_test_support GTest::gtest_main)
  if(ARG_RUNS)
    add_dependencies(${program} ${ARG_RUNS})
  endif()
  if(ARG_AS_ONE)
    add_test(NAME ${program} COMMAND ${program})
    set_tests_properties(${program} PROPERTIES LABELS ${label} TIMEOUT 900)
  elseif(SIGHTLINE_SANITIZE)
    # With sanitizers a program starts slowly: four runs share its tests. Those that run the command take longest and start first,
    # so that
    # none of them is alone at the end.
    if(ARG_RUNS)
      set(cost 60)
    else()
      set(cost 10)
    endif()
    foreach(shard RANGE 3)
      add_test(NAME ${program}.${shard} COMMAND ${program})
      set_tests_properties(${program}.${shard} PROPERTIES LABELS ${label} TIMEOUT 900 COST ${cost}
        ENVIRONMENT "GTEST_TOTAL_SHARDS=4;GTEST_SHARD_INDEX=${shard}")
    endforeach()
  else()
    gtest_discover_tests(${program} PROPERTIES LABELS ${label} TIMEOUT 900 DISCOVERY_TIMEOUT 60)
  endif()
endfunction()
