# SPDX-License-Identifier: GPL-3.0-or-later

# The target doc builds the manual in doc/html of the build tree. It fails on any warning of Doxygen, and so does the CTest
# test documentation. Neither exists without Doxygen or the sources of the manual, or within another project.

if(NOT PROJECT_IS_TOP_LEVEL OR NOT EXISTS ${PROJECT_SOURCE_DIR}/doc/Surface_mesh_coarsening/Doxyfile.in)
  return()
endif()
find_package(Doxygen 1.9.4 QUIET)
if(NOT DOXYGEN_FOUND)
  message(STATUS "Did not find Doxygen 1.9.4: the manual is not made")
  return()
endif()

set(documentation_dir ${PROJECT_BINARY_DIR}/doc)
set(documentation_source_dir ${PROJECT_SOURCE_DIR}/doc/Surface_mesh_coarsening)
file(MAKE_DIRECTORY ${documentation_dir}/html)

# Figures are optional, and Doxygen warns about a missing directory.
set(documentation_image_path "")
if(IS_DIRECTORY ${documentation_source_dir}/fig)
  set(documentation_image_path "\"${documentation_source_dir}/fig\"")
endif()

# MathJax 2 renders formulas. The required parts are copied to the pages, which are then complete without a network and
# can be moved. Debian's package libjs-mathjax provides it.
find_path(MATHJAX_DIR MathJax.js PATHS /usr/share/javascript/mathjax /usr/share/mathjax NO_DEFAULT_PATH)
mark_as_advanced(MATHJAX_DIR)
if(MATHJAX_DIR)
  set(documentation_mathjax mathjax/)
  file(COPY ${MATHJAX_DIR}/MathJax.js ${MATHJAX_DIR}/extensions DESTINATION ${documentation_dir}/html/mathjax)
  file(COPY ${MATHJAX_DIR}/jax/element/mml DESTINATION ${documentation_dir}/html/mathjax/jax/element)
  file(COPY ${MATHJAX_DIR}/jax/input/TeX DESTINATION ${documentation_dir}/html/mathjax/jax/input)
  file(COPY ${MATHJAX_DIR}/jax/output/SVG DESTINATION ${documentation_dir}/html/mathjax/jax/output
    REGEX "/SVG/fonts/" EXCLUDE)
  file(COPY ${MATHJAX_DIR}/jax/output/SVG/fonts/TeX DESTINATION ${documentation_dir}/html/mathjax/jax/output/SVG/fonts)
else()
  message(STATUS "Did not find MathJax (libjs-mathjax): the manual's formulas will be fetched from the network")
  set(documentation_mathjax https://cdn.jsdelivr.net/npm/mathjax@2/)
endif()

configure_file(${documentation_source_dir}/Doxyfile.in ${documentation_dir}/Doxyfile @ONLY)
add_custom_target(doc COMMAND Doxygen::doxygen ${documentation_dir}/Doxyfile
  WORKING_DIRECTORY ${documentation_dir} USES_TERMINAL VERBATIM COMMENT "Making the manual in ${documentation_dir}/html")

if(SURFACE_MESH_COARSENING_BUILD_TESTS)
  add_test(NAME documentation COMMAND Doxygen::doxygen ${documentation_dir}/Doxyfile
    WORKING_DIRECTORY ${documentation_dir})
  find_program(BASH bash)
  mark_as_advanced(BASH)
  if(BASH)
    add_test(NAME documentation_links COMMAND ${BASH} ${PROJECT_SOURCE_DIR}/test/Surface_mesh_coarsening/test_links.bash
      ${PROJECT_SOURCE_DIR} ${documentation_dir}/html)
    set_tests_properties(documentation PROPERTIES FIXTURES_SETUP manual)
    set_tests_properties(documentation_links PROPERTIES FIXTURES_REQUIRED manual)
  endif()
endif()
