// SPDX-License-Identifier: GPL-3.0-or-later
//
// coarsen_mesh_mpi: coarsens a mesh that no single machine has to hold. `coarsen_mesh_mpi --help` shows its usage.

#include "Cluster_file.h"
#include "Input_slice.h"
#include "Options.h"
#include "Run_report.h"
#include "all_ranks.h"
#include "io/Failure.h"
#include "io/Output_files.h"
#include "io/file_type.h"
#include "io/write_mesh.h"

#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Quadric_placement.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_distributed_mesh.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <boost/mpi/collectives.hpp>
#include <boost/mpi/environment.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

namespace coarsen_mesh_mpi {
namespace {

namespace SMC = CGAL::Surface_mesh_coarsening;
using coarsening_support::Mesh;

struct Result
{
  Mesh output;
  std::vector<std::uint32_t> clusters; // of the faces of this rank, if they are wanted
  std::string report;
};

SMC::Distributed_report coarsen(const boost::mpi::communicator& ranks, const Input_slice& slice, const Options& options,
                                Result& result)
{
  const auto names = boost::make_function_property_map<std::uint64_t>([&](std::uint64_t face) { return slice.name(face); });
  const auto run = [&](const auto& np) {
#ifdef CGAL_LINKED_WITH_TBB
    typedef CGAL::Parallel_tag Tag;
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, options.threads);
#else
    typedef CGAL::Sequential_tag Tag;
#endif
    return SMC::coarsen_distributed_faces<Tag>(ranks, slice, options.number_of_vertices, result.output, np);
  };
  const auto with_clusters = [&](const auto& np) {
    if (options.clusters.empty())
      return run(np);
    result.clusters.resize(std::size_t(slice.number_of_faces()));
    return run(np.face_cluster_map(boost::make_iterator_property_map(result.clusters.begin(), boost::identity_property_map())));
  };
  const auto with_placement = [&](const auto& placement) {
    const auto np = SMC::parameters::vertex_placement(placement)
                      .face_name_map(names)
                      .scratch_directory(options.scratch)
                      .scratch_memory(options.memory.value_or(0) / 4);
    return options.faces_per_block ? with_clusters(np.faces_per_block(*options.faces_per_block)) : with_clusters(np);
  };
  return options.is_fitted ? with_placement(SMC::Fitted_placement()) : with_placement(SMC::Quadric_placement());
}

// Writes all files or none.
void write(const boost::mpi::communicator& ranks, const Options& options, const Input_slice& slice, const Result& result)
{
  coarsen_mesh_tool::Output_files files;
  std::optional<Cluster_file> cluster_file;
  on_all_ranks(ranks, [&] {
    if (!options.clusters.empty()) {
      cluster_file.emplace(options.clusters, ranks.rank());
      cluster_file->write(slice, result.clusters);
    }
    if (ranks.rank() != 0)
      return;
    files.stage(options.output, coarsen_mesh_tool::mesh_bytes(result.output, coarsening_support::file_type(options.output)));
    if (!options.clusters.empty())
      files.stage(options.clusters, list_of_cluster_files(options.clusters, ranks.size()));
    if (!options.report.empty())
      files.stage(options.report, result.report);
  });
  try {
    on_all_ranks(ranks, [&] {
      files.write_streams(nullptr);
      if (cluster_file)
        cluster_file->commit();
    });
    on_all_ranks(ranks, [&] { files.commit(); });
  } catch (const std::exception&) {
    if (cluster_file)
      cluster_file->undo();
    throw;
  }
}

void run(const boost::mpi::communicator& ranks, const Options& options)
{
  Run_report report(ranks);
  const Input_slice slice(ranks, options.inputs);
  Result result;
  report.add(slice, coarsen(ranks, slice, options, result));
  result.report = report.json();
  write(ranks, options, slice, result);
  if (ranks.rank() == 0 && !options.is_quiet)
    std::cout << report.sentence() << '\n';
}

int run(int argc, char* argv[])
{
  // A file above the size limit is a failure to write, and must not end the program by a signal.
  std::signal(SIGXFSZ, SIG_IGN);
  const boost::mpi::environment environment(argc, argv, boost::mpi::threading::funneled);
  const boost::mpi::communicator ranks;
  try {
    const Options options = read_options(argc, argv);
    if (options.help.empty())
      run(ranks, options);
    else if (ranks.rank() == 0)
      std::cout << options.help;
    return EXIT_SUCCESS;
  } catch (const std::exception& e) {
    // All ranks have the same message.
    if (ranks.rank() == 0)
      std::cerr << "coarsen_mesh_mpi: " << coarsening_support::escaped_utf8(e.what()) << '\n';
    return EXIT_FAILURE;
  }
}

} // namespace
} // namespace coarsen_mesh_mpi

int main(int argc, char* argv[]) { return coarsen_mesh_mpi::run(argc, argv); }
