// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_PARALLEL_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_PARALLEL_H

#include <CGAL/Surface_mesh_coarsening/Coarsening_visitor_base.h>
#include <CGAL/Surface_mesh_coarsening/exceptions.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <boost/config.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#endif

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <thread>
#include <type_traits>
#include <vector>

// Functions of the headers NAME_impl.h are inline if the package is used header-only. They are not inline if
// CGAL_SURFACE_MESH_COARSENING_COMPILED_CORE is defined; then the core is compiled once into a library.
#ifdef CGAL_SURFACE_MESH_COARSENING_COMPILED_CORE
#define CGAL_SURFACE_MESH_COARSENING_INLINE
#else
#define CGAL_SURFACE_MESH_COARSENING_INLINE inline
#endif

namespace CGAL::Surface_mesh_coarsening::internal {

// The number of a face, corner, vertex or cluster in the arrays.
typedef std::uint32_t Index;

constexpr Index NONE = (std::numeric_limits<Index>::max)();

// What all steps of a run share: whether loops use several threads, and the caller's visitor with its type erased. Copies share the
// visitor and the count of steps, so sequences of short loops are also covered.
class Run_context
{
public:
  // One thread and no visitor.
  Run_context() {}

  // Keeps a copy of the visitor, or the visitor itself if passed as `std::reference_wrapper`.
  template <class ConcurrencyTag, class Visitor = CGAL::internal_np::Param_not_found>
  explicit Run_context(const ConcurrencyTag&, const Visitor& visitor = Visitor())
    : is_parallel_(std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
  {
#ifndef CGAL_LINKED_WITH_TBB
    static_assert(!std::is_convertible<ConcurrencyTag, Parallel_tag>::value, "Parallel_tag is enabled but TBB is unavailable.");
#endif
    keep(visitor);
  }

  bool is_parallel() const { return is_parallel_; }
  bool has_visitor() const { return visitor_ != nullptr; }

  // The same without the visitor: for loops that must not be left half done, and for loops inside loops on several threads.
  Run_context uninterrupted() const
  {
    Run_context result;
    result.is_parallel_ = is_parallel_;
    return result;
  }

  // The same with one thread: for functions of the caller that do not permit several.
  Run_context on_one_thread() const
  {
    Run_context result(*this);
    result.is_parallel_ = false;
    return result;
  }

  void stage_begins(Coarsening_stage stage) const
  {
    throw_if_cancelled();
    if (visitor_)
      visitor_->stage_begins(stage);
  }
  void stage_ends(Coarsening_stage stage) const
  {
    if (visitor_)
      visitor_->stage_ends(stage);
  }
  void round_done(std::size_t round, std::size_t moves, double energy) const
  {
    if (visitor_)
      visitor_->round_done(round, moves, energy);
    throw_if_cancelled();
  }
  void step_done(Coarsening_stage stage, std::size_t done, std::size_t total) const
  {
    if (visitor_)
      visitor_->step_done(stage, done, total);
  }
  void throw_if_cancelled() const
  {
    if (visitor_ && !visitor_->go_further())
      throw Coarsening_cancelled();
  }
  // Calls `go_further()` of the visitor after each `often` steps, about once a millisecond, counted over all loops. Throws if the
  // visitor cancels. Loops on several threads must not call it.
  void poll(std::size_t steps = 1) const
  {
    if (!visitor_)
      return;
    visitor_->steps += steps;
    if (visitor_->steps < often)
      return;
    visitor_->steps = 0;
    throw_if_cancelled();
  }

private:
  static constexpr std::size_t often = 1 << 14;

  struct Erased_visitor
  {
    std::function<void(Coarsening_stage)> stage_begins, stage_ends;
    std::function<void(std::size_t, std::size_t, double)> round_done;
    std::function<void(Coarsening_stage, std::size_t, std::size_t)> step_done;
    std::function<bool()> go_further;
    std::size_t steps = 0; // since the last call of `go_further()`
  };

  void keep(const CGAL::internal_np::Param_not_found&) {}

  template <class Visitor>
  void keep(const std::reference_wrapper<Visitor>& visitor) { keep_pointer(&visitor.get()); }

  template <class Visitor>
  void keep(const Visitor& visitor) { keep_pointer(std::make_shared<Visitor>(visitor)); }

  template <class Pointer>
  void keep_pointer(const Pointer& p)
  {
    visitor_ = std::make_shared<Erased_visitor>(Erased_visitor{
      [p](Coarsening_stage stage) { p->stage_begins(stage); }, [p](Coarsening_stage stage) { p->stage_ends(stage); },
      [p](std::size_t round, std::size_t moves, double energy) { p->round_done(round, moves, energy); },
      [p](Coarsening_stage stage, std::size_t done, std::size_t total) { p->step_done(stage, done, total); },
      [p]() { return p->go_further(); }});
  }

  bool is_parallel_ = false;
  std::shared_ptr<Erased_visitor> visitor_;
};

// Calls `run(i)` for several numbers from 0 to `n`, in parallel if `context` requests it. The function is never inlined, so
// that profilers separate parallel from serial work; `count_serial_part.sh` relies on this.
template <class Run>
BOOST_NOINLINE void run_concurrently([[maybe_unused]] const Run_context& context, std::size_t n, const Run& run)
{
#ifdef CGAL_LINKED_WITH_TBB
  if (context.is_parallel()) {
    tbb::parallel_for(std::size_t(0), n, run);
    return;
  }
#endif
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
