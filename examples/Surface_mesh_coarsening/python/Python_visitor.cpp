// SPDX-License-Identifier: GPL-3.0-or-later

#include "Python_visitor.h"

#include "report/Timing_visitor.h"

#include <pybind11/stl.h>

namespace coarsening_python {

namespace py = pybind11;

// Exceptions do not pass through the library: the coarsening is cancelled, and they are rethrown afterwards.
template <class Call>
void Python_visitor::call_python(const Call& call)
{
  if (failure_)
    return;
  const py::gil_scoped_acquire lock;
  try {
    call();
  } catch (...) {
    failure_ = std::current_exception();
  }
}

void Python_visitor::report(Stage stage, std::size_t done, std::optional<std::size_t> total)
{
  if (!progress_.is_none())
    call_python([&] { progress_(coarsening_support::stage_name(stage), done, total); });
}

void Python_visitor::stage_begins(Stage stage) { report(stage, 0, std::nullopt); }

void Python_visitor::round_done(std::size_t round, std::size_t, double) { report(Stage::MINIMIZATION, round, std::nullopt); }

void Python_visitor::step_done(Stage stage, std::size_t done, std::size_t total) { report(stage, done, total); }

bool Python_visitor::go_further()
{
  if (!failure_)
    try {
      check_();
    } catch (...) {
      failure_ = std::current_exception();
    }
  return !failure_;
}

void Python_visitor::rethrow() const
{
  if (failure_)
    std::rethrow_exception(failure_);
}

} // namespace coarsening_python
