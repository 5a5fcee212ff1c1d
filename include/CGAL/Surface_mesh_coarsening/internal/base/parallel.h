// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_PARALLEL_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_PARALLEL_H

#include <CGAL/Surface_mesh_coarsening/internal/base/Visitor_handle.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/containers.h>

#include <CGAL/tags.h>

#include <boost/config.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#endif

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

enum class Execution { SEQUENTIAL, PARALLEL };

template <class ConcurrencyTag>
constexpr Execution execution()
{
  constexpr bool is_parallel = std::is_convertible<ConcurrencyTag, Parallel_tag>::value;
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!is_parallel, "Parallel_tag is enabled but TBB is unavailable.");
#endif
  return is_parallel ? Execution::PARALLEL : Execution::SEQUENTIAL;
}

// Calls `run(i)` for several numbers from 0 to `n`, in parallel if `execution` requests it. The function is never inlined, so
// that profilers separate parallel from serial work; `count_serial_part.sh` relies on this.
template <class Run>
BOOST_NOINLINE void run_concurrently(Execution execution, std::size_t n, const Run& run)
{
#ifdef CGAL_LINKED_WITH_TBB
  if (execution == Execution::PARALLEL) {
    tbb::parallel_for(std::size_t(0), n, run);
    return;
  }
#endif
  (void)execution;
  for (std::size_t i = 0; i < n; ++i)
    run(i);
}

// Calls `work(i, begin, end)` for the i-th of the chunks of `size` numbers from 0 to `n`. Chunks, and hence results
// combined in order, do not depend on the number of threads. The partitioners of oneTBB choose chunks themselves, and the
// package must give the same results without oneTBB.
template <class Work>
void for_each_chunk(Execution execution, std::size_t n, std::size_t size, const Work& work)
{
  const std::size_t chunks = (n + size - 1) / size;
  const auto run = [&](std::size_t i) { work(i, i * size, (std::min)(n, (i + 1) * size)); };
  if (chunks > 1)
    run_concurrently(execution, chunks, run);
  else if (chunks == 1)
    run(0);
}

// The same with cancellation.
template <class Work>
void for_each_chunk(Execution execution, std::size_t n, std::size_t size, const Cancellation_point& cancellation,
                    const Work& work)
{
  constexpr std::size_t at_a_time = 64; // number of chunks, enough for many threads
  for (std::size_t first = 0; first < n; first += at_a_time * size) {
    const std::size_t last = (std::min)(n, first + at_a_time * size);
    cancellation.poll(last - first);
    for_each_chunk(execution, last - first, size, [&](std::size_t i, std::size_t begin, std::size_t end) {
      work(first / size + i, first + begin, first + end);
    });
  }
}

// Calls `make(part, begin, end)` for the chunks of `size` numbers from 0 to `n`, several at a time, and then
// `take(part)` for each part in order. Parts are reused.
template <class Part, class Make, class Take>
void for_each_part(Execution execution, std::size_t n, std::size_t size, const Cancellation_point& cancellation, const Make& make,
                   const Take& take)
{
  constexpr std::size_t at_a_time = 64;
  std::vector<Part> parts((std::min)(at_a_time, (n + size - 1) / size));
  for (std::size_t first = 0; first < n; first += at_a_time * size) {
    const std::size_t last = (std::min)(n, first + at_a_time * size);
    cancellation.poll(last - first);
    for_each_chunk(execution, last - first, size, [&](std::size_t i, std::size_t begin, std::size_t end) {
      make(parts[i], first + begin, first + end);
    });
    for (std::size_t i = 0; first + i * size < last; ++i)
      take(parts[i]);
  }
}

// Calls `work(i)` for the numbers from 0 to `n`, in any order.
template <class Work>
void for_each_number(Execution execution, std::size_t n, const Cancellation_point& cancellation, const Work& work)
{
  for_each_chunk(execution, n, 1024, cancellation, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      work(Index(i));
  });
}

// Calls `work(i)` for the numbers of each group in order. Each group is processed by one thread at a time.
template <class Work>
void for_each_in_groups(Execution execution, const std::vector<Index>& group, std::size_t number_of_groups,
                        const Cancellation_point& cancellation, const Work& work)
{
  constexpr std::size_t few = 4096; // for fewer numbers, starting threads would take longer
  if (execution == Execution::SEQUENTIAL || group.size() < few) {
    for (std::size_t i = 0; i < group.size(); ++i) {
      cancellation.poll();
      work(Index(i));
    }
    return;
  }
  constexpr std::size_t at_a_time = 1 << 16, parts = 4; // each part scans the groups of all numbers
  for (std::size_t first = 0; first < group.size(); first += at_a_time) {
    const std::size_t last = (std::min)(group.size(), first + at_a_time);
    cancellation.poll(last - first);
    for_each_chunk(execution, number_of_groups, (number_of_groups + parts - 1) / parts,
                   [&](std::size_t, std::size_t begin, std::size_t end) {
                     for (std::size_t i = first; i < last; ++i)
                       if (group[i] >= begin && group[i] < end)
                         work(Index(i));
                   });
  }
}

// A cancellation point for loops on several threads. The visitor is called on the thread that began the loop; the other threads
// are informed if it cancels.
class Shared_cancellation_point
{
public:
  explicit Shared_cancellation_point(const Cancellation_point& cancellation) : cancellation_(cancellation) {}

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
      cancellation_.poll(steps);
    } catch (...) {
      is_refused_ = true;
      throw;
    }
    return true;
  }

private:
  Cancellation_point cancellation_;
  std::thread::id thread_;
  std::atomic<bool> is_refused_{false};
};

// Returns the smallest number from 0 to `n` that satisfies `is_found`; `n` if there is none.
template <class Predicate>
std::size_t first_of(Execution execution, std::size_t n, const Cancellation_point& cancellation, const Predicate& is_found)
{
  std::atomic<std::size_t> first(n);
  for_each_number(execution, n, cancellation, [&](Index i) {
    if (!is_found(i))
      return;
    std::size_t before = first;
    while (i < before && !first.compare_exchange_weak(before, i))
      ;
  });
  return first;
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_PARALLEL_H
