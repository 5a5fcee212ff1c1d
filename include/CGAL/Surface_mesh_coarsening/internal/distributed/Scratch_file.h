// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_SCRATCH_FILE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_SCRATCH_FILE_H

#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>

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

// Keeps words in memory and, beyond a limit, in a file.
//
// The name of the file is removed as soon as the file is open, so the file vanishes when the process ends, also after a crash.
// Systems that cannot remove open files remove it when it is closed.
class Scratch_file
{
public:
  // The number of words of a slot; a larger chunk occupies several slots.
  static constexpr std::size_t slot_words = std::size_t(1) << 13;

  struct Chunk
  {
    Words words; // empty if they are in the file
    std::uint64_t slot;
    std::size_t size;
  };

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

  // Opens the file at the beginning, so that an unusable directory is reported before any work is done. Uses the first unused
  // name, because other ranks and other programs may use the same directory.
  void limit_memory(std::string directory, std::uint64_t max_words)
  {
    directory_ = std::move(directory);
    max_words_ = max_words;
    if (directory_.empty())
      return;
    std::FILE* created = nullptr;
    for (int i = 0; !created; ++i) {
      name_ = directory_ + "/coarsening_scratch_" + std::to_string(i);
      errno = 0;
      created = std::fopen(name_.c_str(), "wbx");
      check(created || errno == EEXIST, "create");
    }
    std::fclose(created);
    file_.rdbuf()->pubsetbuf(nullptr, 0);
    file_.open(name_, std::ios::in | std::ios::out | std::ios::binary);
    std::remove(name_.c_str());
    check(file_.good(), "open");
  }

  // Stores words, at least one, and clears `words`.
  Chunk store(Words& words)
  {
    Chunk chunk{Words(), 0, words.size()};
    if (directory_.empty() || words_ + words.size() <= max_words_) {
      words_ += words.size();
      chunk.words = std::move(words);
    } else {
      chunk.slot = take_slots(number_of_slots(words.size()));
      errno = 0;
      file_.seekp(position(chunk.slot));
      file_.write(reinterpret_cast<const char*>(words.data()), std::streamsize(words.size() * sizeof words[0]));
      file_.flush();
      check(file_.good(), "write to");
      bytes_written_ += words.size() * sizeof words[0];
    }
    words.clear();
    return chunk;
  }

  // Returns the words of a chunk, which may be in the buffer.
  const Words& read(const Chunk& chunk, Words& buffer)
  {
    if (!chunk.words.empty())
      return chunk.words;
    buffer.resize(chunk.size);
    errno = 0;
    file_.seekg(position(chunk.slot));
    file_.read(reinterpret_cast<char*>(buffer.data()), std::streamsize(chunk.size * sizeof buffer[0]));
    check(file_.good(), "read from");
    return buffer;
  }

  void release(const Chunk& chunk)
  {
    words_ -= chunk.words.size();
    if (chunk.words.empty())
      for (std::uint64_t i = 0; i < number_of_slots(chunk.size); ++i)
        free_slots_.push_back(chunk.slot + i);
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

  void check(bool has_succeeded, const char* action) const
  {
    if (has_succeeded)
      return;
    const std::string reason = errno == 0 ? "" : ": " + std::generic_category().message(errno);
    throw std::runtime_error(std::string("cannot ") + action + " a scratch file in " + directory_ + reason);
  }

  std::string directory_, name_; // without a directory, all words are kept in memory
  std::uint64_t max_words_ = 0, words_ = 0, slots_ = 0, bytes_written_ = 0;
  std::vector<std::uint64_t> free_slots_;
  std::fstream file_;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_SCRATCH_FILE_H
