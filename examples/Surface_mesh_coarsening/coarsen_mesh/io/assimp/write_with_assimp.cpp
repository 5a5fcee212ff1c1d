// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/Corner_fields.h"
#include "io/Failure.h"
#include "io/Number_property.h"
#include "io/assimp/export_format.h"
#include "io/assimp_formats.h"
#include "io/file_bytes.h"
#include "io/file_type.h"

#include <assimp/Exporter.hpp>
#include <assimp/scene.h>

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include <nlohmann/json.hpp>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <system_error>
#include <tuple>
#include <vector>

namespace coarsening_support {
namespace {

typedef Corner_fields::Normal Normal;

aiVector3D vector3(double x, double y, double z) { return aiVector3D(ai_real(x), ai_real(y), ai_real(z)); }

// A mesh of Assimp has one texture point and one normal for each vertex: where those of corners differ, a vertex is repeated.
class Corner_vertices
{
  typedef std::tuple<std::size_t, Texture_point, Normal> Key;

  const Mesh& mesh_;
  Corner_fields fields_;
  std::map<Key, unsigned> numbers_;
  std::vector<Halfedge> corners_; // of each vertex, one that points to it

public:
  explicit Corner_vertices(const Mesh& mesh) : mesh_(mesh), fields_(mesh) {}

  unsigned number(Halfedge h)
  {
    const Key key{std::size_t(mesh_.target(h)), fields_.has_texture() ? fields_.texture(h) : Texture_point(),
                  fields_.has_normal() ? fields_.normal(h) : Normal()};
    const auto found = numbers_.emplace(key, unsigned(numbers_.size()));
    if (found.second)
      corners_.push_back(h);
    return found.first->second;
  }

  void write_to(aiMesh& result) const
  {
    const std::size_t n = corners_.size();
    const Color_properties<Vertex> color(mesh_);
    result.mNumVertices = unsigned(n);
    result.mVertices = new aiVector3D[n];
    if (fields_.has_normal())
      result.mNormals = new aiVector3D[n];
    if (fields_.has_texture()) {
      result.mTextureCoords[0] = new aiVector3D[n];
      result.mNumUVComponents[0] = 2;
    }
    if (color)
      result.mColors[0] = new aiColor4D[n];
    for (std::size_t i = 0; i < n; ++i) {
      const Halfedge h = corners_[i];
      const Vertex v = mesh_.target(h);
      const Point& p = mesh_.point(v);
      result.mVertices[i] = vector3(p.x(), p.y(), p.z());
      if (fields_.has_normal())
        result.mNormals[i] = vector3(fields_.normal(h)[0], fields_.normal(h)[1], fields_.normal(h)[2]);
      if (fields_.has_texture())
        result.mTextureCoords[0][i] = vector3(fields_.texture(h)[0], fields_.texture(h)[1], 0);
      const auto part = [v](const Number_property<Vertex>& numbers) { return ai_real(numbers.byte(v) / 255.); };
      if (color)
        result.mColors[0][i] =
          aiColor4D(part(color.red), part(color.green), part(color.blue), color.alpha ? part(color.alpha) : 1);
    }
  }
};

aiMaterial* new_material(const std::string& name)
{
  auto result = std::make_unique<aiMaterial>();
  const aiString words(name.empty() ? AI_DEFAULT_MATERIAL_NAME : name);
  result->AddProperty(&words, AI_MATKEY_NAME);
  return result.release();
}

aiMesh* new_mesh(const Mesh& mesh, const std::vector<Face>& faces, unsigned material)
{
  auto result = std::make_unique<aiMesh>();
  result->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
  result->mName = "mesh";
  result->mMaterialIndex = material;
  result->mFaces = new aiFace[result->mNumFaces = unsigned(faces.size())];
  Corner_vertices vertices(mesh);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    aiFace& face = result->mFaces[f];
    face.mIndices = new unsigned[face.mNumIndices = 3];
    Halfedge h = mesh.halfedge(faces[f]);
    for (unsigned i = 0; i < 3; ++i, h = mesh.next(h))
      face.mIndices[i] = vertices.number(h);
  }
  vertices.write_to(*result);
  return result.release();
}

// The faces of each material, all under one empty name if materials are not written.
std::map<std::string, std::vector<Face> > faces_by_material(const Mesh& mesh, bool writes_materials)
{
  const Found_property<Face, std::string> material(mesh, material_property);
  std::map<std::string, std::vector<Face> > result;
  for (const Face f : mesh.faces())
    result[writes_materials && material ? material.map[f] : ""].push_back(f);
  return result;
}

// A mesh of Assimp has one material. All meshes belong to a child of the root, because 3MF leaves out those of the root itself.
std::unique_ptr<aiScene> scene_of(const Mesh& mesh, bool writes_materials)
{
  const auto pieces = faces_by_material(mesh, writes_materials);
  auto scene = std::make_unique<aiScene>();
  scene->mMaterials = new aiMaterial*[pieces.size()]();
  scene->mMeshes = new aiMesh*[pieces.size()]();
  aiNode* node = new aiNode("mesh");
  scene->mRootNode = new aiNode("root");
  scene->mRootNode->addChildren(1, &node);
  node->mMeshes = new unsigned[node->mNumMeshes = unsigned(pieces.size())];
  for (const auto& piece : pieces) {
    const unsigned number = scene->mNumMeshes;
    scene->mMaterials[scene->mNumMaterials++] = new_material(piece.first);
    scene->mMeshes[scene->mNumMeshes++] = new_mesh(mesh, piece.second, number);
    node->mMeshes[number] = number;
  }
  return scene;
}

std::string bytes_of(const aiExportDataBlob& blob) { return std::string(static_cast<const char*>(blob.data), blob.size); }

std::string base64(std::string bytes)
{
  namespace iterators = boost::archive::iterators;
  typedef iterators::base64_from_binary<iterators::transform_width<std::string::const_iterator, 6, 8> > Letters;
  const std::size_t padding = (3 - bytes.size() % 3) % 3;
  bytes.append(padding, '\0');
  std::string result(Letters(bytes.cbegin()), Letters(bytes.cend()));
  return result.replace(result.size() - padding, padding, padding, '=');
}

// Puts the numbers of a glTF file, which Assimp writes to a file of their own, into the file itself.
std::string in_one_file(const aiExportDataBlob& blob)
{
  nlohmann::ordered_json gltf = nlohmann::ordered_json::parse(bytes_of(blob));
  gltf.at("buffers").at(0)["uri"] = "data:application/octet-stream;base64," + base64(bytes_of(*blob.next));
  return gltf.dump() + "\n";
}

// Some formats are written to files only.
class Temporary_directory
{
  std::string name_ = (std::filesystem::temp_directory_path() / "coarsen_mesh_XXXXXX").string();

public:
  Temporary_directory()
  {
    if (mkdtemp(name_.data()) == nullptr)
      throw Failure(name_, std::generic_category().message(errno));
  }
  Temporary_directory(const Temporary_directory&) = delete;
  Temporary_directory& operator=(const Temporary_directory&) = delete;
  ~Temporary_directory()
  {
    std::error_code ignored;
    std::filesystem::remove_all(name_, ignored);
  }
  std::filesystem::path path() const { return name_; }
};

} // namespace

std::optional<std::string> export_format(const std::string& type)
{
  const Assimp::Exporter exporter;
  std::optional<std::string> result;
  for (std::size_t i = 0; i < exporter.GetExportFormatCount(); ++i) {
    const aiExportFormatDesc& format = *exporter.GetExportFormatDescription(i);
    const std::string id = format.id;
    if (format.fileExtension == type && (!result || id.back() == '2'))
      result = id;
  }
  return result;
}

std::string assimp_bytes(const Mesh& mesh, const std::string& type)
{
  const auto scene = scene_of(mesh, type != "3mf"); // in which each material would take an object of its own
  Assimp::Exporter exporter;
  const std::string format = export_format(type).value_or(type);
  const aiExportDataBlob* blob = exporter.ExportToBlob(scene.get(), format);
  if (blob == nullptr) {
    const Temporary_directory directory;
    const std::string file = (directory.path() / ("mesh." + type)).string();
    if (exporter.Export(scene.get(), format, file) == AI_SUCCESS)
      return file_bytes(file, nullptr);
    throw Failure("the result", "cannot be written as " + upper_case(type) + ": Assimp: " + one_line(exporter.GetErrorString()));
  }
  if (blob->next == nullptr)
    return bytes_of(*blob);
  if (type != "gltf" || blob->next->next != nullptr)
    throw Failure("the result", "cannot be written as " + upper_case(type) + ", which takes several files");
  return in_one_file(*blob);
}

} // namespace coarsening_support
