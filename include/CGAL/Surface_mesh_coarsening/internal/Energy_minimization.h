// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_ENERGY_MINIMIZATION_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_ENERGY_MINIMIZATION_H

#include <CGAL/Surface_mesh_coarsening/internal/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/Dual_walk.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The sums over the faces of a cluster that its energy (8) is made of.
template <class Weight>
struct Cluster_sums
{
  double mass = 0;              // S0 = sum r A
  Vector moment{{0, 0, 0}};     // S1 = sum r A g
  double second_moment = 0;     // S2 = sum r A |g|^2
  Index faces = 0;
  typename Weight::Cluster_data data;
  double energy = 0;
  double magnitude = 0;         // of what the energy is the difference of
};

// Sections 5.1 and 8.2 of the paper: in rounds over the edges between clusters, the face on one side or on the other
// joins the cluster across, whichever lowers the energy more, as long as the clusters remain discs whose dual is a
// simplicial surface. All weights are those of the current sums, so the energy is a function of the clustering and
// falls with each move.
template <class Weight>
class Energy_minimization
{
public:
  Energy_minimization(const Clustering_input& input, Cluster_labels& labels, std::size_t number_of_clusters,
                      const Weight& weight)
    : mesh_(input.mesh), labels_(labels), weight_(weight), walk_(labels), clusters_(number_of_clusters),
      round_of_change_(number_of_clusters, 0), stamp_of_cluster_(number_of_clusters, 0)
  {
    faces_.reserve(mesh_.number_of_faces());
    data_.reserve(mesh_.number_of_faces());
    for (std::size_t f = 0; f < mesh_.number_of_faces(); ++f) {
      const Vector& g = input.centroid[f];
      faces_.push_back({input.mass(Index(f)), g, dot(g, g)});
      data_.push_back(weight_.face_data(input.density[f], input.area[f]));
    }
    sum_up();
    list_boundary_edges();
  }

  // One round. Returns the number of moves.
  std::size_t round()
  {
    ++round_;
    // Sums that are updated again and again drift by roundings.
    if (round_ % 8 == 0)
      sum_up();
    std::size_t moves = run_over(edges_, false);
    // Edges were passed over whose two clusters had not changed. Whether a move is allowed depends on others, too:
    // the end is reached when no edge at all has a move left.
    if (moves == 0)
      moves = run_over(edges_, true);
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
    const auto agree = [](double a, double b, double scale) { return std::abs(a - b) <= 1e-9 * scale; };
    for (std::size_t i = 0; i < clusters_.size(); ++i) {
      const Cluster_sums<Weight>&x = clusters_[i], &y = fresh.clusters_[i];
      if (x.faces != y.faces || !agree(x.mass, y.mass, y.mass) ||
          !agree(x.second_moment, y.second_moment, y.second_moment) ||
          !agree(x.energy, y.energy, y.energy + weight_.weight(y.data, y.mass, y.faces) * y.second_moment))
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
  const std::vector<Cluster_sums<Weight> >& clusters() const { return clusters_; }

  // All sums from scratch.
  void sum_up()
  {
    std::fill(clusters_.begin(), clusters_.end(), Cluster_sums<Weight>());
    for (std::size_t f = 0; f < faces_.size(); ++f)
      add(clusters_[labels_[Index(f)]], Index(f));
    for (Cluster_sums<Weight>& x : clusters_)
      update_energy(x);
  }

private:
  struct Face
  {
    double mass;
    Vector centroid;
    double squared_distance; // of the centroid from the origin
  };

  // An edge between two faces, by its corner in the one of smaller index.
  typedef Directed_edge Edge;

  // What a move would make of the energies of the two clusters.
  struct Trial
  {
    Index face, from, to;
    double gain;      // by which the energy falls
    double scale;     // of the changes of energy that it is the difference of
    double magnitude; // of the sums that these are the difference of
  };

  struct Energy
  {
    double value, magnitude;
  };

  static Energy energy_of(double mass, const Vector& moment, double second_moment, double weight)
  {
    if (!(mass > 0))
      return {0, 0};
    return {weight * (std::max)(0., second_moment - dot(moment, moment) / mass), weight * second_moment};
  }

  void update_energy(Cluster_sums<Weight>& x) const
  {
    const Energy energy = energy_of(x.mass, x.moment, x.second_moment, weight_.weight(x.data, x.mass, x.faces));
    x.energy = energy.value;
    x.magnitude = energy.magnitude;
  }

  void add(Cluster_sums<Weight>& x, Index f) const
  {
    const Face& face = faces_[f];
    x.mass += face.mass;
    x.moment = x.moment + face.mass * face.centroid;
    x.second_moment += face.mass * face.squared_distance;
    ++x.faces;
    weight_.add(x.data, data_[f]);
  }

  void remove(Cluster_sums<Weight>& x, Index f) const
  {
    const Face& face = faces_[f];
    x.mass -= face.mass;
    x.moment = x.moment - face.mass * face.centroid;
    x.second_moment -= face.mass * face.squared_distance;
    --x.faces;
    weight_.remove(x.data, data_[f]);
  }

  Energy energy_with(const Cluster_sums<Weight>& x, Index f) const
  {
    const Face& face = faces_[f];
    const double mass = x.mass + face.mass;
    return energy_of(mass, x.moment + face.mass * face.centroid, x.second_moment + face.mass * face.squared_distance,
                     weight_.weight_with(x.data, data_[f], mass, x.faces + 1));
  }

  Energy energy_without(const Cluster_sums<Weight>& x, Index f) const
  {
    const Face& face = faces_[f];
    const double mass = x.mass - face.mass;
    return energy_of(mass, x.moment - face.mass * face.centroid, x.second_moment - face.mass * face.squared_distance,
                     weight_.weight_without(x.data, data_[f], mass, x.faces - 1));
  }

  Trial trial(Index f, Index to) const
  {
    const Index from = labels_[f];
    const Cluster_sums<Weight>& source = clusters_[from];
    const Cluster_sums<Weight>& target = clusters_[to];
    if (source.faces == 1)
      return {f, from, to, -1, 0, 0};
    const Energy without = energy_without(source, f), with = energy_with(target, f);
    const double lost = source.energy - without.value, won = with.value - target.energy;
    return {f, from, to, lost - won, std::abs(lost) + std::abs(won),
            source.magnitude + target.magnitude + without.magnitude + with.magnitude};
  }

  // Gains this small, relative to what they are the difference of, are taken for none. So moves between equal
  // energies, frequent on regular meshes, do not depend on roundings, and each move lowers the energy as computed.
  static bool is_gain(const Trial& t) { return t.gain > 1e-7 * t.scale && t.gain > 1e-14 * t.magnitude; }
  static bool is_better(const Trial& t, const Trial& than)
  {
    return t.gain - than.gain > 1e-7 * (t.scale + than.scale);
  }

  void list_boundary_edges()
  {
    for (std::size_t f = 0; f < mesh_.number_of_faces(); ++f)
      for (Index c = mesh_.first_corner[f]; c != mesh_.first_corner[f + 1]; ++c) {
        const Index g = mesh_.face_across[c];
        if (g != NONE && g > f && labels_[g] != labels_[Index(f)])
          edges_.push_back({Index(f), c});
      }
    is_listed_.assign(mesh_.corner_vertex.size(), false);
    for (const Edge& e : edges_)
      is_listed_[e.corner] = true;
  }

  // The edge after corner `c` of face `f`, seen from its face of smaller index.
  Edge edge_at(Index f, Index c) const
  {
    const Index g = mesh_.face_across[c];
    return f < g ? Edge{f, c} : Edge{g, mesh_.corner_of(g, mesh_.corner_vertex[mesh_.next_corner(f, c)])};
  }

  std::size_t run_over(std::vector<Edge>& edges, bool all)
  {
    std::size_t moves = 0;
    next_edges_.clear();
    for (const Edge& e : edges) {
      const Index f = e.face, g = mesh_.face_across[e.corner];
      if (labels_[f] == labels_[g]) {
        is_listed_[e.corner] = false;
        continue;
      }
      next_edges_.push_back(e);
      if (!all && round_of_change_[labels_[f]] + 1 < round_ && round_of_change_[labels_[g]] + 1 < round_)
        continue;
      ++tests_;
      moves += improve(f, g);
    }
    edges.swap(next_edges_);
    return moves;
  }

  // Section 8.2: of the three cases at an edge, as it is or either face moved, the one of the smallest energy.
  bool improve(Index f, Index g)
  {
    Trial first = trial(f, labels_[g]), second = trial(g, labels_[f]);
    if (is_better(second, first))
      std::swap(first, second);
    for (const Trial& t : {first, second})
      if (is_gain(t) && relabel(t.face, t.to)) {
        accept(t);
        return true;
      }
    return false;
  }

  // Moves face `f` if it may move.
  bool relabel(Index f, Index to)
  {
    const Index from = labels_[f];
    if (!labels_.stays_disc_without(f) || !labels_.stays_disc_with(f, to))
      return false;
    const bool dual_may_change = !only_slides(f, to);
    labels_.move(f, to);
    if (dual_may_change && !dual_stays_simplicial(f, from)) {
      labels_.move(f, from);
      return false;
    }
    return true;
  }

  // Whether no vertex where more than three clusters meet is involved, before or after, and the face borders on at
  // most one cluster more. Then the move slides a point where three clusters meet at the most, and the dual remains
  // what it was.
  bool only_slides(Index f, Index to) const
  {
    const Index begin = mesh_.first_corner[f], end = mesh_.first_corner[f + 1], from = labels_[f];
    const auto change = [&](Index c) {
      const Index across = labels_.label_across(c);
      return int(across == from) - int(across == to);
    };
    int others = 0, previous = change(end - 1);
    for (Index c = begin; c != end; ++c) {
      const int next = change(c);
      const Index count = labels_.boundary_count(mesh_.corner_vertex[c]);
      others += next == 0;
      if (others > 1 || count > 3 || Index(int(count) + previous + next) > 3)
        return false;
      previous = next;
    }
    return true;
  }

  // All edges that a move adds to the dual belong to the cluster that has grown: the dual remains simplicial if the
  // neighbors of that cluster still form a simple cycle.
  bool dual_stays_simplicial(Index f, Index from)
  {
    for (Index c = mesh_.first_corner[f]; c != mesh_.first_corner[f + 1]; ++c)
      if (labels_.label_across(c) == from)
        return walk_.fault_of_link({f, c}, stamp_of_cluster_, stamp_) == NONE;
    return false;
  }

  void accept(const Trial& t)
  {
    Cluster_sums<Weight>& source = clusters_[t.from];
    Cluster_sums<Weight>& target = clusters_[t.to];
    CGAL_assertion_code(const double before = source.energy + target.energy;)
    remove(source, t.face);
    add(target, t.face);
    update_energy(source);
    update_energy(target);
    CGAL_assertion(source.energy + target.energy < before);
    round_of_change_[t.from] = round_of_change_[t.to] = round_;
    for (Index c = mesh_.first_corner[t.face]; c != mesh_.first_corner[t.face + 1]; ++c)
      if (mesh_.face_across[c] != NONE && labels_.label_across(c) != t.to) {
        const Edge e = edge_at(t.face, c);
        if (!is_listed_[e.corner]) {
          is_listed_[e.corner] = true;
          next_edges_.push_back(e);
        }
      }
  }

  const Flat_mesh& mesh_;
  Cluster_labels& labels_;
  Weight weight_;
  Dual_walk walk_;
  std::vector<Face> faces_;
  std::vector<typename Weight::Face_data> data_;
  std::vector<Cluster_sums<Weight> > clusters_;
  std::vector<Edge> edges_, next_edges_; // between clusters, to be tested in this round and in the next
  std::vector<bool> is_listed_;          // per corner
  std::vector<std::size_t> round_of_change_;
  std::vector<Index> stamp_of_cluster_;
  Index stamp_ = 0;
  std::size_t round_ = 0;
  std::size_t tests_ = 0;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_ENERGY_MINIMIZATION_H
