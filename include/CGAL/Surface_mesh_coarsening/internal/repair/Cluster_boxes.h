// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_CLUSTER_BOXES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_CLUSTER_BOXES_H

#include <CGAL/Surface_mesh_coarsening/internal/geometry/Clustered_faces.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/boxes.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Returns the bounding box of some faces.
inline Bbox_3 box_of_faces(const Clustered_faces& surface, const Clustered_faces::Range& faces)
{
  Bbox_3 box;
  for (const Index f : faces)
    for (const Index v : surface.vertices(f))
      box += box_of_point(surface.point(v));
  return box;
}

// The bounding boxes of blocks of consecutive faces of each cluster, and of groups of consecutive blocks.
class Cluster_boxes
{
public:
  static constexpr std::size_t faces_of_block = 8, blocks_of_group = 8;

  explicit Cluster_boxes(const Clustered_faces& surface)
    : surface_(surface), first_block_(surface.number_of_clusters() + 1, 0), first_group_(first_block_)
  {
    for (std::size_t x = 0; x < surface.number_of_clusters(); ++x) {
      first_block_[x + 1] = first_block_[x] + number_of_parts(surface.faces(x).size(), faces_of_block);
      first_group_[x + 1] = first_group_[x] + number_of_parts(first_block_[x + 1] - first_block_[x], blocks_of_group);
    }
    block_.resize(first_block_.back());
    group_.resize(first_group_.back());
    for_each_chunk(surface.execution(), surface.number_of_clusters(), 16, [this](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t x = begin; x < end; ++x)
        for (std::size_t i = first_block_[x]; i < first_block_[x + 1]; ++i) {
          block_[i] = box_of_faces(surface_, faces(x, i));
          group_[group_of(x, i)] += block_[i];
        }
    });
  }

  // Returns the bounding box of a cluster.
  Bbox_3 box(std::size_t cluster) const
  {
    Bbox_3 all;
    for (std::size_t i = first_group_[cluster]; i < first_group_[cluster + 1]; ++i)
      all += group_[i];
    return all;
  }

  // Calls `visit(squared distance from the box, faces)` for the blocks of a cluster whose boxes are not farther from a point than
  // `is_far(squared distance)` tells; its answer may change between calls. Returns the number of boxes compared.
  template <class Is_far, class Visit>
  std::size_t for_each_near(const Vector& p, std::size_t cluster, const Is_far& is_far, const Visit& visit) const
  {
    std::size_t compared = first_group_[cluster + 1] - first_group_[cluster];
    for (std::size_t g = first_group_[cluster]; g < first_group_[cluster + 1]; ++g) {
      if (is_far(squared_distance_from_box(p, group_[g])))
        continue;
      const std::size_t begin = first_block_[cluster] + (g - first_group_[cluster]) * blocks_of_group,
                        end = (std::min)(begin + blocks_of_group, first_block_[cluster + 1]);
      compared += end - begin;
      for (std::size_t i = begin; i < end; ++i) {
        const double squared_distance = squared_distance_from_box(p, block_[i]);
        if (!is_far(squared_distance))
          visit(squared_distance, faces(cluster, i));
      }
    }
    return compared;
  }

private:
  static std::size_t number_of_parts(std::size_t size, std::size_t size_of_part)
  {
    return (size + size_of_part - 1) / size_of_part;
  }

  std::size_t group_of(std::size_t cluster, std::size_t block) const
  {
    return first_group_[cluster] + (block - first_block_[cluster]) / blocks_of_group;
  }

  Clustered_faces::Range faces(std::size_t cluster, std::size_t block) const
  {
    const Clustered_faces::Range all = surface_.faces(cluster);
    const auto begin = all.begin() + std::ptrdiff_t((block - first_block_[cluster]) * faces_of_block);
    return Clustered_faces::Range(begin, begin + (std::min)(std::ptrdiff_t(faces_of_block), all.end() - begin));
  }

  const Clustered_faces& surface_;
  std::vector<std::size_t> first_block_, first_group_; // of each cluster
  std::vector<Bbox_3> block_, group_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_REPAIR_CLUSTER_BOXES_H
