// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_BENCHMARK_ALL_METHODS_H
#define COARSENING_BENCHMARK_ALL_METHODS_H

#include "peers.h"

#include <vector>

namespace benchmark_support {

inline std::vector<Method> all_methods()
{
  std::vector<Method> methods{
    our_method<SMC::Uniform_weight>("ours uniform", 1),
    our_method<SMC::Weighted_area_weight>("ours area", 50),
    our_method<SMC::Maximum_density_weight>("ours maximum", 50),
    our_method<SMC::Density_variance_weight>("ours variance", 3),
    our_method<SMC::Maximum_density_weight, SMC::Quadric_placement>("ours maximum quadric", 50),
    our_method<SMC::Maximum_density_weight, SMC::Quadric_placement>("ours maximum quadric without repair", 50, false),
    our_method<SMC::Weighted_area_weight, SMC::Fitted_placement>("ours area fitted", 10),
    {"CGAL edge collapse", run_lindstrom_turk},
    {"CGAL edge collapse by planes", run_garland_heckbert<Plane_quadrics>}};
#ifdef COARSENING_HAS_ACVD
  methods.push_back(acvd("CGAL ACVD", CGAL::parameters::random_seed(0)));
#endif
  add_other_libraries(methods);
  return methods;
}

} // namespace benchmark_support

#endif // COARSENING_BENCHMARK_ALL_METHODS_H
