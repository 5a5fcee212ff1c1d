// SPDX-License-Identifier: GPL-3.0-or-later
//
// Prints a checksum of the labels and of the dual triangles for each of a number of generated meshes and weights. It is built
// with several compilers and settings; all have to print checksums.txt.

#include "support/generate_meshes.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Density_variance_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Uniform_weight.h>
#include <CGAL/Surface_mesh_coarsening/Mwcvd_clustering.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>

namespace {

namespace SMC = CGAL::Surface_mesh_coarsening;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

// Coordinates are rounded, so that they do not depend on a compiler's sines.
Mesh rounded_mesh(const generated::Soup& soup)
{
  Mesh mesh;
  std::vector<Mesh::Point> points;
  const auto rounded = [](double x) { return std::ldexp(std::round(std::ldexp(x, 20)), -20); };
  for (const auto& p : soup.points)
    points.emplace_back(rounded(p[0]), rounded(p[1]), rounded(p[2]));
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, soup.polygons, mesh);
  return mesh;
}

class Checksum
{
  std::uint64_t sum = 14695981039346656037u; // FNV-1a

public:
  void add(std::uint64_t number)
  {
    for (int i = 0; i < 8; ++i)
      sum = (sum ^ ((number >> (8 * i)) & 255)) * 1099511628211u;
  }
  unsigned long long value() const { return sum; }
};

template <class Weight>
void print(const std::string& name, const char* weight, const Mesh& mesh, std::size_t number)
{
  SMC::Mwcvd_clustering<Mesh, Weight> clustering(mesh, SMC::parameters::maximum_density(50.)); // the densities of the paper
  clustering.seed(number);
  clustering.grow();
  clustering.minimize(SMC::Coarsening_defaults::number_of_iterations, 0);
  Mesh output;
  clustering.extract_dual_mesh(output, SMC::Centroid_placement());
  Checksum labels, triangles;
  for (const auto f : faces(mesh))
    labels.add(clustering.cluster(f));
  for (const auto f : faces(output))
    for (const auto v : CGAL::vertices_around_face(halfedge(f, output), output))
      triangles.add(v);
  std::printf("%s %s %zu %016llx %016llx\n", name.c_str(), weight, number, labels.value(), triangles.value());
}

void print(const std::string& name, const generated::Soup& soup, std::size_t number)
{
  const Mesh mesh = rounded_mesh(soup);
  print<SMC::Uniform_weight>(name, "uniform", mesh, number);
  print<SMC::Maximum_density_weight>(name, "maximum", mesh, number);
  print<SMC::Density_variance_weight>(name, "variance", mesh, number);
}

} // namespace

int main()
{
  using namespace generated;
  print("sphere", triangle_sphere(4), 150);
  print("rough_sphere", with_noise(triangle_sphere(5), 0.01), 300);
  print("torus", triangulated(torus(48, 32)), 120);
  print("squares", torus(40, 24), 90);
  print("cube", triangulated(cube_grid(12)), 100);
  print("grid", triangulated(grid(40, 40)), 130);
  print("tube", partly_triangulated(tube(60, 30)), 100);
  print("handles", plate_with_windows(4, 4), 120);
  print("needles", needles(60, 12), 80);
  print("scattered", with_noise(triangulated(grid(50, 50)), 0.4), 200);
  print("blocks", with_noise(triangle_sphere(5), 0.01), 1200); // so many clusters are minimized in blocks
}
