// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_WORD_ROUTING_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_WORD_ROUTING_H

#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/Run_context.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Face_set.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Word_store.h>

#include <boost/mpi/collectives.hpp>
#include <boost/mpi/communicator.hpp>
#include <boost/mpi/nonblocking.hpp>
#include <boost/mpi/request.hpp>
#include <boost/serialization/string.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The data that all steps on a rank share: its communicator, its scratch file, and the number of bytes sent.
struct Rank_context : Run_context
{
  const boost::mpi::communicator& communicator;
  Scratch_file scratch;
  std::uint64_t bytes_sent = 0;

  Rank_context(const boost::mpi::communicator& c, const Run_context& run) : Run_context(run), communicator(c) {}

  std::size_t rank() const { return std::size_t(communicator.rank()); }
  std::size_t number_of_ranks() const { return std::size_t(communicator.size()); }
};

// Calls `transfer(bytes, number)` for each part of an array of records, because MPI counts the bytes of a message in an `int`.
template <class Record, class Transfer>
void for_each_message(std::vector<Record>& records, const Transfer& transfer)
{
  static_assert(std::is_trivially_copyable<Record>::value);
  constexpr std::size_t max_bytes = std::size_t(1) << 30;
  char* const bytes = reinterpret_cast<char*>(records.data());
  const std::size_t size = records.size() * sizeof(Record);
  for (std::size_t begin = 0; begin < size; begin += max_bytes)
    transfer(bytes + begin, int((std::min)(max_bytes, size - begin)));
}

// Sends the records `outgoing[r]` to each rank r and returns the records received from each rank. `outgoing` is empty
// afterwards.
template <class Record>
std::vector<std::vector<Record> > exchange(Rank_context& context, std::vector<std::vector<Record> >& outgoing)
{
  const boost::mpi::communicator& communicator = context.communicator;
  const std::size_t ranks = context.number_of_ranks(), own = context.rank();
  std::vector<std::uint64_t> sent, received(ranks);
  for (const std::vector<Record>& records : outgoing)
    sent.push_back(records.size());
  boost::mpi::all_to_all(communicator, sent.data(), 1, received.data());
  std::vector<std::vector<Record> > incoming(ranks);
  std::vector<boost::mpi::request> requests;
  incoming[own].swap(outgoing[own]);
  for (std::size_t rank = 0; rank < ranks; ++rank)
    if (rank != own) {
      incoming[rank].resize(received[rank]);
      for_each_message(incoming[rank], [&](char* bytes, int n) { requests.push_back(communicator.irecv(int(rank), 0, bytes, n)); });
    }
  for (std::size_t rank = 0; rank < ranks; ++rank) {
    context.bytes_sent += outgoing[rank].size() * sizeof(Record);
    for_each_message(outgoing[rank], [&](char* bytes, int n) { requests.push_back(communicator.isend(int(rank), 0, bytes, n)); });
  }
  boost::mpi::wait_all(requests.begin(), requests.end());
  outgoing.clear();
  return incoming;
}

// Sends the records of rank 0 to all ranks.
template <class Record>
void broadcast_records(Rank_context& context, std::vector<Record>& records)
{
  std::uint64_t size = records.size();
  if (context.rank() == 0)
    context.bytes_sent += (context.number_of_ranks() - 1) * size * sizeof(Record);
  boost::mpi::broadcast(context.communicator, size, 0);
  records.resize(size);
  for_each_message(records, [&](char* bytes, int n) { boost::mpi::broadcast(context.communicator, bytes, n, 0); });
}

// An exception that is sent to other ranks.
struct Remote_exception
{
  enum Kind : int { NONE_THROWN, OTHER, INVALID, UNREACHABLE, CANCELLED }; // the last kind has priority
  int kind = NONE_THROWN;
  std::string message;
  std::uint64_t nearest = 0; // the nearest number of vertices, for UNREACHABLE

  template <class Archive>
  void serialize(Archive& archive, unsigned)
  {
    archive & kind & message & nearest;
  }
};

inline Remote_exception caught(const std::function<void()>& work, int rank)
{
  try {
    work();
  } catch (const Coarsening_cancelled&) {
    return {Remote_exception::CANCELLED, "", 0};
  } catch (const Unreachable_number_of_vertices& e) {
    return {Remote_exception::UNREACHABLE, e.what(), e.nearest()};
  } catch (const Invalid_input& e) {
    return {Remote_exception::INVALID, e.what(), 0};
  } catch (const std::exception& e) {
    return {Remote_exception::OTHER, "rank " + std::to_string(rank) + ": " + e.what(), 0};
  }
  return {};
}

[[noreturn]] inline void rethrow(const Remote_exception& e)
{
  if (e.kind == Remote_exception::CANCELLED)
    throw Coarsening_cancelled();
  if (e.kind == Remote_exception::UNREACHABLE)
    throw Unreachable_number_of_vertices(e.message, std::size_t(e.nearest));
  if (e.kind == Remote_exception::INVALID)
    throw Invalid_input(e.message);
  throw std::runtime_error(e.message);
}

// If some ranks have thrown, all ranks throw the same exception. Of several messages, the alphabetically first is selected.
inline void throw_on_all_ranks(const boost::mpi::communicator& communicator, const Remote_exception& own)
{
  if (boost::mpi::all_reduce(communicator, own.kind, boost::mpi::maximum<int>()) == Remote_exception::NONE_THROWN)
    return;
  std::vector<Remote_exception> all;
  boost::mpi::all_gather(communicator, own, all);
  rethrow(*std::min_element(all.begin(), all.end(), [](const Remote_exception& a, const Remote_exception& b) {
    return a.kind != b.kind ? a.kind > b.kind : a.message < b.message;
  }));
}

// Does the work of this rank, which must not wait for other ranks. If it throws on some ranks, all ranks throw the same
// exception.
inline void on_all_ranks(const boost::mpi::communicator& communicator, const std::function<void()>& work)
{
  throw_on_all_ranks(communicator, caught(work, communicator.rank()));
}

// Does work on rank 0. If it throws, all ranks throw the same exception.
inline void on_first_rank(const Rank_context& context, const std::function<void()>& work)
{
  on_all_ranks(context.communicator, [&] {
    if (context.rank() == 0)
      work();
  });
}

// Moves the records of all ranks to rank 0, sorted.
template <class Record>
void gather_sorted(Rank_context& context, std::vector<Record>& records)
{
  std::vector<std::vector<Record> > outgoing(context.number_of_ranks());
  outgoing[0].swap(records);
  const std::vector<std::vector<Record> > incoming = exchange(context, outgoing);
  on_all_ranks(context.communicator, [&] {
    for (const std::vector<Record>& of_rank : incoming)
      records.insert(records.end(), of_rank.begin(), of_rank.end());
    std::sort(records.begin(), records.end());
  });
}

// Does the work of each block of this rank. If several blocks are invalid, the alphabetically first message is selected, so it
// does not depend on the distribution of the blocks.
template <class Work>
void for_each_block(std::size_t blocks, const Work& work)
{
  std::string first;
  for (std::size_t i = 0; i < blocks; ++i)
    try {
      work(i);
    } catch (const Unreachable_number_of_vertices&) {
      throw;
    } catch (const Invalid_input& e) {
      first = first.empty() ? e.what() : (std::min)(first, std::string(e.what()));
    }
  if (!first.empty())
    throw Invalid_input(first);
}

// The ranks of numbered bins.
class Bin_ranks
{
public:
  Bin_ranks(const Rank_context& context, std::size_t bins)
    : bins_(bins), ranks_(context.number_of_ranks()), first_(first_of(context.rank())), end_(first_of(context.rank() + 1))
  {}

  std::size_t number_of_bins() const { return bins_; }
  std::size_t rank_of(std::size_t bin) const { return rank_of_bin(bin, bins_, ranks_); }
  // The bins of this rank.
  std::size_t first() const { return first_; }
  std::size_t number_of_own() const { return end_ - first_; }

private:
  std::size_t first_of(std::size_t rank) const { return (rank * bins_ + ranks_ - 1) / ranks_; }

  std::size_t bins_, ranks_, first_, end_;
};

// Sends records to the bins of all ranks, in rounds of limited size, so no rank must hold all records that it sends or receives.
// Records for the same rank are stored directly.
class Word_routing
{
public:
  // `store` holds the bins of this rank.
  Word_routing(Rank_context& context, const Bin_ranks& bins, Word_store& store)
    : context_(context), bins_(bins), store_(store), outgoing_(context.number_of_ranks())
  {}

  // Calls `produce()`, which calls `send()` and must not wait for other ranks in any other way. If it throws on some ranks, all
  // ranks throw the same exception.
  void run(const std::function<void()>& produce)
  {
    Remote_exception failure = caught(produce, context_.communicator.rank());
    while (!exchange_round(true))
      ;
    if (failure.kind == Remote_exception::NONE_THROWN && failure_of_store_)
      failure = caught([&] { std::rethrow_exception(failure_of_store_); }, context_.communicator.rank());
    throw_on_all_ranks(context_.communicator, failure);
  }

  template <class Record>
  void send(std::size_t bin, const Record& record)
  {
    record_.clear();
    write_record(record, record_);
    if (bins_.rank_of(bin) == context_.rank()) {
      store_.append(bin - bins_.first(), record_.data(), record_.size());
      return;
    }
    Words& words = outgoing_[bins_.rank_of(bin)];
    write_record(Label{Index(bin), Index(record_.size())}, words);
    words.insert(words.end(), record_.begin(), record_.end());
    buffered_ += record_.size() + 1;
    if (buffered_ < max_words_of_round)
      return;
    exchange_round(false);
    if (failure_of_store_)
      std::rethrow_exception(failure_of_store_);
  }

private:
  static constexpr std::size_t max_words_of_round = std::size_t(1) << 18;

  // What precedes a record in a message.
  struct Label
  {
    Index bin, size;
  };

  // Returns whether no rank has more records to send.
  bool exchange_round(bool is_last)
  {
    const int ranks_to_go = boost::mpi::all_reduce(context_.communicator, is_last ? 0 : 1, std::plus<int>());
    std::vector<Words> incoming = exchange(context_, outgoing_);
    outgoing_.resize(incoming.size());
    buffered_ = 0;
    for (std::size_t i = 0; i < incoming.size(); ++i) {
      store(incoming[i]);
      incoming[i] = Words();
    }
    return ranks_to_go == 0;
  }

  // After a failure, rounds continue without storing records, because other ranks wait for them.
  void store(const Words& words)
  {
    if (failure_of_store_)
      return;
    try {
      for (const std::uint64_t* word = words.data(); word != words.data() + words.size();) {
        Label label;
        word = read_record(word, label);
        store_.append(label.bin - bins_.first(), word, label.size);
        word += label.size;
      }
    } catch (...) {
      failure_of_store_ = std::current_exception();
    }
  }

  Rank_context& context_;
  const Bin_ranks& bins_;
  Word_store& store_;
  std::vector<Words> outgoing_;
  Words record_; // the record that is sent
  std::size_t buffered_ = 0;
  std::exception_ptr failure_of_store_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_WORD_ROUTING_H
