// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_COARSE_FEATURES_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_COARSE_FEATURES_H

#include <CGAL/Surface_mesh_coarsening/internal/clusters/Cluster_labels.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/Feature_cells.h>

#include <CGAL/utility.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// The features in the dual of clusters that satisfy Feature_rules. Corners are vertices, and lines are polylines of the
// edges between the clusters that they cross.
class Coarse_features
{
public:
  // A part of a line in one cluster, as a polyline of vertices of the pieces of faces.
  struct Arc
  {
    Index cluster;
    std::vector<Index> vertices;
  };
  struct Line
  {
    std::vector<Arc> arcs; // unless the line is a loop, the first arc begins and the last arc ends at a corner
    bool is_loop = false;
  };

  // `labels` are the labels of the pieces.
  Coarse_features(const Feature_cells& cells, const Cluster_labels& labels, std::size_t clusters)
    : cells_(cells), labels_(labels), corner_of_(clusters, NONE)
  {
    const Feature_graph& graph = cells.graph();
    for (Index i = 0; i < graph.number_of_corners(); ++i)
      corner_of_[label(i)] = graph.vertex(i);
    for (const Feature_line& line : graph.lines())
      add_line(line);
    std::sort(edges_.begin(), edges_.end());
  }

  // The vertex at the corner of each cluster; NONE without a corner.
  const std::vector<Index>& corners() const { return corner_of_; }
  const std::vector<Line>& lines() const { return lines_; }
  bool is_edge(Index x, Index y) const { return std::binary_search(edges_.begin(), edges_.end(), make_sorted_pair(x, y)); }

private:
  Index label(Index node) const
  {
    const Flat_mesh& m = cells_.pieces().mesh;
    return labels_[m.star[m.first_in_star[cells_.graph().vertex(node)]]];
  }

  void add_line(const Feature_line& line)
  {
    std::vector<Index> nodes = line.nodes;
    const std::size_t n = nodes.size();
    if (line.is_loop) { // begins at a crossing
      std::size_t begin = 0;
      while (begin < n && label(nodes[begin]) == label(nodes[(begin + n - 1) % n]))
        ++begin;
      std::rotate(nodes.begin(), nodes.begin() + std::ptrdiff_t(begin), nodes.end());
    }
    Line coarse{{{label(nodes[0]), {}}}, line.is_loop};
    if (line.is_loop)
      coarse.arcs[0].vertices.push_back(cells_.middle(nodes[n - 1], nodes[0]));
    for (std::size_t i = 0; i < n; ++i) {
      const Index node = nodes[i], next = nodes[(i + 1) % n];
      coarse.arcs.back().vertices.push_back(cells_.graph().vertex(node));
      if ((i + 1 == n && !line.is_loop) || label(node) == label(next))
        continue;
      const Index middle = cells_.middle(node, next);
      coarse.arcs.back().vertices.push_back(middle);
      edges_.push_back(make_sorted_pair(label(node), label(next)));
      if (i + 1 < n)
        coarse.arcs.push_back({label(next), {middle}});
    }
    lines_.push_back(coarse);
  }

  const Feature_cells& cells_;
  const Cluster_labels& labels_;
  std::vector<Index> corner_of_;
  std::vector<Line> lines_;
  std::vector<std::pair<Index, Index> > edges_;
};

// The faces with geometry and their clusters: the clustered faces or, if features are kept, the pieces of the cells.
class Labelled_pieces
{
public:
  Labelled_pieces(const Featured_input& input, const Cluster_labels& labels, std::size_t clusters)
    : input_(input.cells ? input.cells->pieces() : input.items), labels_(labels),
      cells_(input.cells && input.cells->base().mesh.is_triangle_mesh() ? input.cells.get() : nullptr)
  {
    if (!input.cells)
      return;
    labels_of_pieces_.emplace(input_.mesh);
    for (std::size_t p = 0; p < input_.mesh.number_of_faces(); ++p)
      labels_of_pieces_->set(Index(p), labels[input.cells->polygon(Index(p))]);
    labels_of_pieces_->recount();
    if (input.cells->has_features())
      features_.emplace(*input.cells, *labels_of_pieces_, clusters);
    if (!has_vertex_cells(input))
      return;
    single_vertex_.assign(clusters, NONE);
    std::vector<char> has_cell(clusters, false);
    for (std::size_t polygon = 0; polygon < labels.labels().size(); ++polygon) {
      const Index x = labels[Index(polygon)];
      single_vertex_[x] = has_cell[x] ? NONE : input.cells->vertex(Index(polygon));
      has_cell[x] = true;
    }
  }

  const Clustering_input& input() const { return input_; }
  // The triangles that were cut into pieces, and the triangle that contains a piece. Pieces of other faces are themselves whole,
  // because the fan of a face from one of its corners is another surface if the face is not flat or not convex.
  const Flat_mesh& whole_mesh() const { return cells_ ? cells_->base().mesh : input_.mesh; }
  Index whole_face(Index piece) const { return cells_ ? cells_->base_face(piece) : piece; }
  const Cluster_labels& labels() const { return labels_of_pieces_ ? *labels_of_pieces_ : labels_; }
  // Null without features.
  const Coarse_features* features() const { return features_ ? &*features_ : nullptr; }
  // For each cluster that is the cell of one vertex, this vertex; NONE for other clusters. Empty if faces are clustered.
  const std::vector<Index>& single_vertices() const { return single_vertex_; }
  // The number of cells of vertices; 0 if faces are clustered.
  std::size_t number_of_cells() const { return single_vertex_.empty() ? 0 : labels_.labels().size(); }

private:
  const Clustering_input& input_;
  const Cluster_labels& labels_;
  std::optional<Cluster_labels> labels_of_pieces_;
  std::optional<Coarse_features> features_;
  std::vector<Index> single_vertex_;
  const Feature_cells* cells_; // of triangles; null if no triangles were cut
};

// Returns the cluster of a face of the caller's mesh: the cluster of its largest part. If features are kept, the first corner of
// the face takes precedence, then the first end of a feature edge of the face. So the faces around a corner have the cluster of
// the corner, and both faces of a feature edge have the same cluster, unless a face has several corners or feature edges.
inline std::size_t cluster_of_face(const Featured_input& input, const Cluster_labels& labels, Index f)
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
  return first_node != NONE ? labels[cells->cell(first_node)] : votes.value();
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_COARSE_FEATURES_H
