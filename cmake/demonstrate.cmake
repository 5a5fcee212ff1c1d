# SPDX-License-Identifier: GPL-3.0-or-later

# Coarsens the Fandisk with the paper's three weights.
#   cmake -D COARSEN_MESH=PROGRAM -D INPUT=fandisk.off -D OUTPUT_DIR=DIRECTORY -P demonstrate.cmake

if(NOT EXISTS "${INPUT}")
  message(FATAL_ERROR "fandisk.off was not found when the project was configured. Debian's package libcgal-demo has it: "
    "install the package, or name a directory that holds the file with -DSURFACE_MESH_COARSENING_MODELS=DIRECTORY, "
    "and configure again.")
endif()
file(MAKE_DIRECTORY ${OUTPUT_DIR})

# The maximum density of each weight is as in the paper's Table 1.
set(maximum_density_for_area 50)
set(maximum_density_for_maximum 50)
set(maximum_density_for_variance 3)

foreach(weight area maximum variance)
  message("\nweight ${weight}, maximum density ${maximum_density_for_${weight}}:")
  set(base ${OUTPUT_DIR}/fandisk_${weight})
  execute_process(
    COMMAND ${COARSEN_MESH} ${INPUT} ${base}.off --vertices 527
      --weight ${weight} --maximum-density ${maximum_density_for_${weight}}
      --clusters ${base}_clusters.ply --picture ${base}.png --report ${base}.json
    RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "coarsen_mesh failed: ${result}")
  endif()
  foreach(suffix .off _clusters.ply .png .json)
    if(NOT EXISTS ${base}${suffix})
      message(FATAL_ERROR "coarsen_mesh did not write ${base}${suffix}")
    endif()
  endforeach()
endforeach()

message("\nFor each weight there is a mesh (.off), the input coloured by cluster (_clusters.ply), a picture of both (.png) "
  "and a report (.json) in\n  ${OUTPUT_DIR}\n")
