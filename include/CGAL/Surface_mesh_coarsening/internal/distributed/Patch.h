// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_PATCH_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_PATCH_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Face_record.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Record_bins.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// A mesh of the faces of a group, the own faces, and of all faces that share a vertex with them. The stars of the vertices of
// own faces are complete. The other faces have edges that seem to lie on a border, and their vertices are split where the faces
// around them form several fans. The faces are in the global order, so each star begins with the same face as in the whole mesh.
struct Patch
{
  std::vector<Face_data> faces;      // their corners are in the mesh
  Featured_input input;              // has only the mesh until the faces are clustered; without features
  std::vector<std::uint64_t> number; // the global number of each vertex of the mesh
  std::vector<char> is_inner;        // for each vertex of the mesh, whether all incident faces are own faces

  const Flat_mesh& mesh() const { return input.items.mesh; }
  bool is_own(std::size_t f) const { return faces[f].is_own; }
  bool is_inner_face(Index f) const
  {
    return !mesh().any_corner(f, [this](Index c) { return !is_inner[mesh().corner_vertex[c]]; });
  }

  void get(Index f, Face_record& face) const
  {
    static_cast<Face_data&>(face) = faces[f];
    face.corner.clear();
    for (const Index c : mesh().corners(f))
      face.corner.push_back({number[mesh().corner_vertex[c]], mesh().points[mesh().corner_vertex[c]]});
  }
};

inline std::vector<Index> faces_of_corners(const Flat_mesh& m)
{
  std::vector<Index> faces;
  faces.reserve(m.first_corner[m.number_of_faces()]);
  for (Index f = 0; f < m.number_of_faces(); ++f)
    faces.resize(m.first_corner[f + 1], f);
  return faces;
}

// Sets the faces across all edges. An edge that leaves a vertex enters it, seen from the other face: corners x and y of the
// vertex belong to one edge if `after(x) == before(y)`, numbers of vertices. Returns whether all edges enter a vertex from
// different vertices. Corners are sorted, so vertices of high degree cost hardly more than others.
template <class Before, class After>
bool pair_edges(Flat_mesh& m, const std::vector<Index>& face_of_corner, const Bucketed_items<Index>& corners_at_vertex,
                const Before& before, const After& after)
{
  struct Corner
  {
    Index corner;
    decltype(before(Index())) previous, next;
  };
  m.face_across.assign(face_of_corner.size(), NONE);
  bool are_different = true;
  std::vector<Corner> corners;
  for (std::size_t v = 0; v < corners_at_vertex.size(); ++v) {
    corners.clear();
    for (const Index c : corners_at_vertex[v])
      corners.push_back({c, before(c), after(c)});
    std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) { return a.previous < b.previous; });
    for (const Corner& x : corners) {
      const auto y = std::lower_bound(corners.begin(), corners.end(), x,
                                      [](const Corner& a, const Corner& b) { return a.previous < b.next; });
      if (y != corners.end() && y->previous == x.next)
        m.face_across[x.corner] = face_of_corner[y->corner];
    }
    are_different = are_different && std::adjacent_find(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) {
                                       return a.previous == b.previous;
                                     }) == corners.end();
  }
  return are_different;
}

// Builds the mesh of a patch from faces in any order. Throws if the faces of the patch, or of several pieces, contradict each
// other. Of several contradictions, the one at the smallest vertex numbers is reported.
class Patch_builder
{
public:
  // Faces with more than `max_corners` corners together are rejected.
  Patch_builder(Patch& patch, const Face_names& names, std::size_t max_corners = NONE / 2 - 1)
    : patch_(patch), faces_(patch.faces), mesh_(patch.input.items.mesh), names_(names), max_corners_(max_corners)
  {}

  void reserve_triangles(std::size_t triangles)
  {
    faces_.reserve(triangles);
    corner_.reserve(3 * triangles);
  }

  void add(const Face_record& face)
  {
    faces_.push_back(face);
    faces_.back().corners = Index(face.corner.size()) & Face_data::max_corners;
    corner_.insert(corner_.end(), face.corner.begin(), face.corner.end());
  }

  void run(const Run_context& context)
  {
    sort_faces();
    if (corner_.size() > max_corners_)
      throw Invalid_input("a block around " + name(0) + " has " + std::to_string(corner_.size()) +
                          " face corners, more than the " + std::to_string(max_corners_) + " that can be numbered");
    mesh_.first_corner.push_back(0);
    for (const Face_data& face : faces_)
      mesh_.first_corner.push_back(mesh_.first_corner[mesh_.number_of_faces()] + face.corners);
    face_of_ = faces_of_corners(mesh_);
    vertex_of_.reserve(corner_.size());
    for (const Face_corner& c : corner_)
      vertex_of_.push_back(table_.index(c.vertex));
    corners_at_.emplace(numbers_below(Index(corner_.size())), table_.numbers().size(), [this](Index c) { return vertex_of_[c]; });
    check_positions();
    const auto previous_vertex = [this](Index c) { return vertex_of_[previous_corner(c)]; };
    if (!pair_edges(mesh_, face_of_, *corners_at_, previous_vertex, [this](Index c) { return next_vertex(c); }))
      throw_two_faces();
    divide_into_fans();
    corner_ = std::vector<Face_corner>();
    complete_stars(mesh_, patch_.number.size(), context);
    patch_.is_inner.assign(patch_.number.size(), true);
    for (Index f = 0; f < faces_.size(); ++f)
      if (!patch_.is_own(f))
        for (const Index c : mesh_.corners(f))
          patch_.is_inner[mesh_.corner_vertex[c]] = false;
  }

private:
  // Reorders one array after the other, which takes less memory than a second set of faces.
  void sort_faces()
  {
    std::vector<std::size_t> first_corner(1, 0);
    first_corner.reserve(faces_.size() + 1);
    for (const Face_data& face : faces_)
      first_corner.push_back(first_corner.back() + face.corners);
    // Duplicate faces are a fault; the message must not depend on the order in which they arrived.
    const auto rest = [&](Index f) {
      const Face_corner* const c = corner_.data() + first_corner[f];
      return std::make_tuple(c[0].vertex, c[1].vertex, faces_[f].origin);
    };
    const Number_range numbers = numbers_below(Index(faces_.size()));
    std::vector<Index> order(numbers.begin(), numbers.end());
    sort_runs(order, [&](Index f, Index g) {
      return faces_[f].place != faces_[g].place ? faces_[f].place < faces_[g].place : rest(f) < rest(g);
    });
    std::vector<Face_corner> corners;
    corners.reserve(corner_.size());
    for (const Index f : order)
      corners.insert(corners.end(), corner_.data() + first_corner[f], corner_.data() + first_corner[f + 1]);
    corner_.swap(corners);
    corners = std::vector<Face_corner>();
    std::vector<Face_data> faces;
    faces.reserve(order.size());
    for (const Index f : order)
      faces.push_back(faces_[f]);
    faces_.swap(faces);
  }

  std::uint64_t number(Index v) const { return table_.numbers()[v]; }
  Bucketed_items<Index>::Range corners_at(Index v) const { return (*corners_at_)[v]; }
  Index next_vertex(Index c) const { return vertex_of_[mesh_.next_corner(face_of_[c], c)]; }
  Index previous_corner(Index c) const { return mesh_.previous_corner(face_of_[c], c); }
  std::string name(Index f) const { return names_(faces_[f].origin); }

  void check_positions() const
  {
    const auto differ = [this](Index c, Index d) { return corner_[c].point != corner_[d].point; };
    const Index* first = nullptr; // of two consecutive corners
    for (Index v = 0; v < table_.numbers().size(); ++v) {
      const Index* const c = std::adjacent_find(corners_at(v).begin(), corners_at(v).end(), differ);
      if (c != corners_at(v).end() && (!first || number(v) < corner_[*first].vertex))
        first = c;
    }
    if (first)
      throw Invalid_input("vertex " + std::to_string(corner_[*first].vertex) + " has two positions, in " +
                          name(face_of_[first[0]]) + " and in " + name(face_of_[first[1]]));
  }

  [[noreturn]] void throw_two_faces() const
  {
    typedef std::tuple<std::uint64_t, std::uint64_t, Index> Side; // the numbers of the ends, and the face
    std::vector<Side> sides;
    for (Index c = 0; c < vertex_of_.size(); ++c)
      sides.emplace_back(corner_[c].vertex, number(next_vertex(c)), face_of_[c]);
    std::sort(sides.begin(), sides.end());
    const auto first = std::adjacent_find(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
      return std::get<0>(a) == std::get<0>(b) && std::get<1>(a) == std::get<1>(b);
    });
    const auto [source, target, f] = first[0];
    const Index g = std::get<2>(first[1]);
    const Number_range a = mesh_.corners(f), b = mesh_.corners(g);
    if (std::equal(a.begin(), a.end(), b.begin(), b.end(), [this](Index c, Index d) { return vertex_of_[c] == vertex_of_[d]; }))
      throw Invalid_input(name(f) + " is " + name(g) + ", too");
    throw Invalid_input("the edge from vertex " + std::to_string(source) + " to vertex " + std::to_string(target) +
                        " has two faces on the same side, " + name(f) + " and " + name(g) +
                        ": their orientations differ, or the edge has more than two faces");
  }

  // The corners of a fan form one vertex. An open fan is visited from its clockwise end, a closed fan from any face. Around a
  // vertex of an own face, all faces must be present.
  void divide_into_fans()
  {
    mesh_.corner_vertex.assign(vertex_of_.size(), NONE);
    Index faulty = NONE; // the vertex of smallest number
    for (Index v = 0; v < table_.numbers().size(); ++v) {
      const std::size_t first = patch_.number.size();
      for (const bool are_closed : {false, true})
        for (const Index x : corners_at(v)) {
          if (mesh_.corner_vertex[x] != NONE || (!are_closed && mesh_.face_across[x] != NONE))
            continue;
          for (Index c = x; c != NONE && mesh_.corner_vertex[c] == NONE; c = next_in_fan(c))
            mesh_.corner_vertex[c] = Index(patch_.number.size());
          patch_.number.push_back(number(v));
          mesh_.points.push_back(corner_[x].point);
        }
      const auto is_own = [this](Index c) { return patch_.is_own(face_of_[c]); };
      if (patch_.number.size() > first + 1 && (faulty == NONE || number(v) < number(faulty)) &&
          std::any_of(corners_at(v).begin(), corners_at(v).end(), is_own))
        faulty = v;
    }
    if (faulty != NONE)
      throw Invalid_input("vertex " + std::to_string(number(faulty)) +
                          " is not a manifold vertex: the faces around it form more than one fan");
  }

  // Returns the corner of the same vertex in the next face, counterclockwise, or NONE.
  Index next_in_fan(Index c) const
  {
    const Index f = mesh_.face_across[previous_corner(c)];
    const auto begin = vertex_of_.begin();
    return f == NONE ? NONE : Index(std::find(begin + mesh_.first_corner[f], vertex_of_.end(), vertex_of_[c]) - begin);
  }

  Patch& patch_;
  std::vector<Face_data>& faces_;
  std::vector<Face_corner> corner_; // of all faces
  Flat_mesh& mesh_;
  const Face_names& names_;
  const std::size_t max_corners_;
  Number_table table_;                               // of the vertex numbers
  std::vector<Index> face_of_;                       // of each corner
  std::vector<Index> vertex_of_;                     // of each corner, by number; fans are not distinguished
  std::optional<Bucketed_items<Index> > corners_at_; // of each vertex number
};

// Moves the faces of an own bin into a patch.
inline Patch take_patch(Record_bins& bins, std::size_t i, const Rank_context& context)
{
  Patch patch;
  Patch_builder builder(patch, context.face_names);
  builder.reserve_triangles(bins.number_of_words(i) / words_of_triangle);
  bins.read<Face_record>(i, [&](const Face_record& face) { builder.add(face); });
  bins.clear(i);
  builder.run(context);
  return patch;
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_PATCH_H
