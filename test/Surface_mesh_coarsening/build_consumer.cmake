# SPDX-License-Identifier: GPL-3.0-or-later

# Configures, builds and runs the application in consumer/, which gets the library by find_package from a prefix, or by
# add_subdirectory or FetchContent from the sources. From an unpacked Debian package it is only configured: the package has to
# hold the same files as the prefix, byte for byte, and with those the application is built.

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
if(WAY STREQUAL "find_package")
  # The installed files must not depend on the prefix.
  run(${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR} --prefix ${WORK_DIR}/installed)
  file(RENAME ${WORK_DIR}/installed ${WORK_DIR}/moved)
  set(way_option -D CMAKE_PREFIX_PATH=${WORK_DIR}/moved)
  # Without CMake, pkg-config names the headers and the source of the compiled part.
  find_program(PKG_CONFIG pkg-config)
  if(PKG_CONFIG)
    foreach(variable IN ITEMS includedir core)
      execute_process(COMMAND ${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${WORK_DIR}/moved/share/pkgconfig
        ${PKG_CONFIG} --variable=${variable} surface-mesh-coarsening
        OUTPUT_VARIABLE path OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
      if(NOT path MATCHES "^${WORK_DIR}/moved/" OR NOT EXISTS ${path})
        message(FATAL_ERROR "pkg-config names '${path}' for ${variable}")
      endif()
    endforeach()
  endif()
elseif(WAY STREQUAL "debian_package")
  # Unpacked instead of installed, which needs no rights on the machine.
  cmake_path(GET CMAKE_COMMAND PARENT_PATH bin)
  run(${bin}/cpack -G DEB --config ${PROJECT_BINARY_DIR}/CPackConfig.cmake -B ${WORK_DIR}/packages)
  file(GLOB packages ${WORK_DIR}/packages/*.deb)
  foreach(package IN LISTS packages)
    run(dpkg-deb --info ${package})
    run(dpkg-deb --extract ${package} ${WORK_DIR}/root)
    cmake_path(GET package FILENAME name)
    string(REGEX REPLACE "_.*" "" name ${name})
    run(${CMAKE_COMMAND} -E compare_files ${PROJECT_SOURCE_DIR}/LICENSE ${WORK_DIR}/root/usr/share/doc/${name}/copyright)
  endforeach()
  # Of a build tree without programs, only the library is packed.
  run(${bin}/cpack -G DEB --config ${PROJECT_BINARY_DIR}/CPackConfig.cmake -D CPACK_BUILD_TREE=${WORK_DIR}/root -B ${WORK_DIR}/library)
  file(GLOB packed RELATIVE ${WORK_DIR}/library ${WORK_DIR}/library/*.deb)
  if(NOT packed MATCHES "^libsurface-mesh-coarsening-dev_[^;]*$")
    message(FATAL_ERROR "The packages of a library without programs are: ${packed}")
  endif()
  set(way_option -D CMAKE_PREFIX_PATH=${WORK_DIR}/root/usr)
  run(${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR} --prefix ${WORK_DIR}/installed --component Development)
  file(GLOB_RECURSE files RELATIVE ${WORK_DIR}/installed ${WORK_DIR}/installed/*)
  list(LENGTH files number)
  if(number LESS 50)
    message(FATAL_ERROR "only ${number} files were installed: ${files}")
  endif()
  foreach(file IN LISTS files)
    run(${CMAKE_COMMAND} -E compare_files ${WORK_DIR}/installed/${file} ${WORK_DIR}/root/usr/${file})
  endforeach()
  # Also what the prefix does not have.
  foreach(directory include share/cmake)
    file(GLOB_RECURSE installed RELATIVE ${WORK_DIR}/installed ${WORK_DIR}/installed/${directory}/*)
    file(GLOB_RECURSE packed RELATIVE ${WORK_DIR}/root/usr ${WORK_DIR}/root/usr/${directory}/*)
    if(NOT installed STREQUAL packed)
      message(FATAL_ERROR "The packages have other files in ${directory} than a prefix: ${packed}")
    endif()
  endforeach()
  if(TOOL)
    run(${WORK_DIR}/root/usr/bin/coarsen_mesh --version)
    foreach(file share/man/man1/coarsen_mesh.1 share/bash-completion/completions/coarsen_mesh)
      if(NOT EXISTS ${WORK_DIR}/root/usr/${file})
        message(FATAL_ERROR "The packages do not have ${file}")
      endif()
    endforeach()
  endif()
  if(PYTHON)
    run(${CMAKE_COMMAND} -E env PYTHONPATH=${WORK_DIR}/root/usr/lib/python3/dist-packages ${PYTHON} -c
      "import surface_mesh_coarsening; print(surface_mesh_coarsening.__version__)")
  endif()
elseif(WAY STREQUAL "FetchContent")
  # As in an application without a network; the repository named in consumer/ is not accessed. Uses the headers alone.
  set(way_option -D FETCH=ON -D SURFACE_MESH_COARSENING_HEADER_ONLY=ON -D FETCHCONTENT_SOURCE_DIR_SURFACE_MESH_COARSENING=${PROJECT_SOURCE_DIR})
else()
  set(way_option -D SURFACE_MESH_COARSENING_SOURCE_DIR=${PROJECT_SOURCE_DIR})
endif()

run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${WORK_DIR}/build -G ${GENERATOR}
  -D CMAKE_BUILD_TYPE=None # which compiles fastest
  -D CMAKE_CXX_COMPILER=${COMPILER}
  -D CMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}
  -D CGAL_DIR=${CGAL_DIR}
  ${way_option})
if(WAY STREQUAL "debian_package")
  file(STRINGS ${WORK_DIR}/build/CMakeCache.txt found REGEX "^Surface_mesh_coarsening_DIR:")
  if(NOT found STREQUAL "Surface_mesh_coarsening_DIR:PATH=${WORK_DIR}/root/usr/share/cmake/Surface_mesh_coarsening")
    message(FATAL_ERROR "The application does not use the package: ${found}")
  endif()
  return()
endif()
run(${CMAKE_COMMAND} --build ${WORK_DIR}/build --parallel 1)
run(${WORK_DIR}/build/consumer)

# An application's build contains only the library of the project.
file(GLOB_RECURSE others ${WORK_DIR}/build/*coarsen_mesh* ${WORK_DIR}/build/*test_*.o)
if(others)
  message(FATAL_ERROR "The application's build holds more than the application: ${others}")
endif()
