// SPDX-License-Identifier: GPL-3.0-or-later

#include "sketches.h"

#include "Paper_model.h"
#include "figures.h"

#include "io/to_mesh.h"
#include "render/captioned.h"
#include "render/render.h"

#include <CGAL/Surface_mesh_coarsening/Mwcvd_clustering.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Minimization_state.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace reproduce_paper {
namespace {

namespace SMC = CGAL::Surface_mesh_coarsening;

// A vertex of the lattice of equilateral triangles, and a triangle that points up or down.
using Place = std::array<int, 2>;
struct Cell
{
  Place corner;
  bool is_up;
  char cluster; // of the color: 'r', 'g' or 'y'
};

const Place v1 = {{0, 0}}, v2 = {{0, 1}}, v3 = {{1, 0}};

Point point_of(const Place& p) { return Point(p[0] + 0.5 * p[1], std::sqrt(0.75) * p[1], 0); }

std::array<Place, 3> corners_of(const Cell& t)
{
  const int i = t.corner[0], j = t.corner[1];
  if (t.is_up)
    return {{{{i, j}}, {{i + 1, j}}, {{i, j + 1}}}};
  return {{{{i + 1, j}}, {{i + 1, j + 1}}, {{i, j + 1}}}};
}

std::size_t number_of(char cluster) { return std::string("rgy").find(cluster); }

Rgb color_of(char cluster)
{
  static const std::array<std::size_t, 3> colors = {3, 2, 5}; // red, green and yellow of the palette
  return palette_color(colors[number_of(cluster)]);
}

// A patch of cells around the triangle v1, v3, v2, whose edge c leads from v1 to v3.
class Patch
{
public:
  explicit Patch(const std::vector<Cell>& cells) : cells_(cells)
  {
    Soup soup;
    for (const Cell& cell : cells) {
      std::vector<std::size_t> polygon;
      for (const Place& p : corners_of(cell)) {
        const auto found = vertices_.emplace(p, soup.points.size());
        if (found.second)
          soup.points.push_back(point_of(p));
        polygon.push_back(found.first->second);
      }
      soup.polygons.push_back(polygon);
    }
    mesh_ = to_mesh(soup);
  }

  const Mesh& mesh() const { return mesh_; }

  // Cells with thin edges, bold edges between clusters, and c in bolder ink.
  Scene scene() const
  {
    const auto cluster = [this](Face f) { return cells_[f].cluster; };
    Scene scene = make_scene(
      mesh_, false, [&](Face f) { return color_of(cluster(f)); }, [](Edge) { return true; }, 2, 0.4);
    for (Edge e : mesh_.edges()) {
      const Halfedge h = mesh_.halfedge(e, 0), g = mesh_.opposite(h);
      if (!mesh_.is_border(e) && cluster(mesh_.face(h)) != cluster(mesh_.face(g)))
        scene.lines.push_back({mesh_.vertex(e, 0), mesh_.vertex(e, 1), 7, 0.6});
    }
    scene.lines.push_back({vertices_.at(v1), vertices_.at(v3), 13, 1});
    return scene;
  }

private:
  std::vector<Cell> cells_;
  std::map<Place, std::size_t> vertices_;
  Mesh mesh_;
};

// A point of the patch, and what is written there.
typedef std::vector<std::pair<Point, std::string> > Notes;

Image drawn(const Patch& patch, const Notes& notes, const std::vector<std::string>& caption)
{
  const Camera camera(std::vector<Point>(patch.mesh().points().begin(), patch.mesh().points().end()), Vector(0, 0, 1),
                      Vector(0, 1, 0), 560);
  Image image = render(patch.scene(), camera);
  for (const auto& note : notes) {
    const Stroke_text text(note.second, text_height);
    const Vector at = camera(note.first);
    text.draw(image, std::size_t(at.x()) - text.width() / 2, image.height - std::size_t(at.y()) - text.height() / 2);
  }
  return captioned(image, caption);
}

// A hexagon around edge c, with a red cluster below and a green cluster above.
std::vector<Cell> two_clusters()
{
  std::vector<Cell> cells;
  for (int j = -4; j < 4; ++j)
    for (int i = -6; i < 6; ++i)
      for (const bool is_up : {true, false}) {
        const Cell cell{{{i, j}}, is_up, j < 0 ? 'r' : 'g'};
        bool is_inside = true;
        for (const Place& p : corners_of(cell))
          is_inside = is_inside && std::hypot(point_of(p).x() - 0.5, point_of(p).y()) < 2.6;
        if (is_inside)
          cells.push_back(cell);
      }
  return cells;
}

// Figure 1a: the three configurations whose energies are compared.
std::vector<std::vector<Image> > figure_1a()
{
  const Notes notes = {
    {Point(0.5, 0.29, 0), "cm"}, {Point(0.5, -0.29, 0), "cn"}, {Point(0.5, 1.44, 0), "vl"}, {Point(0.5, -1.44, 0), "vk"}};
  const auto panel = [&](const Place& moved, bool is_up, char cluster, const std::string& caption) {
    std::vector<Cell> cells = two_clusters();
    for (Cell& cell : cells)
      if (cell.corner == moved && cell.is_up == is_up)
        cell.cluster = cluster;
    return drawn(Patch(cells), notes, {caption});
  };
  return {
    {panel({{0, 0}}, true, 'g', "as it is"), panel({{0, 0}}, true, 'r', "vk grows"), panel({{0, -1}}, false, 'g', "vl grows")}};
}

// A configuration of figure 4. `clusters` has the clusters of the face above c, of its neighbors across n, p and c, and of the
// other faces around v1, v3 and v2, each time counterclockwise around the face.
struct Configuration
{
  std::string name, clusters;
};

std::vector<Cell> cells_of(const Configuration& configuration)
{
  std::vector<Cell> cells = {{{{0, 0}}, true, 'g'},   {{{-1, 0}}, false, 'g'},  {{{0, 0}}, false, 'g'}, {{{0, -1}}, false, 'g'},
                             {{{-1, 0}}, true, 'g'},  {{{-1, -1}}, false, 'g'}, {{{0, -1}}, true, 'g'}, {{{1, -1}}, true, 'g'},
                             {{{1, -1}}, false, 'g'}, {{{1, 0}}, true, 'g'},    {{{0, 1}}, true, 'g'},  {{{-1, 1}}, false, 'g'},
                             {{{-1, 1}}, true, 'g'}};
  std::size_t i = 0;
  for (const char cluster : configuration.clusters)
    if (cluster != ' ')
      cells[i++].cluster = cluster;
  return cells;
}

Image drawn(const Configuration& configuration)
{
  const std::vector<Cell> cells = cells_of(configuration);
  const Patch patch(cells);
  const SMC::Mwcvd_clustering<Mesh> clustering(patch.mesh()); // for its arrays
  SMC::internal::Cluster_labels labels(clustering.state().working_input().mesh);
  for (std::size_t f = 0; f < cells.size(); ++f)
    labels.set(SMC::internal::Index(f), SMC::internal::Index(number_of(cells[f].cluster)));
  labels.recount();
  const SMC::internal::Valid_moves moves(labels, nullptr);
  const auto answer = [](bool is_allowed) { return std::string(is_allowed ? "allowed" : "refused"); };
  const SMC::internal::Index red = SMC::internal::Index(number_of('r'));
  const Notes notes = {{Point(-0.26, 0.15, 0), "v1"}, {Point(1.26, 0.15, 0), "v3"}, {Point(0.5, 1.27, 0), "v2"},
                       {Point(0.5, 0.13, 0), "c"}, {Point(0.38, 0.42, 0), "n"}, {Point(0.62, 0.42, 0), "p"}};
  return drawn(patch, notes,
               {configuration.name, "paper " + answer(moves.boundary_counts_allow(0, red)),
                "discs " + answer(moves.keeps_discs(0, red)), ""});
}

// Figure 4: may the red cluster grow across c? Case by case, then the three situations that the check prevents, and one that it
// does not prevent: the green cluster vanishes.
std::vector<std::vector<Image> > figure_4()
{
  const std::vector<std::vector<Configuration> > rows = {
    {{"case 0", "gggr grr ryg ggg"}, {"case 1", "grgr rrr ryg ggg"}, {"case 2", "ggrr grr rrr ggg"}},
    {{"case 3", "gygr yrr rrg ggy"}, {"case 4", "ggyr grr ryy ygg"}, {"a, one face", "gyyr yrr rry yyy"}},
    {{"b, two parts", "gggr grr rrg gyg"}, {"c, a ring", "gygr yrr rrg gry"}, {"one face vanishes", "gryr rrr ryy yyr"}}};
  std::vector<std::vector<Image> > images;
  for (const auto& row : rows) {
    images.emplace_back();
    for (const Configuration& configuration : row)
      images.back().push_back(drawn(configuration));
  }
  return images;
}

} // namespace

std::vector<std::string> write_sketches(const std::string& directory)
{
  return {write_picture(directory, "figure_1a.png", figure_1a()), write_picture(directory, "figure_4.png", figure_4())};
}

} // namespace reproduce_paper
