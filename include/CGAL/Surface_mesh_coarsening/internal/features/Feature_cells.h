// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FEATURE_CELLS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FEATURE_CELLS_H

#include <CGAL/Surface_mesh_coarsening/internal/features/Feature_graph.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/subdivision.h>

#include <memory>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Builds the mesh to be clustered if there are features, or if the dual cells of all vertices are clustered. Subdivides the faces
// around the nodes of the feature graph, or all faces, into one quadrilateral per corner, and joins the quadrilaterals around a
// vertex to one polygon, its cell. Each feature edge then lies in at most two clusters of these polygons. If there are two, they
// meet in an arc across the midpoint of the edge. Hence rules for cells keep features: see Feature_rules. If each cell of a
// vertex is a cluster, the dual of the clusters is the original mesh.
//
// The polygons of this mesh have sums but no geometry. The surface is given by `pieces`, whose faces form the
// polygons.
class Feature_cells
{
public:
  enum Extent { AT_FEATURES, AT_ALL_VERTICES };

  // Builds the mesh to be clustered. Cells at features need features.
  static Featured_input run(const Clustering_input& base, const Feature_edges& edges, const Run_context& context,
                            Extent extent = AT_FEATURES)
  {
    auto cells = std::make_shared<Feature_cells>(base, edges, extent);
    const std::vector<char> too_wide = cells->faces_at(&Feature_cells::has_bigon);
    if (!too_wide.empty()) {
      Star_subdivision cutting(base.mesh, too_wide);
      Flat_mesh triangles = cutting.run([&](Index f) { return mean_of_corners(base.mesh, f); }, context);
      cells->keep_bounds(triangles);
      return cells->cut(cutting, std::move(triangles), context);
    }
    if (!cells->graph_.has_room())
      return cells->subdivided(std::vector<bool>(base.mesh.components.size(), true), context);
    Clustering_input items = cells->make(context);
    return {std::move(items), std::move(cells)};
  }

  Feature_cells(const Clustering_input& base, const Feature_edges& edges, Extent extent)
    : base_(base), edges_(edges), graph_(base_.mesh, edges), extent_(extent) {}

  // The same after a subdivision of the faces of the chosen components of the original mesh.
  Featured_input subdivided(const std::vector<bool>& chosen_component, const Run_context& context) const
  {
    Quad_subdivision cutting(base_.mesh, faces_of_components(base_.mesh, chosen_component));
    return cut(cutting, cutting.run(context), context);
  }

  // The same after edges have been halved that are long for faces of the mean area; nothing if there are none.
  std::optional<Featured_input> with_long_edges_halved(const Run_context& context) const
  {
    constexpr double long_part = 3; // in units of the square root of the area
    const double area = std::accumulate(base_.area.begin(), base_.area.end(), 0.);
    Long_edge_cutting cutting(base_.mesh, long_part * long_part * area / double(base_.area.size()));
    if (!cutting.has_cut())
      return std::nullopt;
    return cut(cutting, cutting.run(context), context);
  }

  const Clustering_input& base() const { return base_; }
  const Feature_edges& edges() const { return edges_; }
  const Feature_graph& graph() const { return graph_; }
  Extent extent() const { return extent_; }
  bool has_features() const { return graph_.number_of_nodes() > 0; }

  // The faces of the original mesh, subdivided around nodes. Vertices have the same numbers as in the mesh of cells.
  const Clustering_input& pieces() const { return pieces_; }
  // The polygon, and the face of base(), that contains a piece.
  Index polygon(Index piece) const { return polygon_of_piece_[piece]; }
  Index base_face(Index piece) const { return face_of_piece_[piece]; }

  // Returns whether a piece at a node has a feature edge.
  bool has_line_at(Index piece) const
  {
    const Index f = face_of_piece_[piece], v = pieces_.mesh.corner_vertex[pieces_.mesh.first_corner[piece]];
    const Index c = base_.mesh.corner_of(f, v);
    return edges_.is_feature[c] || edges_.is_feature[base_.mesh.previous_corner(f, c)];
  }

  template <class Visit>
  void for_each_piece(Index polygon, const Visit& visit) const
  {
    if (vertex_of_polygon_[polygon] == NONE)
      visit(first_piece_[polygon]);
    else
      for (const Index piece : pieces_.mesh.faces_around(vertex_of_polygon_[polygon]))
        visit(piece);
  }

  // The vertex whose cell a polygon is; NONE if the polygon is a face.
  Index vertex(Index polygon) const { return vertex_of_polygon_[polygon]; }
  // The node of a polygon; NONE if the polygon is not the cell of a node.
  Index node(Index polygon) const { return node_of_polygon_[polygon]; }
  Index cell(Index node) const { return cell_of_node_[node]; }
  // Returns whether a polygon has an edge on the border.
  bool is_at_border(Index polygon) const { return is_at_border_[polygon]; }
  // Returns whether a corner lies on the border.
  bool is_on_border(Index node) const { return base_.mesh.is_on_border(graph_.vertex(node)); }
  // Returns the midpoint of the edge from a node to the next node of a line.
  Index middle(Index node, Index next) const
  {
    const Flat_mesh& m = base_.mesh;
    const Index v = graph_.vertex(node), w = graph_.vertex(next);
    for (const Index f : m.faces_around(v)) {
      const Index c = m.corner_of(f, v);
      if (m.corner_vertex[m.next_corner(f, c)] == w && edges_.is_feature[c])
        return middle_[c];
    }
    return NONE;
  }

private:
  bool has_cell(Index v) const { return extent_ == AT_ALL_VERTICES || graph_.node_of_vertex(v) != NONE; }

  // The cell would have two neighbors and could not be a cluster.
  bool has_bigon(Index v) const { return has_cell(v) && base_.mesh.valence(v) == 2 && !base_.mesh.is_on_border(v); }

  // Marks the faces at the vertices that satisfy a predicate. Returns an empty vector if there are none.
  std::vector<char> faces_at(bool (Feature_cells::*is_chosen)(Index) const) const
  {
    const Flat_mesh& m = base_.mesh;
    std::vector<char> result;
    for (Index v = 0; v < m.number_of_vertices(); ++v) {
      if (!(this->*is_chosen)(v))
        continue;
      result.resize(m.number_of_faces(), false);
      for (const Index f : m.faces_around(v))
        result[f] = true;
    }
    return result;
  }

  // The same after the original mesh has been cut into pieces.
  Featured_input cut(const Face_cutting& cutting, Flat_mesh pieces, const Run_context& context) const
  {
    const Feature_edges edges = edges_.cut(pieces, cutting.old_corner());
    return run(cut_input(base_, std::move(pieces), cutting.old_face(), context), edges, context, extent_);
  }

  Clustering_input make(const Run_context& context)
  {
    const std::vector<char> is_cut = faces_at(&Feature_cells::has_cell);
    Quad_subdivision cutting(base_.mesh, is_cut);
    pieces_ = cut_input(base_, cutting.run(context), cutting.old_face());
    face_of_piece_ = cutting.old_face();
    middle_ = cutting.middle();
    number_polygons(is_cut);
    Clustering_input result;
    result.mesh = join_pieces(context);
    sum_up(result);
    keep_bounds(result.mesh);
    const auto component_of = [&](Index node) -> Component& {
      return result.mesh.components[result.mesh.component[cell_of_node_[node]]];
    };
    for (Index i = 0; i < graph_.number_of_corners(); ++i) {
      ++component_of(i).feature_clusters;
      ++component_of(i).feature_corners;
    }
    for (const Feature_line& line : graph_.lines())
      component_of(line.nodes[0]).feature_clusters += line.is_loop ? line.min_crossings : line.min_crossings - 1;
    for (std::size_t f = 0; f < result.mesh.number_of_faces(); ++f)
      is_at_border_.push_back(result.mesh.has_border_edge(f));
    return result;
  }

  // Numbers polygons in the order of their pieces, which preserves the order of components.
  void number_polygons(const std::vector<char>& is_cut)
  {
    const Flat_mesh& m = base_.mesh;
    std::vector<Index> vertex_of_piece(pieces_.mesh.number_of_faces(), NONE), cell_of_vertex(m.number_of_vertices(), NONE);
    for (std::size_t p = 0; p < vertex_of_piece.size(); ++p) {
      const Index v = pieces_.mesh.corner_vertex[pieces_.mesh.first_corner[p]]; // of a piece of a subdivided face
      if (is_cut[face_of_piece_[p]] && has_cell(v))
        vertex_of_piece[p] = v;
    }
    cell_of_node_.assign(graph_.number_of_nodes(), NONE);
    for (std::size_t p = 0; p < vertex_of_piece.size(); ++p) {
      const Index v = vertex_of_piece[p], node = v == NONE ? NONE : graph_.node_of_vertex(v);
      Index polygon = v == NONE ? NONE : cell_of_vertex[v];
      if (polygon == NONE) {
        polygon = Index(vertex_of_polygon_.size());
        vertex_of_polygon_.push_back(v);
        node_of_polygon_.push_back(node);
        first_piece_.push_back(Index(p));
        if (v != NONE)
          cell_of_vertex[v] = polygon;
        if (node != NONE)
          cell_of_node_[node] = polygon;
      }
      polygon_of_piece_.push_back(polygon);
    }
  }

  // Joins the pieces around each vertex that has a cell. The corners of these pieces are the vertex, the midpoint of an edge, the
  // center of the face, the midpoint of an edge.
  Flat_mesh join_pieces(const Run_context& context) const
  {
    const Flat_mesh& m = pieces_.mesh;
    Flat_mesh result;
    result.points = m.points;
    result.first_corner.push_back(0);
    const auto push = [&](Index corner) {
      const Index across = m.face_across[corner];
      result.corner_vertex.push_back(m.corner_vertex[corner]);
      result.face_across.push_back(across == NONE ? NONE : polygon_of_piece_[across]);
    };
    for (std::size_t polygon = 0; polygon < vertex_of_polygon_.size(); ++polygon) {
      const Index v = vertex_of_polygon_[polygon];
      if (v == NONE) {
        for (const Index c : m.corners(first_piece_[polygon]))
          push(c);
      } else {
        if (m.is_on_border(v))
          push(m.first_corner[m.star[m.first_in_star[v]]]);
        for (const Index piece : m.faces_around(v)) {
          push(m.first_corner[piece] + 1);
          push(m.first_corner[piece] + 2);
        }
        if (m.is_on_border(v))
          push(m.first_corner[m.star[m.first_in_star[v + 1] - 1]] + 3);
      }
      result.first_corner.push_back(Index(result.corner_vertex.size()));
    }
    complete_topology(result, result.points.size(), context);
    return result;
  }

  void sum_up(Clustering_input& result) const
  {
    std::vector<Index> pieces_of_face(base_.mesh.number_of_faces(), 0);
    for (const Index f : face_of_piece_)
      ++pieces_of_face[f];
    const Bucketed_items<Index> parts(numbers_below(Index(polygon_of_piece_.size())), vertex_of_polygon_.size(),
                                      [this](Index piece) { return polygon_of_piece_[piece]; });
    for (std::size_t polygon = 0; polygon < parts.size(); ++polygon) {
      double area = 0, mass = 0, density = 0, faces = 0;
      Vector moment{{0, 0, 0}}, sum{{0, 0, 0}};
      for (const Index piece : parts[polygon]) {
        const Vector centroid = pieces_.centroid(piece);
        area += pieces_.area[piece];
        mass += pieces_.mass(piece);
        moment = moment + pieces_.mass(piece) * centroid;
        sum = sum + centroid;
        density += pieces_.density[piece];
        faces += 1. / double(pieces_of_face[face_of_piece_[piece]]);
      }
      const double number = double(parts[polygon].size());
      result.area.push_back(area);
      result.density.push_back(mass > 0 ? mass / area : density / number);
      result.item_centroid.push_back(mass > 0 ? (1 / mass) * moment : (1 / number) * sum);
      result.item_faces.push_back(faces);
      result.parent.push_back(pieces_.parent[first_piece_[polygon]]);
    }
  }

  // New vertices do not permit more clusters.
  void keep_bounds(Flat_mesh& m) const
  {
    for (std::size_t i = 0; i < m.components.size(); ++i)
      m.components[i].original_vertices = base_.mesh.components[i].max_clusters();
  }

  Clustering_input base_, pieces_;
  Feature_edges edges_;
  Feature_graph graph_;
  Extent extent_;
  std::vector<Index> middle_;                        // of the edge after each corner of the base
  std::vector<Index> face_of_piece_, polygon_of_piece_;
  std::vector<Index> vertex_of_polygon_, node_of_polygon_, first_piece_, cell_of_node_;
  std::vector<char> is_at_border_;
};

// Returns whether the cells of all vertices are clustered.
inline bool has_vertex_cells(const Featured_input& input)
{
  return input.cells && input.cells->extent() == Feature_cells::AT_ALL_VERTICES;
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_FEATURES_FEATURE_CELLS_H
