// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_DUAL_PARTS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_DUAL_PARTS_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/dual_triangles.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Distributed_choice.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Patch.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Border_fit.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/subdivision.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Energy_model.h>
#include <CGAL/Surface_mesh_coarsening/internal/output/place_vertices.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The clusters of a patch whose own faces are all faces of some clusters. A face moves only if all faces around its vertices
// belong to these clusters. Such moves neither affect the moves in other patches nor depend on them, so the patches can be
// processed at the same time and in any order.
class Patch_clusters
{
public:
  explicit Patch_clusters(Patch& patch) : patch_(patch), input_{input_of(patch), nullptr}, labels_(input_.items.mesh)
  {
    global_ = clusters_of(true);
    own_ = global_.size();
    const std::vector<Index> foreign = clusters_of(false);
    global_.insert(global_.end(), foreign.begin(), foreign.end());
    Index last = NONE, number = NONE;
    for (std::size_t f = 0; f < patch.faces.size(); ++f) {
      if (patch.faces.cluster[f] != last) {
        last = patch.faces.cluster[f];
        number = local_number(last);
      }
      labels_.set(Index(f), number);
    }
    labels_.recount();
  }

  const Clustering_input& input() const { return input_.items; }
  const Cluster_labels& labels() const { return labels_; }
  std::size_t size() const { return global_.size(); }
  // The clusters of the own faces come first.
  std::size_t number_of_own() const { return own_; }
  Index global_number(Index x) const { return global_[x]; }

  // Runs at most `end.max_rounds` rounds of the minimization. Returns the number of rounds.
  std::size_t minimize(const Energy_model& energy, const Minimization_end& end, const Cancellation_point& cancellation,
                       Execution execution)
  {
    for (Index f = 0; f < input().mesh.number_of_faces(); ++f)
      if (!may_move(f))
        labels_.pin(f);
    const std::unique_ptr<Minimization> minimization =
      energy.minimization(input_, labels_, size(), false, cancellation, execution);
    std::size_t rounds = 0;
    bool has_ended = false;
    double before = minimization->energy();
    while (rounds < end.max_rounds && !has_ended) {
      const std::size_t some = (std::min)(end.max_rounds - rounds, minimization->rounds_at_a_time());
      const Minimization::Progress progress = minimization->run({some, end.tolerance});
      const double after = minimization->energy();
      has_ended = progress.moves == 0 || before - after <= end.tolerance * before;
      before = after;
      rounds += progress.rounds;
    }
    for (std::size_t f = 0; f < patch_.faces.size(); ++f)
      patch_.faces.cluster[f] = global_[labels_[Index(f)]];
    return rounds;
  }

private:
  // Moves the mesh out of the patch.
  static Clustering_input input_of(Patch& patch)
  {
    Clustering_input input;
    input.mesh = std::move(patch.mesh);
    input.density = patch.faces.density;
    compute_areas_and_centroids(input);
    return input;
  }

  // Returns the clusters of the own or the foreign faces, in order. Most faces have the same cluster as the previous face.
  std::vector<Index> clusters_of(bool own) const
  {
    std::vector<Index> clusters;
    for (std::size_t f = 0; f < patch_.faces.size(); ++f)
      if (patch_.is_own(f) == own && (clusters.empty() || clusters.back() != patch_.faces.cluster[f]))
        clusters.push_back(patch_.faces.cluster[f]);
    sort_unique(clusters);
    return clusters;
  }

  Index local_number(Index cluster) const
  {
    const auto middle = global_.begin() + std::ptrdiff_t(own_);
    const auto i = std::lower_bound(global_.begin(), middle, cluster);
    return Index((i != middle && *i == cluster ? i : std::lower_bound(middle, global_.end(), cluster)) - global_.begin());
  }

  bool may_move(Index f) const
  {
    const Flat_mesh& m = input().mesh;
    for (Index c = m.first_corner[f]; c != m.first_corner[f + 1]; ++c)
      if (!patch_.is_inner[m.corner_vertex[c]])
        return false;
    return true;
  }

  Patch& patch_;
  Featured_input input_; // without features
  Cluster_labels labels_;
  std::vector<Index> global_; // number of each cluster
  std::size_t own_ = 0;
};

// The parts from which the dual of all clusters is assembled.
struct Dual_parts
{
  struct Cluster_part
  {
    Index cluster;
    double energy;
    Vector position;
    Bbox_3 bounds; // of the position
  };
  struct Border_part // an edge of the border
  {
    std::uint64_t source, target;
    Index cluster;
    Vector point; // at the source
  };
  struct Meeting_point // a vertex where several clusters meet, counterclockwise
  {
    std::uint64_t vertex;
    std::vector<Index> clusters;
  };

  struct Center_part // a face that represents its cell
  {
    std::uint64_t origin;
    Index cluster;
  };

  std::vector<Cluster_part> clusters;
  std::vector<Border_part> border;
  std::vector<Center_part> centers; // if vertices are placed on the surface of cells
  std::vector<Meeting_point> meeting_points;

  void add(const Patch& patch, const Patch_clusters& clusters_of_patch, const Distributed_choice& choice,
           const Cancellation_point& cancellation)
  {
    const Clustering_input& input = clusters_of_patch.input();
    const Cluster_labels& labels = clusters_of_patch.labels();
    std::vector<char> is_on_border(clusters_of_patch.size(), false);
    for (Index f = 0; f < input.mesh.number_of_faces(); ++f) {
      if (patch.is_own(f))
        add_border(patch, clusters_of_patch, f, is_on_border);
      if (choice.places_on_cells() && patch.is_own(f) && patch.faces.is_center[f])
        centers.push_back({patch.faces.origin[f], patch.faces.cluster[f]});
    }
    const Clustered_faces surface(input, labels, clusters_of_patch.size(), choice.execution, nullptr, cancellation);
    const auto& place = choice.placement.local ? choice.placement.local : choice.placement.start;
    const std::vector<double> energy = choice.energies(input, labels, clusters_of_patch.size());
    for (Index x = 0; x < clusters_of_patch.number_of_own(); ++x) {
      cancellation.poll(surface.faces(x).size());
      const Vector p = is_on_border[x] ? Vector{{0, 0, 0}} : checked_position(surface, x, place(surface, x));
      clusters.push_back({clusters_of_patch.global_number(x), energy[x], p, surface.vertex_bounds(x)});
    }
    for_each_meeting_point(labels, [&](Index v, const std::vector<Index>& runs) {
      if (!patch.is_own(input.mesh.star[input.mesh.first_in_star[v]]))
        return; // the first face around the vertex belongs to another patch
      meeting_points.push_back({patch.number[v], {}});
      for (const Index x : runs)
        meeting_points.back().clusters.push_back(clusters_of_patch.global_number(x));
    });
  }

  Words words() const
  {
    Words words{clusters.size(), border.size(), centers.size()};
    for (const Cluster_part& x : clusters) {
      words.push_back(x.cluster);
      words.push_back(to_word(x.energy));
      write(x.position, words);
      write(low_corner(x.bounds), words);
      write(high_corner(x.bounds), words);
    }
    for (const Border_part& e : border) {
      words.insert(words.end(), {e.source, e.target, e.cluster});
      write(e.point, words);
    }
    for (const Center_part& center : centers)
      words.insert(words.end(), {center.origin, center.cluster});
    for (const Meeting_point& p : meeting_points) {
      words.push_back(p.vertex);
      words.push_back(p.clusters.size());
      words.insert(words.end(), p.clusters.begin(), p.clusters.end());
    }
    return words;
  }

  void read(const Words& words)
  {
    std::size_t i = 3;
    for (std::size_t k = 0; k < words[0]; ++k, i += 11)
      clusters.push_back({Index(words[i]), to_double(words[i + 1]), vector_at(words, i + 2),
                          box_of_point(vector_at(words, i + 5)) + box_of_point(vector_at(words, i + 8))});
    for (std::size_t k = 0; k < words[1]; ++k, i += 6)
      border.push_back({words[i], words[i + 1], Index(words[i + 2]), vector_at(words, i + 3)});
    for (std::size_t k = 0; k < words[2]; ++k, i += 2)
      centers.push_back({words[i], Index(words[i + 1])});
    while (i < words.size()) {
      meeting_points.push_back({words[i], {}});
      const std::size_t end = i + 2 + words[i + 1];
      for (i += 2; i < end; ++i)
        meeting_points.back().clusters.push_back(Index(words[i]));
    }
  }

  double energy() const
  {
    std::vector<double> energies(clusters.size());
    for (const Cluster_part& x : clusters)
      energies[x.cluster] = x.energy;
    double sum = 0;
    for (const double e : energies)
      sum += e;
    return sum;
  }

  // Returns the triangles in the order of the numbers of the vertices where the clusters meet.
  std::vector<Triangle> triangles()
  {
    std::sort(meeting_points.begin(), meeting_points.end(),
              [](const Meeting_point& a, const Meeting_point& b) { return a.vertex < b.vertex; });
    std::vector<Triangle> triangles;
    for (const Meeting_point& p : meeting_points)
      for (std::size_t i = 2; i < p.clusters.size(); ++i)
        triangles.push_back({p.clusters[0], p.clusters[i - 1], p.clusters[i]});
    return triangles;
  }

  // Returns the bounds of the position of each cluster.
  std::vector<Bbox_3> bounds() const
  {
    std::vector<Bbox_3> bounds(clusters.size());
    for (const Cluster_part& x : clusters)
      bounds[x.cluster] = x.bounds;
    return bounds;
  }

  std::vector<Vector> positions()
  {
    std::vector<Vector> positions(clusters.size());
    for (const Cluster_part& x : clusters)
      positions[x.cluster] = x.position;
    place_on_border(positions);
    return positions;
  }

private:
  static void write(const Vector& p, Words& words)
  {
    for (const double x : p)
      words.push_back(to_word(x));
  }
  static Vector vector_at(const Words& words, std::size_t i)
  {
    return {{to_double(words[i]), to_double(words[i + 1]), to_double(words[i + 2])}};
  }

  void add_border(const Patch& patch, const Patch_clusters& clusters_of_patch, Index f, std::vector<char>& is_on_border)
  {
    const Flat_mesh& m = clusters_of_patch.input().mesh;
    const Index x = clusters_of_patch.labels()[f];
    for (Index c = m.first_corner[f]; c != m.first_corner[f + 1]; ++c)
      if (m.face_across[c] == NONE) {
        const Index v = m.corner_vertex[c], w = m.corner_vertex[m.next_corner(f, c)];
        border.push_back({patch.number[v], patch.number[w], clusters_of_patch.global_number(x), m.points[v]});
        is_on_border[x] = true;
      }
  }

  void place_on_border(std::vector<Vector>& positions)
  {
    std::sort(border.begin(), border.end(), [](const Border_part& a, const Border_part& b) { return a.source < b.source; });
    std::vector<char> done(border.size(), false);
    for (std::size_t i = 0; i < border.size(); ++i) {
      if (done[i])
        continue;
      std::vector<Index> cluster_after;
      std::vector<Vector> points;
      for (std::size_t j = i; !done[j]; j = after(border[j])) {
        done[j] = true;
        cluster_after.push_back(border[j].cluster);
        points.push_back(border[j].point);
      }
      fit_border_loop(
        cluster_after,
        [&](const std::vector<std::size_t>& places, Index) {
          std::vector<Vector> arc;
          for (const std::size_t place : places)
            arc.push_back(points[place]);
          return Border_arc(arc);
        },
        [&](Index cluster, const Vector& p) { positions[cluster] = p; });
    }
  }

  std::size_t after(const Border_part& e) const
  {
    return std::size_t(std::lower_bound(border.begin(), border.end(), e.target,
                                        [](const Border_part& a, std::uint64_t number) { return a.source < number; }) -
                       border.begin());
  }
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_DUAL_PARTS_H
