# SPDX-License-Identifier: GPL-3.0-or-later

# Every command of the tool in README, manual, manual page and pages for contributors runs unchanged, and every preset and
# target that they name exists. The Fandisk replaces missing input files.
#   cmake -D COARSEN_MESH=... -D FANDISK=... -D CGAL_DATA_DIR=... -D PROJECT_SOURCE_DIR=... -D PROJECT_BINARY_DIR=...
#     -P test_commands.cmake

cmake_minimum_required(VERSION 3.25)

set(text "")
file(GLOB pages RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/doc/Surface_mesh_coarsening/*.txt
  ${PROJECT_SOURCE_DIR}/doc/Surface_mesh_coarsening/tables/*.md)
foreach(page README.md CONTRIBUTING.md packaging/coarsen_mesh.1 ${pages})
  file(READ ${PROJECT_SOURCE_DIR}/${page} content)
  string(APPEND text "\n${content}\n")
endforeach()
string(REPLACE "\\-" "-" text "${text}") # as manual pages write it
string(REGEX REPLACE "[][;]" "|" text "${text}") # which are special in lists

# Lines that begin with the command, and commands between backquotes.
string(REGEX MATCHALL "\n *(\\.B )?coarsen_mesh [^\n]*(off|ply|stl|obj) [^\n]*" lines "${text}")
string(REGEX MATCHALL "`coarsen_mesh [^`]*(off|ply|stl|obj) [^`]*`" quoted "${text}")
set(commands ${lines} ${quoted})
list(TRANSFORM commands REPLACE "^[\n` ]*(\\.B )?coarsen_mesh ([^`]*).*" "\\2")
list(REMOVE_DUPLICATES commands)
list(LENGTH commands number)
if(number LESS 6)
  message(FATAL_ERROR "only ${number} commands were found: ${commands}")
endif()

# The first file of a command is its input.
function(provide file)
  string(REGEX REPLACE "\\.[a-z]+$" "" name ${file})
  if(EXISTS ${CGAL_DATA_DIR}/meshes/${file})
    file(COPY_FILE ${CGAL_DATA_DIR}/meshes/${file} ${file})
  elseif(file MATCHES "\\.off$")
    file(COPY_FILE ${FANDISK} ${file})
  else()
    execute_process(COMMAND ${COARSEN_MESH} ${FANDISK} ${file} -n 5000 -w uniform --placement centroid --quiet
      COMMAND_ERROR_IS_FATAL ANY)
  endif()
endfunction()

foreach(command IN LISTS commands)
  separate_arguments(arguments UNIX_COMMAND "${command}")
  set(files ${arguments})
  list(FILTER files INCLUDE REGEX "\\.(off|ply|stl|obj)$")
  list(POP_FRONT files read written)
  provide(${read})
  file(REMOVE ${written})
  execute_process(COMMAND ${COARSEN_MESH} ${arguments} OUTPUT_QUIET ERROR_VARIABLE complaint RESULT_VARIABLE status)
  if(NOT status EQUAL 0 OR NOT EXISTS ${written})
    message(SEND_ERROR "coarsen_mesh ${command}\n  ended with ${status}: ${complaint}")
  endif()
endforeach()

file(READ ${PROJECT_SOURCE_DIR}/CMakePresets.json presets)
string(REGEX MATCHALL "--preset[ =][a-z-]+" named "${text}")
list(REMOVE_DUPLICATES named)
list(LENGTH named number_of_presets)
if(number_of_presets LESS 4)
  message(FATAL_ERROR "only ${number_of_presets} presets were found: ${named}")
endif()
foreach(preset IN LISTS named)
  string(REGEX REPLACE "--preset[ =]" "" preset ${preset})
  if(NOT presets MATCHES "\"name\": \"${preset}\"")
    message(SEND_ERROR "there is no preset ${preset}")
  endif()
endforeach()

# Some targets need programs that may be missing.
execute_process(COMMAND ${CMAKE_COMMAND} --build ${PROJECT_BINARY_DIR} --target help OUTPUT_VARIABLE targets
  COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "--target [a-z_]+" named "${text}")
list(REMOVE_DUPLICATES named)
foreach(target IN LISTS named)
  string(REPLACE "--target " "" target ${target})
  if(NOT targets MATCHES "[ \n/]${target}[:\n]")
    if(target MATCHES "^(picture_|doc|fuzz_long|compile_cost)")
      message(STATUS "Did not find what target ${target} needs")
    else()
      message(SEND_ERROR "there is no target ${target}")
    endif()
  endif()
endforeach()
message(STATUS "${number} commands run, ${number_of_presets} presets and the targets compared")
