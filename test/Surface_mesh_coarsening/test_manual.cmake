# SPDX-License-Identifier: GPL-3.0-or-later

# The manual agrees with the programs: the short tables of the manual, measured again, agree with it to the accuracy of sampling,
# table 1 of the paper agrees exactly, the table in README agrees with the table of speed and with the tool, and numbers in the text
# agree with the code.
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

# Reads the rows with figures, without the semicolons of &deg; that would divide them, and without times.
function(read_rows result file)
  file(READ ${file} text)
  string(REPLACE ";" "" text "${text}")
  string(REGEX MATCHALL "\\|[^\n]*" lines "${text}")
  list(GET lines 0 heading)
  string(REPLACE "|" ";" heading "${heading}")
  set(rows "")
  foreach(line IN LISTS lines)
    string(REPLACE "|" ";" cells "${line}")
    set(row "")
    foreach(title cell IN ZIP_LISTS heading cells)
      if(NOT title MATCHES ", s *$")
        string(APPEND row "${cell}|")
      endif()
    endforeach()
    if(row MATCHES "[0-9]")
      list(APPEND rows "${row}")
    endif()
  endforeach()
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

file(REMOVE_RECURSE ${CMAKE_CURRENT_BINARY_DIR}/tables)
set(tables weights_and_placements energies borders distance levels tolerance)
foreach(name features frozen_weights) # by programs of the benchmarks, which may be left out of the build
  if(EXISTS ${BIN}/measure_${name})
    list(APPEND tables ${name})
  endif()
endforeach()
list(JOIN tables " " names)
execute_process(COMMAND ${CMAKE_COMMAND} -D BIN=${BIN} -D MESHES=${CGAL_DATA_DIR}/meshes -D MODELS= -D SHORT=ON "-D NAMES=${names}"
  -D OUT=${CMAKE_CURRENT_BINARY_DIR}/tables -P ${PROJECT_SOURCE_DIR}/benchmark/Surface_mesh_coarsening/make_tables.cmake
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
foreach(name IN LISTS tables)
  check_table(${name})
endforeach()

# Table 1 of the paper: the rows without times are equal, in the columns of the models that are found.
function(read_paper result file)
  file(STRINGS ${file} lines REGEX "\\|")
  set(rows "")
  foreach(line IN LISTS lines)
    if(NOT line MATCHES "^(initialization, s|  s) ")
      string(REGEX REPLACE " *\\| *" "|" line "${line}")
      list(APPEND rows "${line}")
    endif()
  endforeach()
  set(${result} "${rows}" PARENT_SCOPE)
endfunction()

function(check_paper)
  execute_process(COMMAND ${BIN}/reproduce_paper ${CGAL_DATA_DIR}/meshes OUTPUT_FILE paper.txt COMMAND_ERROR_IS_FATAL ANY)
  read_paper(measured paper.txt)
  read_paper(stated ${doc}/tables/paper.md)
  list(LENGTH measured n)
  list(LENGTH stated m)
  if(NOT n EQUAL m OR n LESS 20)
    message(SEND_ERROR "reproduce_paper prints ${n} rows, the manual has ${m}")
  endif()
  list(GET measured 0 models)
  list(GET stated 0 stated_models)
  string(REPLACE "|" ";" models "${models}")
  string(REPLACE "|" ";" stated_models "${stated_models}")
  foreach(row stated_row IN ZIP_LISTS measured stated)
    string(REPLACE "|" ";" row "${row}")
    string(REPLACE "|" ";" stated_row "${stated_row}")
    foreach(model cell IN ZIP_LISTS models row)
      list(FIND stated_models "${model}" i)
      list(GET stated_row ${i} stated_cell)
      if(NOT cell STREQUAL stated_cell)
        message(SEND_ERROR "table 1, ${model}: reproduce_paper prints '${cell}', the manual has '${stated_cell}' in\n${stated_row}")
      endif()
    endforeach()
  endforeach()
endfunction()

if(EXISTS ${BIN}/reproduce_paper)
  check_paper()
endif()

# Fails unless a page states the number that a file has, where `text` and `code` match with the number as their first group. The
# file is a header, or is named from the root of the project.
function(check_constant page text header code)
  file(READ ${doc}/${page} page_text)
  string(REGEX REPLACE "[ \n]+" " " page_text "${page_text}")
  if(NOT header MATCHES "^(test|doc|examples)/")
    set(header include/CGAL/Surface_mesh_coarsening/${header})
  endif()
  file(READ ${PROJECT_SOURCE_DIR}/${header} header_text)
  if(NOT header_text MATCHES "${code}")
    message(SEND_ERROR "${header} does not have '${code}'")
    return()
  endif()
  set(number ${CMAKE_MATCH_1})
  if(NOT page_text MATCHES "${text}")
    message(SEND_ERROR "${page} does not have '${text}'")
  elseif(NOT CMAKE_MATCH_1 STREQUAL number)
    message(SEND_ERROR "${page} has '${CMAKE_MATCH_0}', but ${header} has ${number}")
  endif()
endfunction()

set(angles internal/placement/Trial_fan.h)
check_constant(Surface_mesh_coarsening.txt "smallest angle of the triangles stays at ([0-9]+) degrees" defaults.h
  "mean_angle = ([0-9]+)")
check_constant(Surface_mesh_coarsening.txt "create no angle below ([0-9]+) degrees" ${angles} "min_angle = ([0-9]+)")
check_constant(Surface_mesh_coarsening.txt "triangles with angles below ([0-9]+) degrees move" ${angles} "narrow_angle = ([0-9]+)")
check_constant(Surface_mesh_coarsening.txt "remaining triangles with angles below ([0-9]+) degrees" ${angles} "min_angle = ([0-9]+)")
check_constant(Robustness.txt "after `number_of_iterations` rounds, ([0-9]+) by default" defaults.h "number_of_iterations = ([0-9]+)")
set(manual Surface_mesh_coarsening.txt)
set(theory Theory_and_proofs.txt)
check_constant(${manual} "more than one pair for ([0-9]+) vertices remains" internal/pipeline/place_and_exchange.h
  "([0-9]+) \\* dual.number_left\\(\\) > state.number_of_clusters")
check_constant(${manual} "reclusters the mesh, up to ([0-9]+) times" internal/pipeline/stages_impl.h "max_repetitions = ([0-9]+)")
check_constant(${manual} "near curved borders, up to ([0-9]+) times" internal/mesh/Clustering_input_impl.h "max_raised = ([0-9]+)")
check_constant(${manual} "at most ([0-9]+) % larger than the number before" internal/distance/find_within_distance_impl.h
  "max_ratio = 1\\.0([0-9]+)")
check_constant(${manual} "rho_j\\^{([0-9]+)} \\)" Cluster_weight/Maximum_density_weight.h "double p = ([0-9]+)")
check_constant(${theory} "f. p = ([0-9]+) .f" Cluster_weight/Maximum_density_weight.h "double p = ([0-9]+)")
check_constant(${theory} "f. ([0-9]+) \\+ 26 g" internal/seeding/Component_plan.h "return ([0-9]+) \\+ 26")
check_constant(${theory} "\\+ ([0-9]+) g \\+ 8 b" internal/seeding/Component_plan.h "\\+ ([0-9]+) \\* c.genus")
check_constant(${theory} "g \\+ ([0-9]+) b .f" internal/seeding/Component_plan.h "\\+ ([0-9]+) \\* c.loops")
check_constant(${theory} "and ([0-9]+) more for each cluster that a feature" internal/seeding/Component_plan.h
  "\\+ ([0-9]+) \\* c.feature_clusters")
check_constant(${theory} "vertices at 1/([0-9]+) of the edges" internal/mesh/subdivision.h "\\(1\\. / ([0-9]+)\\) \\*")
check_constant(${theory} "at most ([0-9]+) bytes per face in addition" test/Surface_mesh_coarsening/test_memory.cpp
  "\"torus\"[^;]*defaults\\) <= ([0-9]+)")
check_constant(${theory} "and at most ([0-9]+) bytes with the placements" test/Surface_mesh_coarsening/test_memory.cpp
  "quadric\", mesh[^;]*<= ([0-9]+)")
check_constant(Robustness.txt "beyond .f. 2\\^{([0-9]+)}" internal/mesh/Vector.h "exponent > ([0-9]+)")

# Fails unless a page has a phrase and a header has the code that the phrase describes.
function(check_phrase page phrase header code)
  file(READ ${doc}/${page} text)
  string(REGEX REPLACE "[ \n]+" " " text "${text}")
  string(FIND "${text}" "${phrase}" place)
  file(READ ${PROJECT_SOURCE_DIR}/include/CGAL/Surface_mesh_coarsening/${header} header_text)
  string(FIND "${header_text}" "${code}" place_of_code)
  if(place EQUAL -1 OR place_of_code EQUAL -1)
    message(SEND_ERROR "${page} has to have '${phrase}', and ${header} '${code}'")
  endif()
endfunction()

check_phrase(${manual} "or turns by more than 60 degrees" internal/features/find_features_impl.h "dot(a, b) < 0.5 * std::sqrt")
check_phrase(${theory} "uses the seeds of the largest level that gives twice this number" internal/seeding/Component_plan.h
  "seeds_per_cluster = 2;")
check_phrase(${theory} "the largest level that gives five times the number" internal/seeding/Component_plan.h "seeds_for_quadrics = 5;")
check_phrase(Robustness.txt "The mesh is clustered at most four times" internal/pipeline/stages_impl.h "max_repetitions = 2;")

# The numbers of seeds in the text are the numbers of table 1.
check_constant(Following_the_paper.txt "Bunny lies in between: it gives ([0-9]+) seeds" doc/Surface_mesh_coarsening/tables/paper.md
  "594 / ([0-9]+)")
check_constant(Following_the_paper.txt "breadth-first order gives ([0-9]+)" doc/Surface_mesh_coarsening/tables/paper.md
  "breadth-first[^|]*\\|[^|]*\\|[^|]*\\| *([0-9]+)")
check_constant(Following_the_paper.txt "finds ([0-9]+) seeds in the file of" doc/Surface_mesh_coarsening/tables/paper.md
  "527 / ([0-9]+)")

# The table in README has the rows of the table of speed.
file(COPY_FILE ${PROJECT_SOURCE_DIR}/README.md README.md)
execute_process(COMMAND ${CMAKE_COMMAND} -D BIN=${BIN} -D NAMES=readme -D SPEED=${doc}/tables/speed.md -D README=README.md
  -D OUT=${CMAKE_CURRENT_BINARY_DIR}/readme_table -P ${PROJECT_SOURCE_DIR}/benchmark/Surface_mesh_coarsening/make_tables.cmake
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files README.md ${PROJECT_SOURCE_DIR}/README.md RESULT_VARIABLE differs
  ERROR_QUIET)
if(differs)
  message(SEND_ERROR "the table in README does not have the rows of tables/speed.md: target table_readme writes it")
endif()

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
