// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_BENCHMARK_WATCHDOG_H
#define COARSENING_BENCHMARK_WATCHDOG_H

#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <iostream>
#include <mutex>
#include <string>
#include <thread>

namespace benchmark_support {

// Ends the program if a job does not end, which a visitor could not detect: not every loop calls it.
class Watchdog
{
public:
  explicit Watchdog(double seconds)
    : limit_(std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds))),
      thread_([this] { watch(); })
  {}
  ~Watchdog()
  {
    set([this] { closed_ = true; });
    thread_.join();
  }
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

  void begin(const std::string& job)
  {
    set([&] {
      job_ = job;
      end_ = Clock::now() + limit_;
      busy_ = true;
    });
  }
  void end()
  {
    set([this] { busy_ = false; });
  }

private:
  typedef std::chrono::steady_clock Clock;

  template <class Change>
  void set(const Change& change)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    change();
    changed_.notify_one();
  }

  void watch()
  {
    std::unique_lock<std::mutex> lock(mutex_);
    while (!closed_) {
      if (!busy_) {
        changed_.wait(lock);
      } else if (changed_.wait_until(lock, end_) == std::cv_status::timeout && busy_ && Clock::now() >= end_) {
        std::cout << "FAILED " << job_ << ": did not end in time; the rest is not tried" << std::endl;
        std::_Exit(1);
      }
    }
  }

  const Clock::duration limit_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::string job_;
  Clock::time_point end_;
  bool busy_ = false, closed_ = false;
  std::thread thread_; // the last member: it uses the others
};

} // namespace benchmark_support

#endif // COARSENING_BENCHMARK_WATCHDOG_H
