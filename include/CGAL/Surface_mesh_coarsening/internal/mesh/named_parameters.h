// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_NAMED_PARAMETERS_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_NAMED_PARAMETERS_H

#include <CGAL/Surface_mesh_coarsening/defaults.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/Clustering_input.h>
#include <CGAL/Surface_mesh_coarsening/parameters.h>

#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/property_map.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>

#include <algorithm>
#include <iterator>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

// The tags of the named parameters that a function reads from a pack.
template <class... Tags>
struct Parameter_list
{
  template <class Tag>
  static constexpr bool has = (std::is_same<Tag, Tags>::value || ...);
};

template <class... Lists>
struct Parameter_lists
{
  template <class Tag>
  static constexpr bool has = (Lists::template has<Tag> || ...);
};

template <class Tag>
constexpr bool is_of_package = Parameter_list<CGAL::internal_np::vertex_point_t, CGAL::internal_np::geom_traits_t,
                                              CGAL::internal_np::face_index_t, CGAL::internal_np::visitor_t,
                                              CGAL::internal_np::number_of_iterations_t,
                                              CGAL::internal_np::edge_is_constrained_t,
                                              CGAL::internal_np::vertex_is_constrained_t,
                                              CGAL::internal_np::face_patch_t>::template has<Tag>;
#define CGAL_add_named_parameter(X, Y, Z) \
  template <>                             \
  inline constexpr bool is_of_package<internal_np::X> = true;
#include <CGAL/Surface_mesh_coarsening/internal/parameters_interface.h>
#undef CGAL_add_named_parameter

// Compilers print the tag with the sentence. Parameters that no function of the package has are accepted, because the same pack
// may be passed to functions of CGAL.
template <class Tag, class List>
constexpr bool check_parameter()
{
  static_assert(!is_of_package<Tag> || List::template has<Tag>,
                "this named parameter cannot be used in this pack of this function; the reference lists the parameters of each pack");
  return true;
}

// Walks a pack from its last parameter to its first.
template <class List, class NamedParameters>
struct Checked_pack;
template <class List>
struct Checked_pack<List, CGAL::internal_np::No_property>
{
  static constexpr bool value = true;
};
template <class List, class Rest>
struct Checked_pack<List, Surface_mesh_coarsening::internal_np::Chain<Rest> > : Checked_pack<List, Rest>
{};
template <class List, class T, class Tag, class Rest>
struct Checked_pack<List, Named_function_parameters<T, Tag, Rest> >
{
  static constexpr bool value = check_parameter<Tag, List>() && Checked_pack<List, Rest>::value;
};

// Fails to compile if the pack holds a parameter that is in none of the lists.
template <class NamedParameters, class... Lists>
constexpr void accept_parameters()
{
  static_assert(Checked_pack<Parameter_lists<Lists...>, NamedParameters>::value, "");
}

typedef Parameter_list<CGAL::internal_np::vertex_point_t, CGAL::internal_np::geom_traits_t> Geometry_parameters;
typedef Parameter_list<CGAL::internal_np::face_index_t> Order_parameters;
typedef Parameter_list<internal_np::maximum_density_t, internal_np::paper_rules_t> Density_parameters;

// The maps of features of a mesh, which are read or written.
typedef Parameter_list<CGAL::internal_np::edge_is_constrained_t, CGAL::internal_np::vertex_is_constrained_t,
                       CGAL::internal_np::face_patch_t>
  Feature_map_parameters;

typedef Parameter_lists<Geometry_parameters, Order_parameters, Density_parameters, Feature_map_parameters,
                        Parameter_list<internal_np::face_density_t, internal_np::cluster_weight_t, internal_np::cluster_energy_t,
                                       internal_np::subdivide_input_t, internal_np::repair_output_t,
                                       internal_np::error_feedback_t, internal_np::feature_angle_t,
                                       CGAL::internal_np::visitor_t> >
  Clustering_parameters;

typedef Parameter_lists<Clustering_parameters,
                        Parameter_list<CGAL::internal_np::number_of_iterations_t, internal_np::convergence_tolerance_t,
                                       internal_np::vertex_placement_t, internal_np::face_cluster_t,
                                       internal_np::vertex_to_cluster_t> >
  Coarsening_parameters;

typedef Parameter_lists<Geometry_parameters, Feature_map_parameters, Parameter_list<internal_np::vertex_source_t> >
  Output_parameters;

using CGAL::parameters::choose_parameter;
using CGAL::parameters::get_parameter;

template <class Parameter, class NamedParameters, class Default>
using Parameter_type =
  std::decay_t<typename CGAL::internal_np::Lookup_named_param_def<Parameter, NamedParameters, Default>::type>;

template <class Type>
constexpr bool is_given = !std::is_same<Type, CGAL::internal_np::Param_not_found>::value;

template <class Parameter, class NamedParameters>
constexpr bool has_parameter = is_given<Parameter_type<Parameter, NamedParameters, CGAL::internal_np::Param_not_found> >;

// Whether the map of a parameter, if it is given, has the keys and values; a sentence of the compiler says so otherwise.
template <class Tag, class Key, class Value, class NamedParameters>
constexpr bool fits_map()
{
  if constexpr (has_parameter<Tag, NamedParameters>) {
    typedef boost::property_traits<Parameter_type<Tag, NamedParameters, CGAL::internal_np::Param_not_found> > Traits;
    constexpr bool has_key = std::is_convertible<Key, typename Traits::key_type>::value,
                   has_value = std::is_convertible<typename Traits::value_type, Value>::value;
    static_assert(has_key, "the property map of this named parameter has keys of another type; the reference says which");
    static_assert(has_value, "the property map of this named parameter has values of another type; the reference says which");
    return has_key && has_value;
  }
  return true;
}

template <class FaceGraph, class NamedParameters>
constexpr bool fits_maps_of_clusters()
{
  typedef typename boost::graph_traits<FaceGraph>::face_descriptor Face;
  typedef typename boost::graph_traits<FaceGraph>::vertex_descriptor Vertex;
  constexpr bool fits_faces = fits_map<internal_np::face_density_t, Face, double, NamedParameters>() &&
                              fits_map<internal_np::face_cluster_t, Face, std::size_t, NamedParameters>();
  return fits_map<internal_np::vertex_boundary_count_t, Vertex, std::size_t, NamedParameters>() && fits_faces;
}

template <class FaceGraph>
struct Is_surface_mesh : std::false_type
{};
template <class Point>
struct Is_surface_mesh<CGAL::Surface_mesh<Point> > : std::true_type
{};

// The faces or vertices of a face graph in the order of their numbers, and these numbers. Elements of a `Surface_mesh` without
// removed elements already have consecutive numbers, so nothing is stored for them.
template <class FaceGraph, class Descriptor, class Number_property>
class Numbered_elements
{
  static constexpr bool is_indexed = Is_surface_mesh<FaceGraph>::value;
  typedef typename boost::property_map<FaceGraph, Number_property>::const_type Number_map;

  auto iterator(std::size_t i) const
  {
    return boost::make_transform_iterator(boost::counting_iterator<std::size_t>(i), [this](std::size_t k) { return (*this)[k]; });
  }

public:
  // `what` names the elements in an error message.
  template <class Range>
  void assign(const FaceGraph& mesh, const Range& elements, const char* what, const Run_context& context)
  {
    size_ = std::size_t(std::distance(elements.begin(), elements.end()));
    check_countable(size_, what);
    if constexpr (is_indexed)
      if (std::size_t i = 0; std::all_of(elements.begin(), elements.end(), [&](Descriptor x) { return std::size_t(x) == i++; }))
        return;
    list_.assign(elements.begin(), elements.end());
    if constexpr (is_indexed)
      number_.assign(std::size_t(*std::max_element(list_.begin(), list_.end())) + 1, NONE);
    else
      number_ = get(Number_property(), mesh);
    for (std::size_t i = 0; i < size_; ++i) {
      context.poll();
      if constexpr (is_indexed)
        number_[list_[i]] = Index(i);
      else
        put(number_, list_[i], Index(i));
    }
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  auto begin() const { return iterator(0); }
  auto end() const { return iterator(size_); }

  Descriptor operator[](std::size_t i) const
  {
    if constexpr (is_indexed)
      return list_.empty() ? Descriptor(typename Descriptor::size_type(i)) : list_[i];
    else
      return list_[i];
  }
  Index number_of(Descriptor element) const
  {
    if constexpr (is_indexed)
      return list_.empty() ? Index(element) : number_[element];
    else
      return get(number_, element);
  }

private:
  std::vector<Descriptor> list_;
  std::size_t size_ = 0;
  std::conditional_t<is_indexed, std::vector<Index>, Number_map> number_;
};

// The numbers of the faces and vertices of a face graph in the arrays. Vertices are numbered in the order of iteration, and
// faces in the order of iteration or by the caller's face index map.
template <class FaceGraph>
struct Numbering
{
  typedef typename boost::graph_traits<FaceGraph>::face_descriptor face_descriptor;
  typedef typename boost::graph_traits<FaceGraph>::vertex_descriptor vertex_descriptor;

  Numbered_elements<FaceGraph, face_descriptor, dynamic_face_property_t<Index> > faces;
  Numbered_elements<FaceGraph, vertex_descriptor, dynamic_vertex_property_t<Index> > vertices;

  Index number_of(face_descriptor f) const { return faces.number_of(f); }
  Index number_of(vertex_descriptor v) const { return vertices.number_of(v); }
};

// Returns the mesh in arrays, without points. Each face begins with its vertex of smallest number, so that the arrays do not
// depend on the halfedge that the face graph stores for a face.
template <class FaceGraph>
Flat_mesh flat_connectivity(const FaceGraph& mesh, const Numbering<FaceGraph>& n, const Run_context& context = Run_context())
{
  struct Face_list
  {
    std::vector<Index> degree, corner_vertex, face_across;
  };
  const auto list_faces = [&](Face_list& list, std::size_t begin, std::size_t end) {
    list.degree.clear();
    list.corner_vertex.clear();
    list.face_across.clear();
    for (std::size_t f = begin; f != end; ++f) {
      const std::size_t first = list.corner_vertex.size();
      for (const auto h : halfedges_around_face(halfedge(n.faces[f], mesh), mesh)) {
        const auto beyond = face(opposite(h, mesh), mesh);
        list.corner_vertex.push_back(n.number_of(source(h, mesh)));
        list.face_across.push_back(beyond == boost::graph_traits<FaceGraph>::null_face() ? NONE : n.number_of(beyond));
      }
      const auto corner = list.corner_vertex.begin() + std::ptrdiff_t(first),
                 across = list.face_across.begin() + std::ptrdiff_t(first);
      const std::ptrdiff_t shift = std::min_element(corner, list.corner_vertex.end()) - corner;
      std::rotate(corner, corner + shift, list.corner_vertex.end());
      std::rotate(across, across + shift, list.face_across.end());
      list.degree.push_back(Index(list.corner_vertex.size() - first));
    }
  };
  Flat_mesh m;
  m.first_corner.reserve(n.faces.size() + 1);
  m.first_corner.push_back(0);
  m.corner_vertex.reserve(3 * n.faces.size());
  m.face_across.reserve(3 * n.faces.size());
  for_each_part<Face_list>(context, n.faces.size(), 1024, list_faces, [&](const Face_list& list) {
    std::size_t corners = m.corner_vertex.size();
    m.corner_vertex.insert(m.corner_vertex.end(), list.corner_vertex.begin(), list.corner_vertex.end());
    m.face_across.insert(m.face_across.end(), list.face_across.begin(), list.face_across.end());
    for (const Index degree : list.degree)
      m.first_corner.push_back(Index(corners += degree));
  });
  check_countable(m.corner_vertex.size(), "face corners");
  complete_topology(m, n.vertices.size(), context);
  return m;
}

template <class Face, class FaceIndexMap>
void sort_by_map(std::vector<Face>& faces, const FaceIndexMap& index, const Run_context& context)
{
  std::vector<bool> taken(faces.size(), false);
  std::vector<Face> ordered(faces);
  for (const Face f : faces) {
    context.poll();
    const std::size_t i = std::size_t(get(index, f));
    if (i >= ordered.size() || taken[i])
      throw Invalid_input("the face index map gives " + std::to_string(i) + (i < ordered.size() ? " twice" : "") +
                          " for a mesh of " + std::to_string(ordered.size()) + " faces");
    taken[i] = true;
    ordered[i] = f;
  }
  faces.swap(ordered);
}

template <class FaceGraph, class NamedParameters>
Numbering<FaceGraph> numbering(const FaceGraph& mesh, [[maybe_unused]] const NamedParameters& np,
                               const Run_context& context = Run_context())
{
  Numbering<FaceGraph> n;
  const auto all = faces(mesh);
  if constexpr (has_parameter<CGAL::internal_np::face_index_t, NamedParameters>) {
    std::vector<typename Numbering<FaceGraph>::face_descriptor> list(all.begin(), all.end());
    sort_by_map(list, get_parameter(np, CGAL::internal_np::face_index), context);
    n.faces.assign(mesh, list, "faces", context);
  } else {
    n.faces.assign(mesh, all, "faces", context);
  }
  n.vertices.assign(mesh, vertices(mesh), "vertices", context);
  return n;
}

// Returns a function that reads the coordinates of vertices by the caller's point map and traits.
template <class FaceGraph, class NamedParameters>
auto vertex_coordinates(const FaceGraph& mesh, const NamedParameters& np)
{
  typedef typename GetGeomTraits<FaceGraph, NamedParameters>::type Traits;
  return [traits = Traits(choose_parameter<Traits>(get_parameter(np, CGAL::internal_np::geom_traits))),
          points = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                    get_const_property_map(CGAL::vertex_point, mesh))](auto v) {
    const auto& p = get(points, v);
    return Vector{{CGAL::to_double(traits.compute_x_3_object()(p)), CGAL::to_double(traits.compute_y_3_object()(p)),
                   CGAL::to_double(traits.compute_z_3_object()(p))}};
  };
}

template <class FaceGraph, class NamedParameters>
Local_frame copy_points(const FaceGraph& mesh, const NamedParameters& np, const Numbering<FaceGraph>& n, Flat_mesh& m,
                  const Run_context& context = Run_context())
{
  const auto coordinates = vertex_coordinates(mesh, np);
  m.points.reserve(n.vertices.size());
  for (const auto v : n.vertices) {
    context.poll();
    m.points.push_back(coordinates(v));
  }
  return to_local_frame(m.points, m.first_in_star, context);
}

struct Density_choice
{
  double maximum;
  bool at_borders;
};

template <class NamedParameters>
Density_choice density_choice(const NamedParameters& np)
{
  const double r = choose_parameter(get_parameter(np, internal_np::maximum_density_p), Coarsening_defaults::maximum_density);
  if (!(r >= 1 && r <= largest_density))
    throw Invalid_input("the maximum density is " + number_text(r) + ", not in [1, 1e20]");
  return {r, !choose_parameter(get_parameter(np, internal_np::paper_rules_p), false)};
}

template <class FaceGraph, class DensityMap>
std::vector<double> read_densities(const Numbering<FaceGraph>& n, const DensityMap& map,
                                   const Run_context& context = Run_context())
{
  std::vector<double> densities;
  densities.reserve(n.faces.size());
  for (const auto f : n.faces) {
    context.poll();
    const double r = CGAL::to_double(get(map, f));
    if (!(r >= 1 / largest_density && r <= largest_density))
      throw Invalid_input("the density of face " + std::to_string(densities.size()) + " is " + number_text(r) +
                          ", not in [1e-20, 1e20]");
    densities.push_back(r);
  }
  return densities;
}

template <class FaceGraph, class NamedParameters>
Clustering_input clustering_input(const FaceGraph& mesh, const NamedParameters& np, const Numbering<FaceGraph>& n,
                                  Local_frame& frame, const Run_context& context)
{
  Clustering_input input;
  const Density_choice choice = density_choice(np);
  input.mesh = flat_connectivity(mesh, n, context);
  if (n.faces.empty())
    throw Invalid_input("the input has no faces");
  frame = copy_points(mesh, np, n, input.mesh, context);
  if constexpr (has_parameter<internal_np::face_density_t, NamedParameters>)
    input.density = read_densities(n, get_parameter(np, internal_np::face_density), context);
  else
    input.density = compute_densities(input.mesh, choice.maximum, choice.at_borders, context);
  compute_areas_and_centroids(input, context);
  return input;
}

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_MESH_NAMED_PARAMETERS_H
