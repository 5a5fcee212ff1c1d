// SPDX-License-Identifier: GPL-3.0-or-later

#include "figures.h"

#include "io/Failure.h"
#include "render/captioned.h"
#include "render/png_bytes.h"
#include "render/render.h"

#include <array>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>

namespace reproduce_paper {
namespace {

// The number of steps across edges from the nearest seed to each face, as far as `level`; `outside` beyond it.
constexpr unsigned outside = (std::numeric_limits<unsigned>::max)();

struct Neighborhoods
{
  std::vector<unsigned> steps;    // of each face
  std::vector<std::size_t> seeds; // the number of the seed of each face
};

Neighborhoods neighborhoods(const Mesh& mesh, const std::vector<Face>& seeds, unsigned level)
{
  Neighborhoods result{std::vector<unsigned>(mesh.num_faces(), outside),
                       std::vector<std::size_t>(mesh.num_faces(), seeds.size())};
  std::deque<Face> queue;
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    result.steps[seeds[i]] = 0;
    result.seeds[seeds[i]] = i;
    queue.push_back(seeds[i]);
  }
  for (; !queue.empty(); queue.pop_front()) {
    const Face f = queue.front();
    if (result.steps[f] == level)
      continue;
    for (Face g : mesh.faces_around_face(mesh.halfedge(f)))
      if (g != mesh.null_face() && result.steps[g] == outside) {
        result.steps[g] = result.steps[f] + 1;
        result.seeds[g] = result.seeds[f];
        queue.push_back(g);
      }
  }
  return result;
}

// Renders panels of one model from one viewpoint.
class Artist
{
  const Mesh& mesh;
  Camera camera;

public:
  Artist(const Mesh& mesh, const Vector& view)
    : mesh(mesh),
      camera(std::vector<Point>(mesh.points().begin(), mesh.points().end()), view, Vector(0, 1, 0), 600)
  {}

  Image clusters(const std::vector<std::size_t>& labels) const { return render(cluster_scene(mesh, labels), camera); }
  Image dual(const Mesh& dual) const { return render(mesh_scene(dual), camera); }

  // Figure 2a: each neighborhood in a color, its seed and the faces next to it dark, and what no neighborhood covers pale.
  Image seeds(const Neighborhoods& n) const
  {
    const std::vector<std::size_t> colors = color_clusters(mesh, n.seeds);
    return colored([&](Face f) {
      return n.steps[f] == outside ? Rgb{{235, 235, 235}}
             : n.steps[f] <= 1     ? Rgb{{40, 40, 40}}
                                   : palette_color(colors[n.seeds[f]]);
    });
  }

  // Figure 3: the layers of each neighborhood.
  Image layers(const Neighborhoods& n, unsigned level) const
  {
    return colored([&](Face f) {
      if (n.steps[f] == outside)
        return Rgb{{235, 235, 235}};
      const auto shade = static_cast<std::uint8_t>(40 + 190 * n.steps[f] / level);
      return Rgb{{shade, static_cast<std::uint8_t>(shade / 2 + 60), 200}};
    });
  }

private:
  Image colored(const std::function<Rgb(Face)>& color) const
  {
    return render(make_scene(
                    mesh, true, color, [](Edge) { return false; }, 1, 0),
                  camera);
  }
};

} // namespace

std::string write_picture(const std::string& directory, const std::string& name, const std::vector<std::vector<Image> >& rows)
{
  const std::string file = (std::filesystem::path(directory) / name).string();
  std::ofstream os(file, std::ios::binary);
  os << png_bytes(in_rows(rows));
  if (!os.flush())
    throw Failure(file, "cannot be written");
  return file;
}

std::vector<std::string> write_figures(const Paper_model& model, const Mesh& mesh, const std::vector<Clustering_run>& runs,
                                       const std::string& directory)
{
  std::vector<std::string> written;
  const Artist artist(mesh, model.name == "Bunny" ? Vector(0.2, 0.35, 1) : Vector(1, 0.5, 0.8));
  const auto write = [&](const std::string& name, const std::vector<std::vector<Image> >& rows) {
    written.push_back(write_picture(directory, name, rows));
  };
  const auto clusters = [&](const std::vector<std::size_t>& labels, const std::string& caption) {
    return captioned(artist.clusters(labels), {caption});
  };
  const auto dual = [&](const Mesh& mesh, const std::string& caption) { return captioned(artist.dual(mesh), {caption}); };
  if (model.name == "Bunny") {
    const Clustering_run& run = runs[VARIANCE];
    const auto uniform = [&](double density) { return run_uniform_clustering(mesh, model.level, density); };
    const Clustering_run with_200 = uniform(200);
    // An ordinary diagram with densities: their range hardly changes it. The paper does not name the model of its figures 1b and
    // 1c.
    write("figure_1bc.png",
          {{clusters(uniform(50).labels, "(b) densities up to 50"), clusters(with_200.labels, "(c) densities up to 200")}});
    const Neighborhoods around = neighborhoods(mesh, run.seeds, model.level);
    const Clustering_run grown = run_clustering(mesh, model.level, VARIANCE, model.maximum_density[VARIANCE], false);
    write("figure_2.png", {{captioned(artist.seeds(around), {"(a) seeds, their neighborhoods"}),
                            clusters(run.labels_after_growth, "(b) after the growth"), dual(grown.dual, "(c) their dual")}});
    write("figure_3.png", {{artist.layers(around, model.level)}});
    // The stages of the algorithm. The paper does not say with which weight.
    write("figure_5.png", {{clusters(run.labels_after_growth, "(a) after the growth"),
                            clusters(run.labels, "(b) after the minimization"), dual(run.dual, "(c) their dual")}});
    // An ordinary diagram with densities up to 200 beside the variance weight.
    write("figure_6.png",
          {{clusters(with_200.labels, "(a) no weights, densities up to 200"), clusters(run.labels, "(b) density variance")}});
  }
  if (model.name == "Fandisk") {
    const std::array<std::string, 3> names = {{"weighted area", "maximum density", "density variance"}};
    std::vector<Image> above, below;
    for (const Paper_weight w : paper_weights) {
      above.push_back(clusters(runs[w].labels, std::string("(") + "abc"[w] + ") " + names[w]));
      below.push_back(dual(runs[w].dual, std::string("(") + "def"[w] + ") " + names[w]));
    }
    write("figure_7.png", {above, below});
  }
  return written;
}

} // namespace reproduce_paper
