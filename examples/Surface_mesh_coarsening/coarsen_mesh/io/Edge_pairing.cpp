// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/Edge_pairing.h"

#include <algorithm>
#include <new>

namespace coarsening_support {
namespace {

// Calls `use(s, a, b)` for each side, from `a` to `b`.
template <class Use>
void for_each_side(const Polygons& polygons, const Stop& stop, const Use& use)
{
  const std::vector<Vertex_number>& corners = polygons.corners();
  for (std::size_t f = 0, begin = 0; f < polygons.size(); ++f) {
    stop_at(f, stop);
    const std::size_t end = polygons.first_corner(f + 1);
    for (std::size_t s = begin; s < end; ++s)
      use(static_cast<Edge_pairing::Side>(s), corners[s], corners[s + 1 == end ? begin : s + 1]);
    begin = end;
  }
}

} // namespace

// A counting sort: groups the sides of an edge with few others.
std::vector<std::size_t> Edge_pairing::sort_by_lower_end(const Polygons& polygons, std::size_t vertices, const Stop& stop,
                                                         std::vector<Entry>& entries)
{
  std::vector<std::size_t> ends(vertices + 1, 0);
  for_each_side(polygons, stop, [&](Side, Vertex_number a, Vertex_number b) { ++ends[(std::min)(a, b) + 1]; });
  for (std::size_t v = 0; v < vertices; ++v)
    ends[v + 1] += ends[v];
  entries.resize(polygons.corners().size());
  for_each_side(polygons, stop, [&](Side s, Vertex_number a, Vertex_number b) {
    entries[ends[(std::min)(a, b)]++] = {(std::max)(a, b), s};
  });
  return ends;
}

void Edge_pairing::pair(const Entry* begin, const Entry* end, const std::vector<Vertex_number>& sources)
{
  while (begin != end) {
    const Entry* next = begin + 1;
    while (next != end && next->other == begin->other)
      ++next;
    edges_.push_back(begin->side);
    if (next - begin == 2 && sources[begin[0].side] != sources[begin[1].side]) {
      twins_[begin[0].side] = begin[1].side;
      twins_[begin[1].side] = begin[0].side;
    } else if (next - begin > 1 && (unpaired_.empty() || begin[1].side < unpaired_[1])) {
      unpaired_.clear();
      for (const Entry* e = begin; e != next; ++e)
        unpaired_.push_back(e->side);
    }
    begin = next;
  }
}

Edge_pairing::Edge_pairing(const Polygons& polygons, std::size_t vertices, const Stop& stop)
{
  const std::vector<Vertex_number>& sources = polygons.corners();
  if (sources.size() >= none)
    throw std::bad_alloc(); // too many for the numbers of a mesh
  std::vector<Entry> entries;
  const std::vector<std::size_t> ends = sort_by_lower_end(polygons, vertices, stop, entries);
  twins_.assign(sources.size(), none);
  edges_.reserve(sources.size() / 2 + 1);
  for (std::size_t v = 0, begin = 0; v < vertices; ++v) {
    stop_at(v, stop);
    Entry *const first = entries.data() + begin, *const last = entries.data() + ends[v];
    std::sort(first, last,
              [](const Entry& s, const Entry& t) { return s.other != t.other ? s.other < t.other : s.side < t.side; });
    pair(first, last, sources);
    begin = ends[v];
  }
}

} // namespace coarsening_support
