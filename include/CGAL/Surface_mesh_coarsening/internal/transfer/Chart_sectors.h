// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_TRANSFER_CHART_SECTORS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_TRANSFER_CHART_SECTORS_H

#include <CGAL/Surface_mesh_coarsening/internal/transfer/Surface_correspondence.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/sort_unique.h>

#include <map>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Finds the points from which the corners of coarse triangles take values if the values have seams.
//
// Around a coarse vertex, seams divide the faces of its cluster and of the adjacent clusters into sectors. A triangle
// there belongs to the sector of the face nearest to its center, and its corner takes the value at the nearest point of
// this sector. So all triangles on the same side of a seam have the same value at the vertex, and no value mixes the two
// sides.
class Chart_sectors
{
public:
  // `is_seam` states, for each corner of the mesh, whether the edge after it is a seam.
  Chart_sectors(Surface_correspondence& surfaces, const std::vector<bool>& is_seam)
    : surfaces_(surfaces), mesh_(surfaces.mesh()), is_seam_(is_seam), stamp_(mesh_.number_of_faces(), NONE),
      sector_(mesh_.number_of_faces(), NONE)
  {}

  // Calls `visit(triangle, nearest point)` for each triangle around a vertex.
  template <class Visit>
  void for_each_corner_at(Index x, const Visit& visit)
  {
    collect(x);
    const bool is_cut = number_sectors(x);
    std::map<Index, Nearest_point> nearest_in_sector;
    for (const Index t : surfaces_.around(x)) {
      const Index face = surfaces_.triangle_sources()[t].face;
      const Index sector = is_cut && stamp_[face] == x ? sector_[face] : 0;
      const auto found = nearest_in_sector.find(sector);
      visit(t, found != nearest_in_sector.end()
                 ? found->second
                 : nearest_in_sector.emplace(sector, nearest_in(x, is_cut ? sector : NONE)).first->second);
    }
  }

private:
  // Collects the faces of the cluster and of its neighbors.
  void collect(Index x)
  {
    std::vector<Index> clusters(1, x);
    for (const Index t : surfaces_.around(x))
      clusters.insert(clusters.end(), surfaces_.triangles()[t].begin(), surfaces_.triangles()[t].end());
    sort_unique(clusters);
    faces_.clear();
    for (const Index y : clusters)
      for (const Index f : surfaces_.faces(y)) {
        faces_.push_back(f);
        stamp_[f] = x;
        sector_[f] = NONE;
      }
  }

  // Returns whether there is a seam.
  bool number_sectors(Index x)
  {
    bool is_cut = false;
    for (const Index f : faces_)
      for (Index c = mesh_.first_corner[f]; c != mesh_.first_corner[f + 1] && !is_cut; ++c)
        is_cut = is_seam_[c] && mesh_.face_across[c] != NONE && stamp_[mesh_.face_across[c]] == x;
    if (!is_cut)
      return false;
    Index sectors = 0;
    for (const Index first : faces_) {
      if (sector_[first] != NONE)
        continue;
      sector_[first] = sectors;
      stack_.assign(1, first);
      while (!stack_.empty()) {
        const Index f = stack_.back();
        stack_.pop_back();
        for (const Index c : mesh_.corners(f)) {
          const Index g = mesh_.face_across[c];
          if (g != NONE && !is_seam_[c] && stamp_[g] == x && sector_[g] == NONE) {
            sector_[g] = sectors;
            stack_.push_back(g);
          }
        }
      }
      ++sectors;
    }
    return true;
  }

  // Searches all faces if the sector is NONE.
  Nearest_point nearest_in(Index x, Index sector) const
  {
    Nearest_point nearest;
    for (const Index f : faces_)
      if (sector == NONE || sector_[f] == sector)
        improve(mesh_, surfaces_.position(x), f, nearest);
    return nearest.face == NONE ? surfaces_.search()(surfaces_.position(x), x) : nearest;
  }

  Surface_correspondence& surfaces_;
  const Flat_mesh& mesh_;
  const std::vector<bool>& is_seam_;
  std::vector<Index> stamp_, sector_; // per face
  std::vector<Index> faces_, stack_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_TRANSFER_CHART_SECTORS_H
