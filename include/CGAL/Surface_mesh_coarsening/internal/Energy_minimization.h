// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_ENERGY_MINIMIZATION_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_ENERGY_MINIMIZATION_H

#include <CGAL/Surface_mesh_coarsening/internal/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/Valid_moves.h>
#include <CGAL/Surface_mesh_coarsening/internal/Visitor_handle.h>
#include <CGAL/Surface_mesh_coarsening/internal/parallel.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// What the energy (8) of a cluster is made of. It is the weight times the inertia about the centroid (7).
template <class Weight>
struct Cluster_sums
{
  double mass = 0;               // sum r A
  Vector centroid{{0, 0, 0}};    // sum r A g / mass
  double inertia = 0;            // sum r A |g - centroid|^2
  double energy = 0;
  Index faces = 0;
  Index round_of_change = 0;
  typename Weight::Cluster_data data;
};

// Sections 5.1 and 8.2 of the paper: in rounds over the edges between clusters, the face on one side or on the other
// joins the cluster across, whichever lowers the energy more, as long as the clusters remain discs whose dual is a
// simplicial surface. All weights are those of the current sums, so the energy is a function of the clustering and
// falls with each move.
//
// Batch by batch of edges, a round first looks for such moves, at the sums as they are, which can be done for many edges at
// a time, and then makes those in the order of the edges that still lower the energy.
template <class Weight>
class Energy_minimization
{
public:
  Energy_minimization(const Clustering_input& input, Cluster_labels& labels, std::size_t number_of_clusters,
                      const Weight& weight, const Checkpoint& checkpoint, Execution execution)
    : mesh_(input.mesh), labels_(labels), weight_(weight), checkpoint_(checkpoint), execution_(execution), moves_(labels, number_of_clusters),
      faces_(mesh_.number_of_faces()), clusters_(number_of_clusters)
  {
    for_each_chunk(execution_, faces_.size(), chunk, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f)
        faces_[f] = {input.mass(Index(f)), input.centroid[f], weight_.face_data(input.density[f], input.area[f])};
    });
    sum_up();
    list_boundary_edges();
  }

  // One round. Returns the number of moves.
  std::size_t round()
  {
    ++round_;
    // Sums that are updated again and again drift by roundings.
    if (round_ % 64 == 0)
      sum_up();
    std::size_t moves = run(false);
    // Edges were passed over whose two clusters had not changed. Whether a move is allowed depends on others, too:
    // the end is reached when no edge at all has a move left.
    if (moves == 0)
      moves = run(true);
    CGAL_expensive_assertion(agrees_with_recount());
    return moves;
  }

  // Whether the boundary-edge counts and the sums are those that counting and adding up from scratch gives.
  bool agrees_with_recount() const
  {
    if (labels_.recounted() != labels_.boundary_counts())
      return false;
    Energy_minimization fresh(*this);
    fresh.sum_up();
    const auto agree = [](double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(b); };
    for (std::size_t i = 0; i < clusters_.size(); ++i) {
      const Cluster_sums<Weight>&x = clusters_[i], &y = fresh.clusters_[i];
      if (x.faces != y.faces || !agree(x.mass, y.mass) || !agree(x.inertia, y.inertia) || !agree(x.energy, y.energy))
        return false;
    }
    return true;
  }

  double energy() const
  {
    double sum = 0;
    for (const Cluster_sums<Weight>& x : clusters_)
      sum += x.energy;
    return sum;
  }

  std::size_t tests() const { return tests_; }

private:
  static constexpr std::size_t chunk = 4096;
  static constexpr std::size_t batch = 1024, part_of_batch = 128; // edges

  struct Face
  {
    double mass;
    Vector centroid;
    typename Weight::Face_data data;
  };

  // An edge between two faces, by its corner in the one of smaller index.
  struct Edge
  {
    Index face, across, corner;
  };

  struct Move
  {
    Index face, to;
  };

  // What a move would make of the energies of the two clusters.
  struct Trial
  {
    Index face, to;
    double gain;      // by which the energy falls
    double scale;     // of the changes of energy that it is the difference of
    double magnitude; // of the energies that these are the difference of
  };

  // All sums from scratch.
  void sum_up()
  {
    for (Cluster_sums<Weight>& x : clusters_) {
      const Index round_of_change = x.round_of_change;
      x = Cluster_sums<Weight>();
      x.round_of_change = round_of_change;
    }
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      Cluster_sums<Weight>& x = clusters_[labels_[Index(f)]];
      x.mass += faces_[f].mass;
      x.centroid = x.centroid + faces_[f].mass * faces_[f].centroid;
      ++x.faces;
      weight_.add(x.data, faces_[f].data);
    }
    for (Cluster_sums<Weight>& x : clusters_)
      if (x.mass > 0)
        x.centroid = (1 / x.mass) * x.centroid;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      Cluster_sums<Weight>& x = clusters_[labels_[Index(f)]];
      x.inertia += faces_[f].mass * squared_distance(faces_[f], x);
    }
    for (Cluster_sums<Weight>& x : clusters_)
      update_energy(x);
  }

  static double squared_distance(const Face& face, const Cluster_sums<Weight>& x)
  {
    const Vector d = face.centroid - x.centroid;
    return dot(d, d);
  }

  void update_energy(Cluster_sums<Weight>& x) const
  {
    x.energy = x.mass > 0 ? weight_.weight(x.data, x.mass, x.faces) * x.inertia : 0;
  }

  // The inertia after a mass has joined or left, by the parallel axis theorem.
  static double inertia_with(const Cluster_sums<Weight>& x, double mass, double sum, double squared_distance)
  {
    return x.inertia + (sum > 0 ? mass * x.mass / sum * squared_distance : 0);
  }
  static double inertia_without(const Cluster_sums<Weight>& x, double mass, double rest, double squared_distance)
  {
    return (std::max)(0., x.inertia - (rest > 0 ? mass * x.mass / rest * squared_distance : 0));
  }

  double energy_with(const Cluster_sums<Weight>& x, const Face& face) const
  {
    const double mass = x.mass + face.mass;
    if (!(mass > 0))
      return 0;
    return weight_.weight_with(x.data, face.data, mass, x.faces + 1) *
           inertia_with(x, face.mass, mass, squared_distance(face, x));
  }

  double energy_without(const Cluster_sums<Weight>& x, const Face& face) const
  {
    const double mass = x.mass - face.mass;
    if (!(mass > 0))
      return 0;
    return weight_.weight_without(x.data, face.data, mass, x.faces - 1) *
           inertia_without(x, face.mass, mass, squared_distance(face, x));
  }

  void add(Cluster_sums<Weight>& x, const Face& face) const
  {
    const double mass = x.mass + face.mass;
    x.inertia = inertia_with(x, face.mass, mass, squared_distance(face, x));
    if (mass > 0)
      x.centroid = x.centroid + (face.mass / mass) * (face.centroid - x.centroid);
    x.mass = mass;
    ++x.faces;
    weight_.add(x.data, face.data);
    update_energy(x);
  }

  void remove(Cluster_sums<Weight>& x, const Face& face) const
  {
    const double mass = x.mass - face.mass;
    x.inertia = inertia_without(x, face.mass, mass, squared_distance(face, x));
    if (mass > 0)
      x.centroid = x.centroid - (face.mass / mass) * (face.centroid - x.centroid);
    x.mass = mass;
    --x.faces;
    weight_.remove(x.data, face.data);
    update_energy(x);
  }

  Trial trial(Index f, Index to) const
  {
    const Cluster_sums<Weight>& source = clusters_[labels_[f]];
    const Cluster_sums<Weight>& target = clusters_[to];
    if (source.faces == 1)
      return {f, to, -1, 0, 0};
    const double without = energy_without(source, faces_[f]), with = energy_with(target, faces_[f]);
    const double lost = source.energy - without, won = with - target.energy;
    return {f, to, lost - won, std::abs(lost) + std::abs(won), source.energy + target.energy + without + with};
  }

  // Gains this small, relative to what they are the difference of, are taken for none. So moves between equal
  // energies, frequent on regular meshes, do not depend on roundings, and each move lowers the energy as computed.
  static bool is_gain(const Trial& t) { return t.gain > 1e-7 * t.scale && t.gain > 1e-12 * t.magnitude; }
  static bool is_better(const Trial& t, const Trial& than)
  {
    return t.gain - than.gain > 1e-7 * (t.scale + than.scale);
  }

  void list_boundary_edges()
  {
    is_listed_.assign(mesh_.corner_vertex.size(), false);
    for (std::size_t f = 0; f < mesh_.number_of_faces(); ++f) {
      checkpoint_.pass();
      for (Index c = mesh_.first_corner[f]; c != mesh_.first_corner[f + 1]; ++c) {
        const Index g = mesh_.face_across[c];
        if (g != NONE && g > f && labels_[g] != labels_[Index(f)]) {
          edges_.push_back({Index(f), g, c});
          is_listed_[c] = true;
        }
      }
    }
  }

  std::size_t run(bool all)
  {
    std::size_t moves = 0;
    const std::size_t edges = edges_.size();
    for (std::size_t begin = 0; begin < edges; begin += batch) {
      checkpoint_.pass((std::min)(edges - begin, batch));
      find_moves(begin, (std::min)(edges, begin + batch), all);
      for (const std::vector<Move>& found : found_)
        for (const Move& m : found) {
          checkpoint_.pass(); // a move takes longer than to look for one
          moves += make(m);
        }
    }
    if (moves > 0)
      drop_inner_edges();
    return moves;
  }

  // Section 8.2: of the three cases at an edge, as it is or either face moved, the one of the smallest energy.
  void find_moves(std::size_t first, std::size_t last, bool all)
  {
    found_.resize((last - first + part_of_batch - 1) / part_of_batch);
    tested_.assign(found_.size(), 0);
    for_each_chunk(execution_, last - first, part_of_batch, [&](std::size_t i, std::size_t begin, std::size_t end) {
      found_[i].clear();
      for (std::size_t j = begin; j < end; ++j) {
        const Edge& e = edges_[first + j];
        const Index x = labels_[e.face], y = labels_[e.across];
        if (x == y || (!all && clusters_[x].round_of_change + 1 < round_ && clusters_[y].round_of_change + 1 < round_))
          continue;
        ++tested_[i];
        Trial first_trial = trial(e.face, y), second_trial = trial(e.across, x);
        if (is_better(second_trial, first_trial))
          std::swap(first_trial, second_trial);
        for (const Trial& t : {first_trial, second_trial})
          if (is_gain(t) && moves_.keeps_discs(t.face, t.to)) {
            found_[i].push_back({t.face, t.to});
            break;
          }
      }
    });
    for (const std::size_t n : tested_)
      tests_ += n;
  }

  bool make(const Move& m)
  {
    const Index from = labels_[m.face];
    if (from == m.to || !is_gain(trial(m.face, m.to)) || !moves_.move(m.face, m.to))
      return false;
    accept(m.face, from, m.to);
    return true;
  }

  void accept(Index f, Index from, Index to)
  {
    Cluster_sums<Weight>& source = clusters_[from];
    Cluster_sums<Weight>& target = clusters_[to];
    CGAL_assertion_code(const double before = source.energy + target.energy;)
    remove(source, faces_[f]);
    add(target, faces_[f]);
    CGAL_assertion(source.energy + target.energy < before);
    source.round_of_change = target.round_of_change = round_;
    for (Index c = mesh_.first_corner[f]; c != mesh_.first_corner[f + 1]; ++c)
      if (mesh_.face_across[c] != NONE && labels_.label_across(c) != to)
        list(f, c);
  }

  void drop_inner_edges()
  {
    edges_.erase(std::remove_if(edges_.begin(), edges_.end(),
                                [&](const Edge& e) {
                                  const bool is_inner = labels_[e.face] == labels_[e.across];
                                  if (is_inner)
                                    is_listed_[e.corner] = false;
                                  return is_inner;
                                }),
                 edges_.end());
  }

  // Adds the edge after corner `c` of face `f` to the list.
  void list(Index f, Index c)
  {
    const Index g = mesh_.face_across[c];
    const Edge e = f < g ? Edge{f, g, c} : Edge{g, f, mesh_.corner_of(g, mesh_.corner_vertex[mesh_.next_corner(f, c)])};
    if (is_listed_[e.corner])
      return;
    is_listed_[e.corner] = true;
    edges_.push_back(e);
  }

  const Flat_mesh& mesh_;
  Cluster_labels& labels_;
  Weight weight_;
  Checkpoint checkpoint_;
  Execution execution_;
  Valid_moves moves_;
  std::vector<Face> faces_;
  std::vector<Cluster_sums<Weight> > clusters_;
  std::vector<Edge> edges_;                // between clusters
  std::vector<bool> is_listed_;            // per corner
  std::vector<std::vector<Move> > found_;  // per part of a batch
  std::vector<std::size_t> tested_;        // per part of a batch
  Index round_ = 0;
  std::size_t tests_ = 0;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_ENERGY_MINIMIZATION_H
