// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_DUAL_EXTRACTION_H
#define CGAL_SURFACE_MESH_COARSENING_DUAL_EXTRACTION_H

#include <CGAL/Surface_mesh_coarsening/Coarsening_report.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/Clustering_access.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/Labelled_pieces.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/dual_triangles.h>
#include <CGAL/Surface_mesh_coarsening/internal/output/Face_graph_filler.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>
#include <CGAL/Surface_mesh_coarsening/internal/output/place_vertices.h>
#include <CGAL/Surface_mesh_coarsening/internal/output/write_features.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningRef
/// The part of `Mwcvd_clustering` that makes the output, the dual triangulation of the clusters (section 8.3).
///
/// \tparam Clustering the class that derives from this one
template <class Clustering>
class Dual_extraction
{
  typedef internal::Index Index;
  typedef internal::Clustering_access Access;

public:
  /// replaces `output` by the dual triangulation. Its `i`-th vertex is that of cluster `i`.
  ///
  /// \tparam Output a model of `MutableFaceGraph`
  /// \tparam VertexPlacement a model of `VertexPlacement` or `GlobalVertexPlacement`
  /// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
  /// \param output is cleared and filled
  /// \param placement gives each cluster in the interior its position; those on the border, or on features, get theirs there
  /// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`, `geom_traits`,
  /// `edge_is_constrained_map`, `vertex_is_constrained_map` and `face_patch_map` of `output`
  /// \pre `grow()` or `set_clusters()` was called; `std::logic_error` is thrown otherwise.
  template <class Output, class VertexPlacement = Centroid_placement,
            class NamedParameters = parameters::Default_named_parameters>
  void extract_dual_mesh(Output& output, const VertexPlacement& placement = VertexPlacement(),
                         const NamedParameters& np = parameters::default_values()) const
  {
    write(place<Output, NamedParameters>(placement), output, np, [](const auto&) {});
  }

  /// does the same, and where triangles are left intersecting makes the clusters anew, with four times the densities in those
  /// that the triangles belong to: with more clusters there, and fewer elsewhere. What has the fewest intersections is taken.
  ///
  /// Seeds, growth and minimization are run as they were before, 4 times at the most, and once more to come back to what is
  /// taken. They are not where the weight is `Uniform_weight`, which does not look at densities, where parameter `repair_output`
  /// is `false`, where clusters were given, or edited or frozen by hand, or where more than half as many pairs of triangles
  /// intersect as there are clusters.
  /// The parameters are those of `extract_dual_mesh()`. `Coarsening_report::clusterings` tells how many clusterings were made.
  /// Densities stay raised afterwards.
  template <class Output, class VertexPlacement = Centroid_placement,
            class NamedParameters = parameters::Default_named_parameters>
  void extract_embedded_dual_mesh(Output& output, const VertexPlacement& placement = VertexPlacement(),
                                  const NamedParameters& np = parameters::default_values())
  {
    extract_embedded_dual_mesh(output, placement, np, [](const auto&) {});
  }

  /// \cond SKIP_IN_MANUAL
  // `before` is called with the positions of the vertices when everything is done that can fail, and `output` has not changed
  // yet.
  template <class Output, class VertexPlacement, class NamedParameters, class Before>
  void extract_embedded_dual_mesh(Output& output, const VertexPlacement& placement, const NamedParameters& np,
                                  const Before& before)
  {
    Placed_dual dual = place<Output, NamedParameters>(placement);
    std::size_t clusterings = 1;
    if (is_worth_repeating(dual)) {
      const auto repeat = [&](const std::vector<double>& densities) {
        Access::recluster(static_cast<Clustering&>(*this), densities);
        dual = place<Output, NamedParameters>(placement);
        ++clusterings;
      };
      std::vector<double> densities = Access::densities(clustering()), best_densities = densities;
      std::size_t fewest = dual.number_left();
      while (clusterings <= max_repetitions && is_worth_repeating(dual)) {
        raise(densities, dual);
        repeat(densities);
        if (dual.number_left() <= fewest) {
          fewest = dual.number_left();
          best_densities = densities;
        }
      }
      if (dual.number_left() > fewest)
        repeat(best_densities);
    }
    Access::report(clustering()).clusterings = clusterings;
    write(dual, output, np, before);
  }
  /// \endcond

private:
  static constexpr std::size_t max_repetitions = 4;
  /// \cond SKIP_IN_MANUAL
  struct Placed_dual
  {
    std::unique_ptr<const internal::Labelled_pieces> pieces;
    std::vector<internal::Triangle> triangles;
    std::vector<internal::Vector> positions;
    internal::Repair_counts counts;

    std::size_t number_left() const { return counts.intersections_left.size(); }
  };
  /// \endcond
  const Clustering& clustering() const { return static_cast<const Clustering&>(*this); }

  template <class Output, class NamedParameters, class VertexPlacement>
  Placed_dual place(const VertexPlacement& placement) const
  {
    typedef typename GetGeomTraits<Output, NamedParameters>::type Traits;
    const internal::Visitor_handle& visitor = Access::visitor(clustering());
    visitor.stage_begins(Coarsening_stage::TRIANGULATION);
    const internal::Cancellation_point cancellation(visitor);
    Placed_dual dual;
    dual.pieces = std::make_unique<internal::Labelled_pieces>(Access::working_input(clustering()), Access::labels(clustering()),
                                                              clustering().number_of_clusters());
    const Clustered_surface surface(dual.pieces->input(), dual.pieces->labels(), clustering().number_of_clusters(),
                                    Access::execution(clustering()), dual.pieces->features(), cancellation);
    dual.triangles = internal::dual_triangles(Access::labels(clustering()), cancellation, Access::execution(clustering()));
    dual.positions =
      internal::place_vertices(surface, placement, Access::repairs(clustering()),
                               internal::output_coordinates<Traits>(Access::frame(clustering())), dual.triangles, dual.counts,
                               cancellation);
    visitor.throw_if_cancelled();
    visitor.stage_ends(Coarsening_stage::TRIANGULATION);
    return dual;
  }

  template <class Output, class NamedParameters, class Before>
  void write(const Placed_dual& dual, Output& output, const NamedParameters& np, const Before& before) const
  {
    const internal::Visitor_handle& visitor = Access::visitor(clustering());
    Coarsening_report& report = Access::report(clustering());
    report.intersections_found = dual.counts.intersections_found;
    report.intersections_left = dual.number_left();
    report.reversals_found = dual.counts.reversals_found;
    report.reversals_left = dual.counts.reversals_left;
    internal::Face_graph_filler<Output, NamedParameters> filler(dual.positions, Access::frame(clustering()), dual.triangles,
                                                                output, np, internal::Cancellation_point(visitor));
    visitor.throw_if_cancelled();
    before(dual.positions);
    filler.commit();
    internal::write_features(output, np, dual.triangles, dual.pieces->features(), Access::working_input(clustering()),
                             Access::labels(clustering()), Access::patches(clustering()));
  }

  bool is_worth_repeating(const Placed_dual& dual) const
  {
    return dual.number_left() > 0 && 2 * dual.number_left() <= clustering().number_of_clusters() &&
           Access::can_recluster(clustering());
  }

  // In the faces whose clusters have vertices of intersecting triangles.
  void raise(std::vector<double>& densities, const Placed_dual& dual) const
  {
    std::vector<char> is_at_fault(clustering().number_of_clusters(), false);
    for (const internal::Triangle_pair& pair : dual.counts.intersections_left)
      for (const Index t : {pair.first, pair.second})
        for (const Index x : dual.triangles[t])
          is_at_fault[x] = true;
    const internal::Clustering_input& pieces = dual.pieces->input();
    std::vector<char> is_raised(Access::numbering(clustering()).faces.size(), false);
    for (std::size_t p = 0; p < pieces.mesh.number_of_faces(); ++p)
      if (is_at_fault[dual.pieces->labels()[Index(p)]])
        is_raised[pieces.parent_of(Index(p))] = true;
    const internal::Clustering_input& input = Access::input(clustering());
    for (std::size_t f = 0; f < densities.size(); ++f)
      if (is_raised[input.parent_of(Index(f))])
        densities[f] = (std::min)(4 * densities[f], internal::largest_density);
  }
};

} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_DUAL_EXTRACTION_H
