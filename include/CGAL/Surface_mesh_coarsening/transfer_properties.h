// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_TRANSFER_PROPERTIES_H
#define CGAL_SURFACE_MESH_COARSENING_TRANSFER_PROPERTIES_H

#include <CGAL/Surface_mesh_coarsening/Property_resampler.h>

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_coarsening {
/// \cond SKIP_IN_MANUAL
namespace internal {

template <class... Types>
struct Type_list
{};

// Transfers the property maps of a `Surface_mesh` one by one by name.
template <class P, class Q>
class Surface_mesh_transfer
{
  typedef Surface_mesh<P> Mesh;
  typedef Surface_mesh<Q> Coarse;
  typedef Type_list<double, float, std::int8_t, std::uint8_t, std::int16_t, std::uint16_t, std::int32_t, std::uint32_t,
                    std::int64_t, std::uint64_t, bool, std::size_t, char, std::string, CGAL::IO::Color,
                    std::array<double, 2>, std::array<double, 3>, std::array<double, 4>, std::array<float, 2>,
                    std::array<float, 3>, std::array<float, 4>>
    Common_types;

public:
  typedef std::map<std::string, Transfer_policy> Policies;

  template <class FaceClusterMap, class NamedParameters1, class NamedParameters2>
  Surface_mesh_transfer(const Mesh& mesh, const FaceClusterMap& clusters, Coarse& coarse, const Policies& policies,
                        const NamedParameters1& np1, const NamedParameters2& np2)
    : mesh_(mesh), coarse_(coarse), policies_(policies), name_of_clusters_(name_of(mesh, clusters)),
      transfer_(mesh, clusters, coarse, np1, np2)
  {}

  // Returns the names of property maps of other types.
  std::vector<std::string> run()
  {
    check();
    run_all<typename Mesh::Vertex_index>([this](auto from, auto to, Transfer_policy policy) {
      transfer_.transfer_vertex_property(from, to, policy);
    });
    run_all<typename Mesh::Face_index>([this](auto from, auto to, Transfer_policy policy) {
      transfer_.transfer_face_property(from, to, policy);
    });
    run_all<typename Mesh::Edge_index>([this](auto from, auto to, Transfer_policy) {
      transfer_.transfer_edge_property(from, to);
    });
    run_all<typename Mesh::Halfedge_index>([this](auto from, auto to, Transfer_policy) {
      transfer_.transfer_corner_property(from, to);
    });
    return left_;
  }

private:
  // Throws all exceptions before the coarse mesh changes.
  void check()
  {
    const auto nothing = [](auto, auto, Transfer_policy) {};
    is_check_ = true;
    run_all<typename Mesh::Vertex_index>(nothing);
    run_all<typename Mesh::Face_index>(nothing);
    run_all<typename Mesh::Edge_index>(nothing);
    run_all<typename Mesh::Halfedge_index>(nothing);
    left_.clear();
    is_check_ = false;
  }

  // The name of the property map of the mesh that holds the clusters, if any. Its values have no meaning for the coarse mesh.
  template <class Type>
  static std::string name_of(const Mesh& mesh,
                             const typename Mesh::template Property_map<typename Mesh::Face_index, Type>& clusters)
  {
    for (const std::string& name : mesh.template properties<typename Mesh::Face_index>()) {
      typename Mesh::template Property_map<typename Mesh::Face_index, Type> map;
      if (find(mesh, name, map) && map.data() == clusters.data())
        return name;
    }
    return "";
  }
  template <class Map>
  static std::string name_of(const Mesh&, const Map&) { return ""; }

  static bool is_of_mesh(const std::string& name)
  {
    const std::string rest = name.substr((std::min)(name.size(), std::size_t(2)));
    return rest == "connectivity" || rest == "removed" || name == "v:point";
  }

  template <class Element, class Transfer>
  void run_all(const Transfer& transfer)
  {
    typedef typename Kernel_traits<P>::Kernel Kernel;
    typedef Type_list<typename Kernel::Point_2, typename Kernel::Point_3, typename Kernel::Vector_2,
                      typename Kernel::Vector_3>
      Kernel_types;
    for (const std::string& name : mesh_.template properties<Element>())
      if (!is_of_mesh(name) && !is_clusters<Element>(name) && !run_as<Element>(name, transfer, Common_types()) &&
          !run_as<Element>(name, transfer, Kernel_types()))
        left_.push_back(name);
  }

  template <class Element>
  bool is_clusters(const std::string& name) const
  {
    return std::is_same<Element, typename Mesh::Face_index>::value && !name_of_clusters_.empty() && name == name_of_clusters_;
  }

  template <class Element, class Transfer, class... Types>
  bool run_as(const std::string& name, const Transfer& transfer, Type_list<Types...>)
  {
    return (run_one<Element, Types>(name, transfer) || ...);
  }

  template <class Element, class Type, class Transfer>
  bool run_one(const std::string& name, const Transfer& transfer)
  {
    typename Mesh::template Property_map<Element, Type> from;
    if (!find(mesh_, name, from))
      return false;
    const auto given = policies_.find(name);
    const Transfer_policy usual = has_means<Type> && !std::is_integral<Type>::value ? Transfer_policy::INTERPOLATED
                                                                                     : Transfer_policy::MAJORITY;
    const Transfer_policy policy = given == policies_.end() ? usual : given->second;
    if (is_check_)
      check_one<Element, Type>(name, policy);
    else {
      auto to = coarse_.template add_property_map<Element, Type>(name).first;
      transfer(from, to, policy);
      if constexpr (std::is_same<Type, typename Kernel_traits<P>::Kernel::Vector_3>::value)
        if (policy == Transfer_policy::INTERPOLATED && are_unit_vectors<Element>(from))
          scale_to_unit_length<Element>(to);
    }
    return true;
  }

  template <class AnyMesh>
  static bool has_value(const AnyMesh& mesh, typename Mesh::Halfedge_index h) { return !mesh.is_border(h); }
  template <class AnyMesh, class Element>
  static bool has_value(const AnyMesh&, Element) { return true; }

  template <class Element, class Map>
  bool are_unit_vectors(const Map& map) const
  {
    constexpr double tolerance = 1e-4; // covers the precision of `float` and of text
    const auto range = elements<Element>(mesh_);
    return std::all_of(range.begin(), range.end(), [&](Element e) {
      return !has_value(mesh_, e) || std::abs(CGAL::to_double(map[e].squared_length()) - 1) < tolerance;
    });
  }

  // The mean of opposite vectors has no direction and stays 0.
  template <class Element, class Map>
  void scale_to_unit_length(Map& map)
  {
    for (const Element e : elements<Element>(coarse_)) {
      const double length = std::sqrt(CGAL::to_double(map[e].squared_length()));
      if (length > 0)
        map[e] = map[e] / length;
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
  void check_one(const std::string& name, Transfer_policy policy) const
  {
    if (policy == Transfer_policy::CONSERVATIVE && !has_means<Type>)
      throw Invalid_input("the values of '" + name + "' have no means and cannot be transferred conservatively");
    const std::vector<std::string> names = coarse_.template properties<Element>();
    typename Coarse::template Property_map<Element, Type> to;
    if (std::find(names.begin(), names.end(), name) != names.end() && !find(coarse_, name, to))
      throw Invalid_input("the coarse mesh has values '" + name + "' of another type");
  }

  template <class SurfaceMesh, class Map>
  static bool find(const SurfaceMesh& mesh, const std::string& name, Map& map)
  {
    typedef typename Map::key_type Element;
    typedef typename Map::value_type Type;
    const auto found = mesh.template property_map<Element, Type>(name);
    if constexpr (std::is_same<std::decay_t<decltype(found)>, std::pair<Map, bool> >::value) {
      map = found.first;
      return found.second;
    } else { // from CGAL 6 on
      if (found)
        map = *found;
      return bool(found);
    }
  }

  const Mesh& mesh_;
  Coarse& coarse_;
  const Policies& policies_;
  std::string name_of_clusters_;
  Property_resampler<Mesh, Coarse> transfer_;
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
  return internal::Surface_mesh_transfer<P, Q>(mesh, clusters, coarse, policies, np1, np2).run();
}

} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_TRANSFER_PROPERTIES_H
