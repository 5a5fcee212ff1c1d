// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_CHUNKED_LIST_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_CHUNKED_LIST_H

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// A list in chunks of fixed size. In contrast to a growing vector, it takes no more memory than one chunk beyond its
// elements.
template <class T>
class Chunked_list
{
public:
  static constexpr std::size_t chunk = 1024; // elements contiguous in memory

  std::size_t size() const { return size_; }
  const T& operator[](std::size_t i) const { return chunks_[i / chunk][i % chunk]; }
  T& operator[](std::size_t i) { return chunks_[i / chunk][i % chunk]; }
  // Returns the number of contiguous elements from element `i` on, as if its chunk were full.
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

  // Removes the elements of these numbers, which ascend; the others keep their order.
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
  // Moves the elements from `begin` to `end` down to number `to` < `begin`. Returns their new end.
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
