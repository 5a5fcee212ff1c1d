# SPDX-License-Identifier: GPL-3.0-or-later

# Builds all tools.
add_custom_target(tools)

# Builds the programs of the long tests, where a short build leaves them out.
add_custom_target(long_tests)

# surface_mesh_coarsening_add_tool(NAME SOURCE...): a program in bin/ with the parts of coarsen_mesh.
function(surface_mesh_coarsening_add_tool name)
  find_package(Boost REQUIRED COMPONENTS program_options)
  add_executable(${name} ${ARGN})
  target_link_libraries(${name} PRIVATE coarsen_mesh_parts Boost::program_options)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
  add_dependencies(tools ${name})
endfunction()

# surface_mesh_coarsening_add_run(NAME COMMAND... [MODELS MODEL...]): a CTest test that runs a command in a separate
# directory of the build tree, and is skipped with a message if one of the models was not found.
function(surface_mesh_coarsening_add_run name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "COMMAND;MODELS")
  foreach(model IN LISTS arg_MODELS)
    if(NOT model_${model})
      add_test(NAME ${name} COMMAND ${CMAKE_COMMAND} -E echo "Skipped: the model ${model} was not found")
      set_tests_properties(${name} PROPERTIES SKIP_REGULAR_EXPRESSION "^Skipped: ")
      return()
    endif()
  endforeach()
  set(directory ${CMAKE_CURRENT_BINARY_DIR}/run/${name})
  file(MAKE_DIRECTORY ${directory})
  add_test(NAME ${name} COMMAND ${arg_COMMAND} WORKING_DIRECTORY ${directory})
  if(CGAL_DATA_DIR)
    set_property(TEST ${name} APPEND PROPERTY ENVIRONMENT CGAL_DATA_DIR=${CGAL_DATA_DIR})
  endif()
  if(TARGET coarsen_mesh)
    set_property(TEST ${name} APPEND PROPERTY ENVIRONMENT COARSEN_MESH=$<TARGET_FILE:coarsen_mesh>)
  endif()
endfunction()

# surface_mesh_coarsening_set_long(TESTS TEST... [PROGRAMS TARGET...]): sweeps of many cases, which only the workflow `long` runs,
# and the programs that no other test runs.
function(surface_mesh_coarsening_set_long)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "" "TESTS;PROGRAMS")
  set_property(TEST ${arg_TESTS} APPEND PROPERTY LABELS long)
  if(SURFACE_MESH_COARSENING_SHORT_BUILD AND arg_PROGRAMS)
    set_target_properties(${arg_PROGRAMS} PROPERTIES EXCLUDE_FROM_ALL ON)
    add_dependencies(long_tests ${arg_PROGRAMS})
  endif()
endfunction()
