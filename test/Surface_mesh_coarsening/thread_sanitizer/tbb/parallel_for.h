// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stands in for oneTBB's header in the build for the thread sanitizer. The sanitizer does not see the synchronization of an
// oneTBB built without it, and reports every hand-over of work as a race. It sees all of this code.

#ifndef CGAL_SURFACE_MESH_COARSENING_THREAD_SANITIZER_PARALLEL_FOR_H
#define CGAL_SURFACE_MESH_COARSENING_THREAD_SANITIZER_PARALLEL_FOR_H

#include "global_control.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace tbb {

// Threads take the numbers one by one, in no order. An exception ends the loop on all threads and is thrown again.
template <class Function>
void parallel_for(std::size_t begin, std::size_t end, const Function& function)
{
  std::atomic<std::size_t> next(begin);
  std::exception_ptr first_exception;
  std::mutex mutex;
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < end; i = next++)
        function(i);
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex);
      if (!first_exception)
        first_exception = std::current_exception();
      next = end;
    }
  };
  std::vector<std::thread> others;
  for (std::size_t i = 1; i < global_control::threads(); ++i)
    others.emplace_back(work);
  work();
  for (std::thread& thread : others)
    thread.join();
  if (first_exception)
    std::rethrow_exception(first_exception);
}

} // namespace tbb

#endif // CGAL_SURFACE_MESH_COARSENING_THREAD_SANITIZER_PARALLEL_FOR_H
