// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_DISTRIBUTED_COARSENING_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_DISTRIBUTED_COARSENING_H

#include <CGAL/Surface_mesh_coarsening/Coarsening_report.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Cell_clustering.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Face_record.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Record_bins.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Task_refinement.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>

#include <boost/mpi/collectives.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening {

// Boost.Serialization calls this function. It names all members, so it does not compile if a member is added.
template <class Archive>
void serialize(Archive& archive, Coarsening_report& report, unsigned)
{
  auto& [level, seeds, clusters, splits, merges, rounds, moves, tests, refused_by_boundary_counts, refused_by_guarantee,
         initial_energy, final_energy, converged, subdivided_components, exchanged_vertices,
         intersections_found, intersections_left, intersecting_faces, reversals_found, reversals_left, narrow_faces, clusterings,
         feature_lines, feature_corners] = report;
  archive & level & seeds & clusters & splits & merges & rounds & moves & tests & refused_by_boundary_counts &
    refused_by_guarantee & initial_energy & final_energy & converged & subdivided_components & exchanged_vertices &
    intersections_found & intersections_left & intersecting_faces & reversals_found & reversals_left & narrow_faces &
    clusterings & feature_lines & feature_corners;
}

namespace internal {

// Receives a face: the global numbers and the points of its vertices, and its density.
typedef std::function<void(const std::vector<std::uint64_t>&, const std::vector<Vector>&, double)> Face_receiver;

// Passes all faces of a piece to the receiver, in the same order in each call.
typedef std::function<void(const Face_receiver&)> Face_source;

// Returns a source of the faces of a face graph, which refers to the arguments.
template <class FaceGraph, class VertexNumberMap, class NamedParameters>
auto source_of_graph(const FaceGraph& graph, const VertexNumberMap& numbers, const NamedParameters& np)
{
  return [&](const auto& receive) {
    const auto coordinates = vertex_coordinates(graph, np);
    std::vector<std::uint64_t> vertices;
    std::vector<Vector> points;
    for (const auto f : faces(graph)) {
      vertices.clear();
      points.clear();
      for (const auto h : halfedges_around_face(halfedge(f, graph), graph)) {
        const auto v = target(h, graph);
        vertices.push_back(std::uint64_t(get(numbers, v)));
        points.push_back(coordinates(v));
      }
      receive(vertices, points);
    }
  };
}

// Reads the pieces of all ranks three times: for the bounding box, for the limits of the blocks, and into the blocks.
class Piece_blocks
{
public:
  Morton_curve curve{{{0, 0, 0}}, {{0, 0, 0}}}; // of the mesh in its frame
  std::uint64_t faces = 0;                      // of this piece
  std::vector<std::uint64_t> first_face = {0};  // of each piece, and the total

  Piece_blocks(Rank_context& context, const Face_source& source) : context_(context), source_(source) {}

  // Checks each face, finds the frame of the mesh, and gives faces without names a name. Throws an exception that names the first
  // invalid face of this piece.
  void measure()
  {
    Bbox_3 box;
    std::optional<Fault> fault;
    on_all_ranks(context_.communicator, [&] {
      source_([&](const std::vector<std::uint64_t>& vertices, const std::vector<Vector>& points, double density) {
        context_.poll();
        if (!fault)
          fault = find_fault(vertices, points, density);
        ++faces;
        for (const Vector& p : points)
          box += box_of_point(p);
      });
    });
    std::vector<std::uint64_t> all_faces;
    boost::mpi::all_gather(context_.communicator, faces, all_faces);
    std::partial_sum(all_faces.begin(), all_faces.end(), std::back_inserter(first_face));
    if (!context_.face_names)
      context_.face_names = [this](std::uint64_t face) {
        const auto [piece, number] = origin(face);
        return "face " + std::to_string(number) + " of piece " + std::to_string(piece);
      };
    on_all_ranks(context_.communicator, [&] {
      if (faces >= NONE)
        throw Invalid_input("piece " + std::to_string(context_.rank()) + " has more faces than the " + std::to_string(NONE - 1) +
                            " that can be numbered");
      if (fault)
        throw Invalid_input(fault->before + context_.face_names(first_face[context_.rank()] + fault->face) + fault->after);
    });
    if (first_face.back() == 0)
      throw Invalid_input("the input has no faces");
    // Minima do not depend on the order of their computation.
    const double own[6] = {box.xmin(), box.ymin(), box.zmin(), -box.xmax(), -box.ymax(), -box.zmax()};
    double all[6];
    boost::mpi::all_reduce(context_.communicator, own, 6, all, boost::mpi::minimum<double>());
    std::vector<Vector> ends = {{{all[0], all[1], all[2]}}, {{-all[3], -all[4], -all[5]}}};
    context_.frame = to_local_frame(ends, {0, 1, 2}, Run_context());
    curve = Morton_curve(ends[0], ends[1]);
  }

  // Returns the rank whose piece contains a face, and the number of the face in this piece.
  std::pair<std::size_t, std::uint64_t> origin(std::uint64_t face) const
  {
    const auto next = std::upper_bound(first_face.begin(), first_face.end(), face);
    return {std::size_t(next - first_face.begin() - 1), face - *(next - 1)};
  }

  // Reads each face into its block.
  std::unique_ptr<Record_bins> read(std::size_t faces_per_block) const
  {
    std::vector<std::uint64_t> places;
    on_all_ranks(context_.communicator, [&] {
      places.reserve(faces);
      for_each_record([&](const Face_record& face) { places.push_back(face.place); });
    });
    const auto sum = [this](const std::vector<std::uint64_t>& own) {
      std::vector<std::uint64_t> all(own.size());
      boost::mpi::all_reduce(context_.communicator, own.data(), int(own.size()), all.data(), std::plus<std::uint64_t>());
      return all;
    };
    const std::vector<std::uint64_t> starts = block_starts(std::move(places), faces_per_block, sum);
    auto blocks = std::make_unique<Record_bins>(context_, starts.size());
    blocks->fill([&] {
      for_each_record([&](const Face_record& face) { blocks->send(block_of(starts, face.place), face); });
    });
    return blocks;
  }

private:
  // What is wrong with a face: a sentence around its name.
  struct Fault
  {
    std::uint64_t face;
    std::string before, after;
  };

  std::optional<Fault> find_fault(const std::vector<std::uint64_t>& vertices, const std::vector<Vector>& points,
                                  double density) const
  {
    const auto fault = [&](const std::string& before, const std::string& after) { return Fault{faces, before, after}; };
    if (vertices.size() < 3 || vertices.size() > Face_data::max_corners)
      return fault("", " has " + std::to_string(vertices.size()) + " sides");
    if (!(density >= 1 / largest_density && density <= largest_density))
      return fault("the density of ", " is " + number_text(density) + ", not in [1e-20, 1e20]");
    for (std::size_t i = 0; i < vertices.size(); ++i)
      for (const double x : points[i])
        if (!std::isfinite(x))
          return fault("vertex " + std::to_string(vertices[i]) + ", in ", ", has a coordinate that is " + number_text(x));
    if (vertices.size() == 3 && vertices[0] != vertices[1] && vertices[1] != vertices[2] && vertices[2] != vertices[0])
      return std::nullopt;
    std::vector<std::uint64_t> sorted = vertices;
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice == sorted.end())
      return std::nullopt;
    return fault("", " visits vertex " + std::to_string(*twice) + " twice");
  }

  template <class Receive>
  void for_each_record(const Receive& receive) const
  {
    Face_record face;
    std::uint64_t number = first_face[context_.rank()];
    source_([&](const std::vector<std::uint64_t>& vertices, const std::vector<Vector>& points, double density) {
      context_.poll();
      face.corner.clear();
      for (std::size_t i = 0; i < vertices.size(); ++i)
        face.corner.push_back({vertices[i], context_.frame.to_local(points[i])});
      begin_with_smallest_number(face);
      face.density = density;
      face.place = curve(mean_of_corners(face));
      face.origin = number++;
      receive(face);
    });
  }

  Rank_context& context_;
  const Face_source source_;
};

// The pipeline across ranks. It divides blocks of faces along a space-filling curve into cells. Rank 0 clusters the mesh of
// cells. Tasks of nearby clusters are refined face by face. Then vertices are placed, and rank 0 triangulates. All results
// depend on blocks and clusters, but not on the ranks that hold them, nor on whether they are in memory or on disk.
class Distributed_coarsening
{
public:
  Distributed_report report;
  std::vector<Index> clusters; // of the faces of the piece of this rank, on request
  Placed_dual dual;            // on rank 0, and on all ranks on request

  Distributed_coarsening(Rank_context& context, const Face_source& source)
    : context_(context), pieces_(context, source), labels_(context, context.number_of_ranks())
  {}

  void run()
  {
    check_equal(context_.number_of_vertices, "number of vertices");
    check_equal(context_.faces_per_block.value_or(0), "number of faces per block");
    begin_stage(Coarsening_stage::PREPARATION);
    pieces_.measure();
    std::unique_ptr<Record_bins> blocks =
      pieces_.read(context_.faces_per_block.value_or(Rank_context::default_faces_per_block));
    share_faces(context_, *blocks);
    context_.stage_ends(Coarsening_stage::PREPARATION);
    Cell_clusters cells = Cell_clustering(context_, pieces_.curve).run(*blocks, pieces_.first_face.back());
    Coarsening_report& report_of_cells = report;
    report_of_cells = cells.report;
    if (cells.level == 0)
      take_dual(cells, *blocks);
    else
      refine_and_place(cells, std::move(blocks));
    on_all_ranks(context_.communicator, [&] {
      clusters.assign(context_.wants_clusters ? pieces_.faces : 0, NONE);
      labels_.read<Face_label>(0, [&](const Face_label& label) { clusters[label.face] = label.cluster; });
    });
    on_first_rank(context_, [&] { report_placement(report, dual.triangles, dual.positions, dual.counts); });
    if (context_.wants_output_everywhere) {
      broadcast_records(context_, dual.triangles);
      broadcast_records(context_, dual.positions);
    }
    boost::mpi::broadcast(context_.communicator, report_of_cells, 0);
    report.bytes_sent = context_.bytes_sent;
    report.bytes_of_scratch = context_.scratch.bytes_written();
  }

private:
  // The cluster of a face of a piece.
  struct Face_label
  {
    Index face, cluster;
  };

  void send_label(std::uint64_t face, Index cluster)
  {
    if (!context_.wants_clusters)
      return;
    const auto [rank, number] = pieces_.origin(face);
    labels_.send(rank, Face_label{Index(number), cluster});
  }

  void begin_stage(Coarsening_stage stage) const
  {
    on_all_ranks(context_.communicator, [&] { context_.stage_begins(stage); });
  }

  void check_equal(std::uint64_t value, const char* what) const
  {
    const std::uint64_t min = boost::mpi::all_reduce(context_.communicator, value, boost::mpi::minimum<std::uint64_t>());
    const std::uint64_t max = boost::mpi::all_reduce(context_.communicator, value, boost::mpi::maximum<std::uint64_t>());
    if (min != max)
      throw Invalid_input(std::string("the ") + what + " is " + std::to_string(min) + " on one rank and " + std::to_string(max) +
                          " on another");
  }

  // Used if the cells are the faces; then rank 0 has placed the vertices.
  void take_dual(Cell_clusters& cells, const Record_bins& blocks)
  {
    dual = std::move(cells.dual);
    labels_.fill([&] {
      for (std::size_t i = 0; i < blocks.number_of_own(); ++i)
        blocks.read<Face_record>(i, [&](const Face_record& face) {
          if (face.is_own)
            send_label(face.origin, cells.clusters[face.cluster]);
        });
    });
  }

  void refine_and_place(Cell_clusters& cells, std::unique_ptr<Record_bins> blocks)
  {
    begin_stage(Coarsening_stage::MINIMIZATION);
    auto tasks = std::make_unique<Record_bins>(context_, number_of_tasks(cells.tasks, 0));
    tasks->fill([&] {
      for (std::size_t i = 0; i < blocks->number_of_own(); ++i) {
        blocks->read<Face_record>(i, [&](Face_record& face) {
          if (!face.is_own)
            return;
          face.cluster = cells.clusters[face.cluster];
          face.density = cells.density(face.density);
          tasks->send(cells.tasks[face.cluster][0], face);
        });
        blocks->clear(i);
      }
    });
    blocks.reset();
    Dual_parts parts;
    const auto receive = [&](const Patch& patch, const Patch_clusters& local) {
      parts.add(patch, local, context_);
      for (const Face_data& face : patch.faces)
        if (face.is_own)
          send_label(face.origin, face.cluster);
    };
    report.rounds += refine_tasks(context_, cells.tasks, std::move(tasks), labels_, receive);
    context_.stage_ends(Coarsening_stage::MINIMIZATION);
    begin_stage(Coarsening_stage::TRIANGULATION);
    gather_sorted(context_, parts.clusters);
    gather_sorted(context_, parts.centers);
    gather_sorted(context_, parts.triangles);
    on_first_rank(context_, [&] {
      report.final_energy = 0;
      for (const Dual_parts::Cluster_part& cluster : parts.clusters) {
        report.final_energy += cluster.energy;
        dual.positions.push_back(cluster.position);
      }
      for (const Dual_parts::Triangle_part& part : parts.triangles)
        dual.triangles.push_back(part.triangle);
    });
    context_.stage_ends(Coarsening_stage::TRIANGULATION);
    on_first_rank(context_, [&] {
      if (cells.surface)
        cells.surface->place(parts, context_, dual);
    });
  }

  Rank_context& context_;
  Piece_blocks pieces_;
  Record_bins labels_; // the clusters of all faces, in the bins of their pieces
};

} // namespace internal
} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_DISTRIBUTED_COARSENING_H
