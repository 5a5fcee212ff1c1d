// SPDX-License-Identifier: GPL-3.0-or-later

#include "Output_files.h"

#include "support/Failure.h"

#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

#include <unistd.h>

namespace coarsen_mesh_tool {
namespace {

using coarsening_support::Failure;
namespace fs = std::filesystem;

Failure cannot_write(const std::string& file, const std::error_code& error)
{
  return Failure(file, "cannot be written: " + error.message());
}

std::error_code last_error() { return std::error_code(errno ? errno : EIO, std::generic_category()); }

// `mode` is one of std::fopen.
std::error_code write_bytes(const fs::path& file, const char* mode, const std::string& bytes)
{
  errno = 0;
  std::FILE* stream = std::fopen(file.c_str(), mode);
  if (!stream)
    return last_error();
  std::error_code error;
  if (std::fwrite(bytes.data(), 1, bytes.size(), stream) != bytes.size() || std::fflush(stream) != 0)
    error = last_error();
  if (std::fclose(stream) != 0 && !error)
    error = last_error();
  return error;
}

// A name in the folder of the target that nobody else uses.
fs::path hidden_name(const fs::path& target, const char* purpose)
{
  return target.parent_path() / ("." + target.filename().string() + "." + std::to_string(getpid()) + "." + purpose);
}

// The file that a chain of links ends at: it is to be replaced, not the link.
fs::path end_of_links(const std::string& file)
{
  std::error_code error;
  const fs::path end = fs::is_symlink(file, error) ? fs::canonical(file, error) : fs::path(file);
  return error || end.empty() ? fs::path(file) : end;
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
  entry.target = end_of_links(file);
  std::error_code error;
  const fs::file_status status = fs::status(entry.target, error);
  if (fs::is_directory(status))
    throw cannot_write(file, std::make_error_code(std::errc::is_a_directory));
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    entry.bytes = bytes;
    entries.push_back(std::move(entry));
    return;
  }
  entry.temporary = hidden_name(entry.target, "part");
  entries.push_back(entry); // from here on the destructor cleans up
  remove_quietly(entry.temporary);
  error = write_bytes(entry.temporary, "wbx", bytes);
  if (error)
    throw cannot_write(file, error);
  if (fs::exists(status))
    fs::permissions(entry.temporary, status.permissions(), error); // as before, where that is allowed
}

void Output_files::place(Entry& entry)
{
  std::error_code error;
  if (entry.temporary.empty())
    error = write_bytes(entry.target, "wb", entry.bytes);
  else {
    if (fs::exists(entry.target, error)) {
      // A second name for what is replaced, so that it can come back. Some file systems have no second names.
      fs::path former = hidden_name(entry.target, "former");
      fs::create_hard_link(entry.target, former, error);
      if (!error)
        entry.former = std::move(former);
    }
    fs::rename(entry.temporary, entry.target, error);
  }
  if (error)
    throw cannot_write(entry.name, error);
  entry.placed = true;
}

void Output_files::undo()
{
  for (Entry& entry : entries) {
    if (!entry.placed || entry.temporary.empty())
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
      place(entry);
  } catch (const Failure&) {
    undo();
    throw;
  }
}

} // namespace coarsen_mesh_tool
