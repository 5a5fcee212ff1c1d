// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_TEST_REFERENCE_ENERGY_H
#define CGAL_SURFACE_MESH_COARSENING_TEST_REFERENCE_ENERGY_H

#include "Reference_mesh.h"

#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Density_variance_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Exact_maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Maximum_density_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Uniform_weight.h>
#include <CGAL/Surface_mesh_coarsening/Cluster_weight/Weighted_area_weight.h>

#include <array>
#include <cmath>
#include <vector>

// Areas, densities and energies from their definitions, in long double. Of the library, only the names of the weights are
// used, to choose the formula.
namespace reference {

typedef long double Real;
typedef std::array<Real, 3> Vector;

inline Vector difference(const generated::Point& a, const generated::Point& b)
{
  return {Real(a[0]) - b[0], Real(a[1]) - b[1], Real(a[2]) - b[2]};
}
inline Vector cross(const Vector& a, const Vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Real dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// A polygon, possibly nonconvex. If it is not planar, the centroid depends on the first vertex of the fan: the vertex of
// smallest number.
struct Face
{
  Real area = 0;
  Vector normal{{0, 0, 0}}, centroid{{0, 0, 0}};
};

inline Face face_of(const generated::Soup& s, generated::Polygon p)
{
  std::rotate(p.begin(), std::min_element(p.begin(), p.end()), p.end());
  Face face;
  Vector sum{{0, 0, 0}};
  for (std::size_t i = 2; i < p.size(); ++i) {
    const Vector n = cross(difference(s.points[p[i - 1]], s.points[p[0]]), difference(s.points[p[i]], s.points[p[0]]));
    for (int k = 0; k < 3; ++k)
      sum[k] += n[k] / 2;
  }
  face.area = std::sqrt(dot(sum, sum));
  for (int k = 0; k < 3 && face.area > 0; ++k)
    face.normal[k] = sum[k] / face.area;
  if (p.size() == 3 || !(face.area > 0)) {
    for (const std::size_t v : p)
      for (int k = 0; k < 3; ++k)
        face.centroid[k] += Real(s.points[v][k]) / p.size();
    return face;
  }
  for (std::size_t i = 2; i < p.size(); ++i) {
    const generated::Point &a = s.points[p[0]], &b = s.points[p[i - 1]], &c = s.points[p[i]];
    const Real part = dot(cross(difference(b, a), difference(c, a)), face.normal) / 2;
    for (int k = 0; k < 3; ++k)
      face.centroid[k] += part / face.area * (Real(a[k]) + b[k] + c[k]) / 3;
  }
  return face;
}

inline std::vector<Face> faces_of(const generated::Soup& s)
{
  std::vector<Face> faces;
  for (const generated::Polygon& p : s.polygons)
    faces.push_back(face_of(s, p));
  return faces;
}

// Section 5.2: the mean of |n_f - n_g| over all pairs of a vertex of f and a face g around it, mapped from [0, maximum] to
// [1, r_new].
inline std::vector<double> densities(const Reference_mesh& m, double r_new)
{
  const std::vector<Face> faces = faces_of(m.soup());
  std::vector<Real> deviation;
  Real maximum = 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    Real sum = 0;
    std::size_t pairs = 0;
    for (const std::size_t v : m.polygons()[f])
      for (const std::size_t g : m.star(v)) {
        ++pairs;
        const Vector d{faces[f].normal[0] - faces[g].normal[0], faces[f].normal[1] - faces[g].normal[1],
                       faces[f].normal[2] - faces[g].normal[2]};
        if (faces[f].area > 0 && faces[g].area > 0)
          sum += std::sqrt(dot(d, d));
      }
    deviation.push_back(sum / pairs);
    maximum = (std::max)(maximum, deviation.back());
  }
  std::vector<double> result;
  for (const Real d : deviation)
    result.push_back(maximum > 0 ? double(1 + (r_new - 1) * d / maximum) : 1.);
  return result;
}

// Formulas (9) to (13) of the paper, for a cluster of faces of these densities and this mass.
namespace smc = CGAL::Surface_mesh_coarsening;

inline Real weight(const smc::Uniform_weight&, const std::vector<Real>&, Real) { return 1; }
inline Real weight(const smc::Weighted_area_weight&, const std::vector<Real>&, Real mass) { return mass; }
inline Real weight(const smc::Maximum_density_weight&, const std::vector<Real>& r, Real, Real p = 10)
{
  const Real largest = *std::max_element(r.begin(), r.end());
  Real sum = 0;
  for (const Real x : r)
    sum += std::pow(x / largest, p);
  return largest * std::pow(sum, 1 / p);
}
inline Real weight(const smc::Exact_maximum_density_weight&, const std::vector<Real>& r, Real)
{
  return *std::max_element(r.begin(), r.end());
}
inline Real weight(const smc::Density_variance_weight&, const std::vector<Real>& r, Real)
{
  Real mean = 0, sum = 0;
  for (const Real x : r)
    mean += x / r.size();
  for (const Real x : r)
    sum += (x - mean) * (x - mean);
  return 1 + sum;
}

// The energy of each cluster: its weight times the sum of r A |g - c|^2 over its faces, about its centroid c.
template <class Weight>
std::vector<Real> energies(const std::vector<Face>& faces, const std::vector<double>& r, const Labels& labels,
                           const Weight& w)
{
  const std::size_t n = number_of_clusters(labels);
  std::vector<Real> mass(n, 0), second(n, 0), result(n);
  std::vector<Vector> center(n, Vector{{0, 0, 0}});
  std::vector<std::vector<Real> > densities(n);
  for (std::size_t f = 0; f < labels.size(); ++f) {
    const std::size_t x = labels[f];
    densities[x].push_back(r[f]);
    mass[x] += r[f] * faces[f].area;
    for (int k = 0; k < 3; ++k)
      center[x][k] += r[f] * faces[f].area * faces[f].centroid[k];
  }
  for (std::size_t x = 0; x < n; ++x)
    for (int k = 0; k < 3 && mass[x] > 0; ++k)
      center[x][k] /= mass[x];
  for (std::size_t f = 0; f < labels.size(); ++f) {
    const Vector &g = faces[f].centroid, &c = center[labels[f]];
    const Vector d{g[0] - c[0], g[1] - c[1], g[2] - c[2]};
    second[labels[f]] += r[f] * faces[f].area * dot(d, d);
  }
  for (std::size_t x = 0; x < n; ++x)
    result[x] = weight(w, densities[x], mass[x]) * second[x];
  return result;
}

template <class Weight>
double energy(const std::vector<Face>& faces, const std::vector<double>& r, const Labels& labels, const Weight& w)
{
  Real sum = 0;
  for (const Real e : energies(faces, r, labels, w))
    sum += e;
  return double(sum);
}

} // namespace reference

#endif // CGAL_SURFACE_MESH_COARSENING_TEST_REFERENCE_ENERGY_H
