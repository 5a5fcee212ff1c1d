# SPDX-License-Identifier: GPL-3.0-or-later
"""`pip install .` installs the Python module; CMake builds its compiled part, and needs the dependencies of the library."""

import os
import re
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent
PACKAGES = "examples/Surface_mesh_coarsening/python"


def version():
    text = (ROOT / "include/CGAL/Surface_mesh_coarsening/version.h").read_text()
    return re.search(r"#define CGAL_SURFACE_MESH_COARSENING_VERSION \D*([0-9.]+)", text).group(1)


def pybind11_arguments():
    try:
        import pybind11
    except ImportError:  # CMake finds the one of the system
        return []
    return ["-Dpybind11_DIR=" + pybind11.get_cmake_dir()]


class Build_with_cmake(build_ext):
    def build_extension(self, extension):
        target = Path(self.get_ext_fullpath(extension.name)).resolve()
        build = (Path(self.build_temp) / "cmake").resolve()
        options = {
            "CMAKE_BUILD_TYPE": "Release",
            "CMAKE_CXX_FLAGS_RELEASE": "-O2 -DNDEBUG",  # for a short build; the core has -O3
            "Python3_EXECUTABLE": sys.executable,
            "SURFACE_MESH_COARSENING_BUILD_BENCHMARKS": "OFF",
            "SURFACE_MESH_COARSENING_BUILD_EXAMPLES": "OFF",
            "SURFACE_MESH_COARSENING_BUILD_PYTHON": "ON",
            "SURFACE_MESH_COARSENING_BUILD_TESTS": "OFF",
        }
        arguments = [f"-D{name}={value}" for name, value in options.items()]
        subprocess.run(["cmake", "-S", ROOT, "-B", build, *arguments, *pybind11_arguments()], check=True)
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", str(os.cpu_count()))
        subprocess.run(["cmake", "--build", build, "--target", "surface_mesh_coarsening_python", "-j", jobs], check=True)
        built = build / "python" / "surface_mesh_coarsening" / target.name
        target.parent.mkdir(parents=True, exist_ok=True)
        self.copy_file(str(built), str(target))


setup(
    version=version(),
    package_dir={"": PACKAGES},
    packages=["surface_mesh_coarsening"],
    package_data={"surface_mesh_coarsening": ["py.typed"]},
    ext_modules=[Extension("surface_mesh_coarsening._core", sources=[])],
    cmdclass={"build_ext": Build_with_cmake},
)
