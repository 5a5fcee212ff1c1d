# SPDX-License-Identifier: GPL-3.0-or-later

# Makes the archive of the static tool, the Debian packages and, if PYTHON has setuptools, the source distribution of the Python
# module, and a file of their checksums, which `sha256sum -c SHA256SUMS` checks.
#   cmake -D PACKAGES=DIRECTORY -D SOURCES=DIRECTORY -D CPACK=PROGRAM -D CONFIG=CPackConfig.cmake [-D PYTHON=PROGRAM] -P make_packages.cmake

cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE ${PACKAGES})
file(MAKE_DIRECTORY ${PACKAGES})
foreach(step IN ITEMS "--preset static" "--build --preset static")
  separate_arguments(arguments UNIX_COMMAND "${step}")
  execute_process(COMMAND ${CMAKE_COMMAND} ${arguments} WORKING_DIRECTORY ${SOURCES} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
execute_process(COMMAND ${CPACK} -G TGZ --config ${SOURCES}/build/static/CPackConfig.cmake -B ${PACKAGES} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CPACK} -G DEB --config ${CONFIG} -B ${PACKAGES} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${PYTHON} -c "import setuptools" RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
if(NOT failed)
  file(MAKE_DIRECTORY ${PACKAGES}/egg)
  execute_process(COMMAND ${PYTHON} setup.py -q egg_info --egg-base ${PACKAGES}/egg sdist --dist-dir ${PACKAGES}
    WORKING_DIRECTORY ${SOURCES} COMMAND_ERROR_IS_FATAL ANY)
else()
  message(STATUS "Did not find setuptools: the source distribution of the Python module is not made")
endif()

file(REMOVE_RECURSE ${PACKAGES}/_CPack_Packages ${PACKAGES}/egg)
file(GLOB files RELATIVE ${PACKAGES} ${PACKAGES}/*.deb ${PACKAGES}/*.tar.gz)
set(sums "")
foreach(file IN LISTS files)
  file(SHA256 ${PACKAGES}/${file} sum)
  string(APPEND sums "${sum}  ${file}\n")
endforeach()
file(WRITE ${PACKAGES}/SHA256SUMS "${sums}")
