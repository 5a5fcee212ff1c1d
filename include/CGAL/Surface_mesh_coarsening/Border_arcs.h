// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_BORDER_ARCS_H
#define CGAL_SURFACE_MESH_COARSENING_BORDER_ARCS_H

#include <CGAL/Surface_mesh_coarsening/Clustered_surface.h>
#include <CGAL/Surface_mesh_coarsening/internal/Border_fit.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningRef
/// The parts of the border of the mesh that belong to clusters, one arc for each cluster on the border. The vertex of such a
/// cluster lies on its arc, and so the border of the coarse mesh is inscribed in that of the mesh. Where on the arcs the
/// vertices lie is chosen so that the two borders are as close together as they can be; that is in sharp corners where an arc
/// has one.
class Border_arcs
{
public:
  /// \cond SKIP_IN_MANUAL
  explicit Border_arcs(const Clustered_surface& surface)
    : mesh_(surface.input().mesh), labels_(surface.labels()), place_of_(surface.number_of_clusters(), internal::NONE)
  {
    std::vector<bool> done(mesh_.number_of_vertices(), false);
    for (std::size_t v = 0; v < mesh_.number_of_vertices(); ++v)
      if (mesh_.is_on_border(Index(v)) && !done[v]) {
        const std::vector<Index> loop = loop_from(Index(v));
        choose_places(loop);
        for (const Index w : loop)
          done[w] = true;
      }
  }
  /// \endcond

  /// returns whether a cluster has a part of the border.
  bool is_on_border(std::size_t cluster) const { return place_of_[cluster] != internal::NONE; }

  /// places the vertices of the clusters on the border. Other positions are not touched.
  void place(std::vector<Clustered_surface::Point>& positions) const
  {
    for (std::size_t x = 0; x < place_of_.size(); ++x)
      if (is_on_border(x))
        positions[x] = places_[place_of_[x]];
  }

  /// moves the vertices of the clusters on the border back to it. Other positions are not touched.
  void pull_back(std::vector<Clustered_surface::Point>& positions) const { place(positions); }

private:
  typedef internal::Index Index;
  typedef internal::Vector Vector;

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

  void choose_places(const std::vector<Index>& loop)
  {
    const std::size_t n = loop.size();
    std::size_t begin = 0; // of a part of the loop that belongs to one cluster
    while (begin < n && label_after(loop[begin]) == label_after(loop[(begin + n - 1) % n]))
      ++begin;
    std::vector<internal::Border_arc> arcs;
    std::vector<Index> clusters;
    for (std::size_t i = 0; i < n;) {
      clusters.push_back(label_after(loop[(begin + i) % n]));
      std::vector<Vector> points;
      do
        points.push_back(mesh_.points[loop[(begin + i++) % n]]);
      while (i < n && label_after(loop[(begin + i) % n]) == clusters.back());
      points.push_back(mesh_.points[loop[(begin + i) % n]]);
      arcs.emplace_back(points);
    }
    const std::vector<std::size_t> chosen = internal::Border_fit(arcs).run();
    for (std::size_t k = 0; k < arcs.size(); ++k) {
      place_of_[clusters[k]] = Index(places_.size());
      places_.push_back(arcs[k][chosen[k]]);
    }
  }

  const internal::Flat_mesh& mesh_;
  const internal::Cluster_labels& labels_;
  std::vector<Index> place_of_; // of each cluster; NONE inside
  std::vector<Vector> places_;
};

} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_BORDER_ARCS_H
