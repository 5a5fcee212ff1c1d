// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_MWCVD_CLUSTERING_H
#define CGAL_SURFACE_MESH_COARSENING_MWCVD_CLUSTERING_H

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Uniform_weight.h>
#include <CGAL/Surface_mesh_coarsening/Clustering_steering.h>
#include <CGAL/Surface_mesh_coarsening/Coarsening_report.h>
#include <CGAL/Surface_mesh_coarsening/Dual_extraction.h>
#include <CGAL/Surface_mesh_coarsening/internal/pipeline/Clustering_access.h>
#include <CGAL/Surface_mesh_coarsening/internal/minimization/Energy_minimization.h>
#include <CGAL/Surface_mesh_coarsening/internal/seeding/Initial_clustering.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/Labelled_pieces.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/Visitor_handle.h>
#include <CGAL/Surface_mesh_coarsening/internal/clusters/Clustering_check.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>
#include <CGAL/Surface_mesh_coarsening/internal/base/parallel.h>
#include <CGAL/Surface_mesh_coarsening/internal/features/read_features.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {

/// \ingroup PkgSurfaceMeshCoarseningRef
/// clusters the faces of a polygon mesh by a multiplicatively weighted centroidal Voronoi diagram, step by step.
///
/// The steps are those of the paper, in this order: `seed()` or `seed_from_level()`, then `grow()`, then any number of
/// rounds of the minimization. From `grow()` on the clustering is valid after every step: each cluster is a closed disc,
/// and the dual is a triangulated 2-manifold with one vertex per cluster and, component by component, the genus, the
/// number of border loops and the orientation of the mesh.
///
/// The mesh is only read, and only by the constructor, `set_clusters()` and the functions that write into property maps.
///
/// \tparam FaceGraph a model of `FaceListGraph`
/// \tparam ClusterWeight a model of `ClusterWeight`
/// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`; the clusters are the
/// same, whichever it is
template <class FaceGraph, class ClusterWeight = Maximum_density_weight, class ConcurrencyTag = Sequential_tag>
class Mwcvd_clustering
  : public Clustering_steering<Mwcvd_clustering<FaceGraph, ClusterWeight, ConcurrencyTag> >,
    public Dual_extraction<Mwcvd_clustering<FaceGraph, ClusterWeight, ConcurrencyTag> >
{
  typedef boost::graph_traits<FaceGraph> Graph_traits;
  typedef internal::Index Index;
  static constexpr internal::Execution execution_ = internal::execution<ConcurrencyTag>();

public:
  /// The face descriptor of the mesh.
  typedef typename Graph_traits::face_descriptor face_descriptor;
  /// The vertex descriptor of the mesh.
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;

  /// checks the mesh, and computes or reads the densities of its faces.
  ///
  /// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
  /// \param mesh a 2-manifold polygon mesh
  /// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `face_density_map`,
  /// `maximum_density`, `border_densities`, `cluster_weight`, `minimum_component_area`, `subdivide_input`,
  /// `repair_output`, `feature_angle`, `edge_is_constrained_map`, `vertex_is_constrained_map`, `face_patch_map`,
  /// `vertex_point_map`, `face_index_map`, `geom_traits` and `visitor`, as `coarsen_mesh()` describes them
  /// \throws Invalid_input if the mesh has no faces, is not a 2-manifold, has a coordinate that is not finite, or if a
  /// parameter is out of range.
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Mwcvd_clustering(const FaceGraph& mesh, const NamedParameters& np = parameters::default_values())
    : weight_(internal::choose_parameter<ClusterWeight>(
        internal::get_parameter(np, internal_np::cluster_weight_p))),
      visitor_(internal::get_parameter(np, CGAL::internal_np::visitor))
  {
    visitor_.stage_begins(Coarsening_stage::PREPARATION);
    const internal::Cancellation_point cancellation(visitor_);
    numbering_ = internal::numbering(mesh, np, cancellation);
    input_ = internal::clustering_input(mesh, np, numbering_, frame_, cancellation, execution_);
    subdivide_ = internal::choose_parameter(internal::get_parameter(np, internal_np::subdivide_input_p), false);
    repair_ = internal::choose_parameter(internal::get_parameter(np, internal_np::repair_output_p), true);
    dropped_components_ = internal::drop_small_components(np, frame_, input_, cancellation);
    internal::read_features(mesh, np, numbering_, input_, frame_, patches_, cancellation);
    visitor_.stage_ends(Coarsening_stage::PREPARATION);
  }

  /// \cond SKIP_IN_MANUAL
  Mwcvd_clustering(const Mwcvd_clustering&) = delete; // its parts refer to each other
  Mwcvd_clustering& operator=(const Mwcvd_clustering&) = delete;
  /// \endcond

  /// \name Seeds and growth (sections 6 and 8.1)
  /// @{

  /// finds seeds from which `grow()` makes exactly `number_of_clusters` clusters: those of the highest level that gives
  /// twice as many, or as many where the mesh is too coarse for that, component by component, the number being shared out by
  /// mass, which is area times density.
  /// \return the number of seeds
  /// \throws Unreachable_number_of_vertices if the mesh has fewer vertices, or if its topology does not allow so few.
  std::size_t seed(std::size_t number_of_clusters)
  {
    return seed_as([this, number_of_clusters](internal::Initial_clustering& initial) {
      if (subdivide_)
        initial.subdivide(faces_per_cluster * number_of_clusters);
      initial.seed(number_of_clusters);
    });
  }

  /// The number of faces for each cluster that subdivision provides, if parameter `subdivide_input` asks for it. Clusters of
  /// so many faces can be round.
  static constexpr std::size_t faces_per_cluster = 20;

  /// takes all seeds whose neighborhoods of `level` steps are disjoint.
  /// \return the number of seeds, which is the number of clusters that `grow()` makes, unless the topology of the mesh
  /// needs more
  std::size_t seed_from_level(std::size_t level)
  {
    return seed_as([level](internal::Initial_clustering& initial) {
      initial.seed_from_level(Index((std::min)(level, std::size_t(internal::NONE / 4))));
    });
  }

  /// grows the clusters from the seeds, a layer a round, until they cover the mesh.
  /// \pre `seed()` or `seed_from_level()` was called.
  /// \throws std::logic_error if it was not.
  void grow()
  {
    if (!initial_)
      throw std::logic_error("grow() was called before seed()");
    visitor_.stage_begins(Coarsening_stage::GROWTH);
    this->forget_editing();
    minimization_.reset();
    labels_.reset();
    all_or_nothing([&] { labels_ = std::make_unique<internal::Cluster_labels>(initial_->grow()); });
    begin_minimization(report_.clusters);
    visitor_.stage_ends(Coarsening_stage::GROWTH);
  }

  /// takes the clusters from a property map instead of growing them.
  ///
  /// \tparam FaceClusterMap a model of `ReadablePropertyMap` with the faces as keys and an integral value type
  /// \param clusters the clusters, numbered from 0 without gaps
  /// \throws Invalid_input if a label is missing or out of range, or if the clustering is not valid in the sense of
  /// `is_valid_clustering()`, or if there are features to be kept.
  template <class FaceClusterMap>
  void set_clusters(const FaceClusterMap& clusters)
  {
    if (input_.cells)
      throw Invalid_input("clusters cannot be taken over where features are kept");
    forget();
    std::size_t number = 0;
    auto labels = std::make_unique<internal::Cluster_labels>(input_.mesh);
    for (std::size_t i = 0; i < input_.mesh.number_of_faces(); ++i) {
      const std::size_t label = std::size_t(get(clusters, numbering_.faces[input_.parent_of(Index(i))]));
      if (label >= numbering_.faces.size())
        throw Invalid_input("the cluster of face " + std::to_string(i) + " is " + std::to_string(label) +
                            " in a mesh of " + std::to_string(numbering_.faces.size()) + " faces");
      number = (std::max)(number, label + 1);
      labels->set(Index(i), Index(label));
    }
    const std::string fault = internal::Clustering_check(*labels, number).fault(
      [](std::size_t x) { return "cluster " + std::to_string(x); });
    if (!fault.empty())
      throw Invalid_input(fault);
    labels->recount();
    reset_report();
    report_.clusters = number;
    labels_ = std::move(labels);
    begin_minimization(number);
  }
  /// @}

  /// \name Minimization (sections 5.1 and 8.2)
  /// \pre `grow()` or `set_clusters()` was called; `std::logic_error` is thrown otherwise.
  /// @{

  /// runs one round: compares, for each edge between two clusters, the energy as it is with that after the face on one
  /// side has joined the cluster across, and with that after the other has.
  /// \return whether anything changed
  bool minimize_round()
  {
    this->forget_editing();
    const std::size_t tests_before = minimization().tests();
    const std::size_t moves = minimization_->round();
    iterations_ = (std::max)(iterations_, ++report_.rounds);
    report_.moves += moves;
    report_.tests += minimization_->tests() - tests_before;
    report_.final_energy = minimization_->energy();
    report_.converged = moves == 0;
    visitor_.round_done(report_.rounds, moves, report_.final_energy);
    return moves != 0;
  }

  /// runs rounds until one changes nothing, or until `number_of_iterations` have been run.
  void minimize(std::size_t number_of_iterations = default_number_of_iterations)
  {
    minimization();
    iterations_ = number_of_iterations;
    visitor_.stage_begins(Coarsening_stage::MINIMIZATION);
    for (std::size_t i = 0; i < number_of_iterations && minimize_round(); ++i)
      ;
    visitor_.stage_ends(Coarsening_stage::MINIMIZATION);
  }

  /// The number of rounds after which `minimize()` ends if it is not told otherwise. Energy falls with each move, so
  /// rounds come to an end by themselves; meshes that need more than some hundred are rare.
  static constexpr std::size_t default_number_of_iterations = 1000;

  /// returns the energy (8) of the clustering, in the sixth (weighted area) or fourth power of the unit of length.
  double energy() const { return minimization().energy(); }
  /// @}

  /// \name Results
  /// @{

  /// returns the number of clusters.
  std::size_t number_of_clusters() const { return report_.clusters; }

  /// returns what has been done so far, in numbers.
  const Coarsening_report& report() const { return report_; }

  /// writes the seeds: before `grow()` those found, after it one face for each cluster.
  template <class OutputIterator>
  OutputIterator seeds(OutputIterator out) const
  {
    if (initial_)
      for (const Index f : initial_->seeds())
        *out++ = numbering_.faces[working_input().parent_of(f)];
    return out;
  }

  /// returns the cluster of a face. Where the faces of a component had to be subdivided internally, it is the cluster of the
  /// largest part of the face. Faces of components that were dropped get `number_of_clusters()`.
  std::size_t cluster(face_descriptor f) const { return cluster_of_face(numbering_.number_of(f)); }

  /// writes the cluster of each face, see `cluster()`.
  /// \tparam FaceClusterMap a model of `WritablePropertyMap` with the faces as keys and an integral value type
  template <class FaceClusterMap>
  void write_clusters(FaceClusterMap clusters) const
  {
    typedef typename boost::property_traits<FaceClusterMap>::value_type Value;
    for (std::size_t i = 0; i < numbering_.faces.size(); ++i)
      put(clusters, numbering_.faces[i], Value(cluster_of_face(Index(i))));
  }

  /// writes the boundary-edge count (section 7) of each vertex: the number of edges at it between two clusters or on the
  /// border.
  /// \tparam VertexBoundaryCountMap a model of `WritablePropertyMap` with the vertices as keys and an integral value type
  template <class VertexBoundaryCountMap>
  void write_boundary_counts(VertexBoundaryCountMap counts) const
  {
    typedef typename boost::property_traits<VertexBoundaryCountMap>::value_type Value;
    for (std::size_t i = 0; i < numbering_.vertices.size(); ++i)
      put(counts, numbering_.vertices[i], Value(labels().boundary_count(Index(i))));
  }

  /// \cond SKIP_IN_MANUAL
  // Gives back what only the minimization needs.
  void end_minimization() { minimization_.reset(); }
  /// \endcond
  /// @}

private:
  friend struct internal::Clustering_access;

  typedef std::function<void(internal::Initial_clustering&)> Seeding;
  static constexpr bool depends_on_densities = !std::is_same<ClusterWeight, Uniform_weight>::value;

  std::size_t seed_as(const Seeding& seed)
  {
    visitor_.stage_begins(Coarsening_stage::SEEDING);
    forget();
    reset_report();
    seeding_ = seed;
    iterations_ = 0;
    initial_ =
      std::make_unique<internal::Initial_clustering>(input_, report_, internal::Cancellation_point(visitor_), execution_);
    all_or_nothing([&] { seed(*initial_); });
    visitor_.stage_ends(Coarsening_stage::SEEDING);
    return report_.seeds;
  }

  void reset_report()
  {
    report_ = Coarsening_report();
    report_.dropped_components = dropped_components_;
    internal::count_features(input_, report_);
  }

  // A step that fails, or is cancelled, leaves nothing to go on from: that begins with seeds or labels again.
  template <class Step>
  void all_or_nothing(const Step& step)
  {
    try {
      step();
    } catch (...) {
      forget();
      throw;
    }
  }

  // What was seeded, grown and minimized is so again, with other densities.
  void recluster(const std::vector<double>& densities)
  {
    const Seeding seeding = seeding_;
    const std::size_t iterations = iterations_;
    forget();
    if (input_.cells) {
      internal::Clustering_input base = input_.cells->base();
      base.density = densities;
      input_ = internal::Feature_cells::run(base, input_.cells->edges(), internal::Cancellation_point(visitor_));
    } else {
      input_.density = densities;
    }
    seed_as(seeding);
    grow();
    minimize(iterations);
  }

  void forget()
  {
    seeding_ = nullptr;
    this->forget_editing();
    minimization_.reset();
    labels_.reset();
    initial_.reset();
  }

  const internal::Clustering_input& working_input() const { return initial_ ? initial_->input() : input_; }

  void begin_minimization(std::size_t clusters)
  {
    report_.clusters = clusters;
    all_or_nothing([&] { minimization(); });
  }

  std::size_t cluster_of_face(Index f) const
  {
    return internal::cluster_of_face(working_input(), labels(), report_.clusters, f);
  }

  const internal::Cluster_labels& labels() const
  {
    if (!labels_)
      throw std::logic_error("there are no clusters before grow() or set_clusters()");
    return *labels_;
  }

  // It is there but after clusters were added or removed.
  internal::Energy_minimization<ClusterWeight>& minimization() const
  {
    labels();
    if (!minimization_) {
      minimization_ = std::make_unique<internal::Energy_minimization<ClusterWeight> >(
        working_input(), *labels_, report_.clusters, weight_, internal::Cancellation_point(visitor_), execution_);
      report_.initial_energy = report_.final_energy = minimization_->energy();
    }
    return *minimization_;
  }

  ClusterWeight weight_;
  internal::Visitor_handle visitor_;
  internal::Numbering<FaceGraph> numbering_;
  internal::Local_frame frame_;
  internal::Clustering_input input_;
  bool subdivide_ = false, repair_ = true;
  std::vector<long long> patches_; // of the faces of the mesh, where they are given
  std::size_t dropped_components_ = 0;
  mutable Coarsening_report report_; // making the output adds to it, and so do energies that are asked for
  Seeding seeding_;            // none if clusters were given, or edited or frozen by hand
  std::size_t iterations_ = 0; // of the minimization, at the most
  std::unique_ptr<internal::Initial_clustering> initial_;
  std::unique_ptr<internal::Cluster_labels> labels_;
  mutable std::unique_ptr<internal::Energy_minimization<ClusterWeight> > minimization_;
};

} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_MWCVD_CLUSTERING_H
