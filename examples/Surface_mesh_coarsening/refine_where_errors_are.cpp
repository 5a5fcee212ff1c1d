// SPDX-License-Identifier: GPL-3.0-or-later
//
// Solves a Poisson problem on a coarse mesh, and splits clusters where an estimate of the error is large, three times. Writes
// clusters_0.ply to clusters_3.ply, the input with a cluster for each face, and solution_0.ply to solution_3.ply, the coarse
// meshes with the solution at each vertex.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/Surface_mesh_coarsening/Mwcvd_clustering.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <numeric>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Vector_3 Vector;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

namespace SMC = CGAL::Surface_mesh_coarsening;

// A source that is strong near one point.
double source(const Kernel::Point_3& p, const Kernel::Point_3& center, double size)
{
  return std::exp(-CGAL::squared_distance(p, center) / (0.01 * size * size));
}

// Solves u - c Laplace(u) = f with the cotangent weights of linear finite elements.
Eigen::VectorXd solve(const Mesh& mesh, const Eigen::VectorXd& f, double c)
{
  std::vector<Eigen::Triplet<double> > entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(f.size());
  for (const auto t : mesh.faces()) {
    auto h = mesh.halfedge(t);
    for (int i = 0; i < 3; ++i, h = mesh.next(h)) {
      const auto a = mesh.source(h), b = mesh.target(h), o = mesh.target(mesh.next(h));
      const Vector u = mesh.point(a) - mesh.point(o), v = mesh.point(b) - mesh.point(o);
      const double area = std::sqrt(CGAL::cross_product(u, v).squared_length()) / 2;
      const double weight = area > 0 ? c * (u * v) / (4 * area) : 0;
      entries.insert(entries.end(), {{int(a), int(a), weight + area / 3}, {int(b), int(b), weight}, {int(a), int(b), -weight},
                                     {int(b), int(a), -weight}});
      right[a] += area / 3 * f[a];
    }
  }
  Eigen::SparseMatrix<double> matrix(f.size(), f.size());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double> >(matrix).solve(right);
}

// Estimates the error at each vertex by the jumps of the gradient across its edges: a linear solution has them where
// the true solution is curved.
std::vector<double> estimated_errors(const Mesh& mesh, const Eigen::VectorXd& u)
{
  std::vector<Vector> gradient;
  for (const auto t : mesh.faces()) {
    const auto h = mesh.halfedge(t);
    const auto a = mesh.source(h), b = mesh.target(h), c = mesh.target(mesh.next(h));
    const Vector n = CGAL::cross_product(mesh.point(b) - mesh.point(a), mesh.point(c) - mesh.point(a));
    const Vector sum = u[a] * (mesh.point(c) - mesh.point(b)) + u[b] * (mesh.point(a) - mesh.point(c)) +
                       u[c] * (mesh.point(b) - mesh.point(a));
    gradient.push_back(n.squared_length() > 0 ? CGAL::cross_product(n, sum) / n.squared_length() : sum);
  }
  std::vector<double> errors(mesh.number_of_vertices(), 0);
  for (const auto e : mesh.edges()) {
    const auto h = mesh.halfedge(e);
    if (mesh.is_border(e))
      continue;
    const Vector jump = gradient[mesh.face(h)] - gradient[mesh.face(mesh.opposite(h))];
    const double length = CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
    for (const auto v : {mesh.source(h), mesh.target(h)})
      errors[v] += length * jump.squared_length();
  }
  return errors;
}

Eigen::VectorXd solution_on(const Mesh& mesh, const Kernel::Point_3& center, double size)
{
  Eigen::VectorXd f(mesh.number_of_vertices());
  for (const auto v : mesh.vertices())
    f[v] = source(mesh.point(v), center, size);
  return solve(mesh, f, 0.01 * size * size);
}

//! [refinement]
// Splits the clusters of the 20 % of the vertices with the largest errors. The other clusters keep their faces while the
// new ones are minimized.
void refine(SMC::Mwcvd_clustering<Mesh>& clustering, const std::vector<double>& errors)
{
  std::vector<double> sorted = errors;
  std::sort(sorted.begin(), sorted.end());
  const double large = sorted[sorted.size() * 4 / 5];
  for (std::size_t x = 0; x < errors.size(); ++x)
    if (errors[x] > large)
      clustering.split_cluster(x);
    else
      clustering.freeze_cluster(x);
  clustering.minimize();
  for (std::size_t x = 0; x < clustering.number_of_clusters(); ++x)
    clustering.thaw_cluster(x);
}
//! [refinement]

bool write(const std::string& file, const Mesh& mesh)
{
  std::ofstream os(file, std::ios::binary);
  CGAL::IO::set_binary_mode(os);
  return CGAL::IO::write_PLY(os, mesh);
}

int main(int argc, char* argv[])
{
  const std::string name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  Mesh input;
  if (!CGAL::IO::read_polygon_mesh(name, input) || input.is_empty()) {
    std::cerr << "cannot read " << name << std::endl;
    return EXIT_FAILURE;
  }
  const Kernel::Point_3 center = input.point(*input.vertices().begin());
  double size = 0;
  for (const auto v : input.vertices())
    size = (std::max)(size, std::sqrt(CGAL::squared_distance(center, input.point(v))));

  // Uniform densities at first: the solution, not the shape, determines the distribution of vertices.
  SMC::Mwcvd_clustering<Mesh> clustering(input, SMC::parameters::maximum_density(1.));
  clustering.seed(200);
  clustering.grow();
  clustering.minimize();
  const auto cluster = input.add_property_map<Mesh::Face_index, std::uint32_t>("f:cluster").first;
  for (int step = 0; step < 4; ++step) {
    Mesh coarse;
    clustering.extract_dual_mesh(coarse, SMC::Centroid_placement());
    const Eigen::VectorXd u = solution_on(coarse, center, size);
    const auto solution = coarse.add_property_map<Mesh::Vertex_index, double>("v:solution").first;
    for (const auto v : coarse.vertices())
      solution[v] = u[v];
    for (const auto f : input.faces())
      cluster[f] = std::uint32_t(clustering.cluster(f));
    const std::string ending = "_" + std::to_string(step) + ".ply";
    if (!write("clusters" + ending, input) || !write("solution" + ending, coarse))
      return EXIT_FAILURE;
    const std::vector<double> errors = estimated_errors(coarse, u);
    std::cout << coarse.number_of_vertices() << " vertices: estimated error "
              << std::sqrt(std::accumulate(errors.begin(), errors.end(), 0.)) << std::endl;
    if (step < 3)
      refine(clustering, errors);
  }
  return EXIT_SUCCESS;
}
