// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_VIEWER_COARSENING_TASK_H
#define COARSENING_VIEWER_COARSENING_TASK_H

#include "io/Mesh.h"

#include <CGAL/Surface_mesh_coarsening/Coarsening_visitor_base.h>
#include <CGAL/Surface_mesh_coarsening/measure_coarsening.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <future>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace coarsening_viewer {

using namespace coarsening_support;

constexpr std::array<const char*, 4> weight_names = {{"uniform", "area", "maximum", "variance"}};
constexpr std::array<const char*, 4> placement_names = {{"centroid", "closest vertex", "quadric", "fitted"}};

struct Choice
{
  std::size_t vertices = 0;
  std::size_t weight = 1, placement = 3; // the defaults of the library

  friend bool operator==(const Choice& a, const Choice& b)
  {
    return a.vertices == b.vertices && a.weight == b.weight && a.placement == b.placement;
  }
};

struct Coarse
{
  Choice choice;
  Mesh mesh;
  std::vector<std::size_t> labels;
  std::vector<double> distances; // of each face of the input
  CGAL::Surface_mesh_coarsening::Coarsening_quality quality;
};

// The least and the largest number of vertices.
std::pair<std::size_t, std::size_t> vertex_numbers(const Mesh& input);

// Coarsens on a thread of its own. Refers to the input.
class Coarsening_task
{
public:
  explicit Coarsening_task(const Mesh& input) : input_(input) {}
  ~Coarsening_task() { cancel(); }

  // Cancels what runs.
  void start(const Choice& choice);

  bool is_running() const { return result_.valid(); }
  // In words.
  std::string progress() const;
  // The result as soon as there is one. Throws what the coarsening has thrown; then nothing runs any more.
  std::optional<Coarse> result();

private:
  class Visitor;

  void cancel();
  void say(const std::string& what);

  const Mesh& input_;
  std::future<Coarse> result_;
  std::atomic<bool> is_cancelled_ = false;
  mutable std::mutex mutex_; // of the progress
  std::string progress_;
};

} // namespace coarsening_viewer

#endif // COARSENING_VIEWER_COARSENING_TASK_H
