# SPDX-License-Identifier: GPL-3.0-or-later

# The library for applications: the headers, and the core that depends on no type of mesh, compiled once. The application's
# build compiles it with its compiler and options, and with threads if oneTBB is found.

option(SURFACE_MESH_COARSENING_HEADER_ONLY "Use the headers of Surface_mesh_coarsening alone, without a compiled core" OFF)
if(NOT TARGET Surface_mesh_coarsening::Surface_mesh_coarsening)
  if(SURFACE_MESH_COARSENING_HEADER_ONLY)
    add_library(Surface_mesh_coarsening_library INTERFACE)
    target_link_libraries(Surface_mesh_coarsening_library INTERFACE Surface_mesh_coarsening::headers)
  else()
    add_library(Surface_mesh_coarsening_library STATIC EXCLUDE_FROM_ALL ${CMAKE_CURRENT_LIST_DIR}/compiled_core.cpp)
    target_link_libraries(Surface_mesh_coarsening_library PUBLIC Surface_mesh_coarsening::headers)
    target_compile_definitions(Surface_mesh_coarsening_library PUBLIC CGAL_SURFACE_MESH_COARSENING_COMPILED_CORE)
    set_target_properties(Surface_mesh_coarsening_library PROPERTIES POSITION_INDEPENDENT_CODE ON) # for plugins and modules
    find_package(TBB QUIET)
    if(TBB_FOUND)
      include(CGAL_TBB_support)
    endif()
    if(TARGET CGAL::TBB_support)
      target_link_libraries(Surface_mesh_coarsening_library PUBLIC CGAL::TBB_support)
      message(STATUS "Found oneTBB: many threads can be used")
    else()
      message(STATUS "Did not find oneTBB (Debian package libtbb-dev): one thread is used")
    endif()
  endif()
  add_library(Surface_mesh_coarsening::Surface_mesh_coarsening ALIAS Surface_mesh_coarsening_library)
endif()
