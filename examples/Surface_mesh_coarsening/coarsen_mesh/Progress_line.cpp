// SPDX-License-Identifier: GPL-3.0-or-later

#include "Progress_line.h"

#include "Interruption.h"

#include <cstdio>

#include <unistd.h>

namespace coarsen_mesh_tool {

Progress_line::Progress_line(bool wanted)
{
  const Deferred_interruption in_painter; // signals are to reach the thread that works
  if (wanted && isatty(STDERR_FILENO))
    painter = std::thread([this] { paint_until_end(); });
}

void Progress_line::say(const std::string& what)
{
  if (!painter.joinable())
    return;
  const std::lock_guard<std::mutex> lock(mutex);
  text = what;
}

void Progress_line::end()
{
  if (!painter.joinable())
    return;
  {
    const std::lock_guard<std::mutex> lock(mutex);
    ended = true;
  }
  wake.notify_one();
  painter.join();
}

void Progress_line::paint_until_end()
{
  std::unique_lock<std::mutex> lock(mutex);
  const auto is_ended = [this] { return ended; };
  if (wake.wait_for(lock, std::chrono::seconds(1), is_ended))
    return;
  do {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - birth;
    std::fprintf(stderr, "\r\033[K%.60s, %.0f s", text.c_str(), elapsed.count());
    std::fflush(stderr);
  } while (!wake.wait_for(lock, std::chrono::milliseconds(200), is_ended));
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
}

} // namespace coarsen_mesh_tool
