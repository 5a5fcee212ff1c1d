// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/assimp/Scene_text.h"
#include "io/assimp/output_of_process.h"
#include "io/Failure.h"
#include "io/assimp_formats.h"
#include "io/read_obj.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/Importer.hpp>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <memory>
#include <set>
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

// The text of a glTF file, also within its binary form, whose header has 12 bytes, then the length and the type of the text.
std::string gltf_text(const std::string& content)
{
  constexpr std::size_t header = 20;
  if (content.compare(0, 4, "glTF") != 0 || content.size() < header)
    return content;
  std::size_t length = 0;
  for (std::size_t i = 4; i > 0; --i)
    length = 256 * length + static_cast<unsigned char>(content[11 + i]);
  return content.substr(header, length);
}

// The fields of an application's own, whose names begin with an underscore, which Assimp does not read.
std::set<std::string> own_gltf_fields(const std::string& content)
{
  std::set<std::string> fields;
  const nlohmann::json gltf = nlohmann::json::parse(gltf_text(content), nullptr, false);
  const auto list = [](const nlohmann::json& object, const char* name) {
    return object.is_object() && object.contains(name) ? object[name] : nlohmann::json::array();
  };
  for (const nlohmann::json& mesh : list(gltf, "meshes"))
    for (const nlohmann::json& primitive : list(mesh, "primitives")) {
      const nlohmann::json attributes = list(primitive, "attributes");
      for (const auto& attribute : attributes.items())
        if (attribute.key()[0] == '_')
          fields.insert("the numbers '" + escaped(attribute.key()) + "' of vertices");
    }
  return fields;
}

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
  if (type == "gltf" || type == "glb")
    for (const std::string& field : own_gltf_fields(content))
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
