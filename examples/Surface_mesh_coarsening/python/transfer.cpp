// SPDX-License-Identifier: GPL-3.0-or-later

#include "transfer.h"

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>

namespace coarsening_python {
namespace {

using CGAL::Surface_mesh_coarsening::Transfer_policy;

// A number without means.
struct Label
{
  std::int64_t number = 0;
  operator std::int64_t() const { return number; }
  bool operator==(const Label& other) const { return number == other.number; }
};

template <class Key, class Number>
auto column(const Rows<Number>& rows, std::size_t c)
{
  return boost::make_function_property_map<Key>(
    [rows, c](Key k) -> Number { return rows.from[std::size_t(k) * rows.columns + c]; });
}

template <class Key, class Number>
auto coarse_column(const Rows<Number>& rows, std::size_t c)
{
  return boost::make_function_property_map<Key>(
    [rows, c](Key k) -> Number& { return rows.to[std::size_t(k) * rows.columns + c]; });
}

// Returns the row of the corner that each halfedge points to. The halfedge of a face begins at its first corner.
std::vector<std::size_t> rows_of_halfedges(const Mesh& mesh)
{
  std::vector<std::size_t> rows(mesh.number_of_halfedges(), 0);
  std::size_t row = 0;
  for (const Face f : mesh.faces())
    for (const Halfedge h : mesh.halfedges_around_face(mesh.prev(mesh.halfedge(f))))
      rows[h] = row++;
  return rows;
}

} // namespace

Transfer::Transfer(const Mesh& mesh, const std::int64_t* labels, const Mesh& coarse)
  : mesh_(mesh),
    coarse_(coarse),
    resampler_(mesh, boost::make_function_property_map<Face>([labels](Face f) -> std::size_t { return std::size_t(labels[f]); }),
               coarse)
{}

template <class Value, class Number>
void Transfer::transfer_corners(const Rows<Number>& rows)
{
  const std::vector<std::size_t> fine = rows_of_halfedges(mesh_), coarse = rows_of_halfedges(coarse_);
  const auto row = [&](Halfedge h) { return rows.from + fine[h] * rows.columns; };
  const auto are_equal = [&](Halfedge h, Halfedge k) { return std::equal(row(h), row(h) + rows.columns, row(k)); };
  // An edge is a seam of all columns if it is a seam of one.
  const auto is_seam = boost::make_function_property_map<Edge>([&](Edge e) -> bool {
    const Halfedge h = mesh_.halfedge(e), o = mesh_.opposite(h);
    return !mesh_.is_border(e) && !(are_equal(h, mesh_.prev(o)) && are_equal(o, mesh_.prev(h)));
  });
  for (std::size_t c = 0; c < rows.columns; ++c) {
    std::vector<Value> values(coarse_.number_of_halfedges());
    resampler_.transfer_corner_property(
      boost::make_function_property_map<Halfedge>([&](Halfedge h) -> Value { return Value{row(h)[c]}; }),
      boost::make_function_property_map<Halfedge>([&](Halfedge h) -> Value& { return values[h]; }), is_seam);
    for (const Halfedge h : coarse_.halfedges())
      if (!coarse_.is_border(h))
        rows.to[coarse[h] * rows.columns + c] = values[h];
  }
}

void Transfer::interpolate(const Rows<double>& rows, Transfer_policy policy)
{
  if (rows.element == Element::CORNER) {
    transfer_corners<double>(rows);
    return;
  }
  for (std::size_t c = 0; c < rows.columns; ++c)
    if (rows.element == Element::VERTEX)
      resampler_.transfer_vertex_property(column<Vertex>(rows, c), coarse_column<Vertex>(rows, c), policy);
    else
      resampler_.transfer_face_property(column<Face>(rows, c), coarse_column<Face>(rows, c), policy);
}

void Transfer::vote(const Rows<std::int64_t>& rows)
{
  if (rows.element == Element::CORNER)
    transfer_corners<Label>(rows);
  else if (rows.element == Element::VERTEX)
    resampler_.transfer_vertex_property(column<Vertex>(rows, 0), coarse_column<Vertex>(rows, 0), Transfer_policy::MAJORITY);
  else
    resampler_.transfer_face_property(column<Face>(rows, 0), coarse_column<Face>(rows, 0), Transfer_policy::MAJORITY);
}

std::vector<CGAL::Surface_mesh_coarsening::Surface_location<Mesh> > Transfer::sources()
{
  typedef CGAL::Surface_mesh_coarsening::Surface_location<Mesh> Location;
  std::vector<Location> sources(coarse_.number_of_vertices());
  resampler_.write_sources(boost::make_function_property_map<Vertex>([&](Vertex v) -> Location& { return sources[v]; }));
  return sources;
}

} // namespace coarsening_python
