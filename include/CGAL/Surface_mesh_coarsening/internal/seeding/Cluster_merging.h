// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_CLUSTER_MERGING_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_CLUSTER_MERGING_H

#include <CGAL/Surface_mesh_coarsening/Cluster_energy/Quadric_energy.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Dual_surface.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/Feature_rules.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

typedef Bucketed_items<Index>::Range Face_range;

// The faces of a connected component and their clusters, which are valid and numbered from 0.
struct Clustered_component
{
  Cluster_labels& labels;
  Face_range faces;
  Index clusters;
  const Feature_rules* rules; // null without features
};

// Which clusters are merged first: the clusters with the smallest total area or mass, or pairs whose union adds least to the
// residuals of their quadrics, as an edge collapse does (Garland and Heckbert: Surface simplification using quadric error metrics,
// 1997).
enum class Merging { BY_AREA, BY_MASS, BY_QUADRICS };

// How clusters are merged.
struct Merging_method
{
  Merging order = Merging::BY_MASS;
  bool by_threes = false; // whether three clusters may be merged at a time; if not, the order does not depend on the number
  // Whether, as a last resort, clusters may be merged that meet only in a vertex, that is, in an edge of its fan.
  // without_pinches() must then turn them into discs.
  bool may_join_at_vertices = false;
};

// Reduction of the number of clusters (section 6 of the paper): merges the three clusters around a vertex whose total size is
// smallest, until a component has the required number of clusters. Merges two clusters if only one cluster too many is left, or
// if only two of the three may be merged.
//
// In the paper, and here on request, the size of a cluster is its area. By default the size is the mass, because clusters of low
// energy have similar masses, and the minimization must carry all remaining differences across the mesh face by face. Clusters of
// few faces cannot be round, whatever their mass, so the number of faces also contributes to the size.
class Cluster_merging
{
public:
  Cluster_merging(const Clustering_input& input, const Clustered_component& component, const Merging_method& method,
                  const Run_context& context)
    : context_(context),
      component_(component),
      dual_(component.labels, component.faces, component.clusters, context),
      method_(method),
      count_(component.clusters),
      merged_into_(count_),
      size_(count_),
      is_queued_(dual_.number_of_triangles(), false)
  {
    std::iota(merged_into_.begin(), merged_into_.end(), Index(0));
    for (const Index f : component.faces) {
      const Size size{is_by_area() ? input.area[f] : input.mass(f), input.number_of_faces_in(f)};
      size_[component.labels[f]] = size_[component.labels[f]] + size;
      mass_of_all_ += size.mass;
    }
    if (component.rules)
      features_.emplace(*component.rules, component.labels.mesh().component[*component.faces.begin()]);
    if (method.order == Merging::BY_QUADRICS)
      add_quadrics(input);
  }

  // Merges until at most `wanted` clusters remain, if the topology permits it. Returns the number of pairwise merges.
  std::size_t run(std::size_t wanted)
  {
    wanted_ = wanted;
    const std::size_t before = count_;
    merge_while_possible();
    if (method_.may_join_at_vertices && excess() > 0) {
      const std::size_t in_arcs = count_;
      joins_at_vertices_ = true;
      merge_while_possible();
      joins_at_vertices_ = count_ != in_arcs;
    }
    return before - count_;
  }

  // Returns whether clusters were merged that met only in a vertex.
  bool has_pinches() const { return joins_at_vertices_; }

  // Returns a face at the common vertex of each merge of three clusters, the last merge first: the new seeds of the paper, after
  // relabel().
  std::vector<Index> new_seeds() const
  {
    const Flat_mesh& m = component_.labels.mesh();
    std::vector<Index> faces;
    for (auto v = common_vertices_.rbegin(); v != common_vertices_.rend(); ++v)
      faces.push_back(m.star[m.first_in_star[*v]]);
    return faces;
  }

  // Renumbers the clusters of the faces without gaps, in their previous order.
  void relabel()
  {
    std::vector<Index> number(merged_into_.size(), NONE);
    Index next = 0;
    for (Index x = 0; x < number.size(); ++x)
      if (merged_into_[x] == x)
        number[x] = next++;
    for (const Index f : component_.faces)
      component_.labels.set(f, number[cluster(component_.labels[f])]);
  }

private:
  typedef Dual_surface::Edge Edge;
  typedef std::pair<double, Index> Candidate; // summed size and triangle

  struct Size
  {
    double mass = 0; // or area
    double faces = 0;
    Size operator+(const Size& other) const { return {mass + other.mass, faces + other.faces}; }
  };

  //! [size]
  // Of 1e-3 to 1e-6, this value has the smallest distances at 60 and 80 % of the vertices of the Horse, with angles that are
  // hardly smaller.
  static constexpr double quadric_regularization = 1e-5;
  // Of the planes at the border. With 1, the border of mannequin-devil.off with 200 vertices is 0.53 % of the diagonal away, with 2
  // 0.37; with 4, the models of compare_quality are 0.4 % farther than with 2.
  static constexpr double border_weight = 2;
  // This number of faces counts as much as the mean mass of a cluster.
  static constexpr double faces_of_round_cluster = 64;
  //! [size]

  bool is_by_area() const { return method_.order == Merging::BY_AREA; }

  // A cell of the input consists of pieces of faces.
  void add_quadrics(const Clustering_input& input)
  {
    quadrics_.resize(count_);
    for (const Index f : component_.faces) {
      Quadric_energy::Cluster_data& quadric = quadrics_[component_.labels[f]];
      if (component_.rules)
        component_.rules->cells().for_each_piece(
          f, [&](Index piece) { add_face(component_.rules->cells().pieces(), piece, quadric); });
      else
        add_face(input, f, quadric);
    }
    for (const Quadric_energy::Cluster_data& quadric : quadrics_)
      residual_.push_back(quadric_energy_.energy(quadric, 0));
  }

  // Border edges add planes perpendicular to their faces.
  void add_face(const Clustering_input& input, Index f, Quadric_energy::Cluster_data& quadric) const
  {
    const Flat_mesh& m = input.mesh;
    const Clustered_face face(input, f);
    const Vector normal = face.plain_normal();
    quadric_energy_.add(quadric, {input.area[f], face.plain_centroid(), normal});
    for (const Index c : m.corners(f)) {
      if (m.face_across[c] != NONE)
        continue;
      const Vector edge = m.edge_vector(f, c), middle = 0.5 * (m.point_at(c) + m.point_at(m.next_corner(f, c)));
      const double size = length(edge);
      if (size > 0)
        quadric_energy_.add(quadric, {border_weight * size * size, middle, (1 / size) * cross(edge, normal)});
    }
  }

  // A merge is retried after one of its clusters has changed. Changes farther away may also enable it; such merges are considered
  // when the queue is empty.
  void merge_while_possible()
  {
    for (std::size_t last = count_ + 1; last != count_ && excess() > 0;) {
      last = count_;
      for (Index t = 0; t < dual_.number_of_triangles(); ++t)
        if (dual_.is_triangle(t))
          enqueue(t);
      work_off();
    }
  }

  std::size_t excess() const { return count_ - (std::min)(count_, wanted_); }

  Index cluster(Index x) const
  {
    while (merged_into_[x] != x)
      x = merged_into_[x] = merged_into_[merged_into_[x]];
    return x;
  }

  void enqueue(Index t)
  {
    const double key = is_queued_[t] ? -1 : key_of(t);
    if (key < 0)
      return;
    is_queued_[t] = true;
    queue_.emplace(key, t);
  }

  // Returns the total size of the three clusters, or of the two smallest, according to the number of clusters to be merged; -1 if
  // there are fewer than two.
  double key_of(Index t) const
  {
    double least = -1;
    const auto offer = [&](double size) { least = least < 0 || size < least ? size : least; };
    if (method_.by_threes && excess() > 1) {
      if (is_by_area())
        for_each_triple_around(t, [&](const Triple& x) { offer(x.size); });
      if (least >= 0)
        return least;
      Size sum;
      for (Edge e = 3 * t; e != 3 * t + 3; ++e)
        if (!dual_.is_cap(dual_.source(e)))
          sum = sum + size_[dual_.source(e)];
      return number_of(sum);
    }
    for (Edge e = 3 * t; e != 3 * t + 3; ++e)
      if (is_candidate(e))
        offer(size_of(e));
    return least;
  }

  // A cluster that is already large, such as a single face as large as many other clusters, is not enlarged unnecessarily.
  bool may_be_third(Index merged, Index third) const
  {
    return is_by_area() || (size_[merged] + size_[third]).mass <= 4 * mean_mass();
  }

  bool is_candidate(Edge e) const
  {
    return (dual_.is_arc(e) || joins_at_vertices_) && !dual_.is_cap(dual_.source(e)) && !dual_.is_cap(dual_.target(e)) &&
           (!features_ || features_->may_merge(dual_.source(e), dual_.target(e), [this](Index x) { return cluster(x); }));
  }
  double size_of(Edge e) const
  {
    const Index x = dual_.source(e), y = dual_.target(e);
    if (quadrics_.empty())
      return number_of(size_[x] + size_[y]);
    const double sum = quadric_energy_.energy(Quadric_energy::joined(quadrics_[x], quadrics_[y]), 0);
    return rounded_for_comparison((std::max)(0., sum - residual_[x] - residual_[y]));
  }

  double mean_mass() const { return mass_of_all_ / double(wanted_); }
  double number_of(const Size& x) const
  {
    const double mass_of_faces = x.faces / faces_of_round_cluster * mean_mass();
    return rounded_for_comparison(is_by_area() ? x.mass : (std::min)(x.mass, mass_of_faces));
  }

  void work_off()
  {
    while (!queue_.empty() && excess() > 0) {
      context_.poll();
      const auto [key, t] = queue_.top();
      queue_.pop();
      is_queued_[t] = false;
      if (!dual_.is_triangle(t))
        continue;
      if (key < key_of(t))
        enqueue(t); // the clusters have grown in the meantime
      else
        merge_at(t);
    }
    queue_ = Queue();
    is_queued_.assign(is_queued_.size(), false);
  }

  // Three clusters that follow each other around a vertex. Those at the arc are merged first.
  struct Triple
  {
    double size, size_at_arc;
    Edge arc;
    Index third;
    bool operator<(const Triple& other) const
    {
      return std::tie(size, size_at_arc, arc, third) < std::tie(other.size, other.size_at_arc, other.arc, other.third);
    }
  };

  // Calls `visit` for each triple around the vertex of `t`, where the fan has one triangle for each but two of the clusters.
  template <class Visit>
  void for_each_triple_around(Index t, const Visit& visit) const
  {
    std::vector<Edge> arcs;
    const Index v = dual_.vertex(t);
    Index u = t;
    while (u > 0 && dual_.vertex(u - 1) == v)
      --u;
    for (; u < dual_.number_of_triangles() && dual_.vertex(u) == v; ++u)
      for (Edge e = 3 * u; dual_.is_triangle(u) && e != 3 * u + 3; ++e)
        if (is_candidate(e))
          arcs.push_back(e);
    for (const Edge e : arcs)
      for (const Edge f : arcs) {
        const Index x = dual_.source(e), y = dual_.target(e), z = dual_.source(f), w = dual_.target(f);
        const Index third = z == x || z == y ? w : z;
        if ((third == z && w != x && w != y) || third == x || third == y)
          continue;
        visit(Triple{number_of(size_[x] + size_[y] + size_[third]), size_of(e), e, third});
      }
  }

  void merge_at(Index t)
  {
    const bool three = method_.by_threes && excess() > 1;
    std::optional<Triple> triple; // the smallest
    if (three && is_by_area())
      for_each_triple_around(t, [&](const Triple& x) {
        if ((!triple || x < *triple) && dual_.may_contract(x.arc))
          triple = x;
      });
    const Edge e = triple ? triple->arc : smallest_edge_of(t);
    if (e == NONE)
      return;
    const Index third = triple ? triple->third : dual_.source(Dual_surface::previous(e));
    Index merged = merge(e);
    if (three && !dual_.is_cap(third) && may_be_third(merged, third)) {
      Edge to_third = NONE;
      dual_.for_each_edge_from(merged, [&](Edge f) { to_third = dual_.target(f) == third ? f : to_third; });
      if (to_third != NONE && is_candidate(to_third) && dual_.may_contract(to_third)) {
        merged = merge(to_third);
        common_vertices_.push_back(dual_.vertex(t));
      }
    }
    dual_.for_each_edge_from(merged, [&](Edge f) { enqueue(f / 3); });
  }

  // Returns the contractible edge whose clusters have the smallest total size; NONE if there is none.
  Edge smallest_edge_of(Index t)
  {
    Edge smallest = NONE;
    for (Edge e = 3 * t; e != 3 * t + 3; ++e)
      if (is_candidate(e) && (smallest == NONE || size_of(e) < size_of(smallest)) && dual_.may_contract(e))
        smallest = e;
    return smallest;
  }

  // Merges the clusters at the ends of `e` and returns the remaining one.
  Index merge(Edge e)
  {
    const Index kept = dual_.source(e), gone = dual_.target(e);
    dual_.contract(e);
    if (features_)
      features_->merge(kept, gone, [this](Index x) { return cluster(x); });
    merged_into_[gone] = kept;
    size_[kept] = size_[kept] + size_[gone];
    if (!quadrics_.empty()) {
      quadrics_[kept] = Quadric_energy::joined(quadrics_[kept], quadrics_[gone]);
      residual_[kept] = quadric_energy_.energy(quadrics_[kept], 0);
    }
    --count_;
    return kept;
  }

  typedef std::priority_queue<Candidate, std::vector<Candidate>, std::greater<Candidate> > Queue;

  const Run_context context_;
  const Clustered_component component_;
  Dual_surface dual_;
  std::optional<Feature_merging> features_;
  const Merging_method method_;
  bool joins_at_vertices_ = false;
  std::size_t count_, wanted_ = 0;
  std::vector<Index> common_vertices_;     // of the merges of three clusters
  mutable std::vector<Index> merged_into_; // with path compression
  std::vector<Size> size_;
  std::vector<bool> is_queued_; // per triangle
  const Quadric_energy quadric_energy_{quadric_regularization};
  std::vector<Quadric_energy::Cluster_data> quadrics_; // empty if clusters are merged by size
  std::vector<double> residual_;                       // of each quadric
  double mass_of_all_ = 0;
  Queue queue_;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_SEEDING_CLUSTER_MERGING_H
