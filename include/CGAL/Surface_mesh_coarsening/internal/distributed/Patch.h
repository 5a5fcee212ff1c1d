// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_PATCH_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_PATCH_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Face_set.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Record_bins.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/complete_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// A mesh of the faces of a group, the own faces, and of all faces that share a vertex with them. The stars of the vertices of
// own faces are complete. The other faces have edges that seem to lie on a border, and their vertices are split where the faces
// around them form several fans. The faces are in the global order, so each star begins with the same face as in the whole mesh.
struct Patch
{
  Face_set faces;                     // their corners are in the mesh
  Flat_mesh mesh;
  std::vector<std::uint64_t> number;  // the global number of each vertex of the mesh
  std::vector<char> is_inner;         // for each vertex of the mesh, whether all incident faces are own faces

  bool is_own(std::size_t f) const { return faces[f].is_own; }
  // Whether all vertices of a face are inner, in the mesh of the patch, which may have been moved.
  bool is_inner_face(const Flat_mesh& m, Index f) const
  {
    const Number_range corners = m.corners(f);
    return std::all_of(corners.begin(), corners.end(), [&](Index c) { return is_inner[m.corner_vertex[c]]; });
  }

  // Returns a face, likewise.
  void get(const Flat_mesh& m, Index f, Face_record& face) const
  {
    static_cast<Face_data&>(face) = faces[f];
    face.corner.clear();
    for (const Index c : m.corners(f))
      face.corner.push_back({number[m.corner_vertex[c]], m.points[m.corner_vertex[c]]});
  }
};

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
    : patch_(patch), faces_(patch.faces), mesh_(patch.mesh), names_(names), max_corners_(max_corners)
  {}

  void run(const Run_context& context)
  {
    sort_faces();
    check_size();
    list_corners();
    check_positions();
    const auto previous_vertex = [this](Index c) { return vertex_of_[previous_corner(c)]; };
    if (!pair_edges(mesh_, face_of_, *corners_at_, previous_vertex, [this](Index c) { return next_vertex(c); }))
      throw_two_faces();
    number_vertices();
    check_fans();
    faces_.corner = std::vector<Face_corner>();
    complete_stars(mesh_, patch_.number.size(), context);
    find_inner_vertices();
  }

private:
  void sort_faces()
  {
    struct Key
    {
      std::uint64_t place;
      Index face;
    };
    std::vector<Key> keys;
    keys.reserve(faces_.size());
    for (Index f = 0; f < faces_.size(); ++f)
      keys.push_back({faces_[f].place, f});
    // Duplicate faces are a fault; the message must not depend on the order in which they arrived.
    const auto rest = [this](Index f) {
      const Face_corner* const c = faces_.corners(f).begin();
      return std::make_tuple(c[0].vertex, c[1].vertex, faces_[f].origin);
    };
    sort_runs(keys, [&](const Key& a, const Key& b) {
      return a.place != b.place ? a.place < b.place : rest(a.face) < rest(b.face);
    });
    std::vector<Index> order;
    order.reserve(keys.size());
    for (const Key& key : keys)
      order.push_back(key.face);
    keys = std::vector<Key>();
    faces_.reorder(order);
  }

  void check_size() const
  {
    if (faces_.corner.size() > max_corners_)
      throw Invalid_input("a block around " + name(0) + " has " + std::to_string(faces_.corner.size()) +
                          " face corners, more than the " + std::to_string(max_corners_) + " that can be numbered");
  }

  // Lists the corners at each vertex number, in order.
  void list_corners()
  {
    mesh_ = Flat_mesh();
    mesh_.first_corner.push_back(0);
    const Index corners = Index(faces_.corner.size());
    face_of_.reserve(corners);
    vertex_of_.reserve(corners);
    for (Index f = 0; f < faces_.size(); ++f) {
      mesh_.first_corner.push_back(Index(faces_.first_corner[f + 1]));
      face_of_.resize(faces_.first_corner[f + 1], f);
    }
    for (const Face_corner& c : faces_.corner)
      vertex_of_.push_back(table_.index(c.vertex));
    corners_at_.emplace(numbers_below(corners), table_.numbers().size(), [this](Index c) { return vertex_of_[c]; });
  }

  Number_range vertices() const { return numbers_below(Index(table_.numbers().size())); }
  std::uint64_t number(Index v) const { return table_.numbers()[v]; }
  Bucketed_items<Index>::Range corners_at(Index v) const { return (*corners_at_)[v]; }
  Index next_vertex(Index c) const { return vertex_of_[mesh_.next_corner(face_of_[c], c)]; }
  Index previous_corner(Index c) const { return mesh_.previous_corner(face_of_[c], c); }
  std::string name(Index f) const { return names_(faces_[f].origin); }

  // Returns the vertex of smallest number for which `is_faulty(v)`, or NONE.
  template <class Predicate>
  Index first_faulty(const Predicate& is_faulty) const
  {
    Index first = NONE;
    for (const Index v : vertices())
      if ((first == NONE || number(v) < number(first)) && is_faulty(v))
        first = v;
    return first;
  }

  // Returns the first corner at a vertex whose position differs from the position of the next corner, or the end.
  const Index* other_position(Index v) const
  {
    return std::adjacent_find(corners_at(v).begin(), corners_at(v).end(),
                              [this](Index c, Index d) { return faces_.corner[c].point != faces_.corner[d].point; });
  }

  void check_positions() const
  {
    const Index v = first_faulty([this](Index w) { return other_position(w) != corners_at(w).end(); });
    if (v == NONE)
      return;
    const Index* const first = other_position(v);
    throw Invalid_input("vertex " + std::to_string(number(v)) + " has two positions, in " + name(face_of_[first[0]]) +
                        " and in " + name(face_of_[first[1]]));
  }

  [[noreturn]] void throw_two_faces() const
  {
    typedef std::tuple<std::uint64_t, std::uint64_t, Index> Side; // the numbers of the ends, and the face
    std::vector<Side> sides;
    for (Index c = 0; c < vertex_of_.size(); ++c)
      sides.emplace_back(faces_.corner[c].vertex, number(next_vertex(c)), face_of_[c]);
    std::sort(sides.begin(), sides.end());
    std::size_t i = 1;
    while (std::get<0>(sides[i]) != std::get<0>(sides[i - 1]) || std::get<1>(sides[i]) != std::get<1>(sides[i - 1]))
      ++i;
    const auto [source, target, f] = sides[i - 1];
    const Index g = std::get<2>(sides[i]);
    if (have_same_vertices(f, g))
      throw Invalid_input(name(f) + " is " + name(g) + ", too");
    throw Invalid_input("the edge from vertex " + std::to_string(source) + " to vertex " + std::to_string(target) +
                        " has two faces on the same side, " + name(f) + " and " + name(g) +
                        ": their orientations differ, or the edge has more than two faces");
  }

  bool have_same_vertices(Index f, Index g) const
  {
    return std::equal(faces_.corners(f).begin(), faces_.corners(f).end(), faces_.corners(g).begin(), faces_.corners(g).end(),
                      [](const Face_corner& a, const Face_corner& b) { return a.vertex == b.vertex; });
  }

  // The corners of a fan form one vertex. Visits each fan from its clockwise end; a closed fan, from any face.
  void number_vertices()
  {
    mesh_.corner_vertex.assign(vertex_of_.size(), NONE);
    for (const Index v : vertices())
      for (const Index x : corners_at(v)) {
        if (mesh_.corner_vertex[x] != NONE)
          continue;
        const Index vertex = Index(patch_.number.size()), begin = first_of_fan(x);
        patch_.number.push_back(number(v));
        mesh_.points.push_back(faces_.corner[begin].point);
        for (Index c = begin; c != NONE && mesh_.corner_vertex[c] == NONE; c = next_in_fan(c))
          mesh_.corner_vertex[c] = vertex;
      }
  }

  // Returns the corner of the same vertex in the next face, counterclockwise or clockwise, or NONE.
  Index next_in_fan(Index c) const { return corner_of(mesh_.face_across[previous_corner(c)], vertex_of_[c]); }
  Index previous_in_fan(Index c) const { return corner_of(mesh_.face_across[c], vertex_of_[c]); }
  Index corner_of(Index f, Index v) const
  {
    const auto begin = vertex_of_.begin();
    return f == NONE ? NONE : Index(std::find(begin + mesh_.first_corner[f], vertex_of_.end(), v) - begin);
  }
  Index first_of_fan(Index c) const
  {
    Index first = c;
    for (Index d = previous_in_fan(c); d != NONE && d != c; d = previous_in_fan(d))
      first = d;
    return first;
  }

  // Around a vertex of an own face, all faces must be present.
  void check_fans() const
  {
    const Index v = first_faulty([this](Index w) {
      bool has_own = false, has_fans = false;
      for (const Index c : corners_at(w)) {
        has_own = has_own || patch_.is_own(face_of_[c]);
        has_fans = has_fans || mesh_.corner_vertex[c] != mesh_.corner_vertex[*corners_at(w).begin()];
      }
      return has_own && has_fans;
    });
    if (v != NONE)
      throw Invalid_input("vertex " + std::to_string(number(v)) +
                          " is not a manifold vertex: the faces around it form more than one fan");
  }

  void find_inner_vertices()
  {
    patch_.is_inner.assign(patch_.number.size(), true);
    for (Index f = 0; f < faces_.size(); ++f)
      if (!patch_.is_own(f))
        for (const Index c : mesh_.corners(f))
          patch_.is_inner[mesh_.corner_vertex[c]] = false;
  }

  Patch& patch_;
  Face_set& faces_;
  Flat_mesh& mesh_;
  const Face_names& names_;
  const std::size_t max_corners_;
  Number_table table_;             // of the vertex numbers
  std::vector<Index> face_of_;     // of each corner
  std::vector<Index> vertex_of_;   // of each corner, by number; fans are not distinguished
  std::optional<Bucketed_items<Index> > corners_at_; // of each vertex number
};

// Moves the faces of an own bin into a patch.
inline Patch take_patch(Record_bins& bins, std::size_t i, const Rank_context& context)
{
  Patch patch;
  patch.faces.reserve_triangles(bins.number_of_words(i) / words_of_triangle);
  bins.read<Face_record>(i, [&](const Face_record& face) { patch.faces.append(face); });
  bins.clear(i);
  Patch_builder(patch, context.face_names).run(context);
  return patch;
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_PATCH_H
