// SPDX-License-Identifier: GPL-3.0-or-later
//
// The memory of the coarsening beyond the loaded mesh, output included, counted in `new`.

#include "support/face_graphs.h"
#include "support/generate_meshes.h"

#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Centroid_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Fitted_placement.h>
#include <CGAL/Surface_mesh_coarsening/Vertex_placement/Quadric_placement.h>
#include <CGAL/Surface_mesh_coarsening/coarsen_mesh.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <new>
#include <string>

namespace {

std::atomic<std::size_t> taken(0), max_taken(0);

constexpr std::size_t header = alignof(std::max_align_t); // stores the size

void* take(std::size_t bytes)
{
  char* const block = static_cast<char*>(std::malloc(bytes + header));
  if (block == nullptr)
    throw std::bad_alloc();
  *reinterpret_cast<std::size_t*>(block) = bytes;
  taken += bytes;
  if (taken > max_taken)
    max_taken.store(taken);
  return block + header;
}

void give_back(void* p)
{
  if (p == nullptr)
    return;
  char* const block = static_cast<char*>(p) - header;
  taken -= *reinterpret_cast<std::size_t*>(block);
  std::free(block);
}

} // namespace

void* operator new(std::size_t bytes) { return take(bytes); }
void* operator new[](std::size_t bytes) { return take(bytes); }
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept
{
  try {
    return take(bytes);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void operator delete(void* p) noexcept { give_back(p); }
void operator delete[](void* p) noexcept { give_back(p); }
void operator delete(void* p, const std::nothrow_t&) noexcept { give_back(p); }
void operator delete(void* p, std::size_t) noexcept { give_back(p); }
void operator delete[](void* p, std::size_t) noexcept { give_back(p); }

BOOST_AUTO_TEST_SUITE(test_memory)

namespace SMC = CGAL::Surface_mesh_coarsening;
using test::Mesh;

namespace {

// Records the peak of each stage.
struct Watching_visitor : SMC::Coarsening_visitor_base
{
  std::size_t before = 0, faces = 0, most = 0;
  std::string protocol;

  void stage_begins(SMC::Coarsening_stage) { max_taken.store(taken); }
  void stage_ends(SMC::Coarsening_stage)
  {
    most = (std::max)(most, max_taken.load());
    protocol += ' ' + std::to_string(double(max_taken - before) / double(faces));
  }
};

template <class Parameters>
double bytes_per_face(const std::string& name, const Mesh& mesh, const Parameters& np)
{
  Mesh output;
  Watching_visitor visitor;
  visitor.before = taken;
  visitor.faces = mesh.number_of_faces();
  SMC::coarsen_mesh(mesh, mesh.number_of_vertices() / 50, output, np.visitor(std::ref(visitor)));
  const std::size_t most = (std::max)(visitor.most, max_taken.load());
  const double each = double(most - visitor.before) / double(visitor.faces);
  BOOST_TEST_MESSAGE(name << ": " << each << " bytes per face; stage by stage" << visitor.protocol);
  return each;
}

const auto defaults = SMC::parameters::repair_output(true); // to begin a chain with

} // namespace

BOOST_AUTO_TEST_CASE(default_settings)
{
  using namespace generated;
  BOOST_TEST(bytes_per_face("ellipsoid", test::to_mesh(scaled(triangle_sphere(7), 3, 2, 1)), defaults) <= 140);
  BOOST_TEST(bytes_per_face("torus", test::to_mesh(triangulated(torus(250, 250))), defaults) <= 140);
  BOOST_TEST(bytes_per_face("rough square", test::to_mesh(with_noise(triangulated(grid(250, 250)), 0.2)), defaults) <= 140);
}

BOOST_AUTO_TEST_CASE(placements)
{
  using namespace generated;
  const Mesh mesh = test::to_mesh(with_noise(scaled(triangle_sphere(7), 3, 2, 1), 0.001));
  const auto plain = SMC::parameters::repair_output(false);
  BOOST_TEST(bytes_per_face("centroid, no repair", mesh, plain.vertex_placement(SMC::Centroid_placement())) <= 100);
  BOOST_TEST(bytes_per_face("quadric, no repair", mesh, plain.vertex_placement(SMC::Quadric_placement())) <= 100);
  BOOST_TEST(bytes_per_face("quadric", mesh, defaults.vertex_placement(SMC::Quadric_placement())) <= 100);
  BOOST_TEST(bytes_per_face("fitted", mesh, defaults.vertex_placement(SMC::Fitted_placement())) <= 140);
}

BOOST_AUTO_TEST_SUITE_END()
