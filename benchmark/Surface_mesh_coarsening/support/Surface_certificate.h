// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_BENCHMARK_SURFACE_CERTIFICATE_H
#define COARSENING_BENCHMARK_SURFACE_CERTIFICATE_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

// The oracle of the sweep. It reads a list of polygons and uses neither the library nor the halfedges of a mesh,
// which could not even represent some of the faults.
namespace benchmark_support {

struct Surface_counts
{
  std::size_t vertices = 0, edges = 0, faces = 0, loops = 0;

  long characteristic() const { return long(vertices) - long(edges) + long(faces); }
  long genus() const { return (2 - characteristic() - long(loops)) / 2; }
  bool same_surface_as(const Surface_counts& c) const
  {
    return characteristic() == c.characteristic() && loops == c.loops;
  }

  // Returns a lower bound on the vertices of simplicial surfaces of this topology. For closed surfaces it is
  // Heawood's bound with the exception of genus 2 (Jungerman and Ringel, 1980); a cone over each border loop makes
  // a surface closed.
  std::size_t fewest_vertices() const
  {
    const double g = double(genus());
    const std::size_t closed = genus() == 2 ? 10 : std::size_t(std::ceil((7 + std::sqrt(1 + 48 * g)) / 2 - 1e-9));
    return (std::max)(3 * loops, closed - (std::min)(closed, loops));
  }
};

// An oriented surface given by polygons, or the first fault if they form none.
class Surface_certificate
{
public:
  typedef std::vector<std::vector<std::size_t> > Polygons;

  // If `simplicial`, only triangles are allowed, no two with the same vertices, and no vertex without a triangle.
  Surface_certificate(const Polygons& polygons, std::size_t vertices, bool simplicial)
    : polygons_(polygons), vertices_(vertices)
  {
    find_fault(simplicial);
    if (fault_.empty())
      count();
  }

  const std::string& fault() const { return fault_; }
  const std::vector<Surface_counts>& components() const { return components_; }
  // The component of a vertex; the number of components for a vertex without faces.
  std::size_t component(std::size_t vertex) const { return component_[vertex]; }

  Surface_counts total() const
  {
    Surface_counts sum;
    for (const Surface_counts& c : components_) {
      sum.vertices += c.vertices;
      sum.edges += c.edges;
      sum.faces += c.faces;
      sum.loops += c.loops;
    }
    return sum;
  }

private:
  struct Side
  {
    std::size_t from, to, corner; // `corner` is the corner of `from`; the next one belongs to `to`
    bool operator<(const Side& s) const { return std::make_pair(from, to) < std::make_pair(s.from, s.to); }
  };

  class Disjoint_sets
  {
  public:
    explicit Disjoint_sets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), std::size_t(0)); }
    std::size_t find(std::size_t x)
    {
      while (parent_[x] != x)
        x = parent_[x] = parent_[parent_[x]];
      return x;
    }
    bool unite(std::size_t a, std::size_t b)
    {
      a = find(a);
      b = find(b);
      parent_[a] = b;
      return a != b;
    }

  private:
    std::vector<std::size_t> parent_;
  };

  void find_fault(bool simplicial)
  {
    if (polygons_.empty())
      fault_ = "there are no faces";
    for (std::size_t f = 0; f < polygons_.size() && fault_.empty(); ++f)
      collect_sides(f, simplicial);
    if (fault_.empty() && simplicial)
      find_repeated_triangle();
    if (fault_.empty()) {
      std::sort(sides_.begin(), sides_.end());
      for (std::size_t i = 1; i < sides_.size() && fault_.empty(); ++i)
        if (!(sides_[i - 1] < sides_[i]))
          fault_ = "two faces use the edge from " + name(sides_[i].from) + " to " + name(sides_[i].to) +
                   " in the same direction";
    }
    if (fault_.empty())
      find_bad_vertex(simplicial);
  }

  static std::string name(std::size_t v) { return std::to_string(v); }

  void collect_sides(std::size_t f, bool simplicial)
  {
    const std::vector<std::size_t>& p = polygons_[f];
    if (p.size() < 3 || (simplicial && p.size() != 3))
      fault_ = "face " + name(f) + " has " + name(p.size()) + " vertices";
    for (std::size_t i = 0; i < p.size() && fault_.empty(); ++i) {
      if (p[i] >= vertices_)
        fault_ = "face " + name(f) + " names vertex " + name(p[i]) + ", which is not there";
      if (std::find(p.begin() + i + 1, p.end(), p[i]) != p.end())
        fault_ = "face " + name(f) + " uses vertex " + name(p[i]) + " twice";
      sides_.push_back({p[i], p[(i + 1) % p.size()], corners_ + i});
    }
    for (std::size_t i = 0; i < p.size(); ++i)
      next_corner_.push_back(corners_ + (i + 1) % p.size());
    corners_ += p.size();
  }

  void find_repeated_triangle()
  {
    std::vector<std::array<std::size_t, 3> > triples;
    triples.reserve(polygons_.size());
    for (const auto& p : polygons_) {
      triples.push_back({p[0], p[1], p[2]});
      std::sort(triples.back().begin(), triples.back().end());
    }
    std::sort(triples.begin(), triples.end());
    const auto twice = std::adjacent_find(triples.begin(), triples.end());
    if (twice != triples.end())
      fault_ = "two faces stand on the vertices " + name((*twice)[0]) + ", " + name((*twice)[1]) + " and " +
               name((*twice)[2]);
  }

  // Requires sorted sides.
  void pair_sides()
  {
    opposite_.assign(sides_.size(), nullptr);
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      const Side turned{sides_[i].to, sides_[i].from, 0};
      const auto found = std::lower_bound(sides_.begin(), sides_.end(), turned);
      if (found != sides_.end() && !(turned < *found))
        opposite_[i] = &*found;
    }
  }
  const Side* opposite(const Side& s) const { return opposite_[std::size_t(&s - sides_.data())]; }

  // The corners at a vertex, joined across edges, have to be one fan.
  void find_bad_vertex(bool isolated_is_bad)
  {
    pair_sides();
    std::vector<std::size_t> fans(vertices_, 0);
    for (const Side& s : sides_)
      ++fans[s.from];
    Disjoint_sets corners(corners_);
    for (const Side& s : sides_)
      if (const Side* t = opposite(s))
        if (corners.unite(s.corner, next_corner_[t->corner]))
          --fans[s.from];
    for (std::size_t v = 0; v < vertices_ && fault_.empty(); ++v)
      if (fans[v] > 1)
        fault_ = "the faces around vertex " + name(v) + " form " + name(fans[v]) + " fans";
      else if (fans[v] == 0 && isolated_is_bad)
        fault_ = "vertex " + name(v) + " has no face";
  }

  void count()
  {
    const std::size_t none = std::size_t(-1);
    Disjoint_sets sets(vertices_), borders(vertices_);
    std::vector<bool> used(vertices_, false), on_border(vertices_, false);
    for (const Side& s : sides_) {
      used[s.from] = true;
      sets.unite(s.from, s.to);
      if (!opposite(s)) {
        on_border[s.from] = true;
        borders.unite(s.from, s.to);
      }
    }
    component_.assign(vertices_, none);
    std::vector<std::size_t> number(vertices_, none);
    for (std::size_t v = 0; v < vertices_; ++v) {
      if (!used[v])
        continue;
      std::size_t& n = number[sets.find(v)];
      if (n == none) {
        n = components_.size();
        components_.emplace_back();
      }
      component_[v] = n;
      ++components_[n].vertices;
      // A loop has one border edge from each of its vertices, so one of them identifies its set.
      if (on_border[v] && borders.find(v) == v)
        ++components_[n].loops;
    }
    std::replace(component_.begin(), component_.end(), none, components_.size());
    for (const Side& s : sides_)
      if (s.from < s.to || !opposite(s))
        ++components_[component_[s.from]].edges;
    for (const auto& p : polygons_)
      ++components_[component_[p[0]]].faces;
  }

  const Polygons& polygons_;
  std::size_t vertices_, corners_ = 0;
  std::vector<Side> sides_;
  std::vector<const Side*> opposite_;
  std::vector<std::size_t> next_corner_;
  std::string fault_;
  std::vector<Surface_counts> components_;
  std::vector<std::size_t> component_;
};

} // namespace benchmark_support

#endif // COARSENING_BENCHMARK_SURFACE_CERTIFICATE_H
