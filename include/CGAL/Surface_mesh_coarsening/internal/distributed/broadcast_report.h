// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_BROADCAST_REPORT_H
#define CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_BROADCAST_REPORT_H

#include <CGAL/Surface_mesh_coarsening/Coarsening_report.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/Words.h>
#include <CGAL/Surface_mesh_coarsening/internal/distributed/exchange.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace CGAL {
namespace Surface_mesh_coarsening {
namespace internal {

// Calls `visit(number)` for each number of a report, with the numbers in its lists. The lists have their sizes already. The
// function names all members, so it does not compile if a member is added.
template <class Visit>
void for_each_number(Coarsening_report& report, const Visit& visit)
{
  auto& [level, seeds, clusters, splits, merges, rounds, moves, tests, refused_by_boundary_counts, refused_by_guarantee,
         initial_energy, final_energy, converged, subdivided_components, dropped_components, exchanged_vertices,
         intersections_found, intersections_left, intersecting_faces, reversals_found, reversals_left, narrow_faces, clusterings,
         feature_lines, feature_corners] = report;
  for (std::size_t* const count :
       {&level, &seeds, &clusters, &splits, &merges, &rounds, &moves, &tests, &refused_by_boundary_counts, &refused_by_guarantee,
        &subdivided_components, &dropped_components, &exchanged_vertices, &intersections_found, &intersections_left,
        &reversals_found, &reversals_left, &clusterings, &feature_lines, &feature_corners})
    visit(*count);
  visit(initial_energy);
  visit(final_energy);
  visit(converged);
  for (auto& [first, second] : intersecting_faces) {
    visit(first);
    visit(second);
  }
  for (std::size_t& face : narrow_faces)
    visit(face);
}

// Sends the report of rank 0 to all ranks.
inline void broadcast_report(Rank_context& context, Coarsening_report& report)
{
  Words sizes{report.intersecting_faces.size(), report.narrow_faces.size()}, words;
  broadcast_words(context, sizes);
  report.intersecting_faces.resize(sizes[0]);
  report.narrow_faces.resize(sizes[1]);
  for_each_number(report, [&](auto& number) {
    if constexpr (std::is_same<decltype(number), double&>::value)
      words.push_back(to_word(number));
    else
      words.push_back(std::uint64_t(number));
  });
  broadcast_words(context, words);
  auto word = words.begin();
  for_each_number(report, [&](auto& number) {
    if constexpr (std::is_same<decltype(number), double&>::value)
      number = to_double(*word++);
    else
      number = static_cast<std::remove_reference_t<decltype(number)> >(*word++);
  });
}

} // namespace internal
} // namespace Surface_mesh_coarsening
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_COARSENING_INTERNAL_DISTRIBUTED_BROADCAST_REPORT_H
