// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_WORD_ROUTING_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_WORD_ROUTING_H

#include <CGAL/Surface_mesh_coarsening/internal/base/Index.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Word_store.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/exchange.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/on_all_ranks.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/face_blocks.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

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
