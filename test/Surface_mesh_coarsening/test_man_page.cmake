# SPDX-License-Identifier: GPL-3.0-or-later

# The manual page lists all options of --help with all values, and no others.
#   cmake -D COARSEN_MESH=PROGRAM -D MAN_PAGE=coarsen_mesh.1 -P test_man_page.cmake

cmake_minimum_required(VERSION 3.25)

execute_process(COMMAND ${COARSEN_MESH} --help OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
file(READ ${MAN_PAGE} page)
string(REPLACE "\\-" "-" page "${page}")

string(REGEX REPLACE "[][;]" "|" help "${help}") # which are special in lists
string(REGEX MATCHALL "\n  (-[a-z] \\| )?--[a-z][a-z-]+" described "${help}")
list(TRANSFORM described REPLACE "^.*--" "--")
list(LENGTH described number)
if(number LESS 15)
  message(FATAL_ERROR "--help describes only ${number} options: ${described}")
endif()

# The heads of the page's entries: the lines that follow .TP and begin with an option.
string(REGEX MATCHALL "\n\\.TP\n\\.BR? +-[^\n]*" heads "${page}")
set(entries "")
foreach(head IN LISTS heads)
  string(REGEX MATCH "--[a-z][a-z-]+" entry "${head}")
  list(APPEND entries ${entry})
endforeach()

foreach(option IN LISTS described)
  if(NOT option IN_LIST entries)
    message(SEND_ERROR "${option} is not in the manual page")
  endif()
endforeach()
foreach(option IN LISTS entries)
  if(NOT option IN_LIST described)
    message(SEND_ERROR "the manual page describes ${option}, which --help does not know")
  endif()
endforeach()

# Choices are listed by the tool's own messages.
foreach(option --weight --placement)
  execute_process(COMMAND ${COARSEN_MESH} in.off out.off ${option} none ERROR_VARIABLE message)
  string(REGEX MATCH "is one of ([a-z, -]+), not" found "${message}")
  string(REPLACE ", " ";" values "${CMAKE_MATCH_1}")
  if(NOT found)
    message(SEND_ERROR "no list of values of ${option} in: ${message}")
  endif()
  foreach(value IN LISTS values)
    string(FIND "${page}" "${value}" place)
    if(place EQUAL -1)
      message(SEND_ERROR "the manual page does not have ${option} ${value}")
    endif()
  endforeach()
endforeach()

# A formatter, if installed, prints no warnings.
find_program(GROFF groff)
if(GROFF)
  execute_process(COMMAND ${GROFF} -man -ww -Tascii ${MAN_PAGE} OUTPUT_QUIET ERROR_VARIABLE warnings)
  if(warnings)
    message(SEND_ERROR "groff: ${warnings}")
  endif()
endif()
message(STATUS "${number} options compared")
