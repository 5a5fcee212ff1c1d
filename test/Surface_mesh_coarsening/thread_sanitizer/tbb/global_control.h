// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stands in for oneTBB's header, see parallel_for.h.

#ifndef CGAL_SURFACE_MESH_COARSENING_THREAD_SANITIZER_GLOBAL_CONTROL_H
#define CGAL_SURFACE_MESH_COARSENING_THREAD_SANITIZER_GLOBAL_CONTROL_H

#include <cstddef>

namespace tbb {

class global_control
{
public:
  enum parameter { max_allowed_parallelism };

  global_control(parameter, std::size_t threads) : before_(limit()) { limit() = threads; }
  ~global_control() { limit() = before_; }
  global_control(const global_control&) = delete;
  global_control& operator=(const global_control&) = delete;

  static std::size_t threads() { return limit(); }

private:
  static std::size_t& limit()
  {
    static std::size_t threads = 2;
    return threads;
  }

  std::size_t before_;
};

} // namespace tbb

#endif // CGAL_SURFACE_MESH_COARSENING_THREAD_SANITIZER_GLOBAL_CONTROL_H
