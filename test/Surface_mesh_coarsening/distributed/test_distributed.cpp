// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes in pieces on several ranks. The program runs on any number of ranks; cases that need fewer use the first ones.

#include "distributed/mixed_surfaces.h"
#include "support/face_graphs.h"
#include "support/generate_meshes.h"
#include "support/random_surfaces.h"
#include "support/reference_energy.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Density_variance_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Exact_maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Uniform_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Closest_vertex_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Quadric_placement.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_distributed_mesh.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>
#include <CGAL/Surface_mesh_coarsening/measure_coarsening.h>

#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <boost/mpi/collectives.hpp>
#include <boost/mpi/environment.hpp>
#include <boost/serialization/vector.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_distributed)

namespace SMC = CGAL::Surface_mesh_coarsening;
namespace mpi = boost::mpi;
using generated::Soup;
using generated::mixed_surfaces;
using test::Mesh;

namespace {

struct Mpi
{
  Mpi() : environment(mpi::threading::multiple, false) {}
  mpi::environment environment;
};

// A piece, with the numbers of its vertices, and of its faces in the whole mesh.
struct Piece
{
  Mesh mesh;
  Mesh::Property_map<Mesh::Vertex_index, std::uint64_t> number;
  std::vector<std::size_t> face;

  Piece() { number = mesh.add_property_map<Mesh::Vertex_index, std::uint64_t>("v:number", 0).first; }
};

// Numbers that need more than 32 bits, in another order than that of the vertices.
std::uint64_t number_of_vertex(std::size_t v) { return (std::uint64_t(1) << 40) + 1000003 * std::uint64_t(v ^ 5); }

// Each face has vertices of its own in the piece: they are one by their numbers.
void add_face(Piece& piece, const Soup& soup, std::size_t f, const std::vector<std::size_t>& polygon)
{
  std::vector<Mesh::Vertex_index> vertices;
  for (const std::size_t v : polygon) {
    vertices.push_back(piece.mesh.add_vertex(test::Point(soup.points[v][0], soup.points[v][1], soup.points[v][2])));
    piece.number[vertices.back()] = number_of_vertex(v);
  }
  piece.mesh.add_face(vertices);
  piece.face.push_back(f);
}

Piece piece_of(const Soup& soup, const mpi::communicator& ranks)
{
  Piece piece;
  for (std::size_t f = 0; f < soup.polygons.size(); ++f)
    if (f * 2654435761u / 64 % std::size_t(ranks.size()) == std::size_t(ranks.rank()))
      add_face(piece, soup, f, soup.polygons[f]);
  return piece;
}

struct Result
{
  std::vector<double> coordinates;
  std::vector<std::size_t> corners, clusters;
  double energy = 0;

  bool operator==(const Result& r) const
  {
    return coordinates == r.coordinates && corners == r.corners && clusters == r.clusters && energy == r.energy;
  }
};

// What rank 0 has of the output, and the clusters of all faces.
Result result_of(const mpi::communicator& ranks, const Soup& soup, const Piece& piece, const std::vector<std::size_t>& clusters,
                 const Mesh& output, double energy)
{
  Result result;
  result.energy = energy;
  std::vector<std::size_t> own(soup.polygons.size(), 0);
  for (std::size_t i = 0; i < piece.face.size(); ++i)
    own[piece.face[i]] = clusters[i];
  result.clusters.resize(own.size());
  mpi::all_reduce(ranks, own.data(), int(own.size()), result.clusters.data(), std::plus<std::size_t>());
  for (const auto v : output.vertices())
    for (int i = 0; i < 3; ++i)
      result.coordinates.push_back(output.point(v)[i]);
  for (const auto f : output.faces())
    for (const auto v : output.vertices_around_face(output.halfedge(f)))
      result.corners.push_back(v);
  return result;
}

template <class ConcurrencyTag, class NamedParameters>
Result coarsened(const mpi::communicator& ranks, const Soup& soup, std::size_t n, const NamedParameters& np)
{
  const Piece piece = piece_of(soup, ranks);
  std::vector<std::size_t> clusters(piece.face.size());
  Mesh output;
  const auto map = boost::make_iterator_property_map(clusters.begin(), get(CGAL::face_index, piece.mesh));
  const SMC::Coarsening_report report =
    SMC::coarsen_distributed_mesh<ConcurrencyTag>(ranks, piece.mesh, piece.number, n, output, np.face_cluster_map(map));
  BOOST_TEST(report.clusters == n);
  BOOST_TEST(output.number_of_vertices() == (ranks.rank() == 0 ? n : 0));
  return result_of(ranks, soup, piece, clusters, output, report.final_energy);
}

// Calls `work(ranks)` on the first so many ranks, if there are so many.
template <class Work>
void on_first_ranks(int number, const Work& work)
{
  const mpi::communicator world;
  if (world.size() < number)
    return;
  const bool takes_part = world.rank() < number;
  const mpi::communicator ranks = world.split(takes_part);
  if (takes_part)
    work(ranks);
  world.barrier();
}

// The promises: clusters are discs, and the output is a surface of the input's topology.
void check_validity(const Soup& soup, const Result& result, std::size_t n)
{
  const reference::Reference_mesh m(soup);
  BOOST_TEST(reference::number_of_clusters(result.clusters) == n);
  BOOST_TEST(reference::fault_of_discs(m, result.clusters) == "");
  std::vector<std::size_t> component(n);
  for (std::size_t f = 0; f < result.clusters.size(); ++f)
    component[result.clusters[f]] = m.component()[f];
  std::vector<reference::Triangle> triangles;
  for (std::size_t i = 0; i < result.corners.size(); i += 3)
    triangles.push_back({result.corners[i], result.corners[i + 1], result.corners[i + 2]});
  BOOST_TEST(reference::fault_of_surface(m, triangles, component) == "");
  for (const double x : result.coordinates)
    BOOST_TEST(std::isfinite(x));
}

template <class NamedParameters>
void check_all_numbers_of_ranks(const Soup& soup, std::size_t n, const NamedParameters& np)
{
  Result on_one;
  for (const int number : {1, 2, 3, 4, 7})
    on_first_ranks(number, [&](const mpi::communicator& ranks) {
      const Result result = coarsened<CGAL::Sequential_tag>(ranks, soup, n, np);
      if (ranks.rank() != 0)
        return;
      check_validity(soup, result, n);
      if (number == 1)
        on_one = result;
      else
        BOOST_TEST((result == on_one), "the result on " << number << " ranks is another one");
    });
}

// The message with which the coarsening of pieces fails, the same on all ranks.
template <class NamedParameters>
std::string message_of(const mpi::communicator& ranks, const Piece& piece, std::size_t n, const NamedParameters& np)
{
  Mesh output;
  output.add_vertex();
  std::string message;
  try {
    SMC::coarsen_distributed_mesh(ranks, piece.mesh, piece.number, n, output, np);
  } catch (const SMC::Invalid_input& e) {
    message = e.what();
  }
  BOOST_TEST((message.empty() || output.number_of_vertices() == 1));
  std::vector<std::string> messages;
  mpi::all_gather(ranks, message, messages);
  for (const std::string& m : messages)
    BOOST_TEST(m == message);
  return message;
}

std::string message_of(const mpi::communicator& ranks, const Piece& piece, std::size_t n = 10)
{
  return message_of(ranks, piece, n, SMC::parameters::faces_per_block(50));
}

// Two sheets much closer to each other than the error of the coarse mesh: triangles of a fit intersect.
Soup thin_plate() { return generated::triangulated(generated::thin_plate(40, 0.05)); }

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string vertex(std::size_t v) { return "vertex " + std::to_string(number_of_vertex(v)); }

} // namespace

BOOST_TEST_GLOBAL_FIXTURE(Mpi);

BOOST_AUTO_TEST_CASE(result_does_not_depend_on_ranks)
{
  const auto blocks = [](std::size_t n) { return SMC::parameters::faces_per_block(n); };
  check_all_numbers_of_ranks(generated::with_noise(generated::triangle_sphere(4), 0.01), 30, blocks(100));
  check_all_numbers_of_ranks(mixed_surfaces(), 120, blocks(200).vertex_placement(SMC::Centroid_placement()));
  check_all_numbers_of_ranks(mixed_surfaces(), 60, blocks(30).vertex_placement(SMC::Quadric_placement()));
  check_all_numbers_of_ranks(mixed_surfaces(), 1500, blocks(500)); // too many for cells
  check_all_numbers_of_ranks(mixed_surfaces(), 60, blocks(60));
  check_all_numbers_of_ranks(thin_plate(), 60, blocks(700));
  check_all_numbers_of_ranks(generated::tetrahedron(), 4, blocks(1));
}

namespace {

struct Repaired
{
  SMC::Distributed_report report;
  Mesh output;
};

template <class NamedParameters>
Repaired repaired(const mpi::communicator& ranks, const Soup& soup, std::size_t n, const NamedParameters& np)
{
  const Piece piece = piece_of(soup, ranks);
  Repaired result;
  result.report = SMC::coarsen_distributed_mesh(ranks, piece.mesh, piece.number, n, result.output, np);
  return result;
}

std::size_t self_intersections(const Mesh& mesh)
{
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index> > pairs;
  CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(pairs));
  return pairs.size();
}

} // namespace

// A fit is repaired by default, other placements on request, and all ranks have the same counts.
BOOST_AUTO_TEST_CASE(repair_takes_sheets_apart)
{
  on_first_ranks(3, [](const mpi::communicator& ranks) {
    const Soup soup = thin_plate();
    const auto blocks = SMC::parameters::faces_per_block(4000);
    const auto check = [&](std::size_t n, const auto& np, const auto& without) {
      const Repaired plain = repaired(ranks, soup, n, without), result = repaired(ranks, soup, n, np);
      const SMC::Distributed_report& report = result.report;
      BOOST_TEST(plain.report.intersections_found == 0);
      BOOST_TEST(report.intersections_found > 0);
      const std::array<std::size_t, 3> own{{report.intersections_found, report.intersections_left, report.reversals_left}};
      BOOST_TEST(report.intersecting_faces.size() == report.intersections_left);
      std::array<std::size_t, 3> first = own;
      mpi::broadcast(ranks, first.data(), 3, 0);
      BOOST_TEST(first == own);
      if (ranks.rank() != 0)
        return;
      BOOST_TEST_MESSAGE(n << " vertices: " << report.intersections_found << " found, " << report.intersections_left
                           << " left, " << self_intersections(plain.output) << " without repair");
      BOOST_TEST(self_intersections(result.output) == report.intersections_left);
      BOOST_TEST(self_intersections(plain.output) == report.intersections_found);
      BOOST_TEST(10 * report.intersections_left <= report.intersections_found);
    };
    const auto fitted = blocks.vertex_placement(SMC::Fitted_placement());
    check(60, fitted, fitted.repair_output(false));
    check(350, fitted, fitted.repair_output(false)); // too many for cells
    const auto by_quadrics = blocks.vertex_placement(SMC::Quadric_placement());
    check(60, by_quadrics.repair_output(true), by_quadrics);
  });
}

BOOST_AUTO_TEST_CASE(result_does_not_depend_on_ranks_threads_and_memory)
{
#ifdef CGAL_LINKED_WITH_TBB
  const Soup soup = generated::joined(mixed_surfaces(), generated::translated(thin_plate(), 9, 0, 0));
  const auto np = SMC::parameters::faces_per_block(1000).vertex_placement(SMC::Fitted_placement());
  Result on_one;
  for (const int number : {1, 2, 3, 4, 7})
    on_first_ranks(number, [&](const mpi::communicator& ranks) {
      const auto check = [&](std::size_t threads, const auto& parameters) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
        const Result result = coarsened<CGAL::Parallel_tag>(ranks, soup, 150, parameters);
        if (ranks.rank() != 0)
          return;
        on_one = on_one.clusters.empty() ? result : on_one;
        BOOST_TEST((result == on_one), "another result on " << number << " ranks with " << threads << " threads");
      };
      check(1, np);
      check(2, np);
      check(1, np.scratch_directory(".").scratch_memory(100000));
      check(2, np.scratch_directory("."));
    });
#endif
}

BOOST_AUTO_TEST_CASE(result_does_not_depend_on_threads)
{
#ifdef CGAL_LINKED_WITH_TBB
  const Soup soup = mixed_surfaces();
  on_first_ranks(1, [&](const mpi::communicator& ranks) {
    const auto np = SMC::parameters::faces_per_block(3000);
    const auto check = [&](const auto& parameters) {
      const Result sequential = coarsened<CGAL::Sequential_tag>(ranks, soup, 80, parameters);
      for (const std::size_t threads : {1, 2}) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
        BOOST_TEST((coarsened<CGAL::Parallel_tag>(ranks, soup, 80, parameters) == sequential));
      }
    };
    check(np);
    check(np.vertex_placement(SMC::Centroid_placement()));
  });
#endif
}

BOOST_AUTO_TEST_CASE(weights_and_placements)
{
  on_first_ranks(2, [](const mpi::communicator& ranks) {
    const Soup soup = mixed_surfaces();
    const auto check = [&](const auto& np) {
      const Result result = coarsened<CGAL::Sequential_tag>(ranks, soup, 70, np.faces_per_block(400));
      if (ranks.rank() == 0)
        check_validity(soup, result, 70);
    };
    check(SMC::parameters::cluster_weight(SMC::Uniform_weight()));
    check(SMC::parameters::cluster_weight(SMC::Density_variance_weight()).maximum_density(3));
    check(SMC::parameters::cluster_weight(SMC::Exact_maximum_density_weight()).number_of_iterations(0));
    check(SMC::parameters::cluster_weight(SMC::Weighted_area_weight()).vertex_placement(SMC::Closest_vertex_placement()));
    const auto np = SMC::parameters::faces_per_block(400);
    const Result by_default = coarsened<CGAL::Sequential_tag>(ranks, soup, 70, np);
    BOOST_TEST((by_default == coarsened<CGAL::Sequential_tag>(ranks, soup, 70, np.vertex_placement(SMC::Fitted_placement()))));
  });
}

// The energy of the report is that of the clusters, with densities that the caller gives.
BOOST_AUTO_TEST_CASE(energy_of_own_densities)
{
  on_first_ranks(2, [](const mpi::communicator& ranks) {
    const Soup soup = generated::with_noise(generated::triangle_sphere(4), 0.02);
    const Piece piece = piece_of(soup, ranks);
    std::vector<double> density;
    for (std::size_t f = 0; f < soup.polygons.size(); ++f)
      density.push_back(1 + double(f % 7));
    std::vector<double> own;
    for (const std::size_t f : piece.face)
      own.push_back(density[f]);
    const auto map = boost::make_iterator_property_map(own.begin(), get(CGAL::face_index, piece.mesh));
    const Result result = coarsened<CGAL::Sequential_tag>(
      ranks, soup, 25, SMC::parameters::faces_per_block(300).face_density_map(map).cluster_weight(SMC::Weighted_area_weight()));
    const double expected = reference::energy(reference::faces_of(soup), density, result.clusters, SMC::Weighted_area_weight());
    BOOST_TEST(std::abs(result.energy - expected) <= 1e-9 * expected);
  });
}

// With some hundred clusters in a task, users see no difference: in the energy, in the distance, in the angles. The fit to the
// cells halves the distance, as a fit to the faces does.
BOOST_AUTO_TEST_CASE(agrees_with_the_coarsening_in_memory)
{
  on_first_ranks(2, [](const mpi::communicator& ranks) {
    const Soup soup = generated::triangulated(generated::scaled(generated::torus(300, 250), 1, 2, 3));
    const std::size_t n = 1500;
    const Piece piece = piece_of(soup, ranks);
    Mesh distributed, fitted, in_memory;
    const auto np = SMC::parameters::faces_per_block(75000);
    const SMC::Coarsening_report report = SMC::coarsen_distributed_mesh(ranks, piece.mesh, piece.number, n, distributed,
                                                                        np.vertex_placement(SMC::Quadric_placement()));
    SMC::coarsen_distributed_mesh(ranks, piece.mesh, piece.number, n, fitted, np.vertex_placement(SMC::Fitted_placement()));
    if (ranks.rank() != 0)
      return;
    const Mesh whole = test::to_mesh(soup);
    const SMC::Coarsening_report expected = SMC::coarsen_mesh(
      whole, n, in_memory, SMC::parameters::vertex_placement(SMC::Quadric_placement()).repair_output(false));
    BOOST_TEST(report.final_energy <= 1.01 * expected.final_energy);
    const SMC::Coarsening_quality a = SMC::measure_coarsening(whole, distributed), b = SMC::measure_coarsening(whole, in_memory);
    BOOST_TEST(a.rms_distance <= 1.03 * b.rms_distance);
    BOOST_TEST(a.mean_smallest_angle >= b.mean_smallest_angle - 0.5);
    const SMC::Coarsening_quality c = SMC::measure_coarsening(whole, fitted);
    BOOST_TEST(c.rms_distance <= 0.65 * a.rms_distance);
    BOOST_TEST(c.mean_smallest_angle >= 40);
  });
}

namespace {

// Passes the faces of a piece one by one.
struct Source_of_piece
{
  const Piece& piece;

  template <class Receive>
  void operator()(const Receive& receive) const
  {
    for (const auto f : piece.mesh.faces()) {
      std::vector<std::uint64_t> numbers;
      std::vector<std::array<double, 3> > points;
      for (const auto v : piece.mesh.vertices_around_face(piece.mesh.halfedge(f))) {
        const auto& p = piece.mesh.point(v);
        numbers.push_back(piece.number[v]);
        points.push_back({{p.x(), p.y(), p.z()}});
      }
      receive(numbers, points);
    }
  }
};

template <class NamedParameters>
Result coarsened_from_source(const mpi::communicator& ranks, const Soup& soup, std::size_t n, std::uint64_t& bytes_of_scratch,
                             const NamedParameters& np)
{
  const Piece piece = piece_of(soup, ranks);
  std::vector<std::size_t> clusters(piece.face.size());
  Mesh output;
  const auto map = boost::make_iterator_property_map(clusters.begin(), boost::identity_property_map());
  const SMC::Distributed_report report =
    SMC::coarsen_distributed_faces(ranks, Source_of_piece{piece}, n, output, np.face_cluster_map(map));
  bytes_of_scratch = mpi::all_reduce(ranks, report.bytes_of_scratch, std::plus<std::uint64_t>());
  BOOST_TEST((report.bytes_sent > 0) == (ranks.size() > 1));
  return result_of(ranks, soup, piece, clusters, output, report.final_energy);
}

} // namespace

// Neither the source of the faces nor where they wait changes the result.
BOOST_AUTO_TEST_CASE(faces_from_a_source_and_on_disk)
{
  for (const int number : {1, 3})
    on_first_ranks(number, [](const mpi::communicator& ranks) {
      const Soup soup = mixed_surfaces();
      const auto np = SMC::parameters::faces_per_block(2000);
      const Result expected = coarsened<CGAL::Sequential_tag>(ranks, soup, 120, np);
      std::uint64_t none = 0, some = 0, all = 0;
      const auto on_disk = np.scratch_directory(".");
      BOOST_TEST((coarsened_from_source(ranks, soup, 120, none, np) == expected));
      BOOST_TEST((coarsened_from_source(ranks, soup, 120, some, on_disk.scratch_memory(100000)) == expected));
      BOOST_TEST((coarsened_from_source(ranks, soup, 120, all, on_disk) == expected));
      BOOST_TEST(none == 0);
      BOOST_TEST((0 < some && some < all));
      ranks.barrier();
      for (const auto& file : std::filesystem::directory_iterator("."))
        BOOST_TEST(file.path().filename().string().find("scratch") == std::string::npos);
    });
}

BOOST_AUTO_TEST_CASE(densities_of_faces_from_a_source)
{
  on_first_ranks(2, [](const mpi::communicator& ranks) {
    const Soup soup = generated::triangle_sphere(3);
    const Piece piece = piece_of(soup, ranks);
    std::vector<double> density;
    for (const std::size_t f : piece.face)
      density.push_back(1 + double(f % 7));
    const auto np = SMC::parameters::faces_per_block(300);
    const auto by_face = boost::make_iterator_property_map(density.begin(), get(CGAL::face_index, piece.mesh));
    const Result expected = coarsened<CGAL::Sequential_tag>(ranks, soup, 25, np.face_density_map(by_face));
    std::uint64_t bytes = 0;
    const auto by_number = boost::make_iterator_property_map(density.begin(), boost::identity_property_map());
    BOOST_TEST((coarsened_from_source(ranks, soup, 25, bytes, np.face_density_map(by_number)) == expected));
  });
}

BOOST_AUTO_TEST_CASE(output_on_all_ranks)
{
  on_first_ranks(3, [](const mpi::communicator& ranks) {
    const Soup soup = mixed_surfaces();
    const Piece piece = piece_of(soup, ranks);
    for (const std::size_t n : {120, 1500}) { // of cells, and of faces
      Mesh output;
      SMC::coarsen_distributed_mesh(ranks, piece.mesh, piece.number, n, output,
                                    SMC::parameters::faces_per_block(300).output_on_all_ranks(true));
      Result own = result_of(ranks, soup, piece, std::vector<std::size_t>(piece.face.size(), 0), output, 0);
      std::vector<double> first = own.coordinates;
      std::vector<std::size_t> corners = own.corners;
      mpi::broadcast(ranks, first, 0);
      mpi::broadcast(ranks, corners, 0);
      BOOST_TEST(output.number_of_vertices() == n);
      BOOST_TEST((own.coordinates == first && own.corners == corners));
    }
  });
}

// Vertices on the border keep the length of a tube.
BOOST_AUTO_TEST_CASE(clusters_on_the_border)
{
  on_first_ranks(2, [](const mpi::communicator& ranks) {
    const Soup soup = generated::triangulated(generated::tube(24, 30));
    const Piece piece = piece_of(soup, ranks);
    Mesh output;
    SMC::coarsen_distributed_mesh(ranks, piece.mesh, piece.number, 20, output, SMC::parameters::faces_per_block(200));
    const double length = soup.points.back()[2];
    for (const auto v : output.vertices())
      if (output.is_border(v))
        BOOST_TEST((std::min)(output.point(v).z(), length - output.point(v).z()) < 1e-9 * length);
  });
}

// What a source throws on one rank, all throw.
BOOST_AUTO_TEST_CASE(source_that_fails)
{
  on_first_ranks(3, [](const mpi::communicator& ranks) {
    const Piece piece = piece_of(generated::triangle_sphere(3), ranks);
    Mesh output;
    for (const int last : {0, 1, 2}) {
      int call = 0;
      const auto source = [&](const auto& receive) {
        Source_of_piece{piece}(receive);
        if (ranks.rank() == 1 && call++ == last)
          throw std::runtime_error("no more");
      };
      std::string message;
      try {
        SMC::coarsen_distributed_faces(ranks, source, 20, output);
      } catch (const std::runtime_error& e) {
        message = e.what();
      }
      BOOST_TEST(message == "rank 1: no more");
      BOOST_TEST(output.number_of_vertices() == 0);
    }
  });
}

// Random surfaces in blocks of a few faces, so that each touches many others.
BOOST_AUTO_TEST_CASE(random_surfaces)
{
  on_first_ranks(2, [](const mpi::communicator& ranks) {
    std::size_t checked = 0;
    for (unsigned seed = 0; seed < 24; ++seed) {
      std::mt19937 engine(seed);
      const Soup starts[] = {generated::tetrahedron(), generated::torus(5, 4), generated::tube(6, 3),
                             generated::plate_with_windows(2, 2), generated::with_holes(generated::triangle_sphere(1), 2)};
      const Soup soup = generated::random_surface(starts[seed % 5], 300 + 30 * (seed % 7), seed % 2 == 0, engine);
      const auto np = SMC::parameters::faces_per_block(10 + seed % 20);
      std::size_t n = 4 + seed % 40;
      const Piece piece = piece_of(soup, ranks);
      Mesh output;
      SMC::Coarsening_report report;
      try {
        report = SMC::coarsen_distributed_mesh(ranks, piece.mesh, piece.number, n, output, np);
      } catch (const SMC::Unreachable_number_of_vertices& e) {
        n = e.nearest();
        report = SMC::coarsen_distributed_mesh(ranks, piece.mesh, piece.number, n, output, np);
      }
      if (report.subdivided_components > 0)
        continue; // clusters are of parts of faces
      ++checked;
      const Result result = coarsened<CGAL::Sequential_tag>(ranks, soup, n, np);
      if (ranks.rank() == 0)
        check_validity(soup, result, n);
    }
    BOOST_TEST(checked >= 16);
  });
}

BOOST_AUTO_TEST_CASE(numbers_that_topology_forbids)
{
  on_first_ranks(2, [](const mpi::communicator& ranks) {
    const Soup soup = generated::torus(30, 30);
    const Piece piece = piece_of(soup, ranks);
    Mesh output;
    for (const std::size_t n : {0, 6, 901}) {
      std::size_t nearest = 0;
      try {
        SMC::coarsen_distributed_mesh(ranks, piece.mesh, piece.number, n, output, SMC::parameters::faces_per_block(100));
      } catch (const SMC::Unreachable_number_of_vertices& e) {
        nearest = e.nearest();
      }
      if (n == 901)
        BOOST_TEST(nearest == 900);
      else
        BOOST_TEST(nearest >= 7);
      const Result result = coarsened<CGAL::Sequential_tag>(ranks, soup, nearest, SMC::parameters::faces_per_block(100));
      if (ranks.rank() == 0)
        check_validity(soup, result, nearest);
    }
  });
}

BOOST_AUTO_TEST_CASE(faults_of_pieces)
{
  on_first_ranks(2, [](const mpi::communicator& ranks) {
    const Soup soup = generated::triangulated(generated::torus(12, 10));
    const auto rank = std::size_t(ranks.rank());
    const auto piece_with = [&](const auto& change) {
      Piece piece;
      for (std::size_t f = rank * 120; f < (rank + 1) * 120; ++f)
        add_face(piece, soup, f, soup.polygons[f]);
      change(piece);
      return piece;
    };
    const Piece twice = piece_with([&](Piece& p) {
      if (rank == 1)
        add_face(p, soup, 7, soup.polygons[7]);
    });
    BOOST_TEST(message_of(ranks, twice) == "face 7 of piece 0 is face 120 of piece 1, too");
    const Piece moved = piece_with([&](Piece& p) {
      if (rank == 0)
        p.mesh.point(Mesh::Vertex_index(0)) = test::Point(9, 9, 9);
    });
    BOOST_TEST(contains(message_of(ranks, moved), vertex(soup.polygons[0][0]) + " has two positions, in face "));
    const Piece reversed = piece_with([&](Piece& p) {
      if (rank == 1)
        CGAL::Polygon_mesh_processing::reverse_face_orientations(p.mesh);
    });
    BOOST_TEST(contains(message_of(ranks, reversed), "has two faces on the same side, face "));
    const Piece repeated = piece_with([&](Piece& p) {
      if (rank == 1)
        p.number[Mesh::Vertex_index(1)] = p.number[Mesh::Vertex_index(0)];
    });
    BOOST_TEST(contains(message_of(ranks, repeated), "face 0 of piece 1 visits vertex "));
    const Piece infinite = piece_with([&](Piece& p) {
      if (rank == 1)
        p.mesh.point(Mesh::Vertex_index(5)) = test::Point(0, std::numeric_limits<double>::infinity(), 0);
    });
    BOOST_TEST(contains(message_of(ranks, infinite), "in face 1 of piece 1, has a coordinate that is inf"));
    BOOST_TEST(message_of(ranks, Piece()) == "the input has no faces");
    BOOST_TEST(contains(message_of(ranks, piece_with([](Piece&) {}), 10 + rank), "is 10 on one rank and 11 on another"));
  });
}

// A real block of so many faces would take more memory than test machines have.
BOOST_AUTO_TEST_CASE(block_with_too_many_corners)
{
  using namespace SMC::internal;
  const Soup soup = generated::triangle_sphere(2);
  const Face_names names = [](std::uint64_t f) { return "face " + std::to_string(f) + " of piece 0"; };
  Patch patch;
  Patch_builder builder(patch, names, 3 * soup.polygons.size() - 1);
  Face_record face;
  for (std::size_t f = 0; f < soup.polygons.size(); ++f) {
    face.origin = f;
    face.corner.clear();
    for (const std::size_t v : soup.polygons[f])
      face.corner.push_back({v, {{soup.points[v][0], soup.points[v][1], soup.points[v][2]}}});
    begin_with_smallest_number(face);
    builder.add(face);
  }
  std::string message;
  try {
    builder.run(Run_context());
  } catch (const SMC::Invalid_input& e) {
    message = e.what();
  }
  BOOST_TEST(contains(message, "a block around face "));
  BOOST_TEST(contains(message, " of piece 0 has 384 face corners, more than the 383 that can be numbered"));
}

BOOST_AUTO_TEST_CASE(vertices_that_are_not_manifold)
{
  on_first_ranks(2, [](const mpi::communicator& ranks) {
    Soup soup = generated::joined(generated::triangle_sphere(2), generated::triangle_sphere(2));
    const std::size_t half = soup.points.size() / 2;
    for (auto& polygon : soup.polygons)
      for (std::size_t& v : polygon)
        v = v == half ? 0 : v;
    BOOST_TEST(contains(message_of(ranks, piece_of(soup, ranks)), vertex(0) + " is not a manifold vertex"));
  });
}

BOOST_AUTO_TEST_CASE(what_is_not_available)
{
  on_first_ranks(2, [](const mpi::communicator& ranks) {
    const Piece piece = piece_of(generated::triangle_sphere(2), ranks);
    const auto at_vertices = SMC::parameters::vertex_placement(SMC::Closest_vertex_placement());
    BOOST_TEST(contains(message_of(ranks, piece, 10, at_vertices.repair_output(true)), "repair_output is not available"));
    BOOST_TEST(message_of(ranks, piece, 10, at_vertices) == "");
  });
}

namespace {

struct Impatient_visitor : SMC::Coarsening_visitor_base
{
  int rank;
  SMC::Coarsening_stage last;
  bool is_over = false;

  Impatient_visitor(int r, SMC::Coarsening_stage s) : rank(r), last(s) {}
  void stage_begins(SMC::Coarsening_stage stage) { is_over = is_over || (rank == 1 && stage == last); }
  bool go_further() { return !is_over; }
};

} // namespace

// One rank says stop, and all do.
BOOST_AUTO_TEST_CASE(cancelling_on_one_rank)
{
  on_first_ranks(3, [](const mpi::communicator& ranks) {
    const Piece piece = piece_of(generated::triangle_sphere(4), ranks);
    for (const auto stage :
         {SMC::Coarsening_stage::PREPARATION, SMC::Coarsening_stage::MINIMIZATION, SMC::Coarsening_stage::TRIANGULATION}) {
      Mesh output;
      Impatient_visitor visitor(ranks.rank(), stage);
      BOOST_CHECK_THROW(SMC::coarsen_distributed_mesh(ranks, piece.mesh, piece.number, 20, output,
                                                      SMC::parameters::faces_per_block(200).visitor(std::ref(visitor))),
                        SMC::Coarsening_cancelled);
      BOOST_TEST(output.number_of_vertices() == 0);
    }
  });
}

BOOST_AUTO_TEST_SUITE_END()
