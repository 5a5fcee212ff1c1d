# SPDX-License-Identifier: GPL-3.0-or-later

# Commands in the manual print the output shown there. The figures in the tables of manual and README agree with the tool's
# measurements up to the accuracy of sampling: distance and shape, distances of borders and of levels, and sizes of results
# within a distance.
#   cmake -D COARSEN_MESH=... -D FIND_SEEDS=... -D FANDISK=... -D CGAL_DATA_DIR=... -D PROJECT_SOURCE_DIR=... -P test_manual.cmake

cmake_minimum_required(VERSION 3.25)

file(READ ${PROJECT_SOURCE_DIR}/doc/Surface_mesh_coarsening/Surface_mesh_coarsening.txt manual)
file(READ ${PROJECT_SOURCE_DIR}/README.md readme)

execute_process(COMMAND ${FIND_SEEDS} OUTPUT_VARIABLE seeds COMMAND_ERROR_IS_FATAL ANY)
string(FIND "${manual}" "\\verbatim\n${seeds}\\endverbatim" place)
if(place EQUAL -1)
  message(SEND_ERROR "the manual does not have what find_seeds prints:\n${seeds}")
endif()

# Numbers without their points, in thousandths.
function(thousandths result number)
  string(REGEX MATCH "^([0-9]+)\\.([0-9]*)" match "${number}")
  string(SUBSTRING "${CMAKE_MATCH_2}000" 0 3 digits)
  math(EXPR value "${CMAKE_MATCH_1} * 1000 + 1${digits} - 1000")
  set(${result} ${value} PARENT_SCOPE)
endfunction()

# Fails unless `stated` is within 5 % of `measured`, or within a thousandth.
function(check_number what measured stated)
  thousandths(measured ${measured})
  thousandths(stated ${stated})
  math(EXPR tolerance "${measured} / 20 + 1")
  math(EXPR difference "${measured} - ${stated}")
  if(difference GREATER tolerance OR difference LESS -${tolerance})
    message(SEND_ERROR "${what} is ${measured} thousandths, not ${stated}")
  endif()
endfunction()

# Fails unless the text after `before` has the distance and the angle that the tool measures.
function(check_figures where text before between weight density placement)
  execute_process(COMMAND ${COARSEN_MESH} ${FANDISK} coarse.off -n 527 --weight ${weight} --maximum-density ${density}
    --placement ${placement} --measure --report report.json --quiet COMMAND_ERROR_IS_FATAL ANY)
  file(READ report.json report)
  string(JSON rms GET "${report}" quality distance_percent rms)
  string(JSON angle GET "${report}" quality smallest_angle_degrees mean)
  if(NOT "${text}" MATCHES "${before}([0-9.]+)${between}([0-9.]+)&deg")
    message(SEND_ERROR "${where} has no figures of ${weight}, ${placement}")
    return()
  endif()
  set(stated_rms ${CMAKE_MATCH_1})
  set(stated_angle ${CMAKE_MATCH_2})
  foreach(name rms angle)
    thousandths(measured ${${name}})
    thousandths(stated ${stated_${name}})
    set(tolerance_rms 4)
    set(tolerance_angle 200)
    math(EXPR difference "${measured} - ${stated}")
    if(difference GREATER tolerance_${name} OR difference LESS -${tolerance_${name}})
      message(SEND_ERROR "${where}, ${weight}, ${placement}: ${name} is ${${name}}, not ${stated_${name}}")
    endif()
  endforeach()
endfunction()

set(cell "[^|]*\\| ")
check_figures("the manual" "${manual}" "\n\\| area \\| ${cell}${cell}${cell}" ", " area 50 fitted)
check_figures("the manual" "${manual}" "\n\\| maximum \\| ${cell}" ", " maximum 50 closest-vertex)
check_figures("the manual" "${manual}" "\n\\| variance \\| " ", " variance 3 centroid)
check_figures("the manual" "${manual}" "\n\\| uniform \\| ${cell}${cell}" ", " uniform 1 quadric)
check_figures("the README" "${readme}" "weight maximum, vertices at centroids \\| " " \\| " maximum 50 centroid)
check_figures("the README" "${readme}" "weight area, vertices fitted \\| " " \\| " area 10 fitted)

# The distances of surfaces and of borders on open meshes of CGAL.
foreach(name lion-head mannequin-devil head mask_cone blade mech-holes-shark)
  if(NOT EXISTS ${CGAL_DATA_DIR}/meshes/${name}.off)
    message(STATUS "Did not find ${name}.off: its figures are not checked")
    continue()
  endif()
  if(NOT manual MATCHES "\n\\| ${name}, ([0-9]+) \\| ([0-9.]+) \\| ([0-9.]+) \\|")
    message(SEND_ERROR "the manual has no distances of ${name}")
    continue()
  endif()
  set(number ${CMAKE_MATCH_1})
  set(surface ${CMAKE_MATCH_2})
  set(border ${CMAKE_MATCH_3})
  execute_process(COMMAND ${COARSEN_MESH} ${CGAL_DATA_DIR}/meshes/${name}.off coarse.off -n ${number} --measure
    --report report.json --quiet COMMAND_ERROR_IS_FATAL ANY)
  file(READ report.json report)
  string(JSON measured GET "${report}" quality distance_percent rms)
  check_number("the distance of ${name}" ${measured} ${surface})
  string(JSON measured GET "${report}" quality border_distance_percent rms)
  check_number("the border's distance of ${name}" ${measured} ${border})
endforeach()

# The distances of levels, by the command below the table.
if(NOT manual MATCHES "\n    coarsen_mesh fandisk.off (coarse.off [^\n]*)")
  message(FATAL_ERROR "the manual has no command for levels")
endif()
separate_arguments(arguments UNIX_COMMAND "${CMAKE_MATCH_1}")
execute_process(COMMAND ${COARSEN_MESH} ${FANDISK} ${arguments} --quiet COMMAND_ERROR_IS_FATAL ANY)
file(READ report.json report)
foreach(level RANGE 0 4)
  if(level EQUAL 0)
    set(row finest)
    string(JSON measured GET "${report}" quality distance_percent rms)
  else()
    math(EXPR part "1 << ${level}")
    math(EXPR i "${level} - 1")
    set(row 1/${part})
    string(JSON measured GET "${report}" levels ${i} distance_percent rms)
  endif()
  if(NOT manual MATCHES "\n\\| ${row} \\| ([0-9.]+) ")
    message(SEND_ERROR "the manual has no distance of the level ${row}")
    continue()
  endif()
  check_number("the distance of the level ${row}" ${measured} ${CMAKE_MATCH_1})
endforeach()

# The numbers of vertices within a distance.
foreach(distance 0.01 0.005)
  execute_process(COMMAND ${COARSEN_MESH} ${FANDISK} coarse.off --maximum-distance ${distance} --report report.json --quiet
    COMMAND_ERROR_IS_FATAL ANY)
  file(READ report.json report)
  string(JSON vertices GET "${report}" output vertices)
  if(NOT manual MATCHES "\n\\| Fandisk, ${distance} \\| ${vertices} \\|")
    message(SEND_ERROR "within ${distance} the Fandisk has ${vertices} vertices")
  endif()
endforeach()
