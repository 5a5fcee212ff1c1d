// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>
#include <CGAL/Surface_mesh_coarsening/measure_coarsening.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMC = CGAL::Surface_mesh_coarsening;

//! [energy]
// The inertia of a cluster in an anisotropic metric, a model of ClusterEnergy: lengths are sqrt(d^T M d) with the symmetric
// tensor M of each face. The energy is the least sum over the faces of their squared distances from one point, times their
// masses.
class Metric_energy
{
public:
  template <class MetricMap>
  Metric_energy(const Mesh& mesh, const MetricMap& metric)
  {
    auto tensors = std::make_shared<std::vector<Eigen::Matrix3d> >();
    for (const Mesh::Face_index f : faces(mesh))
      tensors->push_back(get(metric, f));
    tensors_ = tensors;
  }

  struct Face_data
  {
    Eigen::Matrix3d tensor; // times the mass
    Eigen::Vector3d centroid;
  };
  // Sums of M, M g and g^T M g, with g from the centroid of the first face.
  struct Cluster_data
  {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::Vector3d vector = Eigen::Vector3d::Zero(), origin = Eigen::Vector3d::Zero();
    double constant = 0;
    bool has_origin = false;
  };

  Face_data face_data(const SMC::Clustered_face& face) const
  {
    const Kernel::Point_3 p = face.centroid();
    return {face.mass() * (*tensors_)[face.index()], Eigen::Vector3d(p.x(), p.y(), p.z())};
  }
  void add(Cluster_data& x, const Face_data& face) const
  {
    if (!x.has_origin)
      x.origin = face.centroid;
    x.has_origin = true;
    accumulate(x, face, 1);
  }
  void remove(Cluster_data& x, const Face_data& face) const { accumulate(x, face, -1); }
  double energy(const Cluster_data& x, std::size_t /* faces */) const
  {
    return (std::max)(0., x.constant - x.vector.dot(x.matrix.ldlt().solve(x.vector)));
  }

private:
  static void accumulate(Cluster_data& x, const Face_data& face, double sign)
  {
    const Eigen::Vector3d g = face.centroid - x.origin, moment = face.tensor * g;
    x.matrix += sign * face.tensor;
    x.vector += sign * moment;
    x.constant += sign * g.dot(moment);
  }

  std::shared_ptr<const std::vector<Eigen::Matrix3d> > tensors_; // in the order of the faces; shared by copies
};
//! [energy]

// Lengths count up to five times as much in the direction in which the normals around a face change.
Eigen::Matrix3d metric_at(const Mesh& mesh, Mesh::Face_index f)
{
  const Kernel::Vector_3 n = PMP::compute_face_normal(f, mesh);
  Eigen::Matrix3d change = Eigen::Matrix3d::Zero();
  for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
    for (const Mesh::Face_index g : mesh.faces_around_target(mesh.halfedge(v)))
      if (g != mesh.null_face()) {
        const Kernel::Vector_3 d = PMP::compute_face_normal(g, mesh) - n;
        const Eigen::Vector3d difference(d.x(), d.y(), d.z());
        change += difference * difference.transpose();
      }
  return Eigen::Matrix3d::Identity() + 24 / (change.trace() + 0.1) * change;
}

int main(int argc, char* argv[])
{
  const std::string name = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  Mesh input, output;
  if (!CGAL::IO::read_polygon_mesh(name, input)) {
    std::cerr << "cannot read " << name << std::endl;
    return EXIT_FAILURE;
  }
  const Eigen::Matrix3d isotropic = Eigen::Matrix3d::Identity();
  auto metric = input.add_property_map<Mesh::Face_index, Eigen::Matrix3d>("f:metric", isotropic).first;
  for (const Mesh::Face_index f : input.faces())
    metric[f] = metric_at(input, f);
  const SMC::Coarsening_report report =
    SMC::coarsen_mesh(input, 500, output, SMC::parameters::cluster_energy(Metric_energy(input, metric)));
  const SMC::Coarsening_quality quality = SMC::measure_coarsening(input, output);
  std::cout << "energy " << report.initial_energy << " -> " << report.final_energy << ", " << num_vertices(output)
            << " vertices, RMS distance " << 100 * quality.rms_distance / quality.diagonal << " % of the diagonal" << std::endl;
  return CGAL::IO::write_polygon_mesh("coarse.off", output) ? EXIT_SUCCESS : EXIT_FAILURE;
}
