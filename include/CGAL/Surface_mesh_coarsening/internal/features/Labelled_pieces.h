// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_LABELLED_PIECES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_LABELLED_PIECES_H

#include <CGAL/Surface_mesh_coarsening/internal/base/Majority.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/Coarse_features.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The faces with geometry and their clusters: the clustered faces or, if features are kept, the pieces of the cells.
class Labelled_pieces
{
public:
  Labelled_pieces(const Featured_input& input, const Cluster_labels& labels, std::size_t clusters)
    : input_(input.cells ? input.cells->pieces() : input.items), labels_(labels)
  {
    if (!input.cells)
      return;
    labels_of_pieces_.emplace(input_.mesh);
    for (std::size_t p = 0; p < input_.mesh.number_of_faces(); ++p)
      labels_of_pieces_->set(Index(p), labels[input.cells->polygon(Index(p))]);
    labels_of_pieces_->recount();
    if (input.cells->has_features())
      features_.emplace(*input.cells, *labels_of_pieces_, clusters);
    if (input.cells->extent() == Feature_cells::AT_ALL_VERTICES)
      find_single_cells(*input.cells, clusters);
  }

  const Clustering_input& input() const { return input_; }
  const Cluster_labels& labels() const { return labels_of_pieces_ ? *labels_of_pieces_ : labels_; }
  // Null without features.
  const Coarse_features* features() const { return features_ ? &*features_ : nullptr; }
  // For each cluster that is the cell of one vertex, this vertex; NONE for other clusters. Empty if faces are clustered.
  const std::vector<Index>& single_vertices() const { return single_vertex_; }
  // The number of cells of vertices; 0 if faces are clustered.
  std::size_t number_of_cells() const { return single_vertex_.empty() ? 0 : labels_.labels().size(); }

private:
  void find_single_cells(const Feature_cells& cells, std::size_t clusters)
  {
    single_vertex_.assign(clusters, NONE);
    std::vector<char> has_cell(clusters, false);
    for (std::size_t polygon = 0; polygon < labels_.labels().size(); ++polygon) {
      const Index x = labels_[Index(polygon)];
      single_vertex_[x] = has_cell[x] ? NONE : cells.vertex(Index(polygon));
      has_cell[x] = true;
    }
  }

  const Clustering_input& input_;
  const Cluster_labels& labels_;
  std::optional<Cluster_labels> labels_of_pieces_;
  std::optional<Coarse_features> features_;
  std::vector<Index> single_vertex_;
};

// Returns the cluster of a face of the caller's mesh: the cluster of its largest part, or `none` if it has no part, as
// in a removed component. If features are kept, the first corner of the face takes precedence, then the first end of a
// feature edge of the face. So the faces around a corner have the cluster of the corner, and both faces of a feature
// edge have the same cluster, unless a face has several corners or feature edges.
inline std::size_t cluster_of_face(const Featured_input& input, const Cluster_labels& labels, std::size_t none, Index f)
{
  const Feature_cells* const cells = input.cells.get();
  const Clustering_input& pieces = cells ? cells->pieces() : input.items;
  if (pieces.parent.empty())
    return labels[f];
  // Pieces are sorted by face.
  const auto range = std::equal_range(pieces.parent.begin(), pieces.parent.end(), f);
  Index first_node = NONE;
  Majority<Index> votes;
  for (auto i = range.first; i != range.second; ++i) {
    const Index piece = Index(i - pieces.parent.begin());
    votes.add(pieces.area[piece], labels[cells ? cells->polygon(piece) : piece]);
    const Index node = cells ? cells->node(cells->polygon(piece)) : NONE;
    if (node != NONE && (cells->graph().is_corner(node) || cells->has_line_at(piece)))
      first_node = (std::min)(first_node, node);
  }
  if (first_node != NONE)
    return labels[cells->cell(first_node)];
  return votes.empty() ? none : votes.value();
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_LABELLED_PIECES_H
