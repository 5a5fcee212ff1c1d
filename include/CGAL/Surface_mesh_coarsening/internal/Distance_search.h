// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_SEARCH_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_SEARCH_H

#include <CGAL/Surface_mesh_coarsening/Cluster_levels.h>
#include <CGAL/Surface_mesh_coarsening/internal/Distance_estimate.h>
#include <CGAL/Surface_mesh_coarsening/internal/write_provenance.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Looks for the coarsest result within a distance: among the levels of a fine clustering, and among what coarser levels become
// when they are minimized.
template <class Clustering, class Placement, class OutputTraits>
class Distance_search
{
public:
  template <class Report>
  Distance_search(std::unique_ptr<Clustering> clustering, const Placement& placement, double distance,
                  std::size_t iterations, std::size_t vertices, Report& report)
    : fine_(std::move(clustering)), placement_(placement), iterations_(iterations), vertices_(vertices), number_((std::max)(vertices / 16, std::size_t(4))),
      clusterings_(report.clusterings), estimates_(report.estimates), bounds_(report.bounds),
      final_vertices_(report.vertices), final_bound_(report.distance_bound), distance_(distance),
      local_distance_(std::ldexp(distance, -Access::frame(*fine_).exponent))
  {}

  // `make_clustering` makes another clustering of the same mesh.
  template <class MakeClustering>
  void run(const MakeClustering& make_clustering)
  {
    do {
      find_fine_clustering();
      bracket();
      lower(make_clustering);
    } while (!bound_result());
  }

  // Of the result:
  const Clustering& clustering() const { return lower_ ? *lower_ : *fine_; }
  const std::vector<Vector>& positions() const { return positions_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  std::vector<Index> clusters_of_faces() const
  {
    std::vector<Index> clusters;
    const auto& numbering = Access::numbering(clustering());
    std::vector<Index> all(numbering.faces.size());
    levels().write_clusters(level_, boost::make_function_property_map<typename Clustering::face_descriptor>(
      [&](typename Clustering::face_descriptor f) -> Index& { return all[numbering.number_of(f)]; }));
    const Clustering_input& input = Access::input(clustering());
    for (std::size_t f = 0; f < input.mesh.number_of_faces(); ++f)
      clusters.push_back(all[input.parent_of(Index(f))]);
    return clusters;
  }

private:
  typedef Clustering_access Access;
  typedef Cluster_levels<Clustering> Levels;

  // Estimates come out a little below bounds.
  double wanted() const { return 0.96 * local_distance_; }

  const Levels& levels() const { return lower_levels_ ? *lower_levels_ : *fine_levels_; }

  // With the first of some numbers of vertices that comes near enough.
  void find_fine_clustering()
  {
    for (;;) {
      number_ = (std::min)(number_, vertices_);
      fine_levels_.reset();
      try {
        fine_->seed(number_);
        fine_->grow();
      } catch (const Unreachable_number_of_vertices& e) {
        if (e.nearest() > number_)
          number_ = vertices_ = e.nearest();
        fine_->seed(e.nearest());
        fine_->grow();
      }
      fine_->minimize(iterations_);
      ++clusterings_;
      fine_levels_.emplace(*fine_);
      level_ = fine_levels_->finest();
      const double e = estimate(*fine_levels_, level_);
      if (number_ >= vertices_ || e <= wanted())
        return;
      number_ *= 4;
    }
  }

  // The estimate falls with about the power -1 of the number of vertices where the surface is smooth, and -1/2 at edges. Steps
  // of these sizes close the bracket in on the coarsest level that keeps to the distance.
  void bracket()
  {
    const Levels& levels = *fine_levels_;
    double low = double(levels.coarsest()) - 1, high = double(level_); // too coarse, and fine enough
    double low_estimate = 0, high_estimate = last_estimate_;
    for (int i = 0; i < 5 && high > 1.06 * low + 1; ++i) {
      double next = high * std::pow(high_estimate / wanted(), low_estimate > 0 ? 0.75 : 1.);
      if (low_estimate > 0 && low > 0 && high_estimate < low_estimate) {
        const double slope = std::log(high_estimate / low_estimate) / std::log(high / low);
        next = high * std::pow(0.98 * wanted() / high_estimate, 1 / slope);
      }
      // Not all the way to an end of the bracket.
      next = (std::max)(next, low > 0 && low_estimate > 0 ? low * std::pow(high / low, 0.15) : low + 1);
      next = std::floor((std::min)(next, high * std::pow((std::max)(low, 1.) / high, 0.1)));
      next = (std::min)((std::max)(next, low + 1), high - 1);
      const double e = estimate(levels, std::size_t(next));
      if (e <= wanted()) {
        high = next;
        high_estimate = e;
      } else {
        low = next;
        low_estimate = e;
      }
    }
    level_ = bracketed_ = std::size_t(high);
  }

  // Minimizes the clusters of a somewhat coarser level. A level that is far from the finest one gains most. Clusters of pieces
  // of faces stay as they are.
  template <class MakeClustering>
  void lower(const MakeClustering& make_clustering)
  {
    const std::size_t n = std::size_t(0.93 * double(level_));
    if (n < fine_levels_->coarsest() || 3 * level_ > fine_levels_->finest() ||
        Access::working_input(*fine_).mesh.number_of_faces() != Access::input(*fine_).mesh.number_of_faces())
      return;
    auto clustering = make_clustering();
    std::vector<Index> clusters(Access::numbering(*fine_).faces.size());
    const auto& numbering = Access::numbering(*fine_);
    const auto map = boost::make_function_property_map<typename Clustering::face_descriptor>(
      [&](typename Clustering::face_descriptor f) -> Index& { return clusters[numbering.number_of(f)]; });
    fine_levels_->write_clusters(n, map);
    clustering->set_clusters(map);
    clustering->minimize(iterations_);
    ++clusterings_;
    Levels levels(*clustering);
    if (estimate(levels, n) > wanted())
      return;
    lower_ = std::move(clustering);
    lower_levels_.emplace(*lower_);
    level_ = n;
  }

  // Estimates take the place of bounds in the search; where that was wrong, a finer level is needed. Returns whether there was
  // one that is fine enough, or a finer clustering is.
  bool bound_result()
  {
    const double error = local_distance_ / 32;
    const Distance_mesh surface = triangles_of(Access::input(*fine_).mesh);
    for (;;) {
      place(levels(), level_, Access::repairs(*fine_));
      const double bound = hausdorff_bound(surface, output_positions(), triangles_, error);
      ++bounds_;
      if (bound <= local_distance_) {
        final_vertices_ = level_;
        final_bound_ = std::ldexp(bound, Access::frame(*fine_).exponent);
        return true;
      }
      if (level_ == fine_levels_->finest() && !lower_) {
        if (number_ < vertices_) {
          number_ *= 2;
          return false;
        }
        throw Unreachable_distance("no result within a distance of " + std::to_string(distance_) + " was found",
                                   std::ldexp(bound, Access::frame(*fine_).exponent));
      }
      const double finer = double(level_) * (std::min)(2., (std::max)(1.05, std::pow(bound / local_distance_, 1.2)));
      level_ = lower_ ? bracketed_ : (std::min)(fine_levels_->finest(), std::size_t(finer) + 1);
      lower_levels_.reset();
      lower_.reset();
    }
  }

  double estimate(const Levels& levels, std::size_t n)
  {
    const Cluster_labels labels = place(levels, n, false);
    ++estimates_;
    last_estimate_ = Distance_estimate(labels, positions_, triangles_, Checkpoint(Access::visitor(*fine_))).distance();
    return last_estimate_;
  }

  Cluster_labels place(const Levels& levels, std::size_t n, bool with_repair)
  {
    Cluster_labels labels = levels.labels(n);
    positions_ = levels.place(labels, n, placement_, with_repair,
                              output_coordinates<OutputTraits>(Access::frame(*fine_)), triangles_);
    return labels;
  }

  // The positions that the output has after rounding, in the coordinates of the arrays.
  std::vector<Vector> output_positions() const
  {
    const Frame& frame = Access::frame(*fine_);
    const auto to_output = output_coordinates<OutputTraits>(frame);
    std::vector<Vector> result;
    for (const Vector& p : positions_) {
      Vector q = to_output(p);
      for (int i = 0; i < 3; ++i)
        q[i] = std::ldexp(q[i] - frame.origin[i], -frame.exponent);
      result.push_back(q);
    }
    return result;
  }

  std::unique_ptr<Clustering> fine_, lower_;
  std::optional<Levels> fine_levels_, lower_levels_;
  Placement placement_;
  std::size_t iterations_;
  std::size_t vertices_; // the largest number of clusters that is tried
  std::size_t number_;   // of clusters that the fine clustering shall have
  std::size_t &clusterings_, &estimates_, &bounds_, &final_vertices_;
  double& final_bound_;
  double distance_, local_distance_, last_estimate_ = 0;
  std::size_t level_ = 0, bracketed_ = 0;
  std::vector<Vector> positions_;
  std::vector<Triangle> triangles_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTANCE_SEARCH_H
