// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_COARSEN_DISTRIBUTED_MESH_H
#define CGAL_SURFACE_MESH_COARSENING_COARSEN_DISTRIBUTED_MESH_H

#include <CGAL/Surface_mesh_coarsening/Coarsening_report.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Distributed_coarsening.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Rank_context.h>
#include <CGAL/Surface_mesh_coarsening/internal/output/Face_graph_filler.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/mpi/communicator.hpp>

#include <cstddef>
#include <optional>
#include <type_traits>

namespace CGAL::Surface_mesh_coarsening {

/// \cond SKIP_IN_MANUAL
namespace internal {

// A piece of which `source(receive)` passes the vertices and points of each face, and whose faces have consecutive keys in maps.
template <class Source, class Key, class NamedParameters>
struct Piece
{
  const Source& source;
  const Key first_key; // an iterator
  const NamedParameters& np;
};

template <class ConcurrencyTag, class Piece, class OutputFaceGraph, class NamedParametersOut>
Distributed_report coarsen_piece(const boost::mpi::communicator& communicator, const Piece& piece, std::size_t number_of_vertices,
                                 OutputFaceGraph& output, const NamedParametersOut& np_out)
{
  typedef std::decay_t<decltype(piece.np)> NamedParametersIn;
  typedef std::decay_t<decltype(*piece.first_key)> Face;
  static_assert(fits_map<internal_np::face_density_t, Face, double, NamedParametersIn>() &&
                fits_map<internal_np::face_cluster_t, Face, Index, NamedParametersIn>());
  typedef Parameter_type<internal_np::vertex_placement_t, NamedParametersIn, Fitted_placement> Placement;
  typedef typename GetGeomTraits<OutputFaceGraph, NamedParametersOut>::type OutputTraits;
  const auto placement = choose_parameter<Placement>(get_parameter(piece.np, internal_np::vertex_placement_p));
  Rank_context context(communicator);
  on_all_ranks(communicator,
               [&] { set_choices<ConcurrencyTag, OutputTraits>(context, number_of_vertices, placement, piece.np); });
  Distributed_coarsening coarsening(context, [&piece](const Face_receiver& receive) {
    auto key = piece.first_key;
    piece.source([&, map = get_parameter(piece.np, internal_np::face_density)](const auto& vertices, const auto& points) {
      if constexpr (has_parameter<internal_np::face_density_t, NamedParametersIn>)
        receive(vertices, points, CGAL::to_double(get(map, *key++)));
      else
        receive(vertices, points, 1);
    });
  });
  coarsening.run();
  std::optional<Face_graph_filler<OutputFaceGraph, NamedParametersOut> > filler;
  on_all_ranks(communicator, [&] {
    if (context.rank() == 0 || context.wants_output_everywhere)
      filler.emplace(output_points<OutputFaceGraph>(coarsening.dual.positions, context.frame, np_out), coarsening.dual.triangles,
                     output, np_out, context);
    context.throw_if_cancelled();
  });
  on_all_ranks(communicator, [&] {
    if constexpr (has_parameter<internal_np::face_cluster_t, NamedParametersIn>) {
      auto key = piece.first_key;
      for (const Index cluster : coarsening.clusters)
        put(get_parameter(piece.np, internal_np::face_cluster), *key++, cluster);
    }
    if (filler)
      filler->commit();
  });
  return coarsening.report;
}

} // namespace internal
/// \endcond

/// \ingroup PkgSurfaceMeshCoarseningRef
/// coarsens a mesh whose pieces are distributed over the ranks of an MPI communicator to a triangle mesh with a given number of
/// vertices.
///
/// All ranks of the communicator call this function with the same number and the same parameters. Vertices with equal global
/// numbers are the same vertex, in one piece or in several; coordinates are not compared. A piece may be any set of faces, and it
/// may be empty.
///
/// The output has the properties of the output of `coarsen_mesh()`: it is a 2-manifold with exactly `number_of_vertices`
/// vertices, and with the connected components, genus, border loops and orientation of the input. It is identical to the last bit
/// for any number of ranks and threads, and for any distribution of the faces over the pieces. See \ref smc_distributed for the
/// method, its costs and its limits.
///
/// This header needs Boost.MPI. The rest of the package does not.
///
/// \tparam ConcurrencyTag `Sequential_tag`, or `Parallel_tag` for several threads on each rank
/// \tparam FaceGraph a model of `FaceListGraph`
/// \tparam VertexNumberMap a model of `ReadablePropertyMap` with the vertices as keys and an integral value type of up to 64 bits
/// \tparam OutputFaceGraph a model of `MutableFaceGraph`
/// \tparam NamedParametersIn a sequence of named parameters
/// \tparam NamedParametersOut a sequence of named parameters
/// \param communicator the ranks
/// \param piece the piece of this rank. Among all pieces, no two faces may have the same edge in the same direction. Two faces
/// with the same vertices, incompatible orientations, and two edges with the same ends are rejected.
/// \param vertex_numbers the global numbers of the vertices of the piece
/// \param number_of_vertices the number of vertices of the output
/// \param output receives the coarse mesh on rank 0. On other ranks it does not change, unless `output_on_all_ranks` is `true`.
/// \param np_in an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below and, as for
/// `coarsen_mesh()` with `piece` as input, \smcParam{cluster_weight}, \smcParam{cluster_energy}, \smcParam{maximum_density},
/// \smcParam{face_density_map}, \smcParam{face_cluster_map}, \smcParam{vertex_point_map}, \smcParam{geom_traits} and
/// \smcParam{visitor}. Densities are not raised near borders. The visitor is notified of the progress on its rank.
/// \param np_out an optional sequence of \ref bgl_namedparameters "Named Parameters": \smcParam{vertex_point_map} and
/// \smcParam{geom_traits} of `output`
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{the maximum number of rounds of the minimization, for cells and for faces}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{`1000`}
///     \cgalParamExtra{there are at most 80 rounds for faces, and at most 20 in each of four passes for faces of several tasks}
///   \cgalParamNEnd
///   \cgalParamNBegin{convergence_tolerance}
///     \cgalParamDescription{the relative gain of a round at which the minimization of cells ends. The minimization of faces ends
///                           at a hundredth of this gain.}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`0.001`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_placement}
///     \cgalParamDescription{the position of the vertex of a cluster}
///     \cgalParamType{a model of `VertexPlacement`, or `Fitted_placement`, which fits the vertices to an approximation of the
///                    input on rank 0; other models of `GlobalVertexPlacement` do not
///                    compile}
///     \cgalParamDefault{`Fitted_placement()`}
///     \cgalParamExtra{clusters on the border have their vertex on the border}
///   \cgalParamNEnd
///   \cgalParamNBegin{repair_output}
///     \cgalParamDescription{whether rank 0 moves vertices and flips edges where triangles of the output intersect, or face away
///                           from an approximation of the input. Unless the cells are the faces, triangles are separated also where
///                           the input intersects itself.}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true` with `Fitted_placement`, which needs the approximation, too; otherwise `false`}
///     \cgalParamExtra{With a placement at input vertices, `true` is rejected. The input is not clustered again, and no vertices
///                     are relocated, so more intersections may remain than with `coarsen_mesh()`.}
///   \cgalParamNEnd
///   \cgalParamNBegin{output_on_all_ranks}
///     \cgalParamDescription{whether all ranks receive the output}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`: only rank 0 does}
///     \cgalParamExtra{all ranks must pass the same value}
///   \cgalParamNEnd
///   \cgalParamNBegin{faces_per_block}
///     \cgalParamDescription{the number of faces of a block, which are processed together. The result depends on this number, but
///                           not on the ranks}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{`262144`; in the refinement, the number of faces of 1000 clusters if it is larger, up to `2097152`}
///     \cgalParamExtra{a block is larger if the centers of more faces coincide up to a millionth of the extent of the mesh, or if
///                     a single cluster has more faces}
///   \cgalParamNEnd
///   \cgalParamNBegin{scratch_directory}
///     \cgalParamDescription{a directory for a file of this rank, which receives the faces that exceed `scratch_memory`. The file
///                           is removed when the process ends, also after a crash.}
///     \cgalParamType{`std::string`}
///     \cgalParamDefault{empty: all faces are kept in memory}
///     \cgalParamExtra{the result does not depend on this parameter}
///   \cgalParamNEnd
///   \cgalParamNBegin{scratch_memory}
///     \cgalParamDescription{the number of bytes of faces that are kept in memory in addition to the current block}
///     \cgalParamType{`std::uint64_t`}
///     \cgalParamDefault{`0`: with a scratch directory, only current blocks are in memory}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return statistics of the coarsening.
///
/// \throws Unreachable_number_of_vertices if the number of vertices cannot be reached; the exception carries the nearest
/// attainable number.
/// \throws Invalid_input if the pieces have no faces, do not form a 2-manifold, contradict each other, or have a coordinate that
/// is not finite, if a parameter is out of range, if `repair_output` is not available, or if the ranks pass different numbers of
/// vertices. Messages name the piece and the face, or the number of the vertex.
/// \throws Coarsening_cancelled on all ranks if the visitor of a rank cancels.
/// \throws std::runtime_error if a rank fails for another reason, for example because memory or space for its scratch file is
/// exhausted.
///
/// All ranks throw the same exception, and the output does not change.
template <class ConcurrencyTag = Sequential_tag, class FaceGraph, class VertexNumberMap, class OutputFaceGraph,
          class NamedParametersIn = parameters::Default_named_parameters,
          class NamedParametersOut = parameters::Default_named_parameters>
Distributed_report coarsen_distributed_mesh(const boost::mpi::communicator& communicator, const FaceGraph& piece,
                                            const VertexNumberMap& vertex_numbers, std::size_t number_of_vertices,
                                            OutputFaceGraph& output,
                                            const NamedParametersIn& np_in = parameters::default_values(),
                                            const NamedParametersOut& np_out = parameters::default_values())
{
  using namespace internal;
  accept_parameters<NamedParametersIn, Distributed_parameters, Geometry_parameters>();
  accept_parameters<NamedParametersOut, Geometry_parameters>();
  const auto source = source_of_graph(piece, vertex_numbers, np_in);
  typedef typename boost::graph_traits<FaceGraph>::face_iterator Face;
  const Piece<decltype(source), Face, NamedParametersIn> faces_of_piece{source, faces(piece).begin(), np_in};
  return coarsen_piece<ConcurrencyTag>(communicator, faces_of_piece, number_of_vertices, output, np_out);
}

/// \ingroup PkgSurfaceMeshCoarseningRef
/// coarsens a mesh whose pieces are read face by face, for example from a file.
///
/// No rank needs memory for its piece: with parameter `scratch_directory`, a mesh can be larger than memory. Otherwise the
/// function behaves as the previous overload, except that a face is identified by its number in the sequence of its piece, from
/// 0, and that `np_in` has neither `vertex_point_map` nor `geom_traits`.
///
/// \tparam FaceSource a function object. `source(receive)` calls `receive(numbers, points)` for each face of the piece of this
/// rank, in the same order in each call. `numbers` is a `std::vector<std::uint64_t>` of the global numbers of its vertices,
/// counterclockwise, and `points` is a `std::vector<std::array<double, 3> >` of their coordinates. If the function object throws,
/// all ranks throw `Invalid_input` if the exception is of this class, and `std::runtime_error` otherwise.
///
/// \param communicator the ranks
/// \param source passes the faces of the piece of this rank. It is called three times.
/// \param number_of_vertices the number of vertices of the output
/// \param output receives the coarse mesh on rank 0. On other ranks it does not change, unless `output_on_all_ranks` is `true`.
/// \param np_in an optional sequence of \ref bgl_namedparameters "Named Parameters" as in the previous overload. The keys of the
///              maps `face_density_map` and `face_cluster_map` are `std::size_t`, the number of the face in its piece.
/// \param np_out an optional sequence of \ref bgl_namedparameters "Named Parameters" as in the previous overload
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{face_name_map}
///     \cgalParamDescription{the names of faces in messages}
///     \cgalParamType{a model of `ReadablePropertyMap` with the number of a face in the sequence of all pieces, a
///                    `std::uint64_t`, as key and `std::string` as value type}
///     \cgalParamDefault{names like "face 7 of piece 1"}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
template <class ConcurrencyTag = Sequential_tag, class FaceSource, class OutputFaceGraph,
          class NamedParametersIn = parameters::Default_named_parameters,
          class NamedParametersOut = parameters::Default_named_parameters>
Distributed_report coarsen_distributed_faces(const boost::mpi::communicator& communicator, const FaceSource& source,
                                             std::size_t number_of_vertices, OutputFaceGraph& output,
                                             const NamedParametersIn& np_in = parameters::default_values(),
                                             const NamedParametersOut& np_out = parameters::default_values())
{
  using namespace internal;
  accept_parameters<NamedParametersIn, Distributed_parameters, Parameter_list<internal_np::face_name_t> >();
  accept_parameters<NamedParametersOut, Geometry_parameters>();
  typedef boost::counting_iterator<std::size_t> Number;
  const Piece<FaceSource, Number, NamedParametersIn> piece{source, Number(0), np_in};
  return coarsen_piece<ConcurrencyTag>(communicator, piece, number_of_vertices, output, np_out);
}

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_COARSEN_DISTRIBUTED_MESH_H
