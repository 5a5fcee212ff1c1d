// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_PATCH_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_PATCH_H

#include <CGAL/Surface_mesh_coarsening/internal/distributed/Face_set.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Word_store.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/complete_mesh.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Flat_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Returns the name of a face, given by its number in the sequence of all pieces, for messages.
typedef std::function<std::string(std::uint64_t)> Face_names;

// The faces of a group, its own, and all faces that share vertices with them, as a mesh. The stars of the vertices of its own
// faces are complete. Edges of other faces that lie farther away look like a border, and vertices there are divided where the faces
// around them form several fans. The faces are in the global order, so each star begins with the same face as in the whole mesh.
struct Patch
{
  Face_set faces;                     // their corners are in the mesh
  Flat_mesh mesh;
  std::vector<std::uint64_t> number;  // the global number of each vertex of the mesh
  std::vector<char> is_inner;         // of each vertex of the mesh: whether all faces there are own faces

  bool is_own(std::size_t f) const { return faces.is_own[f] != 0; }

  // Returns a face; its corners come from a mesh that may have been moved elsewhere.
  void get(Index f, const Flat_mesh& corners, Face_record& face) const
  {
    face.is_own = is_own(f);
    face.place = faces.place[f];
    face.density = faces.density[f];
    face.cluster = faces.cluster[f];
    face.origin = faces.origin[f];
    face.vertex.clear();
    face.point.clear();
    for (const Index c : corners.corners(f)) {
      face.vertex.push_back(number[corners.corner_vertex[c]]);
      face.point.push_back(corners.points[corners.corner_vertex[c]]);
    }
  }
};

// Makes the mesh of a patch whose faces have come in any order. Throws where the faces of the patch, or of several pieces,
// contradict each other.
class Patch_builder
{
public:
  Patch_builder(Patch& patch, const Face_names& names)
    : patch_(patch), faces_(patch.faces), mesh_(patch.mesh), names_(names)
  {}

  void run(const Cancellation_point& cancellation)
  {
    sort_faces();
    check_size();
    check_positions();
    mesh_ = Flat_mesh();
    mesh_.first_corner.assign(1, 0);
    for (std::size_t f = 0; f < faces_.size(); ++f)
      mesh_.first_corner.push_back(Index(faces_.first_corner[f + 1]));
    pair_edges();
    number_vertices();
    faces_.vertex = std::vector<std::uint64_t>();
    faces_.point = std::vector<Vector>();
    complete_topology(mesh_, patch_.number.size(), cancellation, Execution::SEQUENTIAL);
    find_inner_vertices();
  }

private:
  struct Side
  {
    std::uint64_t source, target;
    Index face, corner;

    bool operator<(const Side& s) const
    {
      return std::tie(source, target, face) < std::tie(s.source, s.target, s.face);
    }
  };

  void sort_faces()
  {
    std::vector<Index> order(faces_.size());
    std::iota(order.begin(), order.end(), Index(0));
    // Faces that come twice are a fault, whose message must not depend on the order in which they have come.
    const auto key = [this](Index f) {
      const std::size_t c = faces_.first_corner[f];
      return std::make_tuple(faces_.place[f], faces_.vertex[c], faces_.vertex[c + 1], faces_.origin[f]);
    };
    std::sort(order.begin(), order.end(), [&](Index a, Index b) { return key(a) < key(b); });
    faces_.reorder(order);
  }

  void check_size() const
  {
    if (faces_.vertex.size() >= NONE / 2)
      throw Invalid_input("a block around " + names_(faces_.origin.front()) + " has " + std::to_string(faces_.vertex.size()) +
                          " face corners, more than the " + std::to_string(NONE / 2 - 1) + " that can be numbered");
  }

  std::vector<Index> corners_by_vertex() const
  {
    std::vector<Index> corners(faces_.vertex.size());
    std::iota(corners.begin(), corners.end(), Index(0));
    std::sort(corners.begin(), corners.end(), [this](Index a, Index b) {
      return std::tie(faces_.vertex[a], a) < std::tie(faces_.vertex[b], b);
    });
    return corners;
  }

  Index face_of_corner(Index c) const
  {
    return Index(std::upper_bound(faces_.first_corner.begin(), faces_.first_corner.end(), std::size_t(c)) -
                 faces_.first_corner.begin() - 1);
  }

  std::string name(Index f) const { return names_(faces_.origin[f]); }

  void check_positions() const
  {
    const std::vector<Index> corners = corners_by_vertex();
    for (std::size_t i = 1; i < corners.size(); ++i) {
      const Index c = corners[i - 1], d = corners[i];
      if (faces_.vertex[c] == faces_.vertex[d] && faces_.point[c] != faces_.point[d])
        throw Invalid_input("vertex " + std::to_string(faces_.vertex[c]) + " has two positions, in " + name(face_of_corner(c)) +
                            " and in " + name(face_of_corner(d)));
    }
  }

  void pair_edges()
  {
    std::vector<Side> sides;
    sides.reserve(faces_.vertex.size());
    for (Index f = 0; f < faces_.size(); ++f)
      for (Index c = mesh_.first_corner[f]; c != mesh_.first_corner[f + 1]; ++c)
        sides.push_back({faces_.vertex[c], faces_.vertex[mesh_.next_corner(f, c)], f, c});
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 1; i < sides.size(); ++i)
      if (sides[i].source == sides[i - 1].source && sides[i].target == sides[i - 1].target)
        throw_two_faces(sides[i - 1], sides[i]);
    mesh_.face_across.assign(sides.size(), NONE);
    corner_across_.assign(sides.size(), NONE);
    for (const Side& side : sides) {
      const Side opposite{side.target, side.source, 0, 0};
      const auto i = std::lower_bound(sides.begin(), sides.end(), opposite);
      if (i != sides.end() && i->source == side.target && i->target == side.source) {
        mesh_.face_across[side.corner] = i->face;
        corner_across_[side.corner] = i->corner;
      }
    }
  }

  bool have_same_vertices(Index f, Index g) const
  {
    return faces_.degree(f) == faces_.degree(g) &&
           std::equal(faces_.vertex.begin() + std::ptrdiff_t(faces_.first_corner[f]),
                      faces_.vertex.begin() + std::ptrdiff_t(faces_.first_corner[f + 1]),
                      faces_.vertex.begin() + std::ptrdiff_t(faces_.first_corner[g]));
  }

  [[noreturn]] void throw_two_faces(const Side& a, const Side& b) const
  {
    if (have_same_vertices(a.face, b.face))
      throw Invalid_input(name(a.face) + " is " + name(b.face) + ", too");
    throw Invalid_input("the edge from vertex " + std::to_string(a.source) + " to vertex " + std::to_string(a.target) +
                        " has two faces on the same side, " + name(a.face) + " and " + name(b.face) +
                        ": their orientations differ, or the edge has more than two faces");
  }

  // The corners of a fan are one vertex.
  void number_vertices()
  {
    parent_.resize(faces_.vertex.size());
    std::iota(parent_.begin(), parent_.end(), Index(0));
    for (Index f = 0; f < faces_.size(); ++f)
      for (Index c = mesh_.first_corner[f]; c != mesh_.first_corner[f + 1]; ++c)
        if (mesh_.face_across[c] != NONE) {
          const Index d = corner_across_[c];
          join(mesh_.next_corner(f, c), d);
          join(c, mesh_.next_corner(mesh_.face_across[c], d));
        }
    mesh_.corner_vertex.assign(parent_.size(), NONE);
    const std::vector<Index> corners = corners_by_vertex();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Index c = corners[i], root = find(c);
      if (mesh_.corner_vertex[root] == NONE)
        add_vertex(c, root);
      mesh_.corner_vertex[c] = mesh_.corner_vertex[root];
    }
    check_fans(corners);
    corner_across_ = parent_ = std::vector<Index>();
  }

  void add_vertex(Index c, Index root)
  {
    mesh_.corner_vertex[root] = Index(patch_.number.size());
    patch_.number.push_back(faces_.vertex[c]);
    mesh_.points.push_back(faces_.point[c]);
  }

  // Where an own face has a vertex, the faces around it are all there.
  void check_fans(const std::vector<Index>& corners) const
  {
    for (std::size_t begin = 0, end; begin < corners.size(); begin = end) {
      bool has_own = false, has_fans = false;
      for (end = begin; end < corners.size() && faces_.vertex[corners[end]] == faces_.vertex[corners[begin]]; ++end) {
        has_own = has_own || patch_.is_own(face_of_corner(corners[end]));
        has_fans = has_fans || mesh_.corner_vertex[corners[end]] != mesh_.corner_vertex[corners[begin]];
      }
      if (has_own && has_fans)
        throw Invalid_input("vertex " + std::to_string(faces_.vertex[corners[begin]]) +
                            " is not a manifold vertex: the faces around it form more than one fan");
    }
  }

  void find_inner_vertices()
  {
    patch_.is_inner.assign(patch_.number.size(), true);
    for (Index f = 0; f < faces_.size(); ++f)
      if (!patch_.is_own(f))
        for (Index c = mesh_.first_corner[f]; c != mesh_.first_corner[f + 1]; ++c)
          patch_.is_inner[mesh_.corner_vertex[c]] = false;
  }

  Index find(Index c)
  {
    while (parent_[c] != c)
      c = parent_[c] = parent_[parent_[c]];
    return c;
  }

  void join(Index c, Index d)
  {
    const Index a = find(c), b = find(d);
    parent_[(std::max)(a, b)] = (std::min)(a, b);
  }

  Patch& patch_;
  Face_set& faces_;
  Flat_mesh& mesh_;
  const Face_names& names_;
  std::vector<Index> corner_across_; // of each corner: the corner that the edge after it begins at, seen from its other face
  std::vector<Index> parent_;
};

// Makes the patch of a bin of face records.
inline Patch read_patch(const Word_store& store, std::size_t bin, const Face_names& names, const Cancellation_point& cancellation)
{
  Patch patch;
  Face_record face;
  store.read(bin, [&](const std::uint64_t* word, const std::uint64_t* end) {
    while (word != end) {
      word = face.read(word);
      patch.faces.append(face);
    }
  });
  Patch_builder(patch, names).run(cancellation);
  return patch;
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_PATCH_H
