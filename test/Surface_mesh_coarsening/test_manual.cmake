# SPDX-License-Identifier: GPL-3.0-or-later

# What the manual says that commands print, they print: the short tables of the manual, measured again, agree with it to the
# accuracy of sampling, and so do the figures of the README.
#   cmake -D BIN=... -D COARSEN_MESH=... -D FIND_SEEDS=... -D FANDISK=... -D CGAL_DATA_DIR=... -D PROJECT_SOURCE_DIR=... -P test_manual.cmake

cmake_minimum_required(VERSION 3.25)

set(doc ${PROJECT_SOURCE_DIR}/doc/Surface_mesh_coarsening)

execute_process(COMMAND ${FIND_SEEDS} OUTPUT_VARIABLE seeds COMMAND_ERROR_IS_FATAL ANY)
file(READ ${doc}/Theory_and_proofs.txt theory)
string(FIND "${theory}" "\\verbatim\n${seeds}\\endverbatim" place)
if(place EQUAL -1)
  message(SEND_ERROR "the manual does not have what find_seeds prints:\n${seeds}")
endif()

# Numbers without their points, in thousandths.
function(thousandths result number)
  string(REGEX MATCH "^([0-9]+)\\.?([0-9]*)" match "${number}")
  string(SUBSTRING "${CMAKE_MATCH_2}000" 0 3 digits)
  math(EXPR value "${CMAKE_MATCH_1} * 1000 + 1${digits} - 1000")
  set(${result} ${value} PARENT_SCOPE)
endfunction()

# Fails unless `stated` is within a part in twenty of `measured`, or within three thousandths.
function(check_number what measured stated)
  thousandths(measured_value ${measured})
  thousandths(stated_value ${stated})
  math(EXPR tolerance "${measured_value} / 20 + 3")
  math(EXPR difference "${measured_value} - ${stated_value}")
  if(difference GREATER tolerance OR difference LESS -${tolerance})
    message(SEND_ERROR "${what}: ${measured} is measured, ${stated} stated")
  endif()
endfunction()

# Reads the rows with figures, without the semicolons of &deg; that would divide them.
function(read_rows result file)
  file(READ ${file} text)
  string(REPLACE ";" "" text "${text}")
  string(REGEX MATCHALL "\\|[^\n]*[0-9][^\n]*" rows "${text}")
  set(${result} "${rows}" PARENT_SCOPE)
endfunction()

# Compares the rows that were measured with the first rows of the manual's table that begin alike. Every number is compared.
function(check_table name)
  read_rows(measured ${CMAKE_CURRENT_BINARY_DIR}/tables/${name}.md)
  read_rows(stated ${doc}/tables/${name}.md)
  list(LENGTH measured number)
  if(number EQUAL 0)
    message(SEND_ERROR "${name}: nothing was measured")
  endif()
  foreach(row IN LISTS measured)
    string(REGEX MATCH "^\\|[^|]*\\|" title "${row}")
    set(other "")
    foreach(candidate IN LISTS stated)
      string(FIND "${candidate}" "${title}" place)
      if(place EQUAL 0)
        set(other "${candidate}")
        list(REMOVE_ITEM stated "${candidate}")
        break()
      endif()
    endforeach()
    string(REGEX MATCHALL "[0-9]+(\\.[0-9]+)?" measured_numbers "${row}")
    string(REGEX MATCHALL "[0-9]+(\\.[0-9]+)?" stated_numbers "${other}")
    list(LENGTH measured_numbers n)
    list(LENGTH stated_numbers m)
    if(NOT n EQUAL m)
      message(SEND_ERROR "${name}: the manual has no row like\n${row}")
      continue()
    endif()
    foreach(measured_number stated_number IN ZIP_LISTS measured_numbers stated_numbers)
      check_number("${name}, ${title}" ${measured_number} ${stated_number})
    endforeach()
  endforeach()
endfunction()

set(tables weights_and_placements borders distance levels)
list(JOIN tables " " names)
execute_process(COMMAND ${CMAKE_COMMAND} -D BIN=${BIN} -D MESHES=${CGAL_DATA_DIR}/meshes -D MODELS= -D SHORT=ON "-D NAMES=${names}"
  -D OUT=${CMAKE_CURRENT_BINARY_DIR}/tables -P ${PROJECT_SOURCE_DIR}/benchmark/Surface_mesh_coarsening/make_tables.cmake
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
foreach(name IN LISTS tables)
  check_table(${name})
endforeach()

# Rows of the README: a command between backquotes, the distance and the angle that it measures.
file(STRINGS ${PROJECT_SOURCE_DIR}/README.md rows REGEX "^\\| `coarsen_mesh fandisk.off [^`]*` \\| [0-9.]+ \\| [0-9.]+&deg")
list(LENGTH rows number)
if(number LESS 2)
  message(SEND_ERROR "the README has only ${number} rows of figures of the tool")
endif()
foreach(row IN LISTS rows)
  string(REGEX MATCH "^\\| `coarsen_mesh fandisk.off ([^`]*)` \\| ([0-9.]+) \\| ([0-9.]+)&deg" match "${row}")
  set(stated_rms ${CMAKE_MATCH_2})
  set(stated_angle ${CMAKE_MATCH_3})
  separate_arguments(arguments UNIX_COMMAND "${CMAKE_MATCH_1}")
  execute_process(COMMAND ${COARSEN_MESH} ${FANDISK} ${arguments} --report report.json --quiet COMMAND_ERROR_IS_FATAL ANY)
  file(READ report.json report)
  string(JSON rms GET "${report}" quality distance_percent rms)
  string(JSON angle GET "${report}" quality smallest_angle_degrees mean)
  check_number("the README, ${match}" ${rms} ${stated_rms})
  check_number("the README, ${match}" ${angle} ${stated_angle})
endforeach()
