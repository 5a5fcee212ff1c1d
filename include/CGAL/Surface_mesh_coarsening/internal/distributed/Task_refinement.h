// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_TASK_REFINEMENT_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_TASK_REFINEMENT_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/dual_triangles.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Face_record.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Patch.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Record_bins.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Energy_model.h>
#include <CGAL/Surface_mesh_coarsening/internal/output/place_vertices.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// The clusters of a patch whose own faces are all faces of some clusters. A face moves only if all faces around its vertices
// belong to these clusters. Such moves neither affect the moves in other patches nor depend on them, so the patches can be
// processed at the same time and in any order.
class Patch_clusters
{
public:
  explicit Patch_clusters(Patch& patch) : patch_(patch), labels_(patch.mesh())
  {
    Clustering_input& items = patch.input.items;
    items.density.reserve(patch.faces.size());
    for (const Face_data& face : patch.faces)
      items.density.push_back(face.density);
    compute_areas_and_centroids(items);
    // Most faces have the same cluster as the previous face.
    for (std::size_t f = 0; f < patch.faces.size(); ++f)
      if (clusters_.empty() || clusters_.back() != cluster_of(f))
        clusters_.push_back(cluster_of(f));
    sort_unique(clusters_);
    for (std::size_t f = 0; f < patch.faces.size(); ++f)
      labels_.set(Index(f), Index(std::lower_bound(clusters_.begin(), clusters_.end(), cluster_of(f)) - clusters_.begin()));
    labels_.recount();
  }

  const Cluster_labels& labels() const { return labels_; }
  std::size_t size() const { return clusters_.size(); }
  // Whether a cluster consists of own faces; these come first.
  bool is_own(Index x) const { return !clusters_[x].first; }
  Index global_number(Index x) const { return clusters_[x].second; }

  // Runs at most `end.max_rounds` rounds of the minimization. Returns the number of rounds.
  std::size_t minimize(const Energy_model& energy, const Minimization_end& end, const Run_context& context)
  {
    for (Index f = 0; f < patch_.faces.size(); ++f)
      if (!patch_.is_inner_face(f))
        labels_.pin(f);
    const std::unique_ptr<Minimization> minimization = energy.minimization(patch_.input, labels_, size(), false, context);
    std::size_t rounds = 0;
    bool has_ended = false;
    double before = minimization->energy();
    while (rounds < end.max_rounds && !has_ended) {
      const std::size_t some = (std::min)(end.max_rounds - rounds, minimization->rounds_at_a_time());
      const Minimization_progress progress = minimization->run({some, end.tolerance});
      const double after = minimization->energy();
      has_ended = progress.moves == 0 || before - after <= end.tolerance * before;
      before = after;
      rounds += progress.rounds;
    }
    for (std::size_t f = 0; f < patch_.faces.size(); ++f)
      patch_.faces[f].cluster = global_number(labels_[Index(f)]);
    return rounds;
  }

private:
  // Whether the cluster consists of foreign faces, and its number.
  std::pair<bool, Index> cluster_of(std::size_t f) const { return {!patch_.is_own(f), patch_.faces[f].cluster}; }

  Patch& patch_;
  Cluster_labels labels_;
  std::vector<std::pair<bool, Index> > clusters_;
};

// The parts from which the dual of all clusters is assembled.
struct Dual_parts
{
  struct Cluster_part
  {
    Index cluster;
    double energy;
    Vector position; // unless the cluster lies on the border
    Bbox_3 bounds;   // of the position
    bool operator<(const Cluster_part& p) const { return cluster < p.cluster; }
  };
  typedef std::array<std::uint64_t, 2> Center_part; // a face that represents its cell, and its cluster
  struct Triangle_part // a triangle of the fan at a vertex where several clusters meet
  {
    std::uint64_t vertex;
    Index number; // in the fan
    Triangle triangle;
    bool operator<(const Triangle_part& p) const { return std::tie(vertex, number) < std::tie(p.vertex, p.number); }
  };

  std::vector<Cluster_part> clusters;
  std::vector<Center_part> centers;
  std::vector<Triangle_part> triangles;

  void add(const Patch& patch, const Patch_clusters& local, const Rank_context& context)
  {
    const Clustering_input& input = patch.input.items;
    const Flat_mesh& m = input.mesh;
    for (const Face_data& face : patch.faces)
      if (face.is_own && face.is_center)
        centers.push_back({{face.origin, face.cluster}});
    const Clustered_faces surface(input, local.labels(), local.size(), context);
    const auto place = [&](Index x) {
      return context.placement.fitted ? quadric_position(surface, x, Quadric_placement::default_pull)
                                      : context.placement.local(surface, x);
    };
    const std::vector<Cluster_report> reports = context.energy->cluster_reports(input, local.labels(), local.size());
    const auto is_on_border = [&m](Index f) { return m.has_border_edge(f); };
    for (Index x = 0; x < local.size() && local.is_own(x); ++x) {
      const Clustered_faces::Range faces = surface.faces(x);
      context.poll(faces.size());
      const bool has_border = std::any_of(faces.begin(), faces.end(), is_on_border);
      const Vector p = has_border ? Vector{{0, 0, 0}} : checked_position(surface, x, place(x));
      clusters.push_back({local.global_number(x), reports[x].energy, p, surface.vertex_bounds(x)});
    }
    for_each_meeting_point(local.labels(), [&](Index v, const std::vector<Index>& runs) {
      if (!patch.is_own(m.star[m.first_in_star[v]]))
        return; // the first face around the vertex belongs to another patch
      const auto number = [&](std::size_t i) { return local.global_number(runs[i]); };
      for (std::size_t i = 2; i < runs.size(); ++i)
        triangles.push_back({patch.number[v], Index(i), {number(0), number(i - 1), number(i)}});
    });
  }

  // Returns the cluster of the cell that a face represents, if the parts are gathered.
  Index cluster_at(std::uint64_t origin) const
  {
    return Index((*std::lower_bound(centers.begin(), centers.end(), Center_part{{origin, 0}}))[1]);
  }
};

// A vertex and a group with faces at this vertex.
typedef std::array<std::uint64_t, 2> Place;

// Returns the groups at the vertices of a face. `places` is sorted.
inline void find_groups(const Face_record& face, const std::vector<Place>& places, std::vector<Index>& groups)
{
  groups.clear();
  for (const Face_corner& c : face.corner) {
    const auto first = std::lower_bound(places.begin(), places.end(), Place{{c.vertex, 0}});
    for (auto i = first; i != places.end() && (*i)[0] == c.vertex; ++i)
      groups.push_back(Index((*i)[1]));
  }
  sort_unique(groups);
}

// Returns the places of an own bin, sorted, and clears the bin.
inline std::vector<Place> take_places(Record_bins& bins, std::size_t i)
{
  std::vector<Place> places;
  bins.read<Place>(i, [&](const Place& place) { places.push_back(place); });
  bins.clear(i);
  sort_unique(places);
  return places;
}

// `shared` receives, for each group, its shared vertices and the groups with which it shares them.
//
// Each vertex number belongs to a bin. The bin collects the groups with faces at the vertex and informs each group of the others.
inline void find_shared_vertices(Rank_context& context, const Record_bins& faces, Record_bins& shared)
{
  Record_bins places(context, faces.number_of_bins());
  places.fill([&] {
    for (std::size_t i = 0; i < faces.number_of_own(); ++i) {
      Number_table vertices;
      faces.read<Face_record>(i, [&](const Face_record& face) {
        context.poll(words_of_triangle);
        for (const Face_corner& c : face.corner)
          vertices.index(c.vertex);
      });
      for (const std::uint64_t v : vertices.numbers()) {
        // Consecutive numbers, and numbers that differ by powers of two, belong to different bins.
        const std::size_t bin = std::size_t((v * 0x9e3779b97f4a7c15u) >> 32) % faces.number_of_bins();
        places.send(bin, Place{{v, faces.first_own() + i}});
      }
    }
  });
  shared.fill([&] {
    for (std::size_t i = 0; i < places.number_of_own(); ++i) {
      const std::vector<Place> all = take_places(places, i);
      for (auto begin = all.begin(), end = begin; begin != all.end(); begin = end) {
        end = std::find_if(begin, all.end(), [&](const Place& place) { return place[0] != (*begin)[0]; });
        for (auto x = begin; x != end; ++x)
          for (auto y = begin; y != end; ++y)
            if (x != y)
              shared.send(std::size_t((*x)[1]), *y);
      }
    }
  });
}

// Gives each group of faces, a bin, copies of all faces of other groups that share a vertex with its own faces.
inline void share_faces(Rank_context& context, Record_bins& faces)
{
  Record_bins shared(context, faces.number_of_bins());
  find_shared_vertices(context, faces, shared);
  faces.fill([&] {
    std::vector<Index> targets;
    for (std::size_t i = 0; i < faces.number_of_own(); ++i) {
      const std::vector<Place> places = take_places(shared, i);
      // Copies may arrive in this bin while faces are sent, so all copies are collected before.
      std::vector<std::pair<Index, Face_record> > copies;
      faces.read<Face_record>(i, [&](Face_record& face) {
        if (!face.is_own)
          return;
        find_groups(face, places, targets);
        face.is_own = false;
        for (const Index target : targets)
          copies.emplace_back(target, face);
      });
      for (const auto& [target, face] : copies)
        faces.send(target, face);
    }
  });
}

// Two divisions of the clusters into tasks: the two tasks of each cluster. A task is a run of clusters along the curve with at
// most `max_faces` faces, or a single cluster with more faces. The second division begins with half a run, so the borders of the
// first division lie in the middle of its tasks.
typedef std::vector<std::array<Index, 2> > Cluster_tasks;

inline Cluster_tasks divide_into_tasks(const std::vector<std::size_t>& faces, const std::vector<std::uint64_t>& places,
                                       std::size_t max_faces)
{
  std::vector<Index> order(faces.size());
  std::iota(order.begin(), order.end(), Index(0));
  std::sort(order.begin(), order.end(),
            [&](Index i, Index j) { return std::make_pair(places[i], i) < std::make_pair(places[j], j); });
  Cluster_tasks tasks(faces.size());
  for (std::size_t k = 0; k < 2; ++k) {
    Index task = 0;
    std::size_t room = k == 0 ? max_faces : max_faces / 2;
    for (const Index i : order) {
      if (faces[i] > room && (task > 0 || room < max_faces / (k + 1))) {
        ++task;
        room = max_faces;
      }
      tasks[i][k] = task;
      room -= (std::min)(room, faces[i]);
    }
  }
  return tasks;
}

inline std::size_t number_of_tasks(const Cluster_tasks& tasks, std::size_t k)
{
  const auto is_less = [k](const auto& a, const auto& b) { return a[k] < b[k]; };
  return (*std::max_element(tasks.begin(), tasks.end(), is_less))[k] + std::size_t(1);
}

// Sends the own faces to their tasks in a division, and copies to the tasks of all faces with which they share a vertex. The mesh
// of the patch shows these tasks: with share_faces() instead, the coarsening of a torus on disk takes 17 % more processor time.
// Faces that share a vertex with another patch have not moved, so the clusters of the faces of other patches are still valid.
inline void send_to_tasks(const Patch& patch, const Cluster_tasks& tasks, std::size_t division, Record_bins& bins)
{
  const Flat_mesh& m = patch.mesh();
  const auto task_of = [&](Index f) { return tasks[patch.faces[f].cluster][division]; };
  std::vector<char> is_between(m.number_of_vertices(), false); // whether a vertex lies between several tasks
  std::vector<Place> places;                                   // these vertices, and these tasks
  for (Index v = 0; v < is_between.size(); ++v) {
    const auto around = m.faces_around(v);
    is_between[v] = std::any_of(around.begin(), around.end(), [&](Index f) { return task_of(f) != task_of(*around.begin()); });
    if (is_between[v])
      for (const Index f : around)
        places.push_back({{patch.number[v], task_of(f)}});
  }
  sort_unique(places);
  std::vector<Index> targets;
  Face_record face;
  for (Index f = 0; f < patch.faces.size(); ++f) {
    if (!patch.is_own(f))
      continue;
    patch.get(f, face);
    bins.send(task_of(f), face);
    if (!m.any_corner(f, [&](Index c) { return is_between[m.corner_vertex[c]]; }))
      continue;
    find_groups(face, places, targets);
    face.is_own = false;
    for (const Index target : targets)
      if (target != task_of(f))
        bins.send(target, face);
  }
}

// Refines the clusters face by face, in tasks of nearby clusters. Two divisions into tasks alternate. `faces` holds the own faces
// of the tasks of the first division. At the end, calls `receive(patch, clusters)` for each task, which may send results to the
// bins `last`. Returns the number of rounds.
template <class Receive>
std::size_t refine_tasks(Rank_context& context, const Cluster_tasks& tasks, std::unique_ptr<Record_bins> faces, Record_bins& last,
                         const Receive& receive)
{
  constexpr std::size_t max_phases = 4, max_rounds_of_phase = 20;
  // Clusters of cells have a low energy, but vertices of irregular degree. Rounds that hardly lower the energy remove them.
  constexpr double part_of_tolerance = 0.01;
  const std::size_t phases = number_of_tasks(tasks, 0) == 1 ? 1 : max_phases;
  const Minimization_end end{(std::min)(context.end.max_rounds, max_rounds_of_phase * (max_phases / phases)),
                             part_of_tolerance * context.end.tolerance};
  std::size_t rounds = 0;
  share_faces(context, *faces);
  for (std::size_t phase = 0; phase < phases; ++phase) {
    const bool is_last = phase + 1 == phases;
    const std::size_t next = (phase + 1) % 2;
    auto faces_of_next = std::make_unique<Record_bins>(context, is_last ? 0 : number_of_tasks(tasks, next));
    std::size_t rounds_of_phase = 0;
    (is_last ? last : *faces_of_next).fill([&] {
      for (std::size_t i = 0; i < faces->number_of_own(); ++i) {
        Patch patch = take_patch(*faces, i, context);
        Patch_clusters clusters(patch);
        rounds_of_phase = (std::max)(rounds_of_phase, clusters.minimize(*context.energy, end, context));
        if (is_last)
          receive(patch, clusters);
        else
          send_to_tasks(patch, tasks, next, *faces_of_next);
      }
    });
    rounds += boost::mpi::all_reduce(context.communicator, rounds_of_phase, boost::mpi::maximum<std::size_t>());
    faces = std::move(faces_of_next);
  }
  return rounds;
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_TASK_REFINEMENT_H
