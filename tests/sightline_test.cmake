# sightline_tests(NAME name LIBRARIES target ... [FAST a.cpp ...] [SLOW b.cpp ...] [RELEASE_ONLY c.cpp ...] [AS_ONE] [OPTIMISED] [CHECKED] [RUNS program] [APART d.cpp ...])
#   One call per folder makes one test program per label: NAME_test, NAME_slow_test and NAME_release_test. Every GoogleTest case
#   becomes one ctest entry with the label `fast`, `slow` or `release_only`.
#   SIGHTLINE_TEST_DATA  is defined as the absolute path of tests/data
#   SIGHTLINE_SOURCE_DIR is defined as the root of the repository
#   SIGHTLINE_COMMAND    is, for tests that RUN a program, the path of that program
#   RELEASE_ONLY: tests that need optimised code to end in a few seconds; they are not built with sanitizers.
#   AS_ONE: the program runs once for all its tests, because they share what takes long to prepare.
#   APART: of those sources, the ones that are not compiled together with others where that is asked for, because they name
#   a helper as another file does.
#   OPTIMISED: the fast tests, too, contain what works for long: a machine is compiled into the tests that run it.
#   CHECKED: what is under test are templates, which are compiled into the tests alone. With sanitizers these tests are
#   checked as the libraries are. Other tests are not: their subject is checked in its library, and a test's own code
#   took two fifths more to compile with checks than without.
# What else is under test is optimised in its own library; the tests themselves need less, and compile faster for it.
if(CMAKE_BUILD_TYPE STREQUAL "Release" AND CMAKE_CXX_FLAGS_RELEASE MATCHES "-O2")
  set(SIGHTLINE_TEST_OPTIONS -O0)
  set(SIGHTLINE_OPTIMISED_TEST_OPTIONS -O1)
elseif(SIGHTLINE_SANITIZE)
  set(SIGHTLINE_TEST_OPTIONS -fno-sanitize=all)
  set(SIGHTLINE_OPTIMISED_TEST_OPTIONS -O1 -fno-sanitize=all)
  set(SIGHTLINE_OPTIMISED_CHECKED_TEST_OPTIONS -O1)
endif()

function(sightline_tests)
  cmake_parse_arguments(ARG "AS_ONE;OPTIMISED;CHECKED" "NAME;RUNS" "FAST;SLOW;RELEASE_ONLY;LIBRARIES;APART" ${ARGN})
  set_source_files_properties(${ARG_APART} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
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

# Called by sightline_tests, whose other arguments (ARG_LIBRARIES, ARG_RUNS, ARG_AS_ONE, ARG_OPTIMISED, ARG_CHECKED) it reads.
function(sightline_test_program program label sources)
  add_executable(${program} ${sources})
  target_link_libraries(${program} PRIVATE ${ARG_LIBRARIES} sightline_test_support GTest::gtest_main)
  set(kind "")
  if(NOT label STREQUAL "fast" OR ARG_OPTIMISED)
    string(APPEND kind optimised_)
  endif()
  if(ARG_CHECKED AND SIGHTLINE_SANITIZE)
    string(APPEND kind checked_)
  endif()
  target_precompile_headers(${program} REUSE_FROM sightline_${kind}test_headers)
  string(TOUPPER "${kind}" upper)
  target_compile_options(${program} PRIVATE ${SIGHTLINE_${upper}TEST_OPTIONS})
  if(ARG_RUNS)
    target_compile_definitions(${program} PRIVATE SIGHTLINE_COMMAND="$<TARGET_FILE:${ARG_RUNS}>")
    add_dependencies(${program} ${ARG_RUNS})
  endif()
  if(ARG_AS_ONE)
    add_test(NAME ${program} COMMAND ${program})
    set_tests_properties(${program} PROPERTIES LABELS ${label} TIMEOUT 900)
  elseif(SIGHTLINE_SANITIZE)
    # With checks in every line a program takes long to begin: four runs share its tests. Those that run the command take
    # longest; they begin first, so that none of them is alone at the end.
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
