// Nothing: a library needs a source for its precompiled headers (CMakeLists.txt) to belong to.
