// SPDX-License-Identifier: GPL-3.0-or-later

#include "Python_visitor.h"

#include "report/Timing_visitor.h"

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

void Python_visitor::report(std::size_t round)
{
  if (!progress_.is_none())
    call_python([&] { progress_(stage_, round); });
}

void Python_visitor::stage_begins(CGAL::Surface_mesh_coarsening::Coarsening_stage stage)
{
  stage_ = coarsening_support::stage_name(stage);
  report(0);
}

void Python_visitor::round_done(std::size_t round, std::size_t, double) { report(round); }

bool Python_visitor::go_further()
{
  const auto now = std::chrono::steady_clock::now();
  if (now - asked_ > std::chrono::milliseconds(20)) {
    asked_ = now;
    call_python([] {
      if (PyErr_CheckSignals() != 0)
        throw py::error_already_set();
    });
  }
  return !failure_;
}

void Python_visitor::rethrow() const
{
  if (failure_)
    std::rethrow_exception(failure_);
}

} // namespace coarsening_python
