// SPDX-License-Identifier: GPL-3.0-or-later
//
// Times each stage of the coarsening, and the whole, on generated meshes of several sizes and on the models found at
// configuration. `faces/s` counts the faces of the input; `per_face` is its reciprocal.

#include "found_models.h"
#include "support/models.h"

#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>

#include <benchmark/benchmark.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace {

namespace SMC = CGAL::Surface_mesh_coarsening;
using coarsening_support::Mesh;
typedef SMC::Mwcvd_clustering<Mesh> Clustering;

// A practical number of vertices per cluster.
constexpr std::size_t vertices_per_cluster = 50;

std::size_t number_of_clusters(const Mesh& mesh) { return mesh.number_of_vertices() / vertices_per_cluster; }

// Meshes are generated at first use; only the last one is kept, as they may be large.
class Model
{
public:
  Model(const std::string& name, const std::function<Mesh()>& make) : name_(name), make_(make) {}
  const std::string& name() const { return name_; }
  const Mesh& mesh() const
  {
    static const Model* current = nullptr;
    static Mesh mesh;
    if (current != this) {
      mesh.clear();
      mesh = make_();
      current = this;
    }
    return mesh;
  }

private:
  std::string name_;
  std::function<Mesh()> make_;
};

std::vector<std::unique_ptr<Model> > all_models()
{
  using namespace generated;
  std::vector<std::unique_ptr<Model> > models;
  const auto add = [&models](const std::string& name, const std::function<Mesh()>& make) {
    models.push_back(std::make_unique<Model>(name, make));
  };
  const auto add_soup = [&add](const std::string& name, const std::function<Soup()>& make) {
    add(name, [make] { return benchmark_support::generated_mesh(make()); });
  };
  // An ellipsoid, as on a sphere all densities would be nearly the same.
  for (const unsigned level : {5u, 7u, 8u, 9u})
    add_soup("sphere_" + std::to_string(8u << (2 * level)), [level] {
      return scaled(triangle_sphere(level), 3, 2, 1);
    });
  for (const std::size_t n : {100, 300, 600, 1200})
    add_soup("torus_" + std::to_string(2 * n * n), [n] { return triangulated(torus(n, n)); });
  for (const auto& found : benchmark_support::found_models)
    if (!found.second.empty())
      add(found.first, [file = found.second] { return benchmark_support::read_model(file); });
  return models;
}

void count(benchmark::State& state, const Mesh& mesh)
{
  const double faces = double(mesh.number_of_faces()) * double(state.iterations());
  state.counters["faces"] = double(mesh.number_of_faces());
  state.counters["faces/s"] = benchmark::Counter(faces, benchmark::Counter::kIsRate);
  state.counters["per_face"] =
    benchmark::Counter(faces, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

// Checks, flat copies and densities.
void prepare(benchmark::State& state, const Model& model)
{
  const Mesh& mesh = model.mesh();
  for (auto _ : state) {
    const Clustering clustering(mesh);
    benchmark::DoNotOptimize(clustering.number_of_clusters());
  }
  count(state, mesh);
}

// The seeds only: the arrays exist.
void walk_for_seeds(benchmark::State& state, const Model& model, std::size_t level)
{
  const Mesh& mesh = model.mesh();
  Clustering clustering(mesh);
  std::size_t seeds = 0;
  for (auto _ : state)
    seeds = clustering.seed_from_level(level);
  count(state, mesh);
  state.counters["seeds"] = double(seeds);
}

void seed_for_number(benchmark::State& state, const Model& model)
{
  const Mesh& mesh = model.mesh();
  Clustering clustering(mesh);
  for (auto _ : state)
    clustering.seed(number_of_clusters(mesh));
  count(state, mesh);
}

void grow(benchmark::State& state, const Model& model)
{
  const Mesh& mesh = model.mesh();
  Clustering clustering(mesh);
  for (auto _ : state) {
    state.PauseTiming();
    clustering.seed(number_of_clusters(mesh));
    state.ResumeTiming();
    clustering.grow();
  }
  count(state, mesh);
}

void minimize(benchmark::State& state, const Model& model)
{
  const Mesh& mesh = model.mesh();
  Clustering clustering(mesh);
  for (auto _ : state) {
    state.PauseTiming();
    clustering.seed(number_of_clusters(mesh));
    clustering.grow();
    state.ResumeTiming();
    clustering.minimize();
  }
  count(state, mesh);
  state.counters["rounds"] = double(clustering.report().rounds);
  state.counters["tests"] = double(clustering.report().tests);
}

void triangulate(benchmark::State& state, const Model& model)
{
  const Mesh& mesh = model.mesh();
  Clustering clustering(mesh);
  clustering.seed(number_of_clusters(mesh));
  clustering.grow();
  clustering.minimize();
  Mesh output;
  for (auto _ : state)
    clustering.extract_dual_mesh(output, SMC::Centroid_placement());
  count(state, mesh);
}

void whole(benchmark::State& state, const Model& model)
{
  const Mesh& mesh = model.mesh();
  Mesh output;
  for (auto _ : state)
    SMC::coarsen_mesh(mesh, number_of_clusters(mesh), output);
  count(state, mesh);
}

void add_benchmarks(const Model& model)
{
  const auto add = [&model](const std::string& name, const std::function<void(benchmark::State&, const Model&)>& run) {
    benchmark::RegisterBenchmark((name + "/" + model.name()).c_str(), [run, &model](benchmark::State& state) {
      run(state, model);
    })->Unit(benchmark::kMillisecond);
  };
  add("preparation", prepare);
  for (const std::size_t level : {3, 30})
    add("seeds_of_level_" + std::to_string(level),
        [level](benchmark::State& state, const Model& m) { walk_for_seeds(state, m, level); });
  add("seeds_for_number", seed_for_number);
  add("growth", grow);
  add("minimization", minimize);
  add("triangulation", triangulate);
  add("whole", whole);
}

} // namespace

int main(int argc, char** argv)
{
  const auto models = all_models();
  for (const auto& model : models)
    add_benchmarks(*model);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
