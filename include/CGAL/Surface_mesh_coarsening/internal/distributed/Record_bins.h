// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_RECORD_BINS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_RECORD_BINS_H

#include <CGAL/Surface_mesh_coarsening/internal/distributed/Face_record.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Rank_context.h>

#include <boost/mpi/collectives.hpp>
#include <boost/mpi/nonblocking.hpp>
#include <boost/mpi/request.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Numbered bins of records on all ranks. Each rank holds a run of consecutive bins, its own bins, in memory and, beyond the
// limit, in its scratch file. Records remain whole.
class Record_bins
{
public:
  Record_bins(Rank_context& context, std::size_t bins)
    : context_(context), number_(bins), first_own_(first_of(context.rank())),
      bins_(first_of(context.rank() + 1) - first_own_), outgoing_(context.number_of_ranks())
  {}
  Record_bins(const Record_bins&) = delete;
  ~Record_bins()
  {
    for (std::size_t i = 0; i < bins_.size(); ++i)
      clear(i);
  }

  std::size_t number_of_bins() const { return number_; }
  std::size_t first_own() const { return first_own_; }
  std::size_t number_of_own() const { return bins_.size(); }

  // Calls `produce()`, which calls `send()` and must not wait for other ranks in any other way. Records are sent in rounds of
  // limited size, so no rank must hold all records that it sends or receives. If `produce()` throws on some ranks, all ranks
  // throw the same exception.
  void fill(const std::function<void()>& produce)
  {
    try {
      produce();
    } catch (...) {
      failure_ = std::current_exception();
    }
    while (!exchange_round(true))
      ;
    on_all_ranks(context_.communicator, [&] {
      if (failure_)
        std::rethrow_exception(failure_);
    });
  }

  // Records for own bins are stored directly, so they may also be sent outside of `fill()`.
  template <class Record>
  void send(std::size_t bin, const Record& record)
  {
    record_.clear();
    write_record(record, record_);
    const std::size_t rank = rank_of_bin(bin, number_, context_.number_of_ranks());
    if (rank == context_.rank()) {
      append_words(bin - first_own_, record_.data(), record_.size());
      return;
    }
    write_record(Label{Index(bin), Index(record_.size())}, outgoing_[rank]);
    outgoing_[rank].insert(outgoing_[rank].end(), record_.begin(), record_.end());
    buffered_ += record_.size() + 1;
    if (buffered_ < max_words_of_round)
      return;
    exchange_round(false);
    if (failure_)
      std::rethrow_exception(failure_);
  }

  // In the following functions, `i` is the number of a bin among the own ones.

  std::size_t number_of_words(std::size_t i) const { return bins_[i].words; }

  // Calls `receive(record)` for each record of a bin, in the order of appending. The bin must not change during the call.
  template <class Record, class Receive>
  void read(std::size_t i, const Receive& receive) const
  {
    Record record;
    const auto pass = [&](const Words& words) {
      for (const std::uint64_t* word = words.data(); word != words.data() + words.size();) {
        word = read_record(word, record);
        receive(record);
      }
    };
    Words buffer;
    for (const Scratch_file::Chunk& chunk : bins_[i].chunks)
      pass(context_.scratch.read(chunk, buffer));
    pass(bins_[i].open);
  }

  void clear(std::size_t i)
  {
    for (const Scratch_file::Chunk& chunk : bins_[i].chunks)
      context_.scratch.release(chunk);
    bins_[i] = Bin();
  }

private:
  static constexpr std::size_t max_words_of_round = std::size_t(1) << 18;

  // What precedes a record in a message.
  struct Label
  {
    Index bin, size;
  };
  struct Bin
  {
    std::vector<Scratch_file::Chunk> chunks;
    Words open; // the last chunk, to which records are appended
    std::size_t words = 0;
  };

  std::size_t first_of(std::size_t rank) const
  {
    return (rank * number_ + context_.number_of_ranks() - 1) / context_.number_of_ranks();
  }

  // Returns whether no rank has more records to send.
  bool exchange_round(bool is_last)
  {
    const int ranks_to_go = boost::mpi::all_reduce(context_.communicator, is_last ? 0 : 1, std::plus<int>());
    std::vector<Words> incoming(outgoing_.size());
    std::vector<boost::mpi::request> requests;
    for (std::size_t rank = 0; rank < outgoing_.size(); ++rank) {
      if (rank == context_.rank())
        continue;
      requests.push_back(context_.communicator.irecv(int(rank), 0, incoming[rank]));
      requests.push_back(context_.communicator.isend(int(rank), 0, outgoing_[rank]));
      context_.bytes_sent += outgoing_[rank].size() * sizeof(std::uint64_t);
    }
    boost::mpi::wait_all(requests.begin(), requests.end());
    outgoing_ = std::vector<Words>(outgoing_.size());
    buffered_ = 0;
    // After a failure, rounds continue without storing records, because other ranks wait for them.
    for (std::size_t rank = 0; rank < incoming.size() && !failure_; ++rank) {
      const Words words = std::move(incoming[rank]);
      try {
        for (const std::uint64_t* word = words.data(); word != words.data() + words.size();) {
          Label label;
          word = read_record(word, label);
          append_words(label.bin - first_own_, word, label.size);
          word += label.size;
        }
      } catch (...) {
        failure_ = std::current_exception();
      }
    }
    return ranks_to_go == 0;
  }

  void append_words(std::size_t i, const std::uint64_t* words, std::size_t size)
  {
    Bin& bin = bins_[i];
    if (!bin.open.empty() && bin.open.size() + size > Scratch_file::slot_words)
      bin.chunks.push_back(context_.scratch.store(bin.open));
    if (bin.open.empty())
      bin.open.reserve((std::max)(size, Scratch_file::slot_words));
    bin.open.insert(bin.open.end(), words, words + size);
    bin.words += size;
  }

  Rank_context& context_;
  const std::size_t number_, first_own_;
  std::vector<Bin> bins_;       // the own ones
  std::vector<Words> outgoing_; // to each rank
  Words record_;                // the record that is sent
  std::size_t buffered_ = 0;
  std::exception_ptr failure_;
};

// Moves the records of all ranks to rank 0, sorted.
template <class Record>
void gather_sorted(Rank_context& context, std::vector<Record>& records)
{
  Record_bins all(context, 1);
  all.fill([&] {
    for (const Record& record : records)
      all.send(0, record);
    records = std::vector<Record>();
  });
  on_first_rank(context, [&] {
    all.read<Record>(0, [&](const Record& record) { records.push_back(record); });
    std::sort(records.begin(), records.end());
  });
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_RECORD_BINS_H
