// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SURFACE_MESH_COARSENING_PYTHON_SIGNAL_CHECK_H
#define SURFACE_MESH_COARSENING_PYTHON_SIGNAL_CHECK_H

#include <pybind11/pybind11.h>

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <thread>
#include <utility>

namespace coarsening_python {

// Throws the exception of a signal handler, for example KeyboardInterrupt. The caller holds the interpreter's lock.
inline void throw_if_signaled()
{
  if (PyErr_CheckSignals() != 0)
    throw pybind11::error_already_set();
}

// The same for callers without the lock, which another thread may hold for some milliseconds: it is acquired only a few times a
// second.
class Signal_check
{
public:
  void operator()()
  {
    const auto now = std::chrono::steady_clock::now();
    if (now - asked_ < std::chrono::milliseconds(20))
      return;
    asked_ = now;
    const pybind11::gil_scoped_acquire lock;
    throw_if_signaled();
  }

private:
  std::chrono::steady_clock::time_point asked_ = std::chrono::steady_clock::now();
};

// Runs a function that cannot be cancelled in another thread, while this thread checks for signals. After a signal, the function
// continues in the background until it ends, so it has to own the objects that it uses.
template <class Result>
Result run_interruptibly(std::function<Result()> function)
{
  const auto task = std::make_shared<std::packaged_task<Result()> >(std::move(function));
  std::future<Result> result = task->get_future();
  std::thread([task] { (*task)(); }).detach();
  const auto has_ended = [&result] {
    const pybind11::gil_scoped_release unlock;
    return result.wait_for(std::chrono::milliseconds(10)) == std::future_status::ready;
  };
  while (!has_ended())
    throw_if_signaled();
  return result.get();
}

} // namespace coarsening_python

#endif // SURFACE_MESH_COARSENING_PYTHON_SIGNAL_CHECK_H
