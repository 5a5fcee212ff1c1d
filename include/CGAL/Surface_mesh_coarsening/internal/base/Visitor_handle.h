// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_VISITOR_HANDLE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_VISITOR_HANDLE_H

#include <CGAL/Surface_mesh_coarsening/Coarsening_visitor_base.h>
#include <CGAL/Surface_mesh_coarsening/exceptions.h>

#include <CGAL/Named_function_parameters.h>

#include <functional>
#include <memory>
#include <type_traits>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// The caller's visitor with its type erased: a copy, or the visitor itself if passed as `std::reference_wrapper`.
class Visitor_handle
{
public:
  Visitor_handle() {}

  explicit Visitor_handle(const CGAL::internal_np::Param_not_found&) {}

  template <class Visitor>
  explicit Visitor_handle(const std::reference_wrapper<Visitor>& visitor) { keep(&visitor.get()); }

  template <class Visitor>
  explicit Visitor_handle(const Visitor& visitor) { keep(std::make_shared<Visitor>(visitor)); }

  void stage_begins(Coarsening_stage stage) const
  {
    throw_if_cancelled();
    if (stage_begins_)
      stage_begins_(stage);
  }
  void stage_ends(Coarsening_stage stage) const
  {
    if (stage_ends_)
      stage_ends_(stage);
  }
  void round_done(std::size_t round, std::size_t moves, double energy) const
  {
    if (round_done_)
      round_done_(round, moves, energy);
    throw_if_cancelled();
  }
  void step_done(Coarsening_stage stage, std::size_t done, std::size_t total) const
  {
    if (step_done_)
      step_done_(stage, done, total);
  }
  void throw_if_cancelled() const
  {
    if (go_further_ && !go_further_())
      throw Coarsening_cancelled();
  }
  // Calls `go_further()` of the visitor after each `often` steps, counted over all loops. Throws if the visitor cancels.
  void poll(std::size_t steps) const
  {
    steps_ += steps;
    if (steps_ < often)
      return;
    steps_ = 0;
    throw_if_cancelled();
  }
  bool can_cancel() const { return bool(go_further_); }

private:
  static constexpr std::size_t often = 1 << 14;

  template <class Pointer>
  void keep(const Pointer& visitor)
  {
    stage_begins_ = [visitor](Coarsening_stage stage) { visitor->stage_begins(stage); };
    stage_ends_ = [visitor](Coarsening_stage stage) { visitor->stage_ends(stage); };
    round_done_ = [visitor](std::size_t round, std::size_t moves, double energy) {
      visitor->round_done(round, moves, energy);
    };
    step_done_ = [visitor](Coarsening_stage stage, std::size_t done, std::size_t total) {
      visitor->step_done(stage, done, total);
    };
    go_further_ = [visitor]() { return visitor->go_further(); };
  }

  std::function<void(Coarsening_stage)> stage_begins_, stage_ends_;
  std::function<void(std::size_t, std::size_t, double)> round_done_;
  std::function<void(Coarsening_stage, std::size_t, std::size_t)> step_done_;
  std::function<bool()> go_further_;
  mutable std::size_t steps_ = 0;
};

// Checks about once a millisecond whether the visitor cancels. Copies share the count of steps, so sequences of short loops
// are also covered. Loops on several threads must not use it. It also notifies the visitor of stages and steps.
class Cancellation_point
{
public:
  Cancellation_point() {}
  explicit Cancellation_point(const Visitor_handle& visitor) : visitor_(visitor.can_cancel() ? &visitor : nullptr) {}

  void poll(std::size_t steps = 1) const
  {
    if (visitor_ != nullptr)
      visitor_->poll(steps);
  }

  void stage_begins(Coarsening_stage stage) const
  {
    if (visitor_ != nullptr)
      visitor_->stage_begins(stage);
  }
  void stage_ends(Coarsening_stage stage) const
  {
    if (visitor_ != nullptr)
      visitor_->stage_ends(stage);
  }
  void step_done(Coarsening_stage stage, std::size_t done, std::size_t total) const
  {
    if (visitor_ != nullptr)
      visitor_->step_done(stage, done, total);
  }

private:
  const Visitor_handle* visitor_ = nullptr;
};

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_BASE_VISITOR_HANDLE_H
