// SPDX-License-Identifier: GPL-3.0-or-later

#include "Run_report.h"

#include <boost/mpi/collectives.hpp>

#include <nlohmann/json.hpp>

#include <sstream>

#include <sys/resource.h>

namespace coarsen_mesh_mpi {

Run_report::Run_report(const boost::mpi::communicator& ranks)
  : communicator_(ranks), begin_(std::chrono::steady_clock::now())
{}

void Run_report::add(const Input_slice& slice, const CGAL::Surface_mesh_coarsening::Distributed_report& done)
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  const Rank own{slice.number_of_faces(), done.bytes_sent, done.bytes_of_scratch, std::uint64_t(usage.ru_maxrss) * 1024,
                 seconds(usage.ru_utime) + seconds(usage.ru_stime)};
  ranks_.resize(std::size_t(communicator_.size()));
  boost::mpi::gather(communicator_, reinterpret_cast<const char*>(&own), int(sizeof own), reinterpret_cast<char*>(ranks_.data()),
                     0);
  seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  faces_ = slice.number_of_all_faces();
  done_ = done;
}

std::string Run_report::json() const
{
  nlohmann::ordered_json ranks = nlohmann::ordered_json::array();
  for (const Rank& rank : ranks_)
    ranks.push_back({{"faces_read", rank.faces},
                     {"cpu_seconds", rank.cpu_seconds},
                     {"peak_memory_bytes", rank.peak_memory},
                     {"bytes_sent", rank.bytes_sent},
                     {"bytes_of_scratch", rank.bytes_of_scratch}});
  const nlohmann::ordered_json all = {{"faces", faces_},
                                      {"clusters", done_.clusters},
                                      {"rounds", done_.rounds},
                                      {"energy", done_.final_energy},
                                      {"intersections_found", done_.intersections_found},
                                      {"intersections_left", done_.intersections_left},
                                      {"reversals_found", done_.reversals_found},
                                      {"reversals_left", done_.reversals_left},
                                      {"seconds", seconds_},
                                      {"ranks", ranks}};
  return all.dump(2) + "\n";
}

std::string Run_report::sentence() const
{
  std::ostringstream text;
  text.precision(3);
  text << faces_ << " faces to " << done_.clusters << " vertices on " << ranks_.size()
       << (ranks_.size() == 1 ? " rank" : " ranks") << " in " << seconds_ << " s";
  if (done_.intersections_left > 0)
    text << ", with " << done_.intersections_left << " intersecting pairs of triangles";
  return text.str();
}

} // namespace coarsen_mesh_mpi
