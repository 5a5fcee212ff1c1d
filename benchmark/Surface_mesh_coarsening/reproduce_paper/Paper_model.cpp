// SPDX-License-Identifier: GPL-3.0-or-later

#include "Paper_model.h"

#include "check/soup_fault.h"
#include "io/Failure.h"
#include "io/file_type.h"
#include "io/read_soup.h"
#include "io/to_mesh.h"

#include <algorithm>
#include <filesystem>
#include <map>

namespace reproduce_paper {

const std::vector<Paper_model>& paper_models()
{
  static const std::vector<Paper_model> models = {
    {"Fandisk", {"fandisk"}, 6475, 3, 527, "<1", {50, 50, 3}, {8, 8, 8}},
    {"Cube", {}, 15002, 7, 274, "<1", {50, 50, 3}, {20, 12, 5}},
    {"Bunny", {"bunny"}, 34834, 7, 594, "1", {50, 50, 3}, {59, 63, 50}},
    {"Horse", {"horse"}, 48485, 5, 1579, "1", {5, 5, 3}, {112, 124, 106}},
    {"Dragon", {"dragon_vrip", "dragon"}, 437645, 7, 6829, "13", {50, 5, 3}, {940, 864, 759}}};
  return models;
}

Mesh triangulated_cube(std::size_t n)
{
  using Place = std::array<std::size_t, 3>;
  std::map<Place, std::size_t> numbers;
  Soup soup;
  const double step = 1. / static_cast<double>(n);
  const auto vertex = [&](const Place& p) {
    const auto found = numbers.emplace(p, soup.points.size());
    if (found.second)
      soup.points.emplace_back(step * static_cast<double>(p[0]), step * static_cast<double>(p[1]),
                               step * static_cast<double>(p[2]));
    return found.first->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const bool far : {false, true})
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i) {
          const auto corner = [&](std::size_t di, std::size_t dj) {
            Place p;
            p[axis] = far ? n : 0;
            p[(axis + 1) % 3] = i + di;
            p[(axis + 2) % 3] = j + dj;
            return vertex(p);
          };
          const std::size_t a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
          if (far) {
            soup.polygons.push_back({a, b, c});
            soup.polygons.push_back({a, c, d});
          } else {
            soup.polygons.push_back({a, c, b});
            soup.polygons.push_back({a, d, c});
          }
        }
  return to_mesh(soup);
}

std::optional<std::string> find_model(const Paper_model& model, const std::vector<std::string>& places)
{
  namespace fs = std::filesystem;
  const auto is_it = [&model](const fs::path& file) {
    return is_own_file_type(file_type(file.string())) &&
           std::count(model.files.begin(), model.files.end(), lower_case(file.stem().string())) > 0;
  };
  for (const std::string& place : places) {
    if (!fs::is_directory(place)) {
      if (is_it(place))
        return place;
      continue;
    }
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(place))
      if (is_it(entry.path()))
        found.push_back(entry.path().string());
    if (!found.empty())
      return *std::min_element(found.begin(), found.end()); // independent of the order of the directory
  }
  return std::nullopt;
}

Mesh load_model(const Paper_model& model, const std::string& file)
{
  if (model.files.empty())
    return triangulated_cube(50);
  Soup soup = read_soup(file);
  if (const auto fault = soup_fault(soup))
    throw Failure(file, *fault);
  drop_unused_points(soup);
  return to_mesh(soup);
}

} // namespace reproduce_paper
