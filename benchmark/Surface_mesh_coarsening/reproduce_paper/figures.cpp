// SPDX-License-Identifier: GPL-3.0-or-later

#include "figures.h"

#include "io/Failure.h"
#include "render/png_bytes.h"
#include "render/render.h"

#include <filesystem>
#include <fstream>

namespace reproduce_paper {
namespace {

// Renders panels of one model from one viewpoint.
class Artist
{
  const Mesh& mesh;
  Camera camera;

public:
  Artist(const Mesh& mesh, const Vector& view)
    : mesh(mesh),
      camera(std::vector<Point>(mesh.points().begin(), mesh.points().end()), view, Vector(0, 1, 0), 800)
  {}

  Image clusters(const std::vector<std::size_t>& labels) const { return render(cluster_scene(mesh, labels), camera); }
  Image dual(const Mesh& dual) const { return render(mesh_scene(dual), camera); }
};

std::string write_picture(const std::string& directory, const std::string& name,
                          const std::vector<std::vector<Image> >& rows)
{
  const std::string file = (std::filesystem::path(directory) / name).string();
  std::ofstream os(file, std::ios::binary);
  os << png_bytes(in_rows(rows));
  if (!os.flush())
    throw Failure(file, "cannot be written");
  return file;
}

} // namespace

std::vector<std::string> write_figures(const Paper_model& model, const Mesh& mesh,
                                       const std::vector<Clustering_run>& runs, const std::string& directory)
{
  std::vector<std::string> written;
  const Artist artist(mesh, Vector(1, 0.5, 0.8));
  if (model.name == "Bunny") {
    // The stages of the algorithm. The paper does not name the weight.
    const Clustering_run& run = runs[VARIANCE];
    written.push_back(
      write_picture(directory, "figure_5.png",
                    {{artist.clusters(run.labels_after_growth), artist.clusters(run.labels), artist.dual(run.dual)}}));
    // An ordinary diagram with densities up to 200 beside the variance weight.
    const Clustering_run uniform = run_uniform_clustering(mesh, model.level, 200);
    written.push_back(
      write_picture(directory, "figure_6.png", {{artist.clusters(uniform.labels), artist.clusters(run.labels)}}));
  }
  if (model.name == "Fandisk") {
    std::vector<Image> clusters, duals;
    for (const Clustering_run& run : runs) {
      clusters.push_back(artist.clusters(run.labels));
      duals.push_back(artist.dual(run.dual));
    }
    written.push_back(write_picture(directory, "figure_7.png", {clusters, duals}));
  }
  return written;
}

} // namespace reproduce_paper
