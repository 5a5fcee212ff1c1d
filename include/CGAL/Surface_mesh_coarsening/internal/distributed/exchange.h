// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_EXCHANGE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_EXCHANGE_H

#include <CGAL/Surface_mesh_coarsening/internal/distributed/Rank_context.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Words.h>

#include <boost/mpi/collectives.hpp>
#include <boost/mpi/communicator.hpp>
#include <boost/mpi/nonblocking.hpp>
#include <boost/mpi/request.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

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

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_EXCHANGE_H
