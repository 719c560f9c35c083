# sightline_tests(NAME name LIBRARIES target ... [FAST a.cpp ...] [SLOW b.cpp ...] [RELEASE_ONLY c.cpp ...] [AS_ONE] [OPTIMISED] [CHECKED] [RUNS program] [APART d.cpp ...])
#   One call per folder makes one test program per label: NAME_test, NAME_slow_test and NAME_release_test. Every GoogleTest case
#   becomes one ctest entry with the label `fast`, `slow` or `release_only`.
#   SIGHTLINE_TEST_DATA  is defined as the absolute path of tests/data
#   SIGHTLINE_SOURCE_DIR is defined as the root of the repository
#   RUNS: the tests start that program; it is built before they run.
#   RELEASE_ONLY: tests that need optimised code to end in a few seconds; they are not built with sanitizers.
#   AS_ONE: the program runs once for all its tests, because they share what takes long to prepare.
#   APART: of those sources, the ones that are not compiled together with others where that is asked for, because they name
#   a helper as another file does.
#   OPTIMISED: the fast tests, too, contain what works for long: a machine is compiled into the tests that run it.
#   CHECKED: what is under test are templates, which are compiled into the tests alone. With sanitizers these tests are
#   checked as the libraries are. Other tests are not, their subject is checked in its library: they are compiled once, for
#   the release build, and linked with libraries of both kinds where SIGHTLINE_TEST_OBJECTS says where they are.
#
# What else is under test is optimised in its own library; the tests themselves need less, and compile faster for it.
if(CMAKE_BUILD_TYPE STREQUAL "Release" AND CMAKE_CXX_FLAGS_RELEASE MATCHES "-O2")
  # Templates of the standard library that a checked library calls may be those of a test's object: they keep their assertions.
  set(SIGHTLINE_TEST_OPTIONS -O1 -D_GLIBCXX_ASSERTIONS)
  set(SIGHTLINE_OPTIMISED_TEST_OPTIONS -O1 -D_GLIBCXX_ASSERTIONS)
elseif(SIGHTLINE_SANITIZE)
  set(SIGHTLINE_TEST_OPTIONS -fno-sanitize=all)
  set(SIGHTLINE_OPTIMISED_TEST_OPTIONS -O1 -fno-sanitize=all)
  set(SIGHTLINE_OPTIMISED_CHECKED_TEST_OPTIONS -O1)
endif()

# A program whose sources the library PROGRAM_objects compiles: the caller says how, where there is that library. SHARED: the sources
# are compiled once for the builds with and without sanitizers, and there is none where SIGHTLINE_TEST_OBJECTS names the build that has
# compiled them. Its target test_objects compiles all of them; which they are stands in its file tests/objects/PROGRAM.
function(sightline_program_of_objects program shared sources)
  if(shared AND SIGHTLINE_TEST_OBJECTS)
    set(list ${SIGHTLINE_TEST_OBJECTS}/tests/objects/${program})
    file(STRINGS ${list} objects)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${list})
    set_source_files_properties(${objects} PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)
    add_executable(${program} ${objects})
    set_target_properties(${program} PROPERTIES LINKER_LANGUAGE CXX)
  else()
    add_library(${program}_objects OBJECT ${sources})
    if(shared AND TARGET test_objects)
      add_dependencies(test_objects ${program}_objects)
      file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/tests/objects/${program}
        CONTENT "$<JOIN:$<TARGET_OBJECTS:${program}_objects>,\n>\n")
    endif()
    add_executable(${program})
    target_link_libraries(${program} PRIVATE ${program}_objects)
  endif()
endfunction()

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
  set(kind "")
  if(NOT label STREQUAL "fast" OR ARG_OPTIMISED)
    string(APPEND kind optimised_)
  endif()
  if(ARG_CHECKED AND SIGHTLINE_SANITIZE)
    string(APPEND kind checked_)
  endif()
  string(TOUPPER "${kind}" upper)
  set(shared ON)
  if(ARG_CHECKED OR label STREQUAL "release_only")
    set(shared OFF)
  endif()
  sightline_program_of_objects(${program} ${shared} "${sources}")
  if(TARGET ${program}_objects)
    target_link_libraries(${program}_objects PRIVATE ${ARG_LIBRARIES} sightline_test_support)
    target_precompile_headers(${program}_objects REUSE_FROM sightline_${kind}test_headers)
    target_compile_options(${program}_objects PRIVATE ${SIGHTLINE_${upper}TEST_OPTIONS})
  endif()
  target_link_libraries(${program} PRIVATE ${ARG_LIBRARIES} GTest::gtest_main)
  if(ARG_RUNS)
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
