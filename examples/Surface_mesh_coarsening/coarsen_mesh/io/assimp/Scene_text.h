// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COARSENING_SUPPORT_SCENE_TEXT_H
#define COARSENING_SUPPORT_SCENE_TEXT_H

#include "io/Text_writer.h"

#include <assimp/scene.h>

#include <boost/container_hash/hash.hpp>

#include <array>
#include <cstddef>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

namespace coarsening_support {

// Turns a scene of Assimp into the text of an OBJ file, with the meshes where the nodes place them. Points at the same place
// become one: formats for graphics repeat them where normals, textures or materials differ. Text, as the reader for OBJ trusts
// nothing.
class Scene_text
{
public:
  explicit Scene_text(const aiScene& scene);

  // Words for what the scene has and the text has not.
  const std::set<std::string>& left_out() const { return left_out_; }
  std::string text() && { return std::move(text_).bytes(); }

private:
  typedef std::array<double, 3> Triple;

  void add_node(const aiNode& node, const aiMatrix4x4t<double>& parent, std::size_t depth);
  void add_mesh(const aiMesh& mesh, const aiMatrix4x4t<double>& placement);
  void add_corner(const aiMesh& mesh, unsigned v, const std::vector<std::size_t>& points);
  std::size_t add_point(const aiMesh& mesh, unsigned v, const aiMatrix4x4t<double>& placement);
  void add_material(const aiMesh& mesh);

  const aiScene& scene_;
  coarsen_mesh_tool::Text_writer text_;
  std::unordered_map<Triple, std::size_t, boost::hash<Triple> > points_; // numbered from 1
  std::vector<aiColor4D> colors_;
  bool has_colors_ = false, has_materials_ = false;
  std::size_t textures_ = 0, normals_ = 0; // so far
  std::set<std::string> left_out_;
};

} // namespace coarsening_support

#endif // COARSENING_SUPPORT_SCENE_TEXT_H
