// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_CHUNKED_LIST_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_CHUNKED_LIST_H

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// A list in chunks of a fixed size. Unlike a vector it takes no more memory than one chunk beyond its elements, also while it
// grows.
template <class T>
class Chunked_list
{
public:
  static constexpr std::size_t chunk = 1024; // elements that follow each other in memory

  std::size_t size() const { return size_; }
  const T& operator[](std::size_t i) const { return chunks_[i / chunk][i % chunk]; }
  T& operator[](std::size_t i) { return chunks_[i / chunk][i % chunk]; }
  // How many elements follow each other in memory from element `i` on, or would if the chunk were full.
  std::size_t number_in_chunk_from(std::size_t i) const { return chunk - i % chunk; }

  void push_back(const T& x)
  {
    if (size_ % chunk == 0) {
      chunks_.emplace_back();
      chunks_.back().reserve(chunk);
    }
    chunks_.back().push_back(x);
    ++size_;
  }

  // Takes the elements of these numbers, in ascending order, out; the others keep their order.
  template <class Numbers>
  void remove(const Numbers& gone)
  {
    if (gone.empty())
      return;
    std::size_t end = gone.front();
    for (std::size_t i = 0; i < gone.size(); ++i)
      end = move_down(gone[i] + 1, i + 1 < gone.size() ? gone[i + 1] : size_, end);
    size_ = end;
    chunks_.resize((size_ + chunk - 1) / chunk);
    if (!chunks_.empty())
      chunks_.back().resize(size_ - (chunks_.size() - 1) * chunk);
  }

private:
  // Moves the elements from `begin` to `end` to where they begin with number `to`, below `begin`. Returns where they end then.
  std::size_t move_down(std::size_t begin, std::size_t end, std::size_t to)
  {
    while (begin != end) {
      const std::size_t n = (std::min)({end - begin, number_in_chunk_from(begin), number_in_chunk_from(to)});
      const T* const first = &(*this)[begin];
      std::copy(first, first + n, &(*this)[to]);
      begin += n;
      to += n;
    }
    return to;
  }

  std::vector<std::vector<T> > chunks_;
  std::size_t size_ = 0;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_CHUNKED_LIST_H
