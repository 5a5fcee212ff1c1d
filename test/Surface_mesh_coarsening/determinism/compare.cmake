# SPDX-License-Identifier: GPL-3.0-or-later

# Runs PROGRAM and compares its output with the file TABLE, line by line.

cmake_minimum_required(VERSION 3.25)

execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
file(READ ${TABLE} expected)
if(printed STREQUAL expected)
  return()
endif()
string(REPLACE "\n" ";" printed "${printed}")
string(REPLACE "\n" ";" expected "${expected}")
foreach(line IN LISTS printed)
  if(NOT line IN_LIST expected)
    message("not in the table: ${line}")
  endif()
endforeach()
message(FATAL_ERROR "The checksums are not those of ${TABLE}.")
