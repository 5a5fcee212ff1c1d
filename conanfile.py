# SPDX-License-Identifier: GPL-3.0-or-later

import os
import re

from conan import ConanFile
from conan.tools.cmake import CMake, cmake_layout
from conan.tools.files import load


class SurfaceMeshCoarsening(ConanFile):
    name = "surface_mesh_coarsening"
    description = "Coarsening of surface meshes by multiplicatively weighted centroidal Voronoi diagrams"
    license = "GPL-3.0-or-later"
    package_type = "header-library"
    settings = "os", "arch", "compiler", "build_type"
    exports_sources = "CMakeLists.txt", "LICENSE", "cmake/*", "include/*"
    generators = "CMakeDeps", "CMakeToolchain"
    no_copy_source = True

    def set_version(self):
        header = load(self, os.path.join(self.recipe_folder, "include/CGAL/Surface_mesh_coarsening/version.h"))
        self.version = re.search(r"#define CGAL_SURFACE_MESH_COARSENING_VERSION \"([0-9.]+)\"", header).group(1)

    def requirements(self):
        self.requires("cgal/[>=5.5]", transitive_headers=True)
        self.requires("eigen/[>=3.3]", transitive_headers=True)

    def layout(self):
        cmake_layout(self)

    def build(self):
        cmake = CMake(self)
        cmake.configure({
            "SURFACE_MESH_COARSENING_BUILD_EXAMPLES": "OFF",
            "SURFACE_MESH_COARSENING_BUILD_BENCHMARKS": "OFF",
            "SURFACE_MESH_COARSENING_BUILD_PYTHON": "OFF",
            "SURFACE_MESH_COARSENING_BUILD_TESTS": "OFF",
        })

    def package(self):
        CMake(self).install()

    def package_id(self):
        self.info.clear()

    def package_info(self):
        self.cpp_info.bindirs = []
        self.cpp_info.libdirs = []
        self.cpp_info.set_property("cmake_file_name", "Surface_mesh_coarsening")
        self.cpp_info.set_property("cmake_target_name", "Surface_mesh_coarsening::Surface_mesh_coarsening")
