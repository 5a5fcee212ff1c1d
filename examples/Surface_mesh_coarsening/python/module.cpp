// SPDX-License-Identifier: GPL-3.0-or-later
//
// The compiled part of the Python module surface_mesh_coarsening: arrays in, arrays out. Its Python part, which users import,
// checks and documents the arguments.

#include "Array_mesh.h"
#include "Signal_check.h"
#include "coarsening.h"
#include "repairing.h"
#include "transfer.h"

#include <CGAL/Surface_mesh_coarsening/compute_face_densities.h>
#include <CGAL/Surface_mesh_coarsening/exceptions.h>
#include <CGAL/Surface_mesh_coarsening/measure_coarsening.h>
#include <CGAL/Surface_mesh_coarsening/parameters.h>
#include <CGAL/Surface_mesh_coarsening/version.h>

#include <boost/property_map/function_property_map.hpp>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace coarsening_python {
namespace {

namespace SMC = CGAL::Surface_mesh_coarsening;
using namespace py::literals;

py::dict described(const Coarsening& result)
{
  const SMC::Coarsening_report& r = result.report;
  return py::dict("level"_a = r.level, "seeds"_a = r.seeds, "splits"_a = r.splits, "merges"_a = r.merges,
                  "refused_by_boundary_counts"_a = r.refused_by_boundary_counts,
                  "refused_by_guarantee"_a = r.refused_by_guarantee, "clusterings"_a = r.clusterings,
                  "clusters"_a = r.clusters, "rounds"_a = r.rounds, "moves"_a = r.moves,
                  "initial_energy"_a = r.initial_energy,
                  "final_energy"_a = r.final_energy, "converged"_a = r.converged,
                  "subdivided_components"_a = r.subdivided_components, "dropped_components"_a = result.dropped_components,
                  "exchanged_vertices"_a = r.exchanged_vertices, "intersections_found"_a = r.intersections_found,
                  "intersections_left"_a = r.intersections_left, "reversals_found"_a = r.reversals_found,
                  "reversals_left"_a = r.reversals_left, "feature_lines"_a = r.feature_lines,
                  "feature_corners"_a = r.feature_corners, "distance_bound"_a = result.distance_bound,
                  "is_within_distance"_a = result.is_within_distance);
}

Integer_array to_array(const std::vector<std::int64_t>& values)
{
  Integer_array array(py::ssize_t(values.size()));
  std::copy(values.begin(), values.end(), array.mutable_data());
  return array;
}

// Arrays with values of elements, if given.
struct Field_arrays
{
  std::optional<Number_array> density;
  std::optional<Integer_array> patches, clusters;
  std::optional<Integer_array> keep_edges, keep_vertices; // the ends of edges, 0 or 1 for each vertex

  // The arrays of the result belong to this object.
  Fields fields(const Mesh& mesh) const
  {
    Fields result{density ? density->data() : nullptr, patches ? patches->data() : nullptr,
                  clusters ? clusters->data() : nullptr, {}, {}};
    if (keep_edges)
      result.kept_edges = marked_edges(mesh, *keep_edges);
    if (keep_vertices)
      result.kept_vertices.assign(keep_vertices->data(), keep_vertices->data() + keep_vertices->size());
    return result;
  }
};

py::list coarsen_arrays(const Number_array& points, const Index_array& sizes, const Index_array& indices,
                        const Options& options, const Field_arrays& arrays, const py::object& progress)
{
  Mesh input = to_mesh({points, sizes, indices});
  const Fields fields = arrays.fields(input);
  Python_visitor visitor(progress);
  std::vector<Coarsening> results;
  {
    const py::gil_scoped_release unlock;
    results = coarsen(std::move(input), options, fields, visitor);
  }
  py::list list;
  for (const Coarsening& result : results) {
    const auto optional = [](const auto& values) { return values.empty() ? py::none() : py::object(to_array(values)); };
    list.append(py::make_tuple(points_of(result.mesh), faces_of(result.mesh), to_array(result.labels), described(result),
                               optional(result.boundary_counts), optional(result.patches)));
  }
  return list;
}

std::pair<std::size_t, std::size_t> range_of_arrays(const Number_array& points, const Index_array& sizes,
                                                    const Index_array& indices, const Options& options,
                                                    const Field_arrays& arrays, const py::object& progress)
{
  Mesh input = to_mesh({points, sizes, indices});
  const Fields fields = arrays.fields(input);
  Python_visitor visitor(progress);
  const py::gil_scoped_release unlock;
  return range_of(std::move(input), options, fields, visitor);
}

Number_array face_densities(const Number_array& points, const Index_array& sizes, const Index_array& indices,
                            double maximum_density, bool paper)
{
  const Mesh mesh = to_mesh({points, sizes, indices});
  Number_array densities(py::ssize_t(mesh.number_of_faces()));
  double* const values = densities.mutable_data();
  SMC::compute_face_densities(mesh, boost::make_function_property_map<Face>([&](Face f) -> double& { return values[f]; }),
                              SMC::parameters::maximum_density(maximum_density).paper_rules(paper));
  return densities;
}

py::dict measure_arrays(const Number_array& points, const Index_array& sizes, const Index_array& indices,
                        const Number_array& coarse_points, const Index_array& coarse_sizes, const Index_array& coarse_indices,
                        std::size_t samples)
{
  const auto mesh = std::make_shared<const Mesh>(to_mesh({points, sizes, indices})),
             coarse = std::make_shared<const Mesh>(to_mesh({coarse_points, coarse_sizes, coarse_indices}));
  const SMC::Coarsening_quality q = run_interruptibly<SMC::Coarsening_quality>(
    [mesh, coarse, samples] { return SMC::measure_coarsening(*mesh, *coarse, samples); });
  const auto error = [](const SMC::Surface_error& e) {
    return py::dict("rms_distance"_a = e.rms_distance, "mean_distance"_a = e.mean_distance,
                    "maximum_distance"_a = e.maximum_distance, "rms_normal_deviation"_a = e.rms_normal_deviation,
                    "mean_normal_deviation"_a = e.mean_normal_deviation,
                    "maximum_normal_deviation"_a = e.maximum_normal_deviation);
  };
  return py::dict("rms_distance"_a = q.rms_distance, "mean_distance"_a = q.mean_distance,
                  "maximum_distance"_a = q.maximum_distance, "rms_normal_deviation"_a = q.rms_normal_deviation,
                  "mean_normal_deviation"_a = q.mean_normal_deviation,
                  "maximum_normal_deviation"_a = q.maximum_normal_deviation, "from_mesh"_a = error(q.from_mesh),
                  "from_coarse"_a = error(q.from_coarse), "mean_smallest_angle"_a = q.mean_smallest_angle,
                  "smallest_angle"_a = q.smallest_angle, "part_below_30_degrees"_a = q.part_below_30_degrees,
                  "self_intersections"_a = q.self_intersections,
                  "border_rms_distance"_a = q.border_rms_distance, "border_mean_distance"_a = q.border_mean_distance,
                  "border_maximum_distance"_a = q.border_maximum_distance, "diagonal"_a = q.diagonal);
}

// Values of elements, and their transfer: numbers by a policy, labels by majority or from the nearest corner.
struct Values
{
  Element element;
  std::optional<SMC::Transfer_policy> policy; // none for labels
  py::array array;
};

std::size_t rows_of(const Mesh& coarse, Element element)
{
  return element == Element::VERTEX ? coarse.number_of_vertices()
         : element == Element::FACE ? coarse.number_of_faces()
                                    : 3 * coarse.number_of_faces();
}

template <class Array>
Array result_for(const Values& values, const Mesh& coarse)
{
  std::vector<py::ssize_t> shape = {py::ssize_t(rows_of(coarse, values.element))};
  if (values.array.ndim() == 2)
    shape.push_back(values.array.shape(1));
  return Array(shape);
}

template <class Number, class Array>
Rows<Number> rows_of(const Values& values, Array& result)
{
  const std::size_t columns = values.array.ndim() == 2 ? std::size_t(values.array.shape(1)) : 1;
  return {values.element, columns, static_cast<const Number*>(values.array.data()), result.mutable_data()};
}

py::list transfer_arrays(const Number_array& points, const Index_array& sizes, const Index_array& indices,
                         const Integer_array& labels, const Number_array& coarse_points, const Index_array& coarse_sizes,
                         const Index_array& coarse_indices, const std::vector<Values>& all)
{
  const Mesh mesh = to_mesh({points, sizes, indices}), coarse = to_mesh({coarse_points, coarse_sizes, coarse_indices});
  std::optional<Transfer> transfer;
  {
    const py::gil_scoped_release unlock;
    transfer.emplace(mesh, labels.data(), coarse);
  }
  py::list results;
  for (const Values& values : all)
    if (values.policy) {
      Number_array result = result_for<Number_array>(values, coarse);
      const Rows<double> rows = rows_of<double>(values, result);
      {
        const py::gil_scoped_release unlock;
        transfer->interpolate(rows, *values.policy);
      }
      results.append(result);
    } else {
      Integer_array result = result_for<Integer_array>(values, coarse);
      const Rows<std::int64_t> rows = rows_of<std::int64_t>(values, result);
      {
        const py::gil_scoped_release unlock;
        transfer->vote(rows);
      }
      results.append(result);
    }
  return results;
}

// Returns the face of the source of each vertex of the coarse mesh, and coordinates in rows as long as the largest face.
py::tuple sources_of_arrays(const Number_array& points, const Index_array& sizes, const Index_array& indices,
                            const Integer_array& labels, const Number_array& coarse_points, const Index_array& coarse_sizes,
                            const Index_array& coarse_indices)
{
  const Mesh mesh = to_mesh({points, sizes, indices}), coarse = to_mesh({coarse_points, coarse_sizes, coarse_indices});
  std::vector<SMC::Surface_location<Mesh> > sources;
  {
    const py::gil_scoped_release unlock;
    sources = Transfer(mesh, labels.data(), coarse).sources();
  }
  const std::size_t columns = sizes.size() == 0 ? 0 : *std::max_element(sizes.data(), sizes.data() + sizes.size());
  Integer_array faces(py::ssize_t(sources.size()));
  Number_array coordinates({py::ssize_t(sources.size()), py::ssize_t(columns)});
  std::fill_n(coordinates.mutable_data(), sources.size() * columns, 0.);
  for (std::size_t v = 0; v < sources.size(); ++v) {
    faces.mutable_data()[v] = std::int64_t(sources[v].face);
    std::copy(sources[v].coordinates.begin(), sources[v].coordinates.end(), coordinates.mutable_data() + v * columns);
  }
  return py::make_tuple(faces, coordinates);
}

void define_fields(py::module_& m)
{
  py::class_<Field_arrays>(m, "Fields")
    .def(py::init<>())
    .def_readwrite("density", &Field_arrays::density)
    .def_readwrite("patches", &Field_arrays::patches)
    .def_readwrite("clusters", &Field_arrays::clusters)
    .def_readwrite("keep_edges", &Field_arrays::keep_edges)
    .def_readwrite("keep_vertices", &Field_arrays::keep_vertices);
}

void define_options(py::module_& m)
{
  py::class_<Options>(m, "Options")
    .def(py::init<>())
    .def_readwrite("vertices", &Options::vertices)
    .def_readwrite("maximum_distance", &Options::maximum_distance)
    .def_readwrite("vertex_ratio", &Options::vertex_ratio)
    .def_readwrite("level", &Options::level)
    .def_readwrite("faces", &Options::faces)
    .def_readwrite("keep_small", &Options::keep_small)
    .def_readwrite("energy", &Options::energy)
    .def_readwrite("paper", &Options::paper)
    .def_readwrite("keep_borders", &Options::keep_borders)
    .def_readwrite("weight", &Options::weight)
    .def_readwrite("placement", &Options::placement)
    .def_readwrite("maximum_density", &Options::maximum_density)
    .def_readwrite("feature_angle", &Options::feature_angle)
    .def_readwrite("mean_angle", &Options::mean_angle)
    .def_readwrite("error_feedback", &Options::error_feedback)
    .def_readwrite("minimum_component_area", &Options::minimum_component_area)
    .def_readwrite("subdivide", &Options::subdivide)
    .def_readwrite("repair_output", &Options::repair_output)
    .def_readwrite("iterations", &Options::iterations)
    .def_readwrite("convergence_tolerance", &Options::convergence_tolerance)
    .def_readwrite("threads", &Options::threads);
}

void define_values(py::module_& m)
{
  py::enum_<Element>(m, "Element").value("vertex", Element::VERTEX).value("face", Element::FACE).value("corner", Element::CORNER);
  py::enum_<SMC::Transfer_policy>(m, "TransferPolicy")
    .value("interpolated", SMC::Transfer_policy::INTERPOLATED)
    .value("conservative", SMC::Transfer_policy::CONSERVATIVE);
  py::class_<Values>(m, "Values")
    .def(py::init([](Element element, SMC::Transfer_policy policy, const Number_array& array) {
      return Values{element, policy, array};
    }))
    .def(py::init([](Element element, const Integer_array& array) { return Values{element, std::nullopt, array}; }));
}

// The Python part defines the exceptions, as they have an attribute.
void translate_exceptions(py::module_& m)
{
  static py::handle unreachable_vertices, unreachable_distance; // kept alive by the module
  m.def("set_exceptions", [](py::object vertices, py::object distance) {
    unreachable_vertices = vertices.release();
    unreachable_distance = distance.release();
  });
  py::register_exception_translator([](std::exception_ptr p) {
    try {
      if (p)
        std::rethrow_exception(p);
    } catch (const SMC::Unreachable_number_of_vertices& e) {
      PyErr_SetObject(unreachable_vertices.ptr(), py::make_tuple(e.what(), e.nearest()).ptr());
    } catch (const SMC::Unreachable_distance& e) {
      PyErr_SetObject(unreachable_distance.ptr(), py::make_tuple(e.what(), e.nearest()).ptr());
    }
  });
}

} // namespace

PYBIND11_MODULE(_core, m)
{
  m.doc() = "The compiled part of surface_mesh_coarsening.";
  m.attr("version") = CGAL_SURFACE_MESH_COARSENING_VERSION;
  define_options(m);
  define_fields(m);
  define_values(m);
  translate_exceptions(m);
  m.def("coarsen", &coarsen_arrays);
  m.def("range", &range_of_arrays);
  m.def("face_densities", &face_densities);
  m.def("measure", &measure_arrays);
  m.def("repair", &repair_arrays);
  m.def("sources", &sources_of_arrays);
  m.def("transfer", &transfer_arrays);
}

} // namespace coarsening_python
