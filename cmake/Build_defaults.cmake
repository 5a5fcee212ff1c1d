# SPDX-License-Identifier: GPL-3.0-or-later

# Settings of the project's own builds that must not affect an application with the project as a subdirectory.

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Kind of build" FORCE)
endif()

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON) # for clang-tidy

# Headers of CGAL, Boost and Eigen are system headers of imported targets: only the project's headers can warn.
add_compile_options(-Wall -Wextra)

# Distributions have no static oneTBB and Assimp.
if(SURFACE_MESH_COARSENING_STATIC_TOOL)
  set(CMAKE_FIND_LIBRARY_SUFFIXES .a)
  set(CGAL_Boost_USE_STATIC_LIBS ON)
  set(CMAKE_DISABLE_FIND_PACKAGE_TBB ON)
  set(SURFACE_MESH_COARSENING_ASSIMP OFF)
endif()

find_program(CCACHE ccache)
mark_as_advanced(CCACHE)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

# A translation unit takes up to 2 GB: on a machine with many cores, memory limits the parallel compilations.
if(CMAKE_GENERATOR MATCHES Ninja)
  cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)
  cmake_host_system_information(RESULT megabytes QUERY TOTAL_PHYSICAL_MEMORY)
  math(EXPR compilations "${megabytes} / 2000")
  if(compilations GREATER cores)
    set(compilations ${cores})
  elseif(compilations LESS 1)
    set(compilations 1)
  endif()
  set_property(GLOBAL APPEND PROPERTY JOB_POOLS compilations=${compilations})
  set(CMAKE_JOB_POOL_COMPILE compilations)
endif()
