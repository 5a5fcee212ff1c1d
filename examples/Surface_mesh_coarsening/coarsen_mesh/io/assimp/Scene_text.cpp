// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/assimp/Scene_text.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <utility>
#include <vector>

namespace coarsening_support {
namespace {

std::string material_name(const aiScene& scene, const aiMesh& mesh)
{
  if (mesh.mMaterialIndex >= scene.mNumMaterials)
    return "";
  const std::string name = scene.mMaterials[mesh.mMaterialIndex]->GetName().C_Str(), none = AI_DEFAULT_MATERIAL_NAME;
  // The reader of 3MF puts a number before each name.
  const bool is_none = name.size() >= none.size() && name.compare(name.size() - none.size(), none.size(), none) == 0;
  return is_none ? "" : name;
}

// Names in OBJ end at a space.
std::string in_one_word(std::string name)
{
  std::replace_if(
    name.begin(), name.end(), [](unsigned char c) { return std::isspace(c) || std::iscntrl(c) || c == '#' || c == '\\'; }, '_');
  return name;
}

} // namespace

Scene_text::Scene_text(const aiScene& scene) : scene_(scene)
{
  const std::pair<unsigned, const char*> counts[] = {{scene.mNumAnimations, "animations"},
                                                     {scene.mNumCameras, "cameras"},
                                                     {scene.mNumLights, "lights"},
                                                     {scene.mNumTextures, "images"}};
  for (const auto& count : counts)
    if (count.first > 0)
      left_out_.insert(count.second);
  for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
    has_colors_ = has_colors_ || scene.mMeshes[i]->HasVertexColors(0);
    has_materials_ = has_materials_ || !material_name(scene, *scene.mMeshes[i]).empty();
  }
  if (has_materials_)
    left_out_.insert("the properties of materials");
  if (scene.mRootNode != nullptr)
    add_node(*scene.mRootNode, aiMatrix4x4t<double>(), 0);
}

void Scene_text::add_node(const aiNode& node, const aiMatrix4x4t<double>& parent, std::size_t depth)
{
  constexpr std::size_t max_depth = 1000;
  if (depth > max_depth)
    throw std::runtime_error("nodes are nested more than " + std::to_string(max_depth) + " deep");
  const aiMatrix4x4& m = node.mTransformation;
  const aiMatrix4x4t<double> placement =
    parent * aiMatrix4x4t<double>(m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3, m.d4);
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    if (node.mMeshes[i] >= scene_.mNumMeshes)
      throw std::runtime_error("a node has mesh " + std::to_string(node.mMeshes[i]) + " of " + std::to_string(scene_.mNumMeshes));
    add_mesh(*scene_.mMeshes[node.mMeshes[i]], placement);
  }
  for (unsigned i = 0; i < node.mNumChildren; ++i)
    add_node(*node.mChildren[i], placement, depth + 1);
}

std::size_t Scene_text::add_point(const aiMesh& mesh, unsigned v, const aiMatrix4x4t<double>& placement)
{
  const aiVector3D& at = mesh.mVertices[v];
  const aiVector3t<double> p = placement * aiVector3t<double>(at.x, at.y, at.z);
  const aiColor4D color = mesh.HasVertexColors(0) ? mesh.mColors[0][v] : aiColor4D(1, 1, 1, 1);
  const auto found = points_.emplace(Triple{{p.x + 0., p.y + 0., p.z + 0.}}, points_.size() + 1); // -0 is 0
  if (!found.second) {
    if (has_colors_ && colors_[found.first->second - 1] != color)
      left_out_.insert("colors that differ at a vertex");
    return found.first->second;
  }
  (text_ << "v ").coordinates(Point(p.x, p.y, p.z));
  if (has_colors_) {
    colors_.push_back(color);
    for (const float part : {color.r, color.g, color.b, color.a})
      (text_ << ' ').number(double(part));
  }
  text_ << '\n';
  return found.first->second;
}

void Scene_text::add_corner(const aiMesh& mesh, unsigned v, const std::vector<std::size_t>& points)
{
  (text_ << ' ').number(points[v]);
  if (mesh.HasTextureCoords(0))
    (text_ << '/').number(textures_ + v + 1);
  if (mesh.HasNormals())
    (text_ << (mesh.HasTextureCoords(0) ? "/" : "//")).number(normals_ + v + 1);
}

void Scene_text::add_mesh(const aiMesh& mesh, const aiMatrix4x4t<double>& placement)
{
  if (mesh.HasTextureCoords(1))
    left_out_.insert("further texture coordinates");
  if (mesh.HasVertexColors(1))
    left_out_.insert("further colors");
  if (mesh.HasTangentsAndBitangents())
    left_out_.insert("tangents");
  if (mesh.HasBones())
    left_out_.insert("bones");
  if (mesh.mNumAnimMeshes > 0)
    left_out_.insert("morphed shapes");
  std::vector<std::size_t> points;
  for (unsigned v = 0; v < mesh.mNumVertices; ++v)
    points.push_back(add_point(mesh, v, placement));
  if (mesh.HasTextureCoords(0))
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const aiVector3D& t = mesh.mTextureCoords[0][v];
      ((text_ << "vt ").number(double(t.x)) << ' ').number(double(t.y)) << '\n';
    }
  const aiMatrix3x3t<double> turn = aiMatrix3x3t<double>(placement).Inverse().Transpose();
  if (mesh.HasNormals())
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const aiVector3D& n = mesh.mNormals[v];
      aiVector3t<double> turned = turn * aiVector3t<double>(n.x, n.y, n.z);
      turned.NormalizeSafe();
      (text_ << "vn ").coordinates(Point(turned.x, turned.y, turned.z)) << '\n';
    }
  if (has_materials_)
    text_ << "usemtl " << in_one_word(material_name(scene_, mesh)) << '\n';
  const bool is_mirrored = placement.Determinant() < 0;
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    if (face.mNumIndices < 3) {
      left_out_.insert(face.mNumIndices == 2 ? "lines" : "points");
      continue;
    }
    text_ << 'f';
    for (unsigned i = 0; i < face.mNumIndices; ++i) {
      const unsigned v = face.mIndices[is_mirrored ? face.mNumIndices - 1 - i : i];
      if (v >= mesh.mNumVertices)
        throw std::runtime_error("a face has vertex " + std::to_string(v) + " of " + std::to_string(mesh.mNumVertices));
      add_corner(mesh, v, points);
    }
    text_ << '\n';
  }
  textures_ += mesh.HasTextureCoords(0) ? mesh.mNumVertices : 0;
  normals_ += mesh.HasNormals() ? mesh.mNumVertices : 0;
}

} // namespace coarsening_support
