# SPDX-License-Identifier: GPL-3.0-or-later

# Makes the archive of the static tool and the Debian packages, and a file of their checksums, which `sha256sum -c SHA256SUMS` checks.
#   cmake -D PACKAGES=DIRECTORY -D SOURCES=DIRECTORY -D CPACK=PROGRAM -D CONFIG=CPackConfig.cmake -P make_packages.cmake

cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE ${PACKAGES})
file(MAKE_DIRECTORY ${PACKAGES})
foreach(step IN ITEMS "--preset static" "--build --preset static")
  separate_arguments(arguments UNIX_COMMAND "${step}")
  execute_process(COMMAND ${CMAKE_COMMAND} ${arguments} WORKING_DIRECTORY ${SOURCES} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
execute_process(COMMAND ${CPACK} -G TGZ --config ${SOURCES}/build/static/CPackConfig.cmake -B ${PACKAGES} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CPACK} -G DEB --config ${CONFIG} -B ${PACKAGES} COMMAND_ERROR_IS_FATAL ANY)

file(REMOVE_RECURSE ${PACKAGES}/_CPack_Packages)
file(GLOB files RELATIVE ${PACKAGES} ${PACKAGES}/*.deb ${PACKAGES}/*.tar.gz)
set(sums "")
foreach(file IN LISTS files)
  file(SHA256 ${PACKAGES}/${file} sum)
  string(APPEND sums "${sum}  ${file}\n")
endforeach()
file(WRITE ${PACKAGES}/SHA256SUMS "${sums}")
