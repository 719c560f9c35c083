# The header-only libraries of the module for browsers. Debian installs them next to the headers of the build machine's C library,
# which the
# module must not see, so only theirs are linked into its include folder.
set(headers ${CMAKE_BINARY_DIR}/library_headers)
file(MAKE_DIRECTORY ${headers})
foreach(name fmt nlohmann)
  if(NOT IS_DIRECTORY /usr/include/${name})
    message(FATAL_ERROR "/usr/include/${name}: no such folder, expected the headers of ${name}; `tools/dev deps` installs them")
  endif()
  file(CREATE_LINK /usr/include/${name} ${headers}/${name} SYMBOLIC)
endforeach()
add_library(sightline_library_headers INTERFACE)
target_include_directories(sightline_library_headers SYSTEM INTERFACE ${headers})

add_library(fmt::fmt INTERFACE IMPORTED)
# Without locales and long doubles, which the module does not print and which take a twentieth of the file.
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY FMT_EXCEPTIONS=0 "FMT_STATIC_THOUSANDS_SEPARATOR=','" FMT_USE_LONG_DOUBLE=0)
target_link_libraries(fmt::fmt INTERFACE sightline_library_headers)
add_library(nlohmann_json::nlohmann_json INTERFACE IMPORTED)
target_compile_definitions(nlohmann_json::nlohmann_json INTERFACE JSON_NOEXCEPTION JSON_NO_IO JSON_HAS_FILESYSTEM=0 JSON_HAS_EXPERIMENTAL_FILESYSTEM=0)
target_link_libraries(nlohmann_json::nlohmann_json INTERFACE sightline_library_headers)
add_library(Threads::Threads INTERFACE IMPORTED)
