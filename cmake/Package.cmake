# SPDX-License-Identifier: GPL-3.0-or-later

# cpack -G DEB makes Debian packages of the build tree: the library, which is headers and sources and fits every architecture, and the
# tool and the Python module if they have been built. With SURFACE_MESH_COARSENING_STATIC_TOOL, cpack -G TGZ makes
# an archive with the tool alone, which needs no other package.

if(NOT PROJECT_IS_TOP_LEVEL)
  return()
endif()

# To be set by publishers of packages: Debian's format requires an address, and this one does not receive mail.
set(SURFACE_MESH_COARSENING_PACKAGE_CONTACT "Surface_mesh_coarsening <surface-mesh-coarsening@localhost>" CACHE STRING
  "Who maintains the packages that cpack makes")
mark_as_advanced(SURFACE_MESH_COARSENING_PACKAGE_CONTACT)

set(CPACK_PACKAGE_NAME surface-mesh-coarsening)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT ${SURFACE_MESH_COARSENING_PACKAGE_CONTACT})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_SOURCE_DIR}/cmake/omit_unbuilt_packages.cmake)
set(CPACK_BUILD_TREE ${PROJECT_BINARY_DIR})
set(CPACK_COMPONENTS_ALL Development)
if(SURFACE_MESH_COARSENING_BUILD_EXAMPLES)
  list(APPEND CPACK_COMPONENTS_ALL Tools)
endif()
if(TARGET surface_mesh_coarsening_python)
  list(APPEND CPACK_COMPONENTS_ALL Python)
endif()

if(SURFACE_MESH_COARSENING_STATIC_TOOL)
  set(CPACK_COMPONENTS_ALL Tools)
  set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
  set(CPACK_PACKAGING_INSTALL_PREFIX /)
  set(CPACK_ARCHIVE_TOOLS_FILE_NAME coarsen_mesh-${PROJECT_VERSION}-${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR})
endif()

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libsurface-mesh-coarsening-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libcgal-dev (>= 5.5), libeigen3-dev (>= 3.3)")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS "libtbb-dev") # applications without it have one thread
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Coarse triangle meshes of fine polygon meshes: headers for use with CGAL")
set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME coarsen-mesh)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SECTION graphics)
set(CPACK_COMPONENT_TOOLS_DESCRIPTION "Coarse triangle meshes of fine polygon meshes: command-line tool")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-surface-mesh-coarsening)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "Coarse triangle meshes of fine polygon meshes: Python module")

# The libraries of the tool become its dependencies, if the programs that determine them are installed.
find_program(DPKG_SHLIBDEPS dpkg-shlibdeps)
find_program(FILE_COMMAND file)
mark_as_advanced(DPKG_SHLIBDEPS FILE_COMMAND)
if(DPKG_SHLIBDEPS AND FILE_COMMAND)
  set(CPACK_DEBIAN_TOOLS_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
endif()

include(CPack)

# All that is published of this version, with checksums, in packages/ of the build tree. The static tool has a build tree of its own.
if(TARGET coarsen_mesh AND NOT SURFACE_MESH_COARSENING_STATIC_TOOL)
  cmake_path(GET CMAKE_COMMAND PARENT_PATH cmake_bin)
  add_custom_target(packages
    COMMAND ${CMAKE_COMMAND} -D PACKAGES=${PROJECT_BINARY_DIR}/packages -D SOURCES=${PROJECT_SOURCE_DIR} -D CPACK=${cmake_bin}/cpack
      -D CONFIG=${PROJECT_BINARY_DIR}/CPackConfig.cmake -D PYTHON=${PYTHON_EXECUTABLE}
      -P ${PROJECT_SOURCE_DIR}/cmake/make_packages.cmake
    USES_TERMINAL VERBATIM COMMENT "Making the packages")
  add_dependencies(packages coarsen_mesh)
  if(TARGET surface_mesh_coarsening_python)
    add_dependencies(packages surface_mesh_coarsening_python)
  endif()
endif()
