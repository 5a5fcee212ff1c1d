// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_PARALLEL_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_PARALLEL_H

#include <CGAL/Surface_mesh_coarsening/internal/base/Run_context.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>

#include <boost/config.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#endif

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// Calls `run(i)` for several numbers from 0 to `n`, in parallel if `context` requests it. The function is never inlined, so
// that profilers separate parallel from serial work; `count_serial_part.sh` relies on this.
template <class Run>
BOOST_NOINLINE void run_concurrently(const Run_context& context, std::size_t n, const Run& run)
{
#ifdef CGAL_LINKED_WITH_TBB
  if (context.is_parallel()) {
    tbb::parallel_for(std::size_t(0), n, run);
    return;
  }
#endif
  (void)context;
  for (std::size_t i = 0; i < n; ++i)
    run(i);
}

// Calls `work(i, begin, end)` for the i-th of the chunks of `size` numbers from 0 to `n`. Chunks, and hence results
// combined in order, do not depend on the number of threads. The partitioners of oneTBB choose chunks themselves, and the
// package must give the same results without oneTBB. The visitor can cancel between groups of chunks.
template <class Work>
void for_each_chunk(const Run_context& context, std::size_t n, std::size_t size, const Work& work)
{
  const std::size_t chunks = (n + size - 1) / size;
  const std::size_t at_a_time = context.has_visitor() ? 64 : chunks; // 64 chunks are enough for many threads
  for (std::size_t first = 0; first < chunks; first += at_a_time) {
    const std::size_t last = (std::min)(chunks, first + at_a_time);
    context.poll((std::min)(n, last * size) - first * size);
    const auto run = [&](std::size_t i) { work(first + i, (first + i) * size, (std::min)(n, (first + i + 1) * size)); };
    if (last - first > 1)
      run_concurrently(context, last - first, run);
    else
      run(0);
  }
}

// Calls `make(part, begin, end)` for the chunks of `size` numbers from 0 to `n`, several at a time, and then
// `take(part)` for each part in order. Parts are reused.
template <class Part, class Make, class Take>
void for_each_part(const Run_context& context, std::size_t n, std::size_t size, const Make& make, const Take& take)
{
  constexpr std::size_t at_a_time = 64;
  std::vector<Part> parts((std::min)(at_a_time, (n + size - 1) / size));
  for (std::size_t first = 0; first < n; first += at_a_time * size) {
    const std::size_t last = (std::min)(n, first + at_a_time * size);
    for_each_chunk(context, last - first, size,
                   [&](std::size_t i, std::size_t begin, std::size_t end) { make(parts[i], first + begin, first + end); });
    for (std::size_t i = 0; first + i * size < last; ++i)
      take(parts[i]);
  }
}

// Calls `work(i)` for the numbers from 0 to `n`, in any order.
template <class Work>
void for_each_number(const Run_context& context, std::size_t n, const Work& work)
{
  for_each_chunk(context, n, 1024, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      work(Index(i));
  });
}

// Calls `work(i)` for the numbers of each group in order. Each group is processed by one thread at a time.
template <class Work>
void for_each_in_groups(const Run_context& context, const std::vector<Index>& group, std::size_t number_of_groups,
                        const Work& work)
{
  constexpr std::size_t few = 4096; // for fewer numbers, starting threads would take longer
  if (!context.is_parallel() || group.size() < few) {
    for (std::size_t i = 0; i < group.size(); ++i) {
      context.poll();
      work(Index(i));
    }
    return;
  }
  constexpr std::size_t at_a_time = 1 << 16, parts = 4; // each part scans the groups of all numbers
  for (std::size_t first = 0; first < group.size(); first += at_a_time) {
    const std::size_t last = (std::min)(group.size(), first + at_a_time);
    context.poll(last - first);
    for_each_chunk(context.uninterrupted(), number_of_groups, (number_of_groups + parts - 1) / parts,
                   [&](std::size_t, std::size_t begin, std::size_t end) {
                     for (std::size_t i = first; i < last; ++i)
                       if (group[i] >= begin && group[i] < end)
                         work(Index(i));
                   });
  }
}

// Polls in loops on several threads. The visitor is called on the thread that began the loop; the other threads are informed if it
// cancels.
class Shared_cancellation_point
{
public:
  explicit Shared_cancellation_point(const Run_context& context) : context_(context) {}

  // Must be called before the loop.
  void begin()
  {
    thread_ = std::this_thread::get_id();
    is_refused_ = false;
  }

  // Returns whether to continue. On the thread that began the loop, a cancellation throws an exception.
  bool poll(std::size_t steps)
  {
    if (std::this_thread::get_id() != thread_)
      return !is_refused_;
    try {
      context_.poll(steps);
    } catch (...) {
      is_refused_ = true;
      throw;
    }
    return true;
  }

private:
  Run_context context_;
  std::thread::id thread_;
  std::atomic<bool> is_refused_{false};
};

// Returns the smallest number from 0 to `n` that satisfies `is_found`; `n` if there is none.
template <class Predicate>
std::size_t first_of(const Run_context& context, std::size_t n, const Predicate& is_found)
{
  std::atomic<std::size_t> first(n);
  for_each_number(context, n, [&](Index i) {
    if (!is_found(i))
      return;
    std::size_t before = first;
    while (i < before && !first.compare_exchange_weak(before, i))
      ;
  });
  return first;
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_PARALLEL_H
