// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SURFACE_MESH_COARSENING_PYTHON_PYTHON_VISITOR_H
#define SURFACE_MESH_COARSENING_PYTHON_PYTHON_VISITOR_H

#include "Signal_check.h"

#include <CGAL/Surface_mesh_coarsening/Coarsening_visitor_base.h>

#include <pybind11/pybind11.h>

#include <cstddef>
#include <exception>
#include <optional>

namespace coarsening_python {

// Reports progress to a Python function and checks for Ctrl-C.
class Python_visitor : public CGAL::Surface_mesh_coarsening::Coarsening_visitor_base
{
public:
  using Stage = CGAL::Surface_mesh_coarsening::Coarsening_stage;

  // `progress` may be None.
  explicit Python_visitor(const pybind11::object& progress) : progress_(progress) {}

  void stage_begins(Stage stage);
  void round_done(std::size_t round, std::size_t moves, double energy);
  void step_done(Stage stage, std::size_t done, std::size_t total);
  bool go_further();

  // Rethrows the exception of the Python function or of a signal handler.
  void rethrow() const;

private:
  template <class Call>
  void call_python(const Call& call);
  void report(Stage stage, std::size_t done, std::optional<std::size_t> total);

  const pybind11::object& progress_;
  std::exception_ptr failure_;
  Signal_check check_;
};

} // namespace coarsening_python

#endif // SURFACE_MESH_COARSENING_PYTHON_PYTHON_VISITOR_H
