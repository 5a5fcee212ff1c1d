// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_BORDER_ARCS_H
#define CGAL_SURFACE_MESH_COARSENING_BORDER_ARCS_H

#include <CGAL/Surface_mesh_coarsening/Clustered_surface.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningRef
/// The parts of the border of the mesh that belong to clusters, one arc for each cluster on the border. The vertex of such a
/// cluster lies on its arc: in its sharpest corner, if it turns there by more than 30 degrees, and otherwise anywhere but
/// near its ends. So the border of the coarse mesh is inscribed in that of the mesh.
class Border_arcs
{
public:
  /// \cond SKIP_IN_MANUAL
  explicit Border_arcs(const Clustered_surface& surface)
    : mesh_(surface.input().mesh), labels_(surface.labels()), arc_of_(surface.number_of_clusters(), internal::NONE)
  {
    std::vector<bool> done(mesh_.number_of_vertices(), false);
    for (std::size_t v = 0; v < mesh_.number_of_vertices(); ++v)
      if (mesh_.is_on_border(Index(v)) && !done[v]) {
        const std::vector<Index> loop = loop_from(Index(v));
        add_arcs(loop);
        for (const Index w : loop)
          done[w] = true;
      }
  }
  /// \endcond

  /// returns whether a cluster has a part of the border.
  bool is_on_border(std::size_t cluster) const { return arc_of_[cluster] != internal::NONE; }

  /// places the vertices of the clusters on the border in corners or half way along their arcs. Other positions are not
  /// touched.
  void place(std::vector<Clustered_surface::Point>& positions) const
  {
    for (const Arc& arc : arcs_)
      positions[arc.cluster] = arc.has_corner ? arc.corner : at(arc, 0.5 * arc.length.back());
  }

  /// moves the vertices of the clusters on the border to the closest points on their arcs, or to their corners. Other
  /// positions are not touched.
  void pull_back(std::vector<Clustered_surface::Point>& positions) const
  {
    for (const Arc& arc : arcs_)
      positions[arc.cluster] = arc.has_corner ? arc.corner : closest(arc, positions[arc.cluster]);
  }

private:
  typedef internal::Index Index;
  typedef internal::Vector Vector;

  /// \cond SKIP_IN_MANUAL
  struct Arc
  {
    Index cluster;
    std::vector<Index> vertices;
    std::vector<double> length; // from the first vertex to each
    bool has_corner = false;
    Vector corner;
  };
  /// \endcond

  // The label of the face at the border edge that begins at `v`: the first of its star.
  Index label_after(Index v) const { return labels_[mesh_.star[mesh_.first_in_star[v]]]; }

  std::vector<Index> loop_from(Index v) const
  {
    std::vector<Index> loop(1, v);
    for (Index w = internal::Flat_mesh_topology::next_on_border(mesh_, v); w != v;
         w = internal::Flat_mesh_topology::next_on_border(mesh_, w))
      loop.push_back(w);
    return loop;
  }

  void add_arcs(const std::vector<Index>& loop)
  {
    const std::size_t n = loop.size();
    std::size_t begin = 0; // of a part of the loop that belongs to one cluster
    while (begin < n && label_after(loop[begin]) == label_after(loop[(begin + n - 1) % n]))
      ++begin;
    for (std::size_t i = 0; i < n;) {
      Arc arc;
      arc.cluster = label_after(loop[(begin + i) % n]);
      do
        arc.vertices.push_back(loop[(begin + i++) % n]);
      while (i < n && label_after(loop[(begin + i) % n]) == arc.cluster);
      arc.vertices.push_back(loop[(begin + i) % n]);
      measure(arc);
      arc_of_[arc.cluster] = Index(arcs_.size());
      arcs_.push_back(arc);
    }
  }

  Vector side(const Arc& arc, std::size_t i) const
  {
    using namespace internal;
    return mesh_.points[arc.vertices[i + 1]] - mesh_.points[arc.vertices[i]];
  }

  void measure(Arc& arc) const
  {
    using namespace internal;
    double sharpest = std::cos(30. * 3.14159265358979323846 / 180.) - 1e-6;
    arc.length.assign(1, 0);
    for (std::size_t i = 0; i + 1 < arc.vertices.size(); ++i) {
      const Vector s = side(arc, i);
      arc.length.push_back(arc.length.back() + std::sqrt(dot(s, s)));
      if (i == 0)
        continue;
      const Vector before = side(arc, i - 1);
      const double product = std::sqrt(dot(s, s) * dot(before, before));
      if (product > 0 && dot(s, before) / product < sharpest) {
        sharpest = dot(s, before) / product;
        arc.corner = mesh_.points[arc.vertices[i]];
        arc.has_corner = true;
      }
    }
  }

  Vector at(const Arc& arc, double length) const
  {
    using namespace internal;
    std::size_t i = 0;
    while (i + 2 < arc.vertices.size() && arc.length[i + 1] < length)
      ++i;
    const double part = arc.length[i + 1] - arc.length[i];
    return mesh_.points[arc.vertices[i]] + (part > 0 ? (length - arc.length[i]) / part : 0.) * side(arc, i);
  }

  // Keeps off the ends, which the arc shares with its neighbors.
  Vector closest(const Arc& arc, const Vector& p) const
  {
    using namespace internal;
    double nearest = -1, length = 0;
    for (std::size_t i = 0; i + 1 < arc.vertices.size(); ++i) {
      const Vector s = side(arc, i), from = p - mesh_.points[arc.vertices[i]];
      const double square = dot(s, s);
      const double u = square > 0 ? (std::max)(0., (std::min)(1., dot(from, s) / square)) : 0;
      const Vector d = from - u * s;
      if (nearest < 0 || dot(d, d) < nearest) {
        nearest = dot(d, d);
        length = arc.length[i] + u * (arc.length[i + 1] - arc.length[i]);
      }
    }
    return at(arc, (std::max)(0.1 * arc.length.back(), (std::min)(0.9 * arc.length.back(), length)));
  }

  const internal::Flat_mesh& mesh_;
  const internal::Cluster_labels& labels_;
  std::vector<Index> arc_of_; // of each cluster; NONE inside
  std::vector<Arc> arcs_;
};

} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_BORDER_ARCS_H
