// SPDX-License-Identifier: GPL-3.0-or-later
//
// Creates the pictures of the manual and the README, and the figures in them:
//   make_pictures CGAL_MESHES DIRECTORY [NAME...]
// reads meshes of CGAL's data directory and writes panels, tables and scripts for gnuplot, for all pictures or for those that
// are named. The target `pictures` runs both, and so do the targets `picture_NAME`.

#include "Picture_kit.h"

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

int main(int argc, char* argv[])
{
  using namespace coarsening_pictures;
  Pictures all;
  for (const Pictures& some : {pictures_of_the_method(), pictures_of_features_and_borders(), pictures_of_what_comes_next(),
                               pictures_of_refinement(), pictures_of_ranks(), plots()})
    all.insert(all.end(), some.begin(), some.end());
  const std::vector<std::string> wanted(argv + (std::min)(argc, 3), argv + argc);
  const auto is_wanted = [&](const std::string& name) {
    return wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end();
  };
  if (argc < 3) {
    std::cerr << "Usage: make_pictures CGAL_MESHES DIRECTORY [NAME...]\nThe names:";
    for (const auto& picture : all)
      std::cerr << ' ' << picture.first;
    std::cerr << '\n';
    return EXIT_FAILURE;
  }
  try {
    const Setting setting{argv[1], argv[2]};
    std::filesystem::create_directories(setting.directory / "figures");
    for (const auto& picture : all)
      if (is_wanted(picture.first))
        picture.second(setting);
    return EXIT_SUCCESS;
  } catch (const std::exception& e) {
    std::cerr << "make_pictures: " << e.what() << "\n";
    return EXIT_FAILURE;
  }
}
