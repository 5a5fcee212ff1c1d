// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/assimp/Scene_text.h"
#include "io/assimp/output_of_process.h"
#include "io/assimp_formats.h"
#include "io/read_obj.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/Importer.hpp>

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <system_error>

namespace coarsening_support {
namespace {

// Opens regular files in or below one directory, for reading.
class Files_beside : public Assimp::DefaultIOSystem
{
  std::filesystem::path directory_;

public:
  explicit Files_beside(const std::string& file)
    : directory_(std::filesystem::canonical(std::filesystem::absolute(file).parent_path()))
  {}

  Assimp::IOStream* Open(const char* file, const char* mode) override
  {
    std::error_code error;
    const std::filesystem::path path = std::filesystem::canonical(file, error);
    const std::filesystem::path below = path.lexically_relative(directory_);
    const bool is_below = !error && !below.empty() && *below.begin() != "..";
    if (!is_below || mode[0] != 'r' || !std::filesystem::is_regular_file(path, error))
      return nullptr;
    return DefaultIOSystem::Open(file, mode);
  }
};

// What has been left out, one field a line, an empty line, and the text of an OBJ file.
std::string scene_text(const std::string& content, const std::string& file, const std::string& type)
{
  Assimp::Importer importer;
  const aiScene* scene = nullptr;
  if (file.empty()) {
    scene = importer.ReadFileFromMemory(content.data(), content.size(), 0, type.c_str());
  } else {
    importer.SetIOHandler(new Files_beside(file));
    scene = importer.ReadFile(file, 0);
  }
  if (scene == nullptr)
    throw std::runtime_error(*importer.GetErrorString() == '\0' ? "the file cannot be read" : importer.GetErrorString());
  Scene_text text(*scene);
  std::string result;
  for (const std::string& field : text.left_out())
    result += field + '\n';
  return result + '\n' + std::move(text).text();
}

} // namespace

void read_with_assimp(const std::string& content, const std::string& file, const std::string& type, Soup& soup, const Stop& stop)
{
  // Ample for files that are sound.
  const Process_limits limits = {60 + content.size() / 1000000, (std::size_t(4) << 30) + 200 * content.size()};
  std::string text = output_of_process(
    "Assimp", limits, [&] { return scene_text(content, file, type); }, stop);
  std::size_t at = 0;
  for (std::size_t end = text.find('\n'); end != at && end != std::string::npos; end = text.find('\n', at)) {
    soup.leave_out(text.substr(at, end - at));
    at = end + 1;
  }
  text.erase(0, at + 1);
  read_obj(text, soup, stop);
}

} // namespace coarsening_support
