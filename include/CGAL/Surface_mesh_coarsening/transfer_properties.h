// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_TRANSFER_PROPERTIES_H
#define CGAL_SURFACE_MESH_COARSENING_TRANSFER_PROPERTIES_H

#include <CGAL/Surface_mesh_coarsening/Property_resampler.h>

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening {
/// \cond SKIP_IN_MANUAL
namespace internal {

// Finds the property map of a name and of the type of `map`.
template <class Mesh, class Map>
bool find_property_map(const Mesh& mesh, const std::string& name, Map& map)
{
  const auto found = mesh.template property_map<typename Map::key_type, typename Map::value_type>(name);
  if constexpr (std::is_same<std::decay_t<decltype(found)>, std::pair<Map, bool> >::value) {
    map = found.first;
    return found.second;
  } else { // from CGAL 6 on
    if (found)
      map = *found;
    return bool(found);
  }
}

// Returns the name of the property map of the mesh that holds the clusters, if any.
template <class Mesh, class FaceClusterMap>
std::string name_of_clusters([[maybe_unused]] const Mesh& mesh, [[maybe_unused]] const FaceClusterMap& clusters)
{
  typedef typename Mesh::template Property_map<typename Mesh::Face_index,
                                               typename boost::property_traits<FaceClusterMap>::value_type> Map;
  if constexpr (std::is_same<FaceClusterMap, Map>::value)
    for (const std::string& name : mesh.template properties<typename Mesh::Face_index>())
      if (Map map; find_property_map(mesh, name, map) && map.data() == clusters.data())
        return name;
  return "";
}

// Transfers the property maps of a `Surface_mesh` one by one by name.
template <class P, class Q>
class Surface_mesh_transfer
{
  typedef Surface_mesh<P> Mesh;
  typedef Surface_mesh<Q> Coarse;
  typedef typename Kernel_traits<P>::Kernel Kernel;
  typedef std::map<std::string, Transfer_policy> Policies;

public:
  Surface_mesh_transfer(const Mesh& mesh, Coarse& coarse, const Policies& policies, const std::string& name_of_clusters,
                        Property_resampler<Mesh, Coarse>& transfer)
    : mesh_(mesh), coarse_(coarse), policies_(policies), name_of_clusters_(name_of_clusters), transfer_(transfer)
  {}

  // Returns the names of property maps of other types.
  std::vector<std::string> run()
  {
    for (const bool is_check : {true, false}) { // throws all exceptions before the coarse mesh changes
      is_check_ = is_check;
      left_.clear();
      run_all<typename Mesh::Vertex_index>();
      run_all<typename Mesh::Face_index>(name_of_clusters_); // they have no meaning for the coarse mesh
      run_all<typename Mesh::Edge_index>();
      run_all<typename Mesh::Halfedge_index>();
    }
    return left_;
  }

private:
  static bool is_of_mesh(const std::string& name)
  {
    const std::string rest = name.substr((std::min)(name.size(), std::size_t(2)));
    return rest == "connectivity" || rest == "removed" || name == "v:point";
  }

  template <class Element>
  void run_all(const std::string& omitted = "")
  {
    for (const std::string& name : mesh_.template properties<Element>())
      if (!is_of_mesh(name) && (name.empty() || name != omitted) &&
          !run_as<Element, double, float, std::int8_t, std::uint8_t, std::int16_t, std::uint16_t, std::int32_t, std::uint32_t,
                  std::int64_t, std::uint64_t, bool, std::size_t, char, std::string, CGAL::IO::Color, std::array<double, 2>,
                  std::array<double, 3>, std::array<double, 4>, std::array<float, 2>, std::array<float, 3>,
                  std::array<float, 4>, typename Kernel::Point_2, typename Kernel::Point_3, typename Kernel::Vector_2,
                  typename Kernel::Vector_3>(name))
        left_.push_back(name);
  }

  template <class Element, class... Types>
  bool run_as(const std::string& name)
  {
    return (run_one<Element, Types>(name) || ...);
  }

  template <class Element, class Type>
  bool run_one(const std::string& name)
  {
    typename Mesh::template Property_map<Element, Type> from;
    if (!find_property_map(mesh_, name, from))
      return false;
    const auto given = policies_.find(name);
    const Transfer_policy usual = has_means<Type> && !std::is_integral<Type>::value ? Transfer_policy::INTERPOLATED
                                                                                     : Transfer_policy::MAJORITY;
    const Transfer_policy policy = given == policies_.end() ? usual : given->second;
    if (is_check_) {
      check<Element, Type>(name, policy);
      return true;
    }
    auto to = coarse_.template add_property_map<Element, Type>(name).first;
    if constexpr (std::is_same<Element, typename Mesh::Vertex_index>::value)
      transfer_.transfer_vertex_property(from, to, policy);
    else if constexpr (std::is_same<Element, typename Mesh::Face_index>::value)
      transfer_.transfer_face_property(from, to, policy);
    else if constexpr (std::is_same<Element, typename Mesh::Edge_index>::value)
      transfer_.transfer_edge_property(from, to);
    else
      transfer_.transfer_corner_property(from, to);
    if constexpr (std::is_same<Type, typename Kernel::Vector_3>::value)
      if (policy == Transfer_policy::INTERPOLATED)
        keep_unit_length<Element>(from, to);
    return true;
  }

  // Scales vectors to unit length if all vectors of the mesh have unit length. The mean of opposite vectors has no direction and
  // stays 0.
  template <class Element, class Map, class CoarseMap>
  void keep_unit_length(const Map& from, CoarseMap& to)
  {
    constexpr double tolerance = 1e-4; // covers the precision of `float` and of text
    for (const Element e : elements<Element>(mesh_)) {
      if constexpr (std::is_same<Element, typename Mesh::Halfedge_index>::value)
        if (mesh_.is_border(e))
          continue; // it has no value
      if (!(std::abs(CGAL::to_double(from[e].squared_length()) - 1) < tolerance))
        return;
    }
    for (const Element e : elements<Element>(coarse_)) {
      const double length = std::sqrt(CGAL::to_double(to[e].squared_length()));
      if (length > 0)
        to[e] = to[e] / length;
    }
  }

  template <class Element, class AnyMesh>
  static auto elements(const AnyMesh& mesh)
  {
    if constexpr (std::is_same<Element, typename Mesh::Vertex_index>::value)
      return mesh.vertices();
    else if constexpr (std::is_same<Element, typename Mesh::Face_index>::value)
      return mesh.faces();
    else if constexpr (std::is_same<Element, typename Mesh::Edge_index>::value)
      return mesh.edges();
    else
      return mesh.halfedges();
  }

  template <class Element, class Type>
  void check(const std::string& name, Transfer_policy policy) const
  {
    if (policy == Transfer_policy::CONSERVATIVE && !has_means<Type>)
      throw Invalid_input("the values of '" + name + "' have no means and cannot be transferred conservatively");
    const std::vector<std::string> names = coarse_.template properties<Element>();
    typename Coarse::template Property_map<Element, Type> to;
    if (std::find(names.begin(), names.end(), name) != names.end() && !find_property_map(coarse_, name, to))
      throw Invalid_input("the coarse mesh has values '" + name + "' of another type");
  }

  const Mesh& mesh_;
  Coarse& coarse_;
  const Policies& policies_;
  const std::string& name_of_clusters_;
  Property_resampler<Mesh, Coarse>& transfer_;
  std::vector<std::string> left_;
  bool is_check_ = false;
};

} // namespace internal
/// \endcond

/// \ingroup PkgSurfaceMeshCoarseningRef
/// transfers all property maps of a `CGAL::Surface_mesh` to its coarse mesh, which gets property maps of the same names and
/// types. Existing maps are overwritten.
///
/// Supported types are numbers, `bool`, `std::string`, `CGAL::IO::Color`, `std::array` of 2, 3 or 4 `float` or `double`,
/// and the points and vectors of the kernel in two and three dimensions. Floating-point numbers, colors, points, vectors and
/// arrays are interpolated, and integers, `bool` and strings are transferred by majority, unless `policies` overrides it.
/// `Property_resampler` describes the transfer of values of edges and halfedges; seams follow from the values of halfedges. The
/// function does not transfer the points, the internal properties of the mesh, whose names begin with `v:connectivity` and the
/// like, and `clusters` if it is a property map of the mesh. Three-dimensional vectors that are all of unit length, such as
/// normals, keep unit length.
///
/// \tparam P a point type
/// \tparam Q a point type
/// \tparam FaceClusterMap a model of `ReadablePropertyMap` with the faces as keys and an integral value type
/// \tparam NamedParameters1 a sequence of \ref bgl_namedparameters "Named Parameters"
/// \tparam NamedParameters2 a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the input of `coarsen_mesh()`
/// \param clusters the `face_cluster_map` written by `coarsen_mesh()`
/// \param coarse the output of `coarsen_mesh()`
/// \param policies the policies of properties of vertices and faces, by name
/// \param np1 an optional sequence of \ref bgl_namedparameters "Named Parameters": \smcParam{vertex_point_map} and
/// \smcParam{geom_traits} of `mesh`
/// \param np2 an optional sequence of \ref bgl_namedparameters "Named Parameters": \smcParam{vertex_point_map} and
/// \smcParam{geom_traits} of `coarse`
///
/// \return the names of the property maps of unsupported types, which are not transferred.
/// \throws Invalid_input as the constructor of `Property_resampler` does, before `coarse` changes, and if values without
/// means are to be transferred with `CONSERVATIVE`.
template <class P, class Q, class FaceClusterMap, class NamedParameters1 = parameters::Default_named_parameters,
          class NamedParameters2 = parameters::Default_named_parameters>
std::vector<std::string> transfer_properties(const Surface_mesh<P>& mesh, const FaceClusterMap& clusters,
                                             Surface_mesh<Q>& coarse,
                                             const std::map<std::string, Transfer_policy>& policies = {},
                                             const NamedParameters1& np1 = parameters::default_values(),
                                             const NamedParameters2& np2 = parameters::default_values())
{
  Property_resampler<Surface_mesh<P>, Surface_mesh<Q> > transfer(mesh, clusters, coarse, np1, np2);
  const std::string name = internal::name_of_clusters(mesh, clusters);
  return internal::Surface_mesh_transfer<P, Q>(mesh, coarse, policies, name, transfer).run();
}

} // namespace CGAL::Surface_mesh_coarsening

#endif // CGAL_SURFACE_MESH_COARSENING_TRANSFER_PROPERTIES_H
