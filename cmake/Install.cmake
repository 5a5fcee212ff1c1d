# SPDX-License-Identifier: GPL-3.0-or-later

# Installs the headers and the files for find_package(Surface_mesh_coarsening). No installed file contains an
# absolute path, so the prefix can be moved.

include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(config_dir ${CMAKE_INSTALL_DATADIR}/cmake/Surface_mesh_coarsening)

install(TARGETS Surface_mesh_coarsening
  EXPORT Surface_mesh_coarsening_targets
  FILE_SET HEADERS COMPONENT Development
  FILE_SET internal_headers COMPONENT Development)
install(EXPORT Surface_mesh_coarsening_targets
  FILE Surface_mesh_coarseningTargets.cmake
  NAMESPACE Surface_mesh_coarsening::
  DESTINATION ${config_dir}
  COMPONENT Development)

configure_package_config_file(
  ${CMAKE_CURRENT_LIST_DIR}/Surface_mesh_coarseningConfig.cmake.in
  ${PROJECT_BINARY_DIR}/cmake/Surface_mesh_coarseningConfig.cmake
  INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/cmake/Surface_mesh_coarseningConfigVersion.cmake
  COMPATIBILITY SameMinorVersion
  ARCH_INDEPENDENT)
install(FILES
  ${PROJECT_BINARY_DIR}/cmake/Surface_mesh_coarseningConfig.cmake
  ${PROJECT_BINARY_DIR}/cmake/Surface_mesh_coarseningConfigVersion.cmake
  ${PROJECT_SOURCE_DIR}/cmake/Surface_mesh_coarseningCore.cmake
  ${PROJECT_SOURCE_DIR}/cmake/compiled_core.cpp
  DESTINATION ${config_dir}
  COMPONENT Development)
# The license is part of each package, under the name that Debian requires.
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE RENAME copyright COMPONENT Development
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libsurface-mesh-coarsening-dev)

# The manual page of the tool and the completion of its command line.
if(SURFACE_MESH_COARSENING_BUILD_EXAMPLES AND PROJECT_IS_TOP_LEVEL)
  install(FILES ${PROJECT_SOURCE_DIR}/packaging/coarsen_mesh.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1
    COMPONENT Tools)
  install(FILES ${PROJECT_SOURCE_DIR}/packaging/coarsen_mesh.bash RENAME coarsen_mesh
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT Tools)
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE RENAME copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/coarsen-mesh
    COMPONENT Tools)
endif()

# For users without CMake: the headers alone, with the libraries that CGAL needs.
configure_file(${CMAKE_CURRENT_LIST_DIR}/surface-mesh-coarsening.pc.in
  ${PROJECT_BINARY_DIR}/cmake/surface-mesh-coarsening.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/cmake/surface-mesh-coarsening.pc DESTINATION ${CMAKE_INSTALL_DATADIR}/pkgconfig
  COMPONENT Development)

# surface_mesh_coarsening_install_program(NAME COMPONENT): a program, if built, with its manual page. The programs that need MPI or Qt
# are components of their own, so that the package of the tool depends on neither.
function(surface_mesh_coarsening_install_program name component)
  add_custom_command(TARGET ${name} POST_BUILD
    COMMAND ${CMAKE_COMMAND} -E copy ${PROJECT_SOURCE_DIR}/packaging/${name}.1 ${PROJECT_BINARY_DIR}/bin/${name}.1)
  install(PROGRAMS ${PROJECT_BINARY_DIR}/bin/${name}${CMAKE_EXECUTABLE_SUFFIX} DESTINATION ${CMAKE_INSTALL_BINDIR}
    COMPONENT ${component} OPTIONAL)
  install(FILES ${PROJECT_BINARY_DIR}/bin/${name}.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT ${component} OPTIONAL)
endfunction()
