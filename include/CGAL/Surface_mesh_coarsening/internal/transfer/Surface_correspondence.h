// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_TRANSFER_SURFACE_CORRESPONDENCE_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_TRANSFER_SURFACE_CORRESPONDENCE_H

#include <CGAL/Surface_mesh_coarsening/internal/geometry/Nearest_point_search.h>
#include <CGAL/Surface_mesh_coarsening/internal/mesh/named_parameters.h>

#include <CGAL/IO/Color.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_coarsening::internal {

template <class Number>
Number to_number(double x)
{
  if constexpr (std::is_integral<Number>::value) {
    // The ends of a range of 64 bits are not doubles; values beyond them must not be converted.
    if (!(x > double((std::numeric_limits<Number>::min)())))
      return (std::numeric_limits<Number>::min)();
    if (x >= double((std::numeric_limits<Number>::max)()))
      return (std::numeric_limits<Number>::max)();
    return Number(std::nearbyint(x));
  } else {
    return Number(x);
  }
}

template <class Value>
constexpr bool is_number = std::is_arithmetic<Value>::value && !std::is_same<Value, bool>::value;

// The numbers of a value, if its type has means.
template <class Value, class = void>
struct Value_components
{
  static constexpr std::size_t size = 0;
};

template <class Value>
struct Value_components<Value, std::enable_if_t<is_number<Value> > >
{
  static constexpr std::size_t size = 1;
  static double get(const Value& value, std::size_t) { return double(value); }
  static Value make(const std::array<double, 1>& x) { return to_number<Value>(x[0]); }
};

template <>
struct Value_components<CGAL::IO::Color>
{
  static constexpr std::size_t size = 4;
  static double get(const CGAL::IO::Color& c, std::size_t i) { return double(c[i]); }
  static CGAL::IO::Color make(const std::array<double, 4>& x)
  {
    return CGAL::IO::Color(to_number<unsigned char>(x[0]), to_number<unsigned char>(x[1]),
                           to_number<unsigned char>(x[2]), to_number<unsigned char>(x[3]));
  }
};

template <class Number, std::size_t n>
struct Value_components<std::array<Number, n>, std::enable_if_t<is_number<Number> > >
{
  static constexpr std::size_t size = n;
  static double get(const std::array<Number, n>& value, std::size_t i) { return double(value[i]); }
  static std::array<Number, n> make(const std::array<double, n>& x)
  {
    std::array<Number, n> value;
    std::transform(x.begin(), x.end(), value.begin(), to_number<Number>);
    return value;
  }
};

// Points and vectors of a kernel.
template <class Value>
struct Value_components<Value, std::void_t<typename Value::R, decltype(std::declval<const Value&>().cartesian(0)),
                                           typename Value::Ambient_dimension> >
{
  static constexpr std::size_t size = Value::Ambient_dimension::value;
  typedef typename Value::R::FT FT;

  static double get(const Value& value, std::size_t i) { return CGAL::to_double(value.cartesian(int(i))); }
  static Value make(const std::array<double, size>& x)
  {
    if constexpr (size == 2)
      return Value(FT(x[0]), FT(x[1]));
    else
      return Value(FT(x[0]), FT(x[1]), FT(x[2]));
  }
};

template <class Value>
constexpr bool has_means = Value_components<Value>::size != 0;

// A weighted sum of values.
template <class Value>
class Weighted_sum
{
  typedef Value_components<Value> Components;

public:
  void add(double weight, const Value& value)
  {
    for (std::size_t i = 0; i < sum_.size(); ++i)
      sum_[i] += weight * Components::get(value, i);
  }
  void add(double weight, const Weighted_sum& other)
  {
    for (std::size_t i = 0; i < sum_.size(); ++i)
      sum_[i] += weight * other.sum_[i];
  }
  Value value() const { return Components::make(sum_); }

private:
  std::array<double, Components::size> sum_{};
};

struct Clustered_arrays
{
  Flat_mesh mesh;
  std::vector<double> area;
  std::vector<Vector> centroid;
  std::vector<Index> cluster; // per face; NONE if it corresponds to nothing
  Local_frame frame;
};

template <class FaceGraph, class NamedParameters, class FaceClusterMap, class CoarseNumbering>
Clustered_arrays clustered_arrays(const FaceGraph& mesh, const NamedParameters& np, const Numbering<FaceGraph>& n,
                                  const FaceClusterMap& map, const CoarseNumbering& coarse)
{
  Clustered_arrays result;
  result.mesh = flat_connectivity(mesh, n);
  if (n.faces.empty() || coarse.faces.empty())
    throw Invalid_input("there is nothing to transfer between meshes of which one has no faces");
  result.frame = copy_points(mesh, np, n, result.mesh);
  for (std::size_t f = 0; f < n.faces.size(); ++f) {
    const Face_geometry g = face_geometry(result.mesh, Index(f));
    result.area.push_back(g.area);
    result.centroid.push_back(g.centroid);
    const std::size_t x = std::size_t(get(map, n.faces[f])), clusters = coarse.vertices.size();
    if (x > clusters)
      throw Invalid_input("the cluster of face " + std::to_string(f) + " is " + std::to_string(x) + ", but the coarse mesh has " +
                          std::to_string(clusters) + " vertices");
    result.cluster.push_back(x == clusters ? NONE : Index(x));
  }
  if (std::all_of(result.cluster.begin(), result.cluster.end(), [](Index x) { return x == NONE; }))
    throw Invalid_input("no face has a cluster");
  return result;
}

// A clustered mesh and its coarse mesh in arrays, and the correspondence between their elements.
class Surface_correspondence : public Clustered_arrays
{
public:
  template <class CoarseFaceGraph, class NamedParameters>
  Surface_correspondence(Clustered_arrays clustered, const CoarseFaceGraph& coarse, const Numbering<CoarseFaceGraph>& n,
                         const NamedParameters& np)
    : Clustered_arrays(std::move(clustered)), around_(n.vertices.size()), dual_area_(n.vertices.size(), 0),
      faces_(numbers_below(Index(cluster.size())), n.vertices.size(), [this](Index f) { return cluster[f]; }),
      search_(mesh, faces_)
  {
    const auto coordinates = vertex_coordinates(coarse, np);
    for (const auto v : n.vertices) {
      const Vector p = coordinates(v);
      for (std::size_t i = 0; i < 3; ++i)
        if (!std::isfinite(p[i]))
          throw Invalid_input("coordinate " + std::to_string(i) + " of vertex " + std::to_string(position_.size()) +
                              " of the coarse mesh is " + std::to_string(p[i]));
      position_.push_back(frame.to_local(p));
    }
    for (const auto f : n.faces) {
      std::vector<Index> corners;
      for (const auto h : halfedges_around_face(halfedge(f, coarse), coarse))
        corners.push_back(n.number_of(source(h, coarse)));
      const std::size_t t = triangles_.size();
      if (corners.size() != 3)
        throw Invalid_input("face " + std::to_string(t) + " of the coarse mesh has " + std::to_string(corners.size()) + " sides");
      triangles_.push_back({{corners[0], corners[1], corners[2]}});
      for (const Index x : corners) {
        around_[x].push_back(Index(t));
        dual_area_[x] += 0.5 * length(normal_of(position_, triangles_[t])) / 3;
      }
    }
  }

  Surface_correspondence(const Surface_correspondence&) = delete; // its members refer to each other
  Surface_correspondence& operator=(const Surface_correspondence&) = delete;

  const std::vector<Vector>& positions() const { return position_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  const std::vector<Index>& around(Index x) const { return around_[x]; }
  Bucketed_items<Index>::Range faces(Index x) const { return faces_[x]; }
  const Nearest_point_search& search() const { return search_; }

  // Returns a third of the area of the triangles around a vertex.
  double dual_area(Index x) const { return dual_area_[x]; }
  Vector center(const std::array<Index, 2>& edge) const { return 0.5 * (position_[edge[0]] + position_[edge[1]]); }
  Vector center(const Triangle& t) const { return (1. / 3) * (position_[t[0]] + position_[t[1]] + position_[t[2]]); }

  // Returns the nearest point to each coarse vertex.
  const std::vector<Nearest_point>& sources()
  {
    if (sources_.empty())
      for (std::size_t x = 0; x < position_.size(); ++x)
        sources_.push_back(search_(position_[x], Index(x)));
    return sources_;
  }

  // Returns the point nearest to the center of an edge or a triangle, within the clusters of its ends or corners.
  // Closer points on the other side of a thin sheet do not correspond to it.
  template <class Clusters>
  Nearest_point triangle_source(const Clusters& clusters) const
  {
    const Vector p = center(clusters);
    Nearest_point nearest;
    for (const Index x : clusters)
      search_.improve_in(p, x, nearest);
    return nearest.face == NONE ? search_(p, clusters[0]) : nearest;
  }

  const std::vector<Nearest_point>& triangle_sources()
  {
    if (triangle_sources_.empty())
      for (const Triangle& t : triangles_)
        triangle_sources_.push_back(triangle_source(t));
    return triangle_sources_;
  }

  // Returns the nearest triangle to each face of the mesh, among the triangles around the vertex of its cluster; NONE if there
  // are none.
  const std::vector<Index>& triangles_of_faces()
  {
    if (triangle_of_face_.empty())
      for (std::size_t f = 0; f < cluster.size(); ++f)
        triangle_of_face_.push_back(cluster[f] == NONE ? NONE : nearest_around(cluster[f], centroid[f]));
    return triangle_of_face_;
  }

  // Returns the vertex that receives the values to be distributed over the dual cell of `x`: `x`, or the first vertex with
  // an area found from `x`. Depends on the arguments only.
  Index vertex_with_area(Index x) const
  {
    if (dual_area_[x] > 0)
      return x;
    std::vector<Index> queue(1, x);
    std::vector<bool> seen(position_.size(), false);
    seen[x] = true;
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (const Index t : around_[queue[i]])
        for (const Index y : triangles_[t]) {
          if (seen[y])
            continue;
          if (dual_area_[y] > 0)
            return y;
          seen[y] = true;
          queue.push_back(y);
        }
    return x;
  }

private:
  Index nearest_around(Index x, const Vector& p) const
  {
    Index nearest = NONE;
    double least = 0;
    for (const Index t : around_[x]) {
      const Triangle& corners = triangles_[t];
      const double d =
        closest_on_triangle(p, position_[corners[0]], position_[corners[1]], position_[corners[2]]).squared_distance;
      if (nearest == NONE || d < least) {
        nearest = t;
        least = d;
      }
    }
    return nearest;
  }

  std::vector<Vector> position_;
  std::vector<Triangle> triangles_;
  std::vector<std::vector<Index> > around_;
  std::vector<double> dual_area_;
  Bucketed_items<Index> faces_; // per cluster
  Nearest_point_search search_;
  // Computed on demand:
  std::vector<Nearest_point> sources_, triangle_sources_;
  std::vector<Index> triangle_of_face_;
};

// Finds the points from which the corners of coarse triangles take values if the values have seams.
//
// Around a coarse vertex, seams divide the faces of its cluster and of the adjacent clusters into sectors. A triangle
// there belongs to the sector of the face nearest to its center, and its corner takes the value at the nearest point of
// this sector. So all triangles on the same side of a seam have the same value at the vertex, and no value mixes the two
// sides.
class Chart_sectors
{
public:
  // `is_seam` states, for each corner of the mesh, whether the edge after it is a seam.
  Chart_sectors(Surface_correspondence& surfaces, const std::vector<bool>& is_seam)
    : surfaces_(surfaces), mesh_(surfaces.mesh), is_seam_(is_seam), stamp_(mesh_.number_of_faces(), NONE),
      sector_(mesh_.number_of_faces(), NONE)
  {}

  // Calls `visit(triangle, nearest point)` for each triangle around a vertex.
  template <class Visit>
  void for_each_corner_at(Index x, const Visit& visit)
  {
    std::vector<Index> clusters(1, x); // and the adjacent clusters
    for (const Index t : surfaces_.around(x))
      clusters.insert(clusters.end(), surfaces_.triangles()[t].begin(), surfaces_.triangles()[t].end());
    sort_unique(clusters);
    faces_.clear();
    for (const Index y : clusters)
      for (const Index f : surfaces_.faces(y)) {
        faces_.push_back(f);
        stamp_[f] = x;
        sector_[f] = NONE;
      }
    bool is_cut = false;
    for (const Index f : faces_)
      for (const Index c : mesh_.corners(f))
        is_cut = is_cut || (is_seam_[c] && mesh_.face_across[c] != NONE && stamp_[mesh_.face_across[c]] == x);
    if (is_cut)
      number_parts(mesh_, faces_, sector_, Run_context(), [&](Index c, Index g) { return !is_seam_[c] && stamp_[g] == x; });
    std::map<Index, Nearest_point> nearest_in_sector;
    for (const Index t : surfaces_.around(x)) {
      const Index face = surfaces_.triangle_sources()[t].face;
      const Index sector = is_cut && stamp_[face] == x ? sector_[face] : 0;
      const auto [found, is_new] = nearest_in_sector.emplace(sector, Nearest_point());
      if (is_new)
        found->second = nearest_in(x, is_cut ? sector : NONE);
      visit(t, found->second);
    }
  }

private:
  // Searches all faces if the sector is NONE.
  Nearest_point nearest_in(Index x, Index sector) const
  {
    Nearest_point nearest;
    for (const Index f : faces_)
      if (sector == NONE || sector_[f] == sector)
        improve(mesh_, surfaces_.positions()[x], f, nearest);
    return nearest.face == NONE ? surfaces_.search()(surfaces_.positions()[x], x) : nearest;
  }

  Surface_correspondence& surfaces_;
  const Flat_mesh& mesh_;
  const std::vector<bool>& is_seam_;
  std::vector<Index> stamp_, sector_; // per face
  std::vector<Index> faces_;
};

} // namespace CGAL::Surface_mesh_coarsening::internal

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_TRANSFER_SURFACE_CORRESPONDENCE_H
