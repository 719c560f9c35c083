# Defines libraries and who may include whom, from one list of dependencies.
#
# sightline_library(TARGET SOURCES a.cpp ... [DEPENDS target ...] [MAY_INCLUDE header ...])
#   makes the static library TARGET of the current folder and of its subfolders without a library.
# sightline_depends(TARGET ...) takes the same arguments without SOURCES, for an existing target.
#
#   DEPENDS      targets that TARGET links. Sources of the folder may include the headers in the folders of these targets, not of
#                the targets that those link in turn.
#   MAY_INCLUDE  single headers, by their paths from the root of the repository. Where DEPENDS names the target of such a header,
#                the header is all that may be included of its folder; elsewhere it is a header that needs no linking.
#
# sightline_write_include_rules(FILE), called when all targets exist, writes what each folder may include: one line
# FOLDER=ALLOWED,...
# per folder, where ALLOWED is a folder or a header. tests/layering/check_includes.cmake compares the include lines with it.
function(sightline_library TARGET)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;MAY_INCLUDE" ${ARGN})
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "sightline_library(${TARGET}): unknown argument ${ARG_UNPARSED_ARGUMENTS}, expected SOURCES, DEPENDS or MAY_INCLUDE")
  endif()
  add_library(${TARGET} STATIC ${ARG_SOURCES})
  target_include_directories(${TARGET} PUBLIC ${PROJECT_SOURCE_DIR})
  sightline_depends(${TARGET} DEPENDS ${ARG_DEPENDS} MAY_INCLUDE ${ARG_MAY_INCLUDE})
endfunction()

function(sightline_depends TARGET)
  cmake_parse_arguments(ARG "" "" "DEPENDS;MAY_INCLUDE" ${ARGN})
  target_link_libraries(${TARGET} PUBLIC ${ARG_DEPENDS})
  set_target_properties(${TARGET} PROPERTIES SIGHTLINE_MAY_INCLUDE "${ARG_MAY_INCLUDE}")
  set_property(GLOBAL APPEND PROPERTY SIGHTLINE_TARGETS ${TARGET})
endfunction()

# The folder whose headers belong to a target, relative to the root of the repository; empty for targets of other projects.
function(sightline_folder_of TARGET RESULT)
  set(folder "")
  if(TARGET ${TARGET})
    get_target_property(imported ${TARGET} IMPORTED)
    get_target_property(directory ${TARGET} SOURCE_DIR)
    if(NOT imported)
      cmake_path(RELATIVE_PATH directory BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE folder)
    endif()
    # That package defines all its targets in one CMakeLists.txt.
    if(folder STREQUAL "emulators")
      get_target_property(name ${TARGET} EXPORT_NAME)
      string(APPEND folder "/${name}")
    endif()
  endif()
  set(${RESULT} "${folder}" PARENT_SCOPE)
endfunction()

function(sightline_write_include_rules FILE)
  get_property(targets GLOBAL PROPERTY SIGHTLINE_TARGETS)
  get_property(emulators DIRECTORY ${PROJECT_SOURCE_DIR}/emulators PROPERTY BUILDSYSTEM_TARGETS)
  set(rules "")
  foreach(target IN LISTS emulators targets)
    sightline_folder_of(${target} own)
    get_target_property(depends ${target} INTERFACE_LINK_LIBRARIES)
    get_target_property(type ${target} TYPE)
    if(type STREQUAL "EXECUTABLE")
      get_target_property(depends ${target} LINK_LIBRARIES)
    endif()
    get_target_property(headers ${target} SIGHTLINE_MAY_INCLUDE)
    set(allowed "")
    if(headers)
      set(allowed ${headers})
    endif()
    foreach(depend IN LISTS depends)
      sightline_folder_of("${depend}" folder)
      if(folder AND NOT headers MATCHES "(^|;)${folder}/[^;/]*(;|$)")
        list(APPEND allowed ${folder})
      endif()
    endforeach()
    list(SORT allowed)
    list(JOIN allowed "," allowed)
    list(APPEND rules "${own}=${allowed}")
  endforeach()
  list(SORT rules)
  list(JOIN rules "\n" text)
  file(CONFIGURE OUTPUT ${FILE} CONTENT "${text}\n" @ONLY)
endfunction()
