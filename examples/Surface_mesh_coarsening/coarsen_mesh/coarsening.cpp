// SPDX-License-Identifier: GPL-3.0-or-later

#include "coarsening.h"

#include "io/Failure.h"
#include "io/Number_property.h"
#include "Stowed_halfedges.h"
#include "kept_vertices.h"
#include "named_energies.h"
#include "patches.h"
#include "written.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_levels.h>
#include <CGAL/Surface_mesh_coarsening/Mwcvd_clustering.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Closest_vertex_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Quadric_placement.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh_to_distance.h>
#include <CGAL/Surface_mesh_coarsening/compute_face_densities.h>
#include <CGAL/Surface_mesh_coarsening/parameters.h>
#include <CGAL/Surface_mesh_coarsening/transfer_properties.h>

#include <CGAL/tags.h>

#include <boost/property_map/function_property_map.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

namespace coarsen_mesh_tool {

namespace SMC = CGAL::Surface_mesh_coarsening;

namespace {

// Calls `use` with the placement in the options.
template <class Use>
void with_placement(const Options& options, const Use& use)
{
  if (options.placement == "centroid")
    use(SMC::Centroid_placement());
  else if (options.placement == "closest-vertex")
    use(SMC::Closest_vertex_placement());
  else if (options.placement == "quadric")
    use(SMC::Quadric_placement());
  else
    use(SMC::Fitted_placement(SMC::Fitted_placement::default_rounds, options.mean_angle));
}

// Has points of the mesh, with coordinates that single precision holds: the repair of the result sees them as they are written.
struct Single_precision_kernel : Kernel
{
  typedef float FT;
};

// Calls `use` with the placement in the options, and with the parameter for coordinates that the file of the result holds.
template <class Use>
void with_placement_and_traits(const Mesh& input, const Options& options, const Use& use)
{
  const bool rounds = rounds_coordinates(input, type_of(options, options.output));
  with_placement(options, [&](const auto& placement) {
    if (rounds)
      use(placement, SMC::parameters::geom_traits(Single_precision_kernel()));
    else
      use(placement, SMC::parameters::geom_traits(Kernel()));
  });
}

// Normals that are unit vectors stay such.
void keep_normals_normal(const Mesh& input, Mesh& result)
{
  const Normal_properties before(input), after(result);
  constexpr double tolerance = 1e-3; // of numbers that were written with few digits
  const auto length = [](const Normal_properties& n, Vertex v) { return std::hypot(n.x(v), n.y(v), n.z(v)); };
  if (!before || !after || std::any_of(input.vertices_begin(), input.vertices_end(),
                                       [&](Vertex v) { return std::abs(length(before, v) - 1) > tolerance; }))
    return;
  std::vector<double> lengths;
  for (const Vertex v : result.vertices())
    lengths.push_back(length(after, v));
  for (const char* name : {"v:nx", "v:ny", "v:nz"})
    use_numbers<Vertex>(result, name, [&](auto map) {
      typedef typename decltype(map)::value_type Number;
      for (const Vertex v : result.vertices())
        if (lengths[v] > 0)
          map[v] = static_cast<Number>(map[v] / lengths[v]);
    });
}

bool has_properties(const Mesh& mesh)
{
  static const Mesh plain;
  return mesh.properties<Vertex>() != plain.properties<Vertex>() || mesh.properties<Face>() != plain.properties<Face>() ||
         mesh.properties<Halfedge>() != plain.properties<Halfedge>();
}

// Colors are means, as numbers with fractions are; other whole numbers are labels.
void carry_properties(const Mesh& input, const std::vector<std::size_t>& labels, Mesh& result)
{
  if (!has_properties(input))
    return;
  std::map<std::string, SMC::Transfer_policy> policies;
  for (const char* name : {"red", "green", "blue", "alpha", "diffuse_red", "diffuse_green", "diffuse_blue"})
    for (const char* prefix : {"v:", "f:"})
      policies[std::string(prefix) + name] = SMC::Transfer_policy::INTERPOLATED;
  const auto clusters =
    boost::make_function_property_map<Face>([&](Face f) { return labels[static_cast<std::size_t>(f)]; });
  SMC::transfer_properties(input, clusters, result, policies);
  keep_normals_normal(input, result);
}

// Patches to be kept, of each face; none if all faces belong to one.
std::vector<std::int64_t> wanted_patches(const Mesh& input, const Options& options)
{
  if (options.patches.empty())
    return {};
  auto result = patches(input, options.patches);
  if (!result)
    throw Failure(options.input, "has no " +
                                   (options.patches == "material" || options.patches == "group" || options.patches == "solid" ||
                                        options.patches == "object"
                                      ? options.patches + "s"
                                      : "whole numbers '" + options.patches + "'") +
                                   " of faces, which --patches names");
  return std::move(*result);
}

auto patch_map(const std::vector<std::int64_t>& patch_of)
{
  return boost::make_function_property_map<Face>([&](Face f) { return patch_of.empty() ? std::int64_t(0) : patch_of[f]; });
}

auto kept_map(const std::vector<char>& is_kept)
{
  return boost::make_function_property_map<Vertex>([&](Vertex v) { return !is_kept.empty() && is_kept[v]; });
}

// Calls `use` with the placement and the parameters of the result, whose mesh, labels and report it fills. Then carries the
// properties over.
template <class Use>
void extract(const Mesh& input, const Options& options, const std::vector<std::int64_t>& patch_of, Coarsening_result& result,
             const Use& use)
{
  const auto is_on_line = result.mesh.add_property_map<Edge, bool>("e:is on a line", false).first;
  const auto is_corner = result.mesh.add_property_map<Vertex, bool>("v:is a corner", false).first;
  const auto patch = result.mesh.add_property_map<Face, std::int64_t>("f:patch", 0).first;
  with_placement_and_traits(input, options, [&](const auto& placement, const auto& traits) {
    use(placement, traits.edge_is_constrained_map(is_on_line).vertex_is_constrained_map(is_corner).face_patch_map(patch));
  });
  for (Vertex v : result.mesh.vertices()) {
    const auto around = result.mesh.halfedges_around_target(result.mesh.halfedge(v));
    result.vertices_on_features += is_corner[v] || std::any_of(around.begin(), around.end(), [&](Halfedge h) {
      return is_on_line[result.mesh.edge(h)];
    });
  }
  const std::vector<std::int64_t> patch_of_result(patch.begin(), patch.end());
  result.mesh.remove_all_property_maps();
  carry_properties(input, result.labels, result.mesh);
  if (!options.patches.empty())
    write_patches(input, patch_of, options.patches, patch_of_result, result.mesh);
}

std::size_t maximum_vertices(const Mesh& input, const Options& options)
{
  if (options.vertex_ratio)
    return static_cast<std::size_t>(
      (std::max)(std::round(*options.vertex_ratio * static_cast<double>(input.number_of_vertices())), 1.));
  return options.vertices.value_or((std::numeric_limits<std::size_t>::max)());
}

template <class NamedParameters>
void coarsen_to_distance(const Mesh& input, const Options& options, const std::vector<std::int64_t>& patch_of,
                         const NamedParameters& np, Coarsening_result& result)
{
  const double unit = options.distance_is_relative ? diagonal(input) : 1;
  result.labels.resize(input.number_of_faces());
  const auto clusters = boost::make_function_property_map<Face>(
    [&](Face f) -> std::size_t& { return result.labels[static_cast<std::size_t>(f)]; });
  extract(input, options, patch_of, result, [&](const auto& placement, const auto& np_out) {
    const SMC::Distance_report report = SMC::coarsen_mesh_to_distance<CGAL::Parallel_if_available_tag>(
      input, (std::min)(*options.maximum_distance * unit, (std::numeric_limits<double>::max)()),
      maximum_vertices(input, options), result.mesh, np.vertex_placement(placement).face_cluster_map(clusters), np_out);
    result.report = report.clustering;
    result.distance_bound = report.distance_bound;
    result.is_within_distance = report.is_within_distance;
  });
}

// Each level has half the vertices of the previous one, as long as the topology allows it.
template <class Clustering>
void make_levels(const Mesh& input, const Options& options, const Clustering& clustering, Coarsening_result& result)
{
  const SMC::Cluster_levels<Clustering> levels(clustering);
  std::vector<std::size_t> parents(clustering.number_of_clusters()), labels(input.number_of_faces());
  // The vertices of the result and of the finest level are ordered differently.
  const auto map = boost::make_function_property_map<Face>(
    [&](Face f) -> std::size_t& { return labels[static_cast<std::size_t>(f)]; });
  std::size_t n = levels.finest();
  for (std::size_t i = 0; i < options.levels && n / 2 >= levels.coarsest(); ++i) {
    Coarser_level level;
    levels.write_clusters(n / 2, map);
    if (i == 0) {
      level.parents.resize(n);
      for (std::size_t f = 0; f < labels.size(); ++f)
        if (result.labels[f] < n)
          level.parents[result.labels[f]] = labels[f];
    } else {
      levels.parents(n, n / 2, std::back_inserter(level.parents));
    }
    n /= 2;
    with_placement_and_traits(input, options, [&](const auto& placement, const auto& traits) {
      levels.extract_dual_mesh(n, level.mesh, placement, traits);
    });
    carry_properties(input, labels, level.mesh);
    result.levels.push_back(std::move(level));
  }
}

Coarsening_result coarsen_with(const SMC::Any_cluster_energy& energy, Mesh& input, const Options& options, Tool_visitor& visitor)
{
  Coarsening_result result;
  typedef SMC::Mwcvd_clustering<Mesh, SMC::Any_cluster_energy, CGAL::Parallel_if_available_tag> Clustering;
  const std::size_t rounds = options.rounds.value_or(Defaults::number_of_iterations);
  const std::vector<std::int64_t> patch_of = wanted_patches(input, options);
  const std::vector<char> is_kept = kept_vertices(input, options);
  const auto np = SMC::parameters::maximum_density(options.maximum_density)
                    .cluster_energy(energy)
                    .subdivide_input(options.subdivide)
                    .paper_rules(options.paper)
                    .repair_output(!options.paper)
                    .error_feedback(options.error_feedback)
                    .feature_angle(options.features.value_or(Defaults::feature_angle))
                    .face_patch_map(patch_map(patch_of))
                    .vertex_is_constrained_map(kept_map(is_kept))
                    .visitor(std::ref(visitor));
  if (options.maximum_distance) {
    coarsen_to_distance(input, options, patch_of,
                        np.number_of_iterations(rounds).convergence_tolerance(options.convergence_tolerance), result);
    return result;
  }
  Stowed_halfedges stowed(input); // restored after the clustering has freed its memory
  Clustering clustering(input, np);
  if (!has_properties(input)) // which are read at halfedges
    stowed.stow();
  with_placement(options, [&](const auto& placement) {
    clustering.choose_items_for(placement, rounds, options.convergence_tolerance);
  });
  if (options.vertices && options.neighborhood_level)
    clustering.seed_from_level(*options.neighborhood_level, *options.vertices);
  else if (options.vertices)
    clustering.seed_faces_or_cells(*options.vertices);
  else if (options.vertex_ratio)
    clustering.seed_from_ratio(*options.vertex_ratio, options.keep_small);
  else if (options.faces)
    clustering.seed_from_number_of_faces(*options.faces, rounds, options.convergence_tolerance);
  else
    clustering.seed_from_level(*options.neighborhood_level);
  clustering.grow();
  clustering.minimize(rounds, options.convergence_tolerance);
  extract(input, options, patch_of, result, [&](const auto& placement, const auto& np_out) {
    clustering.extract_embedded_dual_mesh(result.mesh, placement, np_out);
    result.report = clustering.report();
    for (Face f : input.faces())
      result.labels.push_back(clustering.cluster(f));
  });
  if (options.levels > 0)
    make_levels(input, options, clustering, result);
  return result;
}

SMC::Any_cluster_energy energy_of(const Options& options)
{
  const bool is_weighted = options.energy == default_energy();
  const std::string& wanted = is_weighted ? options.weight : options.energy;
  for (const auto& [name, energy] : is_weighted ? weighted_energies() : energies())
    if (name == wanted)
      return energy;
  throw Wrong_usage((is_weighted ? "there is no weight '" : "there is no energy '") + wanted + "'");
}

std::vector<std::string> names_of(const Named_energies& energies)
{
  std::vector<std::string> names;
  for (const auto& [name, energy] : energies)
    names.push_back(name);
  return names;
}

} // namespace

const std::vector<std::string>& energy_names()
{
  static const std::vector<std::string> names = names_of(energies());
  return names;
}

const std::vector<std::string>& weight_names()
{
  static const std::vector<std::string> names = names_of(weighted_energies());
  return names;
}

const std::vector<std::string>& placement_names()
{
  static const std::vector<std::string> names = {"centroid", "closest-vertex", "quadric", "fitted"};
  return names;
}

double diagonal(const Mesh& mesh)
{
  CGAL::Bbox_3 box;
  for (Vertex v : mesh.vertices())
    box += mesh.point(v).bbox();
  return std::hypot(box.x_span(), box.y_span(), box.z_span());
}

unsigned max_threads()
{
#ifdef CGAL_LINKED_WITH_TBB
  return unsigned(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
#else
  return 1;
#endif
}

std::string default_energy() { return energies().front().first; }

std::string default_weight() { return "area"; }

std::string default_placement() { return "fitted"; }

std::string level_file(const std::string& output, std::size_t level)
{
  std::filesystem::path file(output);
  const std::filesystem::path ending = file.extension();
  return file.replace_extension("." + std::to_string(level) + ending.string()).string();
}

SMC::Vertex_number_range range_of(const Mesh& input, const Options& options, Tool_visitor& visitor)
{
  const std::vector<std::int64_t> patch_of = wanted_patches(input, options);
  const std::vector<char> is_kept = kept_vertices(input, options);
  const auto patches = patch_map(patch_of);
  const auto kept = kept_map(is_kept);
  return SMC::vertex_number_range(input, SMC::parameters::subdivide_input(options.subdivide)
                                           .feature_angle(options.features.value_or(Defaults::feature_angle))
                                           .face_patch_map(patches)
                                           .vertex_is_constrained_map(kept)
                                           .visitor(std::ref(visitor)));
}

std::vector<double> face_densities(const Mesh& input, const Options& options)
{
  std::vector<double> densities(input.number_of_faces());
  const auto map = boost::make_function_property_map<Face>(
    [&](Face f) -> double& { return densities[static_cast<std::size_t>(f)]; });
  SMC::compute_face_densities(
    input, map, SMC::parameters::maximum_density(options.maximum_density).paper_rules(options.paper));
  return densities;
}

Coarsening_result coarsen(Mesh& input, const Options& options, Tool_visitor& visitor)
{
  return coarsen_with(energy_of(options), input, options, visitor);
}

} // namespace coarsen_mesh_tool
