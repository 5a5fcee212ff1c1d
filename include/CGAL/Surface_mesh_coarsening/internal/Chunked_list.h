// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_CHUNKED_LIST_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_CHUNKED_LIST_H

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

  // Takes the elements out of whose numbers `is_gone` holds; the others keep their order. An element is asked for before it, or
  // one after it, is moved.
  template <class Predicate>
  void remove_if(const Predicate& is_gone)
  {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      if (is_gone(i))
        continue;
      if (kept != i)
        (*this)[kept] = (*this)[i];
      ++kept;
    }
    size_ = kept;
    chunks_.resize((size_ + chunk - 1) / chunk);
    if (!chunks_.empty())
      chunks_.back().resize(size_ - (chunks_.size() - 1) * chunk);
  }

private:
  std::vector<std::vector<T> > chunks_;
  std::size_t size_ = 0;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_CHUNKED_LIST_H
