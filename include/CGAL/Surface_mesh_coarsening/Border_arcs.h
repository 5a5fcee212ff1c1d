// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_BORDER_ARCS_H
#define CGAL_SURFACE_MESH_COARSENING_BORDER_ARCS_H

#include <CGAL/Surface_mesh_coarsening/Clustered_surface.h>
#include <CGAL/Surface_mesh_coarsening/internal/geometry/Border_fit.h>

#include <vector>

namespace CGAL::Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningRef
/// The border of the mesh, divided into arcs: one arc for each cluster on the border. The vertex of a cluster on the border lies
/// on its arc, so the border of the coarse mesh is inscribed in the border of the mesh. The positions on the arcs minimize the
/// distance between the two borders. An arc with a sharp corner has its vertex at the corner.
///
/// If features are kept, feature lines are divided into arcs in the same way, and a cluster with a feature corner has its
/// vertex at that corner.
class Border_arcs
{
public:
  /// \cond SKIP_IN_MANUAL
  // `with_border`: whether clusters on the border have their vertex on the border.
  explicit Border_arcs(const internal::Clustered_faces& surface, bool with_border = true)
    : mesh_(surface.input().mesh), labels_(surface.labels()), features_(surface.features()),
      place_of_(surface.number_of_clusters(), internal::NONE)
  {
    if (with_border)
      internal::for_each_border_loop(mesh_, internal::Run_context(),
                                     [this](const std::vector<Index>& loop) { place_on_border(loop); });
    if (features_)
      place_on_features(*features_);
  }
  /// \endcond

  /// returns whether a cluster contains a part of the border or of a feature.
  bool is_on_border(std::size_t cluster) const { return place_of_[cluster] != internal::NONE; }

  /// places the vertices of the clusters on the border or on features. Other positions do not change.
  void place(std::vector<Clustered_surface::Point_3>& positions) const
  {
    for (std::size_t x = 0; x < place_of_.size(); ++x)
      if (is_on_border(x))
        positions[x] = internal::to_point(places_[place_of_[x]]);
  }
  /// \cond SKIP_IN_MANUAL
  void place(std::vector<internal::Vector>& positions) const
  {
    for (std::size_t x = 0; x < place_of_.size(); ++x)
      if (is_on_border(x))
        positions[x] = places_[place_of_[x]];
  }

  // Returns the place on the border or on a feature of a cluster that contains a part of it.
  const internal::Vector& place(std::size_t cluster) const { return places_[place_of_[cluster]]; }
  /// \endcond

private:
  typedef internal::Index Index;
  typedef internal::Vector Vector;

  void place_on_border(const std::vector<Index>& loop)
  {
    std::vector<Index> cluster_after; // of the face at the border edge that begins at each vertex
    for (const Index v : loop)
      cluster_after.push_back(labels_[mesh_.star[mesh_.first_in_star[v]]]);
    internal::fit_border_loop(
      cluster_after,
      [&](const std::vector<std::size_t>& places, Index cluster) {
        std::vector<Index> vertices;
        for (const std::size_t i : places)
          vertices.push_back(loop[i]);
        return arc(vertices, cluster);
      },
      [this](Index cluster, const Vector& place) { set_place(cluster, place); });
  }

  void place_on_features(const internal::Coarse_features& features)
  {
    for (const internal::Coarse_features::Line& line : features.lines()) {
      std::vector<internal::Border_arc> arcs;
      for (const internal::Coarse_features::Arc& a : line.arcs)
        arcs.push_back(arc(a.vertices, a.cluster));
      const std::vector<std::size_t> chosen = internal::Border_fit(arcs, line.is_loop).run();
      for (std::size_t k = 0; k < arcs.size(); ++k)
        set_place(line.arcs[k].cluster, arcs[k][chosen[k]]);
    }
    for (std::size_t x = 0; x < features.corners().size(); ++x)
      if (features.corners()[x] != internal::NONE)
        set_place(Index(x), mesh_.points[features.corners()[x]]);
  }

  // Returns the part of a polyline in a cluster. Its vertex is the feature corner if there is one.
  internal::Border_arc arc(const std::vector<Index>& vertices, Index cluster) const
  {
    std::vector<Vector> points;
    std::size_t fixed = internal::Border_arc::none;
    for (const Index v : vertices) {
      if (features_ && features_->corners()[cluster] == v)
        fixed = points.size();
      points.push_back(mesh_.points[v]);
    }
    return internal::Border_arc(points, fixed);
  }

  void set_place(Index cluster, const Vector& place)
  {
    place_of_[cluster] = Index(places_.size());
    places_.push_back(place);
  }

  const internal::Flat_mesh& mesh_;
  const internal::Cluster_labels& labels_;
  const internal::Coarse_features* features_;
  std::vector<Index> place_of_; // per cluster; NONE inside and off features
  std::vector<Vector> places_;
};

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_BORDER_ARCS_H
