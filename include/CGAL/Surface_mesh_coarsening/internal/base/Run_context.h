// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_RUN_CONTEXT_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_RUN_CONTEXT_H

#include <CGAL/Surface_mesh_coarsening/Coarsening_visitor_base.h>
#include <CGAL/Surface_mesh_coarsening/exceptions.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <type_traits>

namespace CGAL::Surface_mesh_coarsening::internal {

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

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_RUN_CONTEXT_H
