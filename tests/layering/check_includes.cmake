# Reads the #include lines of emulators/, host/ and tools/ and compares them with the list below.
# Each rule: a folder, then what its files may include from the repository. A folder may always include itself.
# A file goes by the rule of the innermost folder that has one. FOLDER/* is each folder in it that has no rule of its own.
cmake_minimum_required(VERSION 3.25)

set(RULES
  "emulators/core="
  "emulators/pdp7=emulators/core"
  "emulators/type340=emulators/core"
  "emulators/devices=emulators/core"
  "emulators/i8080=emulators/core"
  "emulators/machines=emulators/core,emulators/devices,emulators/i8080,emulators/pdp7,emulators/type340"
  "tools/image=host/base,emulators/core/word.hpp"
  "tools/asm=host/base,tools/image,emulators/core/word.hpp,emulators/machines/pdp7_devices.hpp,emulators/pdp7/isa.hpp,emulators/i8080/isa.hpp"
  "tools/disasm=host/base,tools/image,emulators/core/word.hpp,emulators/machines/pdp7_devices.hpp,emulators/pdp7/isa.hpp,emulators/type340/words.hpp,emulators/i8080/isa.hpp"
  "host/base="
  "host/geometry="
  "host/scene=host/base,host/geometry"
  "host/picture=host/base,host/geometry,host/scene,emulators/core,emulators/devices/calcomp565.hpp"
  "host/algorithms/*=host/base,host/geometry,host/scene,host/picture"
  "host/algorithms/registry=host/base,host/algorithms,host/programs/skala,host/geometry,host/scene,host/picture,emulators/devices,emulators/core"
  "host/hidden_lines=host/base,host/geometry,host/scene,host/picture,host/algorithms/registry,host/algorithms/oracle/matter_scene.hpp"
  "host/machines=host/base,host/picture,emulators,tools/image,tools/asm,tools/disasm"
  "host/programs/jones=host/base,host/machines,host/geometry,host/scene,emulators,tools/asm"
  "host/programs/jones/precision=host/base,host/geometry,host/scene,host/programs/jones,host/machines,host/algorithms/oracle,emulators/core,emulators/machines"
  "host/programs/jones/twin=emulators/core/word.hpp,emulators/type340/words.hpp,host/geometry/integer.hpp"
  "host/programs/turn=host/base,host/machines,host/scene,host/algorithms/plantinga,emulators,tools/asm"
  "host/programs/turn/twin=emulators/core/word.hpp"
  "host/programs/flight=host/base,host/machines/i8080_program.hpp,host/scene,host/algorithms/willis,emulators,tools/asm"
  "host/programs/flight/twin="
  "host/programs/skala=host/base,host/machines/i8080_program.hpp,host/machines/i8080_run_to.hpp,host/scene,host/picture/pen_path.hpp,emulators,tools/asm"
  "host/programs/skala/twin=host/programs/skala/commands.hpp,emulators/core/raster.hpp"
  "host/programs/stripes=host/base,host/machines/i8080_program.hpp,host/machines/i8080_run_to.hpp,host/scene,host/picture/pen_path.hpp,host/picture/pixel_metrics.hpp,host/algorithms/montani_re,emulators,tools/asm"
  "host/programs/stripes/twin=host/programs/stripes/status.hpp,emulators/core/raster.hpp"
  "host/live=host/base,host/machines,emulators,tools/asm,tools/disasm,tools/image"
  "host/live/dap=host/base,host/machines,host/live/debugger.hpp,host/live/monitor.hpp"
  "host/live/monitor=host/base,host/machines,host/live/debugger.hpp"
  "host/compare=host/base,host/hidden_lines,host/geometry,host/scene,host/picture,host/algorithms,host/machines,host/programs,emulators"
  "host/report=host/app/command.hpp,host/app/command_line.hpp,host/base,host/compare,host/machines,host/programs,host/geometry,host/scene,host/picture,host/algorithms,emulators"
  "host/live/web=host/base,host/hidden_lines,host/live,host/machines,host/programs,host/algorithms/registry,host/algorithms/oracle,host/geometry,host/explain,host/picture,host/scene,emulators"
  "host/explain=host/base,host/geometry,host/scene,host/picture,host/algorithms"
  "host/app=host/base,host/hidden_lines,host/compare,host/explain,host/machines,host/programs,host/live,host/geometry,host/scene,host/picture,host/algorithms,emulators,tools/image,tools/asm,tools/disasm")

# Libraries that may appear in one place only.
set(LIBRARY_RULES
  "png.h=host/picture"
  "nlohmann/=host/base"
  "muParser=host/scene"
  "assimp/=host/scene/read/assimp_mesh.cpp"
  "CLI/=host/app"
  "editline/=host/app"
  "gtest/=tests"
  "benchmark/=tests")

# What the machines must not need.
set(FORBIDDEN_IN_EMULATORS "iostream;fstream;sstream;filesystem;thread;mutex;stdexcept;regex;chrono")

foreach(rule IN LISTS RULES)
  if(rule MATCHES "^(.*)/[*]=(.*)$")
    set(parent "${CMAKE_MATCH_1}")
    set(allowed "${CMAKE_MATCH_2}")
    list(REMOVE_ITEM RULES "${rule}")
    file(GLOB inner RELATIVE ${ROOT} "${ROOT}/${parent}/*")
    foreach(folder IN LISTS inner)
      if(IS_DIRECTORY ${ROOT}/${folder} AND NOT RULES MATCHES "(^|;)${folder}=")
        list(APPEND RULES "${folder}=${allowed}")
      endif()
    endforeach()
  endif()
endforeach()

set(problems "")
set(folders "${RULES}")
list(TRANSFORM folders REPLACE "=.*" "/")
foreach(rule IN LISTS RULES)
  string(REGEX MATCH "^([^=]*)=(.*)$" _ "${rule}")
  set(folder "${CMAKE_MATCH_1}")
  string(REPLACE "," ";" allowed "${CMAKE_MATCH_2}")
  list(APPEND covered "${folder}")
  file(GLOB_RECURSE sources RELATIVE ${ROOT} "${ROOT}/${folder}/*.hpp" "${ROOT}/${folder}/*.cpp")
  foreach(inner IN LISTS folders)
    if(inner MATCHES "^${folder}/.")
      list(FILTER sources EXCLUDE REGEX "^${inner}")
    endif()
  endforeach()
  foreach(source IN LISTS sources)
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
        set(ok FALSE)
        foreach(prefix IN ITEMS ${folder} ${allowed})
          string(FIND "${target}" "${prefix}" at)
          if(at EQUAL 0)
            set(ok TRUE)
          endif()
        endforeach()
        if(NOT ok)
          string(APPEND problems "  ${source} includes ${target}, which ${folder} may not\n")
        endif()
      endif()
      if(folder MATCHES "^emulators/" AND line MATCHES "<([^>]*)>")
        if(CMAKE_MATCH_1 IN_LIST FORBIDDEN_IN_EMULATORS)
          string(APPEND problems "  ${source} includes <${CMAKE_MATCH_1}>: not allowed in machines\n")
        endif()
      endif()
      foreach(library_rule IN LISTS LIBRARY_RULES)
        string(REGEX MATCH "^([^=]*)=(.*)$" _ "${library_rule}")
        set(library "${CMAKE_MATCH_1}")
        string(REPLACE "," ";" homes "${CMAKE_MATCH_2}")
        string(FIND "${line}" "<${library}" at)
        if(at GREATER -1)
          set(ok FALSE)
          foreach(home IN LISTS homes)
            string(FIND "${source}" "${home}" home_at)
            if(home_at EQUAL 0)
              set(ok TRUE)
            endif()
          endforeach()
          if(NOT ok)
            string(APPEND problems "  ${source} includes ${library}: only ${homes} may\n")
          endif()
        endif()
      endforeach()
    endforeach()
  endforeach()
endforeach()

# Every source file lies in a folder that has a rule.
file(GLOB_RECURSE everything RELATIVE ${ROOT} "${ROOT}/emulators/*.[ch]pp" "${ROOT}/host/*.[ch]pp" "${ROOT}/tools/*.[ch]pp")
foreach(source IN LISTS everything)
  set(ok FALSE)
  foreach(folder IN LISTS covered)
    string(FIND "${source}" "${folder}/" at)
    if(at EQUAL 0)
      set(ok TRUE)
    endif()
  endforeach()
  if(NOT ok)
    string(APPEND problems "  ${source} lies in a folder without a rule\n")
  endif()
endforeach()

if(problems)
  message(FATAL_ERROR "Includes against the plan of the house:\n${problems}")
endif()
