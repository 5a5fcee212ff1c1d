// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_WORD_STORE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_WORD_STORE_H

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Records as they lie in memory, one after the other.
typedef std::vector<std::uint64_t> Words;

// Appends records of a fixed size.
template <class Record>
void write_records(const Record* records, std::size_t number, Words& words)
{
  static_assert(std::is_trivially_copyable<Record>::value && sizeof(Record) % sizeof(std::uint64_t) == 0);
  const std::size_t size = words.size();
  words.resize(size + number * sizeof(Record) / sizeof(std::uint64_t));
  std::memcpy(words.data() + size, records, number * sizeof(Record));
}

// Reads the records that begin at `word`, and returns their end.
template <class Record>
const std::uint64_t* read_records(const std::uint64_t* word, Record* records, std::size_t number)
{
  std::memcpy(static_cast<void*>(records), word, number * sizeof(Record));
  return word + number * sizeof(Record) / sizeof(std::uint64_t);
}

// The same for one record. Records with lists have overloads of these two functions.
template <class Record>
void write_record(const Record& record, Words& words)
{
  write_records(&record, 1, words);
}
template <class Record>
const std::uint64_t* read_record(const std::uint64_t* word, Record& record)
{
  return read_records(word, &record, 1);
}

// The limit on the words that a rank keeps in memory, and the file for the words that exceed it.
//
// The name of the file is removed as soon as the file is open, so the file vanishes when the process ends, also after a crash.
// Systems that cannot remove open files remove it when it is closed.
class Scratch_file
{
public:
  // The number of words of a slot; a larger chunk occupies several slots.
  static constexpr std::size_t slot_words = std::size_t(1) << 13;

  Scratch_file() = default;
  Scratch_file(const Scratch_file&) = delete;
  Scratch_file& operator=(const Scratch_file&) = delete;
  ~Scratch_file()
  {
    if (file_.is_open()) {
      file_.close();
      std::remove(name_.c_str());
    }
  }

  // Opens the file at the beginning, so that an unusable directory is reported before any work is done.
  void limit_memory(std::string directory, std::uint64_t max_words)
  {
    directory_ = std::move(directory);
    max_words_ = max_words;
    if (!directory_.empty())
      open();
  }

  // Reserves memory for this many words, unless the limit would be exceeded.
  bool reserve(std::size_t words)
  {
    if (!directory_.empty() && words_ + words > max_words_)
      return false;
    words_ += words;
    return true;
  }
  void release_memory(std::size_t words) { words_ -= words; }

  // Writes words and returns the number of their first slot.
  std::uint64_t write(const Words& words)
  {
    const std::uint64_t slot = take_slots(number_of_slots(words.size()));
    errno = 0;
    file_.seekp(position(slot));
    file_.write(reinterpret_cast<const char*>(words.data()), std::streamsize(words.size() * sizeof words[0]));
    file_.flush();
    check("write to");
    bytes_written_ += words.size() * sizeof words[0];
    return slot;
  }

  void read(std::uint64_t slot, std::size_t size, Words& words)
  {
    words.resize(size);
    errno = 0;
    file_.seekg(position(slot));
    file_.read(reinterpret_cast<char*>(words.data()), std::streamsize(size * sizeof words[0]));
    check("read from");
  }

  void release_slots(std::uint64_t slot, std::size_t size)
  {
    for (std::uint64_t i = 0; i < number_of_slots(size); ++i)
      free_slots_.push_back(slot + i);
  }

  std::uint64_t bytes_written() const { return bytes_written_; }

private:
  static std::uint64_t number_of_slots(std::size_t size) { return (size + slot_words - 1) / slot_words; }
  static std::streamoff position(std::uint64_t slot) { return std::streamoff(slot * slot_words * sizeof(std::uint64_t)); }

  std::uint64_t take_slots(std::uint64_t n)
  {
    if (n == 1 && !free_slots_.empty()) {
      const std::uint64_t slot = free_slots_.back();
      free_slots_.pop_back();
      return slot;
    }
    slots_ += n;
    return slots_ - n;
  }

  // Uses the first unused name, because other ranks and other programs may use the same directory.
  void open()
  {
    for (int i = 0;; ++i) {
      name_ = directory_ + "/coarsening_scratch_" + std::to_string(i);
      errno = 0;
      if (std::FILE* const created = std::fopen(name_.c_str(), "wbx")) {
        std::fclose(created);
        break;
      }
      if (errno != EEXIST)
        fail("create");
    }
    file_.rdbuf()->pubsetbuf(nullptr, 0);
    file_.open(name_, std::ios::in | std::ios::out | std::ios::binary);
    std::remove(name_.c_str());
    check("open");
  }

  void check(const char* action)
  {
    if (!file_)
      fail(action);
  }

  [[noreturn]] void fail(const char* action) const
  {
    const std::string reason = errno == 0 ? "" : ": " + std::generic_category().message(errno);
    throw std::runtime_error(std::string("cannot ") + action + " a scratch file in " + directory_ + reason);
  }

  std::string directory_, name_; // without a directory, all words are kept in memory
  std::uint64_t max_words_ = 0, words_ = 0, slots_ = 0, bytes_written_ = 0;
  std::vector<std::uint64_t> free_slots_;
  std::fstream file_;
};

// Bins of records, in memory and, beyond its limit, in a scratch file. Records remain whole.
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

  // Appends one record.
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

  // Calls `receive(record)` for each record of a bin, in the order of appending. The bin must not change during the call.
  template <class Record, class Receive>
  void read(std::size_t bin, const Receive& receive) const
  {
    Record record;
    const auto pass = [&](const Words& words) {
      for (const std::uint64_t* word = words.data(); word != words.data() + words.size();) {
        word = read_record(word, record);
        receive(record);
      }
    };
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
