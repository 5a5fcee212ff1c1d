# SPDX-License-Identifier: GPL-3.0-or-later

# Targets for static analysis, `tidy` and `cppcheck`, and a test that runs the tool under valgrind. Each exists if its
# program was found.

find_program(CLANG_TIDY clang-tidy)
find_program(CPPCHECK cppcheck)
find_program(VALGRIND valgrind)
mark_as_advanced(CLANG_TIDY CPPCHECK VALGRIND)

file(GLOB analyzed CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/examples/Surface_mesh_coarsening/*.cpp)
file(GLOB_RECURSE tool CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/examples/Surface_mesh_coarsening/coarsen_mesh/*.cpp)

if(CLANG_TIDY)
  add_custom_target(tidy
    COMMAND ${CLANG_TIDY} --quiet -p ${PROJECT_BINARY_DIR} --extra-arg=-Wno-unknown-warning-option ${analyzed} ${tool}
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} USES_TERMINAL VERBATIM COMMENT "clang-tidy")
endif()

if(CPPCHECK)
  # It reports unknown assertion macros as errors, so assertions are disabled.
  add_custom_target(cppcheck
    COMMAND ${CPPCHECK} --quiet --enable=warning,performance,portability --std=c++17 --language=c++
      "-DCGAL_assertion_code(x)=" "-DCGAL_assertion(x)=" --suppressions-list=.cppcheck-suppressions --error-exitcode=1
      -Iinclude -Iexamples/Surface_mesh_coarsening/coarsen_mesh include examples/Surface_mesh_coarsening
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} USES_TERMINAL VERBATIM COMMENT "cppcheck")
endif()

if(VALGRIND AND TARGET coarsen_mesh AND NOT CMAKE_CXX_FLAGS MATCHES "sanitize")
  # Valgrind does not emulate rounding modes, which an assertion of CGAL tests at the start of a program.
  set(targets coarsen_mesh coarsen_mesh_parts)
  if(NOT SURFACE_MESH_COARSENING_HEADER_ONLY)
    list(APPEND targets Surface_mesh_coarsening_library)
  endif()
  foreach(target IN LISTS targets)
    target_compile_definitions(${target} PRIVATE CGAL_DISABLE_ROUNDING_MATH_CHECK)
  endforeach()
  set(small_mesh ${PROJECT_BINARY_DIR}/octahedron.off)
  file(WRITE ${small_mesh} "OFF\n6 8 0\n1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n3 0 2 4\n3 2 1 4\n3 1 3 4\n3 3 0 4\n"
    "3 2 0 5\n3 1 2 5\n3 3 1 5\n3 0 3 5\n")
  surface_mesh_coarsening_add_run(valgrind COMMAND ${VALGRIND} --quiet --error-exitcode=9 --leak-check=full
    --show-leak-kinds=definite,possible --errors-for-leak-kinds=definite,possible
    $<TARGET_FILE:coarsen_mesh> ${small_mesh} coarse.off -n 5 --threads 1 --report report.json --clusters clusters.ply)
endif()
