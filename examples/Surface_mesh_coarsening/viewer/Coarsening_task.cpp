// SPDX-License-Identifier: GPL-3.0-or-later

#include "Coarsening_task.h"

#include "named_energies.h"
#include "render/face_distances.h"
#include "report/Timing_visitor.h"

#include <CGAL/Surface_mesh_coarsening/Mwcvd_clustering.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Closest_vertex_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Quadric_placement.h>
#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/parameters.h>
#include <CGAL/Surface_mesh_coarsening/vertex_number_range.h>

#include <chrono>
#include <functional>

namespace coarsening_viewer {

namespace SMC = CGAL::Surface_mesh_coarsening;

class Coarsening_task::Visitor : public SMC::Coarsening_visitor_base
{
  Coarsening_task& task_;

public:
  explicit Visitor(Coarsening_task& task) : task_(task) {}

  void stage_begins(SMC::Coarsening_stage stage) { task_.say(stage_name(stage)); }
  void round_done(std::size_t round, std::size_t, double) { task_.say("minimization, round " + std::to_string(round)); }
  void step_done(SMC::Coarsening_stage stage, std::size_t done, std::size_t total)
  {
    task_.say(stage_name(stage) + ", " + std::to_string(done) + " of " + std::to_string(total));
  }
  bool go_further() { return !task_.is_cancelled_; }
};

namespace {

SMC::Any_cluster_energy energy_of(const Choice& choice)
{
  using coarsen_mesh_tool::weighted_energy;
  switch (choice.weight) {
  case 0:
    return weighted_energy<SMC::Uniform_weight>();
  case 1:
    return weighted_energy<SMC::Weighted_area_weight>();
  case 2:
    return weighted_energy<SMC::Maximum_density_weight>();
  default:
    return weighted_energy<SMC::Density_variance_weight>();
  }
}

double maximum_density_of(const Choice& choice)
{
  constexpr double of_variance = 3;
  return choice.weight < 3 ? SMC::Coarsening_defaults::maximum_density : of_variance;
}

template <class Visitor>
void coarsen(const Mesh& input, Visitor& visitor, Coarse& result)
{
  SMC::Mwcvd_clustering<Mesh, SMC::Any_cluster_energy> clustering(
    input, SMC::parameters::cluster_energy(energy_of(result.choice))
             .maximum_density(maximum_density_of(result.choice))
             .visitor(std::ref(visitor)));
  clustering.seed(result.choice.vertices);
  clustering.grow();
  clustering.minimize();
  switch (result.choice.placement) {
  case 0:
    clustering.extract_embedded_dual_mesh(result.mesh, SMC::Centroid_placement());
    break;
  case 1:
    clustering.extract_embedded_dual_mesh(result.mesh, SMC::Closest_vertex_placement());
    break;
  case 2:
    clustering.extract_embedded_dual_mesh(result.mesh, SMC::Quadric_placement());
    break;
  default:
    clustering.extract_embedded_dual_mesh(result.mesh, SMC::Fitted_placement());
  }
  for (Face f : input.faces())
    result.labels.push_back(clustering.cluster(f));
}

template <class Visitor>
Coarse coarsened(const Mesh& input, const Choice& choice, Visitor& visitor)
{
  Coarse result;
  result.choice = choice;
  coarsen(input, visitor, result);
  const auto poll = [&visitor] {
    if (!visitor.go_further())
      throw SMC::Coarsening_cancelled();
  };
  result.distances = face_distances(input, result.mesh, poll);
  poll();
  result.quality = SMC::measure_coarsening(input, result.mesh);
  return result;
}

} // namespace

std::pair<std::size_t, std::size_t> vertex_numbers(const Mesh& input)
{
  const SMC::Vertex_number_range range = SMC::vertex_number_range(input);
  return {range.least, range.most};
}

void Coarsening_task::start(const Choice& choice)
{
  cancel();
  is_cancelled_ = false;
  result_ = std::async(std::launch::async, [this, choice] {
    Visitor visitor(*this);
    return coarsened(input_, choice, visitor);
  });
}

void Coarsening_task::cancel()
{
  is_cancelled_ = true;
  if (result_.valid())
    result_.wait();
  result_ = {};
}

void Coarsening_task::say(const std::string& what)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  progress_ = what;
}

std::string Coarsening_task::progress() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return progress_;
}

std::optional<Coarse> Coarsening_task::result()
{
  if (!result_.valid() || result_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
    return std::nullopt;
  return result_.get();
}

} // namespace coarsening_viewer
