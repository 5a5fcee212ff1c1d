// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSEN_MESH_OUTPUT_FILES_H
#define COARSEN_MESH_OUTPUT_FILES_H

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace coarsen_mesh_tool {

// Writes several files so that each appears whole, and all of them or none.
//
// A staged file lies under another name in the folder of its target, so that giving it its own name is one step of the
// file system. What has not been committed is removed by the destructor. Pipes and devices cannot be treated so: they are
// written to when everything else is staged and nothing has its name yet.
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

  // Writes the content under a temporary name. Throws Failure if that cannot be done.
  void stage(const std::string& file, const std::string& bytes);

  // Writes to pipes and devices. `stop` is called when a signal has interrupted that; it throws to give up.
  void write_streams(const std::function<void()>& stop);

  // Gives all staged files their names. Throws Failure after having undone everything if one cannot get its name.
  void commit();

private:
  static void place(Entry& entry);
  void undo();
};

} // namespace coarsen_mesh_tool

#endif // COARSEN_MESH_OUTPUT_FILES_H
