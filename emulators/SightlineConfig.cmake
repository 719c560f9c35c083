# The targets of the machines and, where it was installed too, of the library of hidden-line removal, sightline::hidden_lines.
include(${CMAKE_CURRENT_LIST_DIR}/SightlineMachines.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/SightlineHiddenLines.cmake OPTIONAL)
