#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Copies the package into a checkout of CGAL, as a package among its others:
#   packaging/copy_to_cgal.sh CGAL_CHECKOUT
# Files are copied unchanged; parts that CGAL keeps elsewhere, the names of the parameters and the bibliography, have to be
# merged by hand as described in CONTRIBUTING.md.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
name=Surface_mesh_coarsening
target=${1:?the directory of a checkout of CGAL}/$name
if [[ -e $target ]]; then
  echo "copy_to_cgal.sh: $target exists already" >&2
  exit 1
fi

mkdir -p "$target"/{include/CGAL,examples/$name,test/$name,doc/$name,package_info/$name}
cp -r "$here/include/CGAL/$name" "$target/include/CGAL/"
cp "$here"/examples/$name/*.cpp "$target/examples/$name/"
cp -r "$here"/doc/$name/{Concepts,fig,PackageDescription.txt,$name.txt,distributed_meshes.txt,examples.txt} "$target/doc/$name/"
cp -r "$here"/test/$name/support "$target/test/$name/"
# The tests that need neither the tool nor models missing in CGAL.
for test in "$here"/test/$name/test_*.cpp; do
  grep -qE 'models\.h"|Tool_process|COARSEN_MESH|nlohmann|"(io|check|render)/' "$test" || cp "$test" "$target/test/$name/"
done
rm -f "$target/test/$name/support/Tool_process.h"

for kind in Examples:examples Tests:test; do
  cat > "$target/${kind#*:}/$name/CMakeLists.txt" <<END
# Created by the copying script of the package.

cmake_minimum_required(VERSION 3.12...3.29)
project(${name}_${kind%:*})

find_package(CGAL REQUIRED)
include_directories(BEFORE ../../include .)

find_package(Eigen3 3.3 QUIET)
include(CGAL_Eigen3_support)
if(NOT TARGET CGAL::Eigen3_support)
  message(NOTICE "This project requires the Eigen library, and will not be compiled.")
  return()
endif()
$([[ $kind == Tests:test ]] && printf 'find_package(Boost REQUIRED COMPONENTS unit_test_framework)\nadd_definitions(-DBOOST_TEST_DYN_LINK)\n')
find_package(TBB QUIET)
include(CGAL_TBB_support)

file(GLOB sources CONFIGURE_DEPENDS \${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
foreach(source IN LISTS sources)
  get_filename_component(program \${source} NAME_WE)
  create_single_source_cgal_program("\${program}.cpp")
  target_link_libraries(\${program} PRIVATE CGAL::Eigen3_support)
  if(TARGET CGAL::TBB_support)
    target_link_libraries(\${program} PRIVATE CGAL::TBB_support)
  endif()
$([[ $kind == Tests:test ]] && printf '  %s\n' 'target_link_libraries(${program} PRIVATE Boost::unit_test_framework)' \
  'target_compile_definitions(${program} PRIVATE BOOST_TEST_MODULE=${program})')
endforeach()
END
done

info=$target/package_info/$name
echo "GPL (v3 or later)" > "$info/license.txt"
echo "Coarsening of surface meshes by multiplicatively weighted centroidal Voronoi diagrams" > "$info/description.txt"
cat > "$info/long_description.txt" <<END
This package makes a coarse triangle mesh of a fine polygon mesh, with exactly the number of vertices asked for and the
topology of the input. Faces are gathered into clusters that form a multiplicatively weighted centroidal Voronoi diagram;
the result is the mesh dual to the clusters.
END
# The packages whose headers are included, itself among them, are found by CGAL's own scripts; these are the direct ones.
printf '%s\n' AABB_tree BGL Box_intersection_d Installation Intersections_3 Kernel_23 Polygon_mesh_processing Property_map \
  STL_Extension Stream_support "$name" Surface_mesh | sort > "$info/dependencies"
touch "$info/copyright" "$info/maintainer"
echo "The package is in $target"
