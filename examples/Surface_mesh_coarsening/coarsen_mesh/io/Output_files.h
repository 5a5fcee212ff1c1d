// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_OUTPUT_FILES_H
#define COARSEN_MESH_OUTPUT_FILES_H

#include <exception>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace coarsen_mesh_tool {

// The reader of standard output ended before all was written, as `head` does.
struct Closed_pipe : std::exception
{};

// Writes several files such that each appears complete, and all of them or none.
//
// A staged file has a temporary name in the folder of its target, so that renaming it is one step of the file system. The
// destructor removes uncommitted files. Pipes and devices cannot be staged: they are written when all files are staged
// and none is renamed yet.
class Output_files
{
  struct Entry
  {
    std::string name; // as the user gave it
    std::filesystem::path target, temporary, former;
    std::string bytes; // for a pipe or a device
    bool placed = false;
  };
  std::vector<Entry> entries;

public:
  Output_files() = default;
  Output_files(const Output_files&) = delete;
  Output_files& operator=(const Output_files&) = delete;
  ~Output_files();

  // Writes the content under a temporary name. Throws Failure if this is impossible.
  void stage(const std::string& file, const std::string& bytes);

  // Writes to pipes and devices. Calls `stop` after a signal has interrupted this; it may throw to end the writing. Throws
  // Failure, and Closed_pipe for standard output.
  void write_streams(const std::function<void()>& stop);

  // Renames all staged files to their targets. If one fails, undoes all and throws Failure.
  void commit();

private:
  static void place(Entry& entry);
  void undo();
};

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_OUTPUT_FILES_H
