// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_WORD_ROUTING_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_WORD_ROUTING_H

#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/Visitor_handle.h>
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
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The data that all steps on a rank share: its communicator, its scratch file, and the number of bytes sent.
struct Rank_context
{
  const boost::mpi::communicator& communicator;
  Cancellation_point cancellation;
  Scratch_file scratch;
  std::uint64_t bytes_sent = 0;

  Rank_context(const boost::mpi::communicator& c, const Cancellation_point& p) : communicator(c), cancellation(p) {}

  std::size_t rank() const { return std::size_t(communicator.rank()); }
  std::size_t number_of_ranks() const { return std::size_t(communicator.size()); }
};

// MPI counts the elements of a message in an `int`.
constexpr std::size_t max_words_of_message = std::size_t(1) << 27;

// Sends the words `outgoing[r]` to each rank r and returns the words received from each rank. `outgoing` is empty
// afterwards.
inline std::vector<Words> exchange(Rank_context& context, std::vector<Words>& outgoing)
{
  const boost::mpi::communicator& communicator = context.communicator;
  const int ranks = communicator.size(), own = communicator.rank();
  std::vector<std::uint64_t> sent, received(outgoing.size());
  for (const Words& words : outgoing)
    sent.push_back(words.size());
  boost::mpi::all_to_all(communicator, sent.data(), 1, received.data());
  std::vector<Words> incoming(outgoing.size());
  std::vector<boost::mpi::request> requests;
  const auto for_each_message = [&](std::vector<Words>& words, int rank, const auto& transfer) {
    Words& all = words[std::size_t(rank)];
    for (std::size_t begin = 0; begin < all.size(); begin += max_words_of_message)
      requests.push_back(transfer(all.data() + begin, int((std::min)(max_words_of_message, all.size() - begin))));
  };
  for (int rank = 0; rank < ranks; ++rank)
    if (rank != own) {
      incoming[std::size_t(rank)].resize(received[std::size_t(rank)]);
      for_each_message(incoming, rank, [&](std::uint64_t* words, int n) { return communicator.irecv(rank, 0, words, n); });
    }
  for (int rank = 0; rank < ranks; ++rank)
    if (rank != own) {
      context.bytes_sent += outgoing[std::size_t(rank)].size() * sizeof(std::uint64_t);
      for_each_message(outgoing, rank, [&](std::uint64_t* words, int n) { return communicator.isend(rank, 0, words, n); });
    }
  boost::mpi::wait_all(requests.begin(), requests.end());
  incoming[std::size_t(own)].swap(outgoing[std::size_t(own)]);
  outgoing.clear();
  return incoming;
}

// Sends words to rank 0, which receives the words of each rank.
inline std::vector<Words> gather_words(Rank_context& context, Words words)
{
  std::vector<Words> outgoing(context.number_of_ranks());
  outgoing[0] = std::move(words);
  return exchange(context, outgoing);
}

// Sends the words of rank 0 to all ranks.
inline void broadcast_words(Rank_context& context, Words& words)
{
  const boost::mpi::communicator& communicator = context.communicator;
  std::uint64_t size = words.size();
  if (context.rank() == 0)
    context.bytes_sent += (context.number_of_ranks() - 1) * size * sizeof(std::uint64_t);
  boost::mpi::broadcast(communicator, size, 0);
  words.resize(size);
  for (std::size_t begin = 0; begin < size; begin += max_words_of_message)
    boost::mpi::broadcast(communicator, words.data() + begin, int((std::min)(max_words_of_message, size - begin)), 0);
}

// An exception that is sent to other ranks.
struct Remote_exception
{
  enum Kind : int { NONE_THROWN, OTHER, INVALID, UNREACHABLE, CANCELLED }; // the last kind has priority
  int kind = NONE_THROWN;
  std::string message;
  std::uint64_t nearest = 0; // the nearest number of vertices, for UNREACHABLE
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
  const int kind = boost::mpi::all_reduce(communicator, own.kind, boost::mpi::maximum<int>());
  if (kind == Remote_exception::NONE_THROWN)
    return;
  std::vector<std::string> messages;
  std::vector<int> kinds;
  std::vector<std::uint64_t> nearest;
  boost::mpi::all_gather(communicator, own.message, messages);
  boost::mpi::all_gather(communicator, own.kind, kinds);
  boost::mpi::all_gather(communicator, own.nearest, nearest);
  std::size_t first = messages.size();
  for (std::size_t i = 0; i < messages.size(); ++i)
    if (kinds[i] == kind && (first == messages.size() || messages[i] < messages[first]))
      first = i;
  rethrow({kind, messages[first], nearest[first]});
}

// Does the work of this rank, which must not wait for other ranks. If it throws on some ranks, all ranks throw the same
// exception.
inline void on_all_ranks(const boost::mpi::communicator& communicator, const std::function<void()>& work)
{
  throw_on_all_ranks(communicator, caught(work, communicator.rank()));
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

  void send(std::size_t bin, const Words& record) { send(bin, record.data(), record.size()); }
  void send(std::size_t bin, const std::uint64_t* record, std::size_t size)
  {
    if (bins_.rank_of(bin) == context_.rank()) {
      store_.append(bin - bins_.first(), record, size);
      return;
    }
    Words& words = outgoing_[bins_.rank_of(bin)];
    words.push_back(packed(Index(bin), Index(size)));
    words.insert(words.end(), record, record + size);
    buffered_ += size + 1;
    if (buffered_ < max_words_of_round)
      return;
    exchange_round(false);
    if (failure_of_store_)
      std::rethrow_exception(failure_of_store_);
  }

private:
  static constexpr std::size_t max_words_of_round = std::size_t(1) << 18;

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
        const std::size_t bin = high_half(*word), size = low_half(*word);
        store_.append(bin - bins_.first(), word + 1, size);
        word += 1 + size;
      }
    } catch (...) {
      failure_of_store_ = std::current_exception();
    }
  }

  Rank_context& context_;
  const Bin_ranks& bins_;
  Word_store& store_;
  std::vector<Words> outgoing_;
  std::size_t buffered_ = 0;
  std::exception_ptr failure_of_store_;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_WORD_ROUTING_H
