# Reads the #include lines of emulators/, host/ and tools/ and compares them with the rules that the build writes from its DEPENDS
# (tools/library.cmake).
#
#   cmake -DROOT=. [-DRULES=build/release/include_rules.txt] -P tests/layering/check_includes.cmake
#
# A rule FOLDER=ALLOWED,... lists what the files in FOLDER may include from the repository: files in these folders, and single
# headers.
# A folder may always include itself. A file belongs to the innermost folder that has a rule.
cmake_minimum_required(VERSION 3.25)

# Libraries that may be included in one place only.
set(LIBRARY_RULES
  "png.h=host/picture"
  "nlohmann/=host/base"
  "zip.h=host/scene/read/zip_archive.cpp"
  "pugixml=host/scene/read/three_mf.cpp"
  "draco/=host/scene/read/draco_mesh.cpp"
  "CLI/=host/app"
  "editline/=host/app"
  "gmp=tools/verify"
  "pybind11/=host/bindings/python"
  "gtest/=tests"
  "benchmark/=tests")

# Headers that the machines must not include.
set(FORBIDDEN_IN_EMULATORS "iostream;fstream;sstream;filesystem;thread;mutex;stdexcept;regex;chrono")

cmake_path(ABSOLUTE_PATH ROOT NORMALIZE)
if(NOT RULES)
  set(RULES ${ROOT}/build/release/include_rules.txt)
endif()
if(NOT EXISTS ${RULES})
  message(FATAL_ERROR "${RULES}: no such file; configure the build (cmake --preset release-test) first")
endif()
file(STRINGS ${RULES} rules)
set(folders "")
foreach(rule IN LISTS rules)
  string(REGEX MATCH "^([^=]*)=(.*)$" _ "${rule}")
  set(folder "${CMAKE_MATCH_1}")
  string(REPLACE "," ";" allowed "${CMAKE_MATCH_2}")
  list(APPEND folders "${folder}")
  # If a folder has several targets, they share their rules.
  list(APPEND "allowed in ${folder}" "${folder}" ${allowed})
endforeach()
list(REMOVE_DUPLICATES folders)

# The innermost folder that has a rule, or nothing.
function(find_folder file result)
  cmake_path(GET file PARENT_PATH folder)
  while(folder AND NOT folder IN_LIST folders)
    cmake_path(GET folder PARENT_PATH folder)
  endwhile()
  set(${result} "${folder}" PARENT_SCOPE)
endfunction()

set(problems "")
file(GLOB_RECURSE sources RELATIVE ${ROOT} "${ROOT}/emulators/*.[ch]pp" "${ROOT}/host/*.[ch]pp" "${ROOT}/tools/*.[ch]pp")
foreach(source IN LISTS sources)
  find_folder(${source} folder)
  if(NOT folder)
    string(APPEND problems "  ${source} lies in a folder without a library\n")
    continue()
  endif()
  file(STRINGS "${ROOT}/${source}" lines REGEX "^[ \t]*#[ \t]*include")
  foreach(line IN LISTS lines)
    set(target "")
    if(line MATCHES "\"((emulators|host|tools|tests|firmware)/[^\"]*)\"")
      set(target "${CMAKE_MATCH_1}")
      if(folder MATCHES "^emulators/")
        string(APPEND problems "  ${source} includes ${target}: the machines' headers include each other by relative "
                               "paths, because they are installed\n")
      endif()
    elseif(folder MATCHES "^emulators/" AND line MATCHES "\"([^\"]*)\"")
      cmake_path(SET target NORMALIZE "${folder}/${CMAKE_MATCH_1}")
    endif()
    if(target)
      find_folder(${target} target_folder)
      if(NOT target_folder IN_LIST "allowed in ${folder}" AND NOT target IN_LIST "allowed in ${folder}")
        string(APPEND problems "  ${source} includes ${target}, which is not among the DEPENDS of ${folder}\n")
      endif()
    endif()
    if(folder MATCHES "^emulators/" AND line MATCHES "<([^>]*)>" AND CMAKE_MATCH_1 IN_LIST FORBIDDEN_IN_EMULATORS)
      string(APPEND problems "  ${source} includes <${CMAKE_MATCH_1}>: not allowed in machines\n")
    endif()
    foreach(library_rule IN LISTS LIBRARY_RULES)
      string(REGEX MATCH "^([^=]*)=(.*)$" _ "${library_rule}")
      set(library "${CMAKE_MATCH_1}")
      set(home "${CMAKE_MATCH_2}")
      string(FIND "${line}" "<${library}" at)
      string(FIND "${source}" "${home}" home_at)
      if(at GREATER -1 AND NOT home_at EQUAL 0)
        string(APPEND problems "  ${source} includes ${library}: only ${home} may\n")
      endif()
    endforeach()
  endforeach()
endforeach()

if(problems)
  message(FATAL_ERROR "Includes that the CMakeLists.txt do not allow:\n${problems}")
endif()
