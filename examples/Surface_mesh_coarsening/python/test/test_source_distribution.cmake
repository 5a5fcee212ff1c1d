# SPDX-License-Identifier: GPL-3.0-or-later

# The source distribution of the Python module has all files that its build needs. The build is planned, and not executed.
#   cmake -D PYTHON=PROGRAM -D SOURCES=DIRECTORY -D WORK_DIR=DIRECTORY -D COMPILER=PROGRAM -P test_source_distribution.cmake

cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${SOURCES} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
file(MAKE_DIRECTORY ${WORK_DIR}/egg)
run(${PYTHON} setup.py -q egg_info --egg-base ${WORK_DIR}/egg sdist --dist-dir ${WORK_DIR})
file(GLOB archive ${WORK_DIR}/*.tar.gz)
file(ARCHIVE_EXTRACT INPUT ${archive} DESTINATION ${WORK_DIR})
file(GLOB unpacked ${WORK_DIR}/surface*mesh*coarsening-*/setup.py)
cmake_path(GET unpacked PARENT_PATH unpacked)

# As setup.py does.
run(${CMAKE_COMMAND} -S ${unpacked} -B ${WORK_DIR}/build -G Ninja
  -D CMAKE_CXX_COMPILER=${COMPILER}
  -D Python3_EXECUTABLE=${PYTHON}
  -D CGAL_DIR=${CGAL_DIR}
  -D pybind11_DIR=${pybind11_DIR}
  -D SURFACE_MESH_COARSENING_BUILD_BENCHMARKS=OFF
  -D SURFACE_MESH_COARSENING_BUILD_EXAMPLES=OFF
  -D SURFACE_MESH_COARSENING_BUILD_TESTS=OFF)
run(${CMAKE_COMMAND} --build ${WORK_DIR}/build --target surface_mesh_coarsening_python -- -n)
