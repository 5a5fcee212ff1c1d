// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_FACE_RECORD_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_FACE_RECORD_H

#include <CGAL/Surface_mesh_coarsening/internal/mesh/Vector.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Records as they lie in memory, one after the other.
typedef std::vector<std::uint64_t> Words;

// Appends values, which occupy whole words.
template <class T>
void write_values(const T* values, std::size_t number, Words& words)
{
  static_assert(std::is_trivially_copyable<T>::value && sizeof(T) % sizeof(std::uint64_t) == 0);
  const std::size_t size = words.size();
  words.resize(size + number * sizeof(T) / sizeof(std::uint64_t));
  std::memcpy(words.data() + size, values, number * sizeof(T));
}

// Reads the values that begin at `word`, and returns their end.
template <class T>
const std::uint64_t* read_values(const std::uint64_t* word, T* values, std::size_t number)
{
  std::memcpy(static_cast<void*>(values), word, number * sizeof(T));
  return word + number * sizeof(T) / sizeof(std::uint64_t);
}

// A record of a face or a cell: data, with the number of corners, and the corners.
template <class Data, class Corner>
struct Polygon_record : Data
{
  std::vector<Corner> corner;
};

template <class Record>
void write_record(const Record& record, Words& words)
{
  write_values(&record, 1, words);
}
template <class Data, class Corner>
void write_record(const Polygon_record<Data, Corner>& record, Words& words)
{
  Data data = record;
  data.corners = Index(record.corner.size()) & Data::max_corners;
  write_values(&data, 1, words);
  write_values(record.corner.data(), record.corner.size(), words);
}

template <class Record>
const std::uint64_t* read_record(const std::uint64_t* word, Record& record)
{
  return read_values(word, &record, 1);
}
template <class Data, class Corner>
const std::uint64_t* read_record(const std::uint64_t* word, Polygon_record<Data, Corner>& record)
{
  word = read_values(word, static_cast<Data*>(&record), 1);
  record.corner.resize(record.corners);
  return read_values(word, record.corner.data(), record.corner.size());
}

// The position of a point on the Morton curve, whose binary digits are the digits of the three coordinates in turn.
class Morton_curve
{
public:
  static constexpr int bits = 20; // of each coordinate

  // For points of a box.
  Morton_curve(const Vector& low, const Vector& high) : low_(low)
  {
    double extent = 0;
    for (std::size_t i = 0; i < 3; ++i)
      extent = (std::max)(extent, high[i] - low[i]);
    scale_ = extent > 0 ? double(std::uint64_t(1) << bits) / extent : 0;
  }

  std::uint64_t operator()(const Vector& p) const
  {
    std::uint64_t place = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      constexpr double last = double((std::uint64_t(1) << bits) - 1);
      const std::uint64_t x = std::uint64_t((std::min)((std::max)(scale_ * (p[i] - low_[i]), 0.), last));
      place |= spread(x) << i;
    }
    return place;
  }

private:
  // Moves bit b to 3 b, by halves, quarters and so on.
  static std::uint64_t spread(std::uint64_t x)
  {
    x = (x | x << 32) & 0x1f00000000ffff;
    x = (x | x << 16) & 0x1f0000ff0000ff;
    x = (x | x << 8) & 0x100f00f00f00f00f;
    x = (x | x << 4) & 0x10c30c30c30c30c3;
    return (x | x << 2) & 0x1249249249249249;
  }

  Vector low_;
  double scale_;
};

// Divides the curve into blocks of at most `max_faces` faces, unless more faces have the same position. Returns the first
// position of each block. Cubes of an octree with few enough faces are joined in order as long as they fit into a block.
// `places` has the positions of the faces of this rank; `sum(own)` returns the sums of numbers over all ranks.
template <class Sum>
std::vector<std::uint64_t> block_starts(std::vector<std::uint64_t> places, std::size_t max_faces, const Sum& sum)
{
  std::sort(places.begin(), places.end());
  struct Cube
  {
    std::uint64_t first, faces;
  };
  std::vector<Cube> leaves, open(1, {0, (std::numeric_limits<std::uint64_t>::max)()});
  for (int level = Morton_curve::bits; level > 0 && !open.empty(); --level) {
    const std::uint64_t side = std::uint64_t(1) << (3 * (level - 1)); // the number of positions in a child
    std::vector<std::uint64_t> own;
    for (const Cube& cube : open)
      for (std::uint64_t child = 0; child < 8; ++child) {
        const std::uint64_t first = cube.first + child * side;
        own.push_back(std::uint64_t(std::lower_bound(places.begin(), places.end(), first + side) -
                                    std::lower_bound(places.begin(), places.end(), first)));
      }
    const std::vector<std::uint64_t> all = sum(own);
    std::vector<Cube> divided;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Cube child{open[i / 8].first + i % 8 * side, all[i]};
      if (child.faces > max_faces && level > 1)
        divided.push_back(child);
      else if (child.faces > 0)
        leaves.push_back(child);
    }
    open.swap(divided);
  }
  std::sort(leaves.begin(), leaves.end(), [](const Cube& a, const Cube& b) { return a.first < b.first; });
  std::vector<std::uint64_t> starts;
  std::uint64_t faces = 0;
  for (const Cube& leaf : leaves) {
    if (starts.empty() || faces + leaf.faces > max_faces) {
      starts.push_back(leaf.first);
      faces = 0;
    }
    faces += leaf.faces;
  }
  return starts;
}

// Returns the block of a position on the curve.
inline Index block_of(const std::vector<std::uint64_t>& starts, std::uint64_t place)
{
  return Index(std::upper_bound(starts.begin(), starts.end(), place) - starts.begin() - 1);
}

// Returns the rank of one of `bins` bins, blocks or others: consecutive runs of bins belong to consecutive ranks.
inline std::size_t rank_of_bin(std::size_t bin, std::size_t bins, std::size_t ranks) { return bin * ranks / bins; }

// Assigns consecutive indices to 64-bit numbers, from 0, in the order of their first occurrence. The table uses open addressing;
// the maps of the standard library take several times the memory and the time.
class Number_table
{
public:
  Index index(std::uint64_t number)
  {
    if (2 * numbers_.size() >= slots_.size()) {
      slots_.assign(slots_.empty() ? 64 : 2 * slots_.size(), NONE);
      for (std::size_t i = 0; i < numbers_.size(); ++i)
        slot(numbers_[i]) = Index(i);
    }
    Index& i = slot(number);
    if (i == NONE) {
      i = Index(numbers_.size());
      numbers_.push_back(number);
    }
    return i;
  }

  // The numbers in the order of their indices.
  const std::vector<std::uint64_t>& numbers() const { return numbers_; }

private:
  Index& slot(std::uint64_t number)
  {
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = std::size_t((number * 0x9e3779b97f4a7c15u) >> 32) & mask;
    while (slots_[i] != NONE && numbers_[slots_[i]] != number)
      i = (i + 1) & mask;
    return slots_[i];
  }

  std::vector<Index> slots_;
  std::vector<std::uint64_t> numbers_;
};

// What a record of a face has besides its corners.
struct Face_data
{
  static constexpr Index max_corners = (Index(1) << 30) - 1;

  Index corners : 30, is_own : 1, is_center : 1; // whether it belongs to its group, and whether it represents its cell
  Index cluster = NONE;     // or the cell
  std::uint64_t place = 0;  // the position on the curve
  double density = 1;       // or the deviation, from which the density is computed
  std::uint64_t origin = 0; // the number of the face in the sequence of all pieces

  Face_data() : corners(0), is_own(true), is_center(false) {}
};

// A corner of a face: the global number and the coordinates of its vertex.
struct Face_corner
{
  std::uint64_t vertex;
  Vector point;
};

// A self-contained record of a face. It begins with the corner of smallest number.
//
// Two faces differ in their first two vertices, because an edge has one face on each side. Hence the position on a space-filling
// curve, followed by these two vertices, defines an order of the faces that depends on the mesh alone.
typedef Polygon_record<Face_data, Face_corner> Face_record;

inline void begin_with_smallest_number(Face_record& face)
{
  std::rotate(face.corner.begin(),
              std::min_element(face.corner.begin(), face.corner.end(),
                               [](const Face_corner& a, const Face_corner& b) { return a.vertex < b.vertex; }),
              face.corner.end());
}

template <class Data, class Corner>
Vector mean_of_corners(const Polygon_record<Data, Corner>& face)
{
  Vector sum{{0, 0, 0}};
  for (const Corner& c : face.corner)
    sum = sum + c.point;
  return (1. / double(face.corner.size())) * sum;
}

constexpr std::size_t words_of_triangle = (sizeof(Face_data) + 3 * sizeof(Face_corner)) / sizeof(std::uint64_t);

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_FACE_RECORD_H
