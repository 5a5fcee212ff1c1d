// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_PROGRESS_LINE_H
#define COARSEN_MESH_PROGRESS_LINE_H

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace coarsen_mesh_tool {

// A line on a terminal's standard error that shows the progress. It appears after one second of work, and is erased at
// the end. A separate thread paints it, so that it also moves during long steps without notifications.
class Progress_line
{
  std::mutex mutex;
  std::condition_variable wake;
  std::string text;
  bool ended = false;
  const std::chrono::steady_clock::time_point birth = std::chrono::steady_clock::now();
  std::thread painter;

public:
  // Does nothing unless `wanted` and standard error is a terminal.
  explicit Progress_line(bool wanted);
  ~Progress_line() { end(); }
  Progress_line(const Progress_line&) = delete;
  Progress_line& operator=(const Progress_line&) = delete;

  void say(const std::string& what);

  // Erases the line; it does not come back.
  void end();

private:
  void paint_until_end();
};

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_PROGRESS_LINE_H
