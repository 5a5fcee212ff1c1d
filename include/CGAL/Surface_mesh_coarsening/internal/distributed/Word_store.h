// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_WORD_STORE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_WORD_STORE_H

#include <CGAL/Surface_mesh_coarsening/internal/distributed/Scratch_file.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Bins of records, in memory and, beyond its limit, in a scratch file. Records are sequences of words that remain whole.
class Word_store
{
public:
  Word_store(std::size_t bins, Scratch_file& scratch) : bins_(bins), scratch_(scratch) {}
  Word_store(const Word_store&) = delete;
  Word_store& operator=(const Word_store&) = delete;
  ~Word_store()
  {
    for (std::size_t i = 0; i < bins_.size(); ++i)
      clear(i);
  }

  std::size_t number_of_bins() const { return bins_.size(); }

  // Appends whole records.
  void append(std::size_t bin, const std::uint64_t* words, std::size_t size)
  {
    Bin& b = bins_[bin];
    if (!b.open.empty() && b.open.size() + size > Scratch_file::slot_words)
      close_chunk(b);
    if (b.open.empty())
      b.open.reserve((std::max)(size, Scratch_file::slot_words));
    b.open.insert(b.open.end(), words, words + size);
  }

  std::size_t number_of_words(std::size_t bin) const
  {
    std::size_t words = bins_[bin].open.size();
    for (const Chunk& chunk : bins_[bin].chunks)
      words += chunk.size;
    return words;
  }

  // Calls `receive(begin, end)` for all records of a bin, some at a time, in the order of appending. The bin must not change
  // during the call.
  template <class Receive>
  void read(std::size_t bin, const Receive& receive) const
  {
    const auto pass = [&](const Words& words) { receive(words.data(), words.data() + words.size()); };
    Words from_file;
    for (const Chunk& chunk : bins_[bin].chunks) {
      if (!chunk.is_in_memory)
        scratch_.read(chunk.slot, chunk.size, from_file);
      pass(chunk.is_in_memory ? chunk.words : from_file);
    }
    pass(bins_[bin].open);
  }

  void clear(std::size_t bin)
  {
    for (const Chunk& chunk : bins_[bin].chunks)
      if (chunk.is_in_memory)
        scratch_.release_memory(chunk.size);
      else
        scratch_.release_slots(chunk.slot, chunk.size);
    bins_[bin] = Bin();
  }

private:
  struct Chunk
  {
    bool is_in_memory;
    Words words; // the words, if the chunk is in memory
    std::uint64_t slot;
    std::size_t size;
  };
  struct Bin
  {
    std::vector<Chunk> chunks;
    Words open; // the last chunk, to which records are appended
  };

  void close_chunk(Bin& b)
  {
    const std::size_t size = b.open.size();
    if (scratch_.reserve(size))
      b.chunks.push_back({true, std::move(b.open), 0, size});
    else
      b.chunks.push_back({false, Words(), scratch_.write(b.open), size});
    b.open.clear();
  }

  std::vector<Bin> bins_;
  Scratch_file& scratch_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_WORD_STORE_H
