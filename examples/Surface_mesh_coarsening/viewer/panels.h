// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_VIEWER_PANELS_H
#define COARSENING_VIEWER_PANELS_H

#include "Coarsening_task.h"

#include "render/Image.h"

#include <array>
#include <memory>
#include <string>

namespace coarsening_support {
struct Scene;
}

namespace coarsening_viewer {

// Where the meshes are looked at from.
struct View
{
  double turn = 0.9, tilt = 0.35; // in radians, around the axis that points up, and above the horizon
  double zoom = 1;
  bool z_is_up = false;
};

// The four pictures: input, clusters, result and error.
constexpr std::size_t number_of_panels = 4;

class Panel_scenes
{
public:
  explicit Panel_scenes(const Mesh& input);
  ~Panel_scenes();

  void show(const Coarse& coarse);

  // A line of text above a picture.
  std::string caption(std::size_t panel) const;
  // A picture of a square, empty where there is nothing to show yet.
  Image image(std::size_t panel, const View& view, std::size_t size) const;

private:
  const Mesh& input_;
  std::vector<Point> sphere_; // around the input: the pictures keep their size when it turns
  Point center_;
  std::array<std::unique_ptr<Scene>, number_of_panels> scenes_;
  std::array<std::string, number_of_panels> captions_;
};

} // namespace coarsening_viewer

#endif // COARSENING_VIEWER_PANELS_H
