// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_FACE_SET_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_FACE_SET_H

#include <CGAL/Surface_mesh_coarsening/internal/base/Index.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Words.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// A self-contained record of a face, with the global numbers and the coordinates of its vertices. It begins with the smallest
// number.
//
// Two faces differ in their first two vertices, because an edge has one face on each side. Hence the position on a space-filling
// curve, followed by these two vertices, defines an order of the faces that depends on the mesh alone.
struct Face_record
{
  bool is_own = true;      // whether it belongs to its group; otherwise it is a neighbor
  bool is_center = false;  // whether it represents its cell
  std::uint64_t place = 0; // the position on the curve
  double density = 1;      // or the deviation, from which the density is computed
  Index cluster = NONE;    // or the cell
  std::uint64_t origin = 0; // the number of the face in the sequence of all pieces
  std::vector<std::uint64_t> vertex;
  std::vector<Vector> point;

  void begin_with_smallest_number()
  {
    const auto shift = std::min_element(vertex.begin(), vertex.end()) - vertex.begin();
    std::rotate(vertex.begin(), vertex.begin() + shift, vertex.end());
    std::rotate(point.begin(), point.begin() + shift, point.end());
  }

  Vector mean_of_corners() const
  {
    Vector sum{{0, 0, 0}};
    for (const Vector& p : point)
      sum = sum + p;
    return (1. / double(point.size())) * sum;
  }

  static constexpr Index own_bit = Index(1) << 31, center_bit = Index(1) << 30, max_corners = center_bit - 1;
  static constexpr std::size_t words_of_face = 4, words_of_corner = 4;
  static constexpr std::size_t words_of_triangle = words_of_face + 3 * words_of_corner;

  void write(Words& words) const
  {
    words.resize(words_of_face + words_of_corner * vertex.size());
    std::uint64_t* word = words.data();
    *word++ = packed(Index(vertex.size()) | (is_own ? own_bit : 0) | (is_center ? center_bit : 0), cluster);
    *word++ = place;
    *word++ = to_word(density);
    *word++ = origin;
    for (std::size_t i = 0; i < vertex.size(); ++i) {
      *word++ = vertex[i];
      for (const double x : point[i])
        *word++ = to_word(x);
    }
  }

  // Reads the face that begins at `word`, and returns the end of its record.
  const std::uint64_t* read(const std::uint64_t* word)
  {
    is_own = (high_half(*word) & own_bit) != 0;
    is_center = (high_half(*word) & center_bit) != 0;
    const std::size_t corners = high_half(*word) & max_corners;
    cluster = low_half(*word++);
    place = *word++;
    density = to_double(*word++);
    origin = *word++;
    vertex.resize(corners);
    point.resize(corners);
    for (std::size_t i = 0; i < corners; ++i, word += words_of_corner) {
      vertex[i] = word[0];
      point[i] = {{to_double(word[1]), to_double(word[2]), to_double(word[3])}};
    }
    return word;
  }
};

// Faces in arrays.
struct Face_set
{
  // Of each face:
  std::vector<char> is_own, is_center;
  std::vector<std::uint64_t> place;
  std::vector<double> density;
  std::vector<Index> cluster;
  std::vector<std::uint64_t> origin;
  std::vector<std::size_t> first_corner = std::vector<std::size_t>(1, 0);
  // Of each corner:
  std::vector<std::uint64_t> vertex;
  std::vector<Vector> point;

  std::size_t size() const { return place.size(); }
  std::size_t degree(std::size_t f) const { return first_corner[f + 1] - first_corner[f]; }

  // Reserves memory for triangles.
  void reserve(std::size_t triangles)
  {
    is_own.reserve(triangles);
    is_center.reserve(triangles);
    place.reserve(triangles);
    density.reserve(triangles);
    cluster.reserve(triangles);
    origin.reserve(triangles);
    first_corner.reserve(triangles + 1);
    vertex.reserve(3 * triangles);
    point.reserve(3 * triangles);
  }

  void append(const Face_record& face)
  {
    is_own.push_back(face.is_own);
    is_center.push_back(face.is_center);
    place.push_back(face.place);
    density.push_back(face.density);
    cluster.push_back(face.cluster);
    origin.push_back(face.origin);
    vertex.insert(vertex.end(), face.vertex.begin(), face.vertex.end());
    point.insert(point.end(), face.point.begin(), face.point.end());
    first_corner.push_back(vertex.size());
  }

  // Reorders the faces one array after the other, which takes less memory than a second set.
  void reorder(const std::vector<Index>& order)
  {
    std::vector<std::size_t> first(1, 0);
    for (const Index f : order)
      first.push_back(first.back() + degree(f));
    reorder_corners(order, vertex);
    reorder_corners(order, point);
    first_corner.swap(first);
    reorder(order, is_own);
    reorder(order, is_center);
    reorder(order, place);
    reorder(order, density);
    reorder(order, cluster);
    reorder(order, origin);
  }

private:
  template <class T>
  static void reorder(const std::vector<Index>& order, std::vector<T>& values)
  {
    std::vector<T> reordered;
    reordered.reserve(values.size());
    for (const Index f : order)
      reordered.push_back(values[f]);
    values.swap(reordered);
  }

  template <class T>
  void reorder_corners(const std::vector<Index>& order, std::vector<T>& values) const
  {
    std::vector<T> reordered;
    reordered.reserve(values.size());
    for (const Index f : order)
      for (std::size_t c = first_corner[f]; c != first_corner[f + 1]; ++c)
        reordered.push_back(values[c]);
    values.swap(reordered);
  }
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_FACE_SET_H
