// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares weights from the current sums, as in the package, with weights that are frozen for a round, as the paper can be read:
//   measure_frozen_weights FILE VERTICES [R_AREA R_MAXIMUM R_VARIANCE]
// Moves must pass the check of the paper as printed, and the guarantee of the package. For each weight, prints the number of
// rounds, at most 300, and the smallest and the largest energy in the last twenty rounds, or the energy at the end if the rounds
// ended, relative to the energy at the end with current sums. Prints the shapes of the densest third of the clusters: the mean
// elongation, and the mean cosine of the angle between the long axis and the sharp edges of a cluster, if it has sharp edges.

#include <CGAL/Surface_mesh_coarsening/Mwcvd_clustering.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Minimization_state.h>
#include <CGAL/Surface_mesh_coarsening/paper.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace {

namespace SMC = CGAL::Surface_mesh_coarsening;
using namespace SMC::internal;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

enum Weight
{
  AREA,
  MAXIMUM,
  VARIANCE
};
const std::array<const char*, 3> names = {{"area", "maximum", "variance"}};

// The sums of section 5.1 and 8.4, of a face or of a cluster.
struct Sums
{
  double mass = 0, inertia = 0, faces = 0, r = 0, r2 = 0, r10 = 0;
  Vector first{};

  Sums plus(const Sums& x, double sign) const
  {
    Sums y = *this;
    y.mass += sign * x.mass;
    y.inertia += sign * x.inertia;
    y.faces += sign * x.faces;
    y.r += sign * x.r;
    y.r2 += sign * x.r2;
    y.r10 += sign * x.r10;
    y.first = y.first + sign * x.first;
    return y;
  }
  double moment() const { return mass > 0 ? (std::max)(0., inertia - dot(first, first) / mass) : 0.; }
  double weight(Weight w) const
  {
    return w == AREA      ? mass
           : w == MAXIMUM ? std::pow((std::max)(0., r10), 0.1)
                          : 1 + (std::max)(0., r2 - r * r / (std::max)(1., faces));
  }
};

struct Course
{
  std::size_t rounds = 0;
  bool has_ended = false;       // whether the last round moved no face
  std::vector<double> energies; // after each round, with the weights of the current sums
};

class Experiment
{
public:
  Experiment(const Clustering_input& input, const Cluster_labels& start, std::size_t clusters, Weight weight)
    : input_(input), labels_(start), moves_(labels_, nullptr), weight_(weight), sums_(clusters)
  {
    for (std::size_t f = 0; f < input.mesh.number_of_faces(); ++f) {
      faces_.push_back(of_face(Index(f)));
      sums_[labels_[Index(f)]] = sums_[labels_[Index(f)]].plus(faces_.back(), 1);
    }
  }

  Course run(bool is_frozen, std::size_t max_rounds)
  {
    Course course;
    while (!course.has_ended && course.rounds < max_rounds) {
      course.has_ended = round(is_frozen) == 0;
      ++course.rounds;
      course.energies.push_back(energy());
    }
    return course;
  }

  // The mean elongation, and the mean cosine with sharp edges, of the densest third of the clusters.
  std::array<double, 2> shapes() const
  {
    std::vector<std::size_t> order(sums_.size());
    for (std::size_t x = 0; x < order.size(); ++x)
      order[x] = x;
    const auto density = [this](std::size_t x) { return sums_[x].r / sums_[x].faces; };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return density(a) > density(b); });
    order.resize((order.size() + 2) / 3);
    const std::vector<Eigen::Matrix3d> extents = extents_of_clusters(), edges = sharp_edges_of_clusters();
    double elongation = 0, cosine = 0;
    std::size_t with_edges = 0;
    for (const std::size_t x : order) {
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> shape(extents[x]), line(edges[x]);
      elongation += std::sqrt(shape.eigenvalues()[2] / (std::max)(shape.eigenvalues()[1], 1e-300));
      if (line.eigenvalues()[2] <= 0)
        continue;
      cosine += std::abs(shape.eigenvectors().col(2).dot(line.eigenvectors().col(2)));
      ++with_edges;
    }
    return {{elongation / double(order.size()), with_edges == 0 ? 0 : cosine / double(with_edges)}};
  }

private:
  Sums of_face(Index f) const
  {
    const double r = input_.density[f], mass = r * input_.area[f];
    const Vector g = input_.centroid(f);
    Sums s;
    s.mass = mass;
    s.inertia = mass * dot(g, g);
    s.faces = 1;
    s.r = r;
    s.r2 = r * r;
    s.r10 = std::pow(r, 10);
    s.first = mass * g;
    return s;
  }

  double energy() const
  {
    double sum = 0;
    for (const Sums& s : sums_)
      sum += s.weight(weight_) * s.moment();
    return sum;
  }

  // Each face may join the cluster across each of its edges.
  std::size_t round(bool is_frozen)
  {
    std::vector<double> frozen;
    for (const Sums& s : sums_)
      frozen.push_back(s.weight(weight_));
    const auto energy_of = [&](Index x, const Sums& s) { return (is_frozen ? frozen[x] : s.weight(weight_)) * s.moment(); };
    std::size_t moves = 0;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const Index f = Index(i);
      for (Index c = input_.mesh.first_corner[f]; c != input_.mesh.first_corner[f + 1]; ++c) {
        const Index from = labels_[f], to = labels_.label_across(c);
        if (to == from || to >= sums_.size() || sums_[from].faces == 1)
          continue;
        const Sums without = sums_[from].plus(faces_[i], -1), with = sums_[to].plus(faces_[i], 1);
        const double before = energy_of(from, sums_[from]) + energy_of(to, sums_[to]),
                     after = energy_of(from, without) + energy_of(to, with);
        if (!(before - after > 1e-7 * before) || !moves_.boundary_counts_allow(f, to) || !moves_.move(f, to))
          continue;
        sums_[from] = without;
        sums_[to] = with;
        ++moves;
      }
    }
    return moves;
  }

  static Eigen::Vector3d eigen(const Vector& v) { return Eigen::Vector3d(v[0], v[1], v[2]); }

  // The second moments of the clusters about their centers; a triangle's own are those of its corners and center.
  std::vector<Eigen::Matrix3d> extents_of_clusters() const
  {
    std::vector<Eigen::Vector3d> center(sums_.size(), Eigen::Vector3d::Zero());
    std::vector<double> area(sums_.size(), 0);
    std::vector<Eigen::Matrix3d> result(sums_.size(), Eigen::Matrix3d::Zero());
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const Index x = labels_[Index(i)];
      area[x] += input_.area[i];
      center[x] += input_.area[i] * eigen(input_.centroid(Index(i)));
    }
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const Index x = labels_[Index(i)];
      const Eigen::Vector3d d = eigen(input_.centroid(Index(i))) - center[x] / area[x];
      result[x] += 0.75 * input_.area[i] * d * d.transpose();
      for (Index c = input_.mesh.first_corner[i]; c != input_.mesh.first_corner[i + 1]; ++c) {
        const Eigen::Vector3d e = eigen(input_.mesh.points[input_.mesh.corner_vertex[c]]) - center[x] / area[x];
        result[x] += input_.area[i] / 12 * e * e.transpose();
      }
    }
    return result;
  }

  // The sum of e e^T over the edges of 30 degrees and more of the faces of each cluster.
  std::vector<Eigen::Matrix3d> sharp_edges_of_clusters() const
  {
    const Flat_mesh& m = input_.mesh;
    const auto normal = [&m](Index f) {
      const Index c = m.first_corner[f];
      const Eigen::Vector3d p = eigen(m.points[m.corner_vertex[c]]), q = eigen(m.points[m.corner_vertex[c + 1]]),
                            r = eigen(m.points[m.corner_vertex[c + 2]]);
      return Eigen::Vector3d((q - p).cross(r - p).normalized());
    };
    std::vector<Eigen::Matrix3d> result(sums_.size(), Eigen::Matrix3d::Zero());
    for (std::size_t i = 0; i < faces_.size(); ++i)
      for (Index c = m.first_corner[i]; c != m.first_corner[i + 1]; ++c) {
        const Index g = m.face_across[c];
        if (g == NONE || normal(Index(i)).dot(normal(g)) > std::cos(CGAL_PI / 6))
          continue;
        const Index next = c + 1 == m.first_corner[i + 1] ? m.first_corner[i] : c + 1;
        const Eigen::Vector3d e = eigen(m.points[m.corner_vertex[next]]) - eigen(m.points[m.corner_vertex[c]]);
        result[labels_[Index(i)]] += e * e.transpose();
      }
    return result;
  }

  const Clustering_input& input_;
  Cluster_labels labels_;
  Valid_moves moves_;
  Weight weight_;
  std::vector<Sums> faces_, sums_;
};

void print(const std::string& name, bool is_frozen, const Course& course, const Experiment& experiment, double reference)
{
  const std::size_t last = course.has_ended ? 1 : (std::min)(course.energies.size(), std::size_t(20));
  const auto range = std::minmax_element(course.energies.end() - std::ptrdiff_t(last), course.energies.end());
  const auto shapes = experiment.shapes();
  std::cout << name << (is_frozen ? ",frozen," : ",current,") << course.rounds << ',' << *range.first / reference << ','
            << *range.second / reference << ',' << shapes[0] << ',' << shapes[1] << std::endl;
}

template <class Cluster_weight>
void compare(const Mesh& mesh, std::size_t number, Weight weight, double density)
{
  SMC::Mwcvd_clustering<Mesh, Cluster_weight> clustering(mesh, SMC::parameters::paper_clustering(Cluster_weight(), density));
  clustering.seed(number);
  clustering.grow();
  const Clustering_state& state = clustering.state();
  double reference = 0;
  for (const bool is_frozen : {false, true}) {
    Experiment experiment(state.working_input(), *state.labels, number, weight);
    const Course course = experiment.run(is_frozen, 300);
    if (!is_frozen)
      reference = course.energies.back();
    print(names[weight], is_frozen, course, experiment, reference);
  }
}

} // namespace

int main(int argc, char* argv[])
{
  Mesh mesh;
  if ((argc != 3 && argc != 6) || !CGAL::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << "usage: measure_frozen_weights FILE VERTICES [R_AREA R_MAXIMUM R_VARIANCE]" << std::endl;
    return EXIT_FAILURE;
  }
  try {
    const std::size_t number = std::strtoul(argv[2], nullptr, 10);
    const auto density = [&](int i, double otherwise) { return argc == 6 ? std::strtod(argv[i], nullptr) : otherwise; };
    std::cout.precision(4);
    std::cout << "weight,weights_of_a_round,rounds,least_energy_of_last_20,largest,elongation,cosine_with_sharp_edges"
              << std::endl;
    compare<SMC::Weighted_area_weight>(mesh, number, AREA, density(3, 50));
    compare<SMC::Maximum_density_weight>(mesh, number, MAXIMUM, density(4, 50));
    compare<SMC::Density_variance_weight>(mesh, number, VARIANCE, density(5, 3));
    return EXIT_SUCCESS;
  } catch (const std::exception& e) {
    std::cerr << e.what() << std::endl;
    return EXIT_FAILURE;
  }
}
