# SPDX-License-Identifier: GPL-3.0-or-later
#
# Runs the steps of conanfile.py without Conan: copies the sources that it exports, configures them with its options, and installs.

file(READ ${PROJECT_SOURCE_DIR}/conanfile.py recipe)
string(REGEX MATCH "exports_sources = ([^\n]*)" exported "${recipe}")
string(REGEX MATCHALL "\"[^\"]+\"" exported "${CMAKE_MATCH_1}")
string(REGEX MATCHALL "\"SURFACE_MESH_COARSENING_[A-Z_]+\": \"O[NF]+\"" settings "${recipe}")
if(NOT exported OR NOT settings)
  message(FATAL_ERROR "conanfile.py exports no sources, or sets no options")
endif()

file(REMOVE_RECURSE ${WORK_DIR})
foreach(pattern IN LISTS exported)
  string(REGEX REPLACE "\"|/\\*" "" entry ${pattern})
  file(COPY ${PROJECT_SOURCE_DIR}/${entry} DESTINATION ${WORK_DIR}/source)
endforeach()
set(arguments)
foreach(setting IN LISTS settings)
  string(REGEX REPLACE "\"(.*)\": \"(.*)\"" "-D;\\1=\\2" argument ${setting})
  list(APPEND arguments ${argument})
endforeach()
execute_process(COMMAND ${CMAKE_COMMAND} -S ${WORK_DIR}/source -B ${WORK_DIR}/build -G ${GENERATOR}
  -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_BUILD_TYPE=Release -D CGAL_DIR=${CGAL_DIR} ${arguments} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${WORK_DIR}/build --prefix ${WORK_DIR}/package COMMAND_ERROR_IS_FATAL ANY)
foreach(file IN ITEMS include/CGAL/Surface_mesh_coarsening/coarsen_mesh.h
    share/cmake/Surface_mesh_coarsening/Surface_mesh_coarseningConfig.cmake)
  if(NOT EXISTS ${WORK_DIR}/package/${file})
    message(FATAL_ERROR "The package has no ${file}")
  endif()
endforeach()
