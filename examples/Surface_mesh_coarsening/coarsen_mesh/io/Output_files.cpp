// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/Output_files.h"

#include "io/Descriptor.h"
#include "io/Failure.h"
#include "io/same_file.h"

#include <cstddef>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace coarsen_mesh_tool {
namespace {

using coarsening_support::Failure;
namespace fs = std::filesystem;

Failure cannot_write(const std::string& file, const std::error_code& error)
{
  return Failure(file, "cannot be written: " + error.message());
}

// `flags` are those of open(). `stop` as in write_streams().
std::error_code write_bytes(const fs::path& file, int flags, const std::string& bytes,
                            const std::function<void()>& stop = nullptr)
{
  std::error_code error;
  coarsening_support::Descriptor descriptor(file.string(), O_WRONLY | flags, stop, error);
  if (!error)
    descriptor.write(bytes, stop, error);
  if (!error)
    descriptor.close(error);
  return error;
}

// Returns an unused name in the folder of the target.
fs::path hidden_name(const fs::path& target, const char* purpose, std::size_t index)
{
  return target.parent_path() / (".coarsen_mesh." + std::to_string(getpid()) + "." + std::to_string(index) + "." + purpose);
}

// Returns whether the name denotes something already open, possibly a file, that must not be replaced.
bool is_open_file(const std::string& file)
{
  return file == "/dev/stdout" || file == "/dev/stderr" || file.compare(0, 8, "/dev/fd/") == 0 ||
         file.compare(0, 6, "/proc/") == 0;
}

void remove_quietly(const fs::path& file)
{
  std::error_code ignored;
  if (!file.empty())
    fs::remove(file, ignored);
}

} // namespace

Output_files::~Output_files()
{
  for (const Entry& entry : entries) {
    if (!entry.placed)
      remove_quietly(entry.temporary);
    remove_quietly(entry.former);
  }
}

void Output_files::stage(const std::string& file, const std::string& bytes)
{
  Entry entry;
  entry.name = file;
  if (file == coarsening_support::standard_stream) {
    entry.target = file;
    entry.bytes = bytes;
    entries.push_back(std::move(entry));
    return;
  }
  entry.target = coarsening_support::end_of_links(file); // which is to be replaced, not the link
  std::error_code error;
  const fs::file_status status = fs::status(entry.target, error);
  if (status.type() == fs::file_type::none) // its name is too long, its folder is not accessible, or similar
    throw cannot_write(file, error);
  if (fs::is_symlink(fs::symlink_status(entry.target, error)))
    throw cannot_write(file, std::make_error_code(std::errc::too_many_symbolic_link_levels));
  if (fs::is_directory(status))
    throw cannot_write(file, std::make_error_code(std::errc::is_a_directory));
  if (is_open_file(file))
    entry.target = file;
  if (is_open_file(file) || (fs::exists(status) && !fs::is_regular_file(status))) {
    entry.bytes = bytes;
    entries.push_back(std::move(entry));
    return;
  }
  entry.temporary = hidden_name(entry.target, "part", entries.size());
  entries.push_back(entry); // from here on the destructor removes it
  remove_quietly(entry.temporary);
  error = write_bytes(entry.temporary, O_CREAT | O_EXCL, bytes);
  if (error)
    throw cannot_write(file, error);
  if (fs::exists(status))
    fs::permissions(entry.temporary, status.permissions(), error); // as before, if permitted
}

void Output_files::write_streams(const std::function<void()>& stop)
{
  for (const Entry& entry : entries)
    if (entry.temporary.empty()) {
      const std::error_code error = write_bytes(entry.target, 0, entry.bytes, stop);
      if (error == std::errc::broken_pipe && entry.target == coarsening_support::standard_stream)
        throw Closed_pipe();
      if (error)
        throw cannot_write(entry.name, error);
    }
}

void Output_files::place(Entry& entry)
{
  std::error_code error;
  if (fs::exists(entry.target, error)) {
    // Gives the replaced file a second name, from which it can be restored. Some file systems have no second names.
    fs::path former = entry.temporary;
    former.replace_extension("former");
    fs::create_hard_link(entry.target, former, error);
    if (!error)
      entry.former = std::move(former);
  }
  fs::rename(entry.temporary, entry.target, error);
  if (error)
    throw cannot_write(entry.name, error);
  entry.placed = true;
}

void Output_files::undo()
{
  for (Entry& entry : entries) {
    if (!entry.placed)
      continue;
    std::error_code ignored;
    if (entry.former.empty())
      fs::remove(entry.target, ignored);
    else
      fs::rename(entry.former, entry.target, ignored);
    entry.former.clear();
  }
}

void Output_files::commit()
{
  try {
    for (Entry& entry : entries)
      if (!entry.temporary.empty())
        place(entry);
  } catch (const Failure&) {
    undo();
    throw;
  }
}

} // namespace coarsen_mesh_tool
