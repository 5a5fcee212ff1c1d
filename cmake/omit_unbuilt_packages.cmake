# SPDX-License-Identifier: GPL-3.0-or-later

# Read by cpack: the tool and the Python module are packed only if they have been built, because a package of their other files
# could be installed and would not work.

if(NOT EXISTS ${CPACK_BUILD_TREE}/bin/coarsen_mesh)
  list(REMOVE_ITEM CPACK_COMPONENTS_ALL Tools)
endif()
file(GLOB module ${CPACK_BUILD_TREE}/python/surface_mesh_coarsening/_core*)
if(NOT module)
  list(REMOVE_ITEM CPACK_COMPONENTS_ALL Python)
endif()
if(NOT CPACK_COMPONENTS_ALL)
  message(FATAL_ERROR "coarsen_mesh has not been built")
endif()
