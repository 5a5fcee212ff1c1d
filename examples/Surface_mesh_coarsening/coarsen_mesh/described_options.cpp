// SPDX-License-Identifier: GPL-3.0-or-later

#include "described_options.h"

#include "Options.h"
#include "coarsening.h"

#include <boost/program_options.hpp>

#include <iostream>
#include <sstream>

namespace coarsen_mesh_tool {
namespace {

namespace po = boost::program_options;

po::typed_value<std::string>* text(const char* name) { return po::value<std::string>()->value_name(name); }

std::string number_text(double x)
{
  std::ostringstream text;
  text << x;
  return text.str();
}

// clang-format off

po::options_description size_options()
{
  po::options_description result("Size of the result");
  result.add_options()
    ("vertices,n", text("N"), "number of vertices of the result, or a part of the input's, such as 10%")
    ("keep-small", "with --vertices P%: components that cannot be reduced to this part stay as they are, triangulated")
    ("faces", text("N"), "instead of --vertices: number of triangles of the result; the nearest possible number, if N is not possible")
    ("range", "instead of writing OUTPUT, print the smallest and the largest number that --vertices can take for INPUT")
    ("maximum-distance", text("D"),
     "instead of --vertices: as few vertices (with --vertices: at most that many) as keep the result within this distance of "
     "the input, both ways, in parts of the diagonal of the input's bounding box (0.01 is one percent); the distance is bounded, not sampled")
    ("maximum-distance-absolute", text("D"), "the same in the mesh's unit of length")
    ("neighborhood-level,k", text("K"),
     "one vertex for every seed whose neighborhood of K layers of faces is free; with --vertices N, these seeds are merged to N")
    ("levels", text("L")->default_value("0"),
     "beside OUTPUT, write L coarser levels of it, each with half the vertices of the previous one: OUTPUT with .1, .2 and so on "
     "before its ending")
    ("subdivide",
     "subdivide faces of a copy until there are 20 for each vertex of the result: clusters are rounder if the input is "
     "hardly finer than the result, and --vertices may exceed the input's");
  return result;
}

po::options_description kept_options()
{
  po::options_description result("What is kept");
  result.add_options()
    ("features", text("ANGLE")->implicit_value(default_feature_angle),
     "keep sharp edges, whose normals differ by ANGLE degrees or more: they become lines of edges, and their corners keep "
     "their positions")
    ("patches", text("FIELD"),
     "keep the lines between faces that differ in FIELD: material, group, object or solid, or the name of whole numbers "
     "that a PLY file has for faces")
    ("keep-borders",
     "keep vertices and edges of borders as they are, so that neighboring tiles still fit")
    ("keep", text("FIELD"),
     "keep the vertices whose number FIELD in a PLY file is not zero, and the vertices of faces whose number is not zero");
  return result;
}

po::options_description preparing_options()
{
  po::options_description result("Preparation of the input");
  result.add_options()
    ("repair",
     "repair the input first: merge coincident points, remove useless faces, orient, duplicate non-manifold vertices, "
     "stitch borders, remove degenerate triangles and unused points; warnings name what was duplicated, removed or separated")
    ("weld", text("T"),
     "the same, and merge points within the distance T of each other before, in the mesh's unit of length")
    ("fill-holes", text("LENGTH"),
     "first fill the holes whose border is at most LENGTH long, in the mesh's unit of length, or in percent of the "
     "diagonal of its "
     "bounding box, such as 10%, or all; --report lists the holes with their lengths, and whether they were filled")
    ("minimum-component-area", text("A"),
     "after --repair, remove connected components of an area below A, in the square of the mesh's unit of length (a cube of side "
     "2 has area 24); --report counts them");
  return result;
}

po::options_description output_options()
{
  po::options_description result("More output");
  result.add_options()
    ("measure",
     "measure the result and print, and put into --report: distance from the input both ways (RMS, mean, maximum) and of the "
     "borders, in % of the diagonal of the input's bounding box; deviation of normals; smallest angles of the triangles; "
     "self-intersections")
    ("report", text("FILE"), "write parameters, counts, topology, warnings and times (JSON)")
    ("picture", text("FILE"),
      "write a picture of the input with its clusters, the result, and the distance between them (.png)")
    ("view", text("X,Y,Z"), "direction from which the picture is taken (default 1,0.5,0.8, rotated with --up)")
    ("up", text("X,Y,Z"), "direction that points up in the picture (default 0,1,0)")
    ("clusters", text("FILE"), "write the input with a color, a label and a density for each face (.ply)")
    ("distances",
     "give each vertex of OUTPUT the number 'distance' (.ply): the largest distance from the result of the faces that it "
     "stands for, in the mesh's unit of length")
    ("format", text("F"),
      "the format, off, obj, ply, stl or the ending of another one, of INPUT or OUTPUT where they are -, standard input "
      "and output")
    ("force", "write OUTPUT even if it replaces INPUT")
    ("quiet", "print nothing but errors");
  return result;
}

po::options_description method_options()
{
  po::options_description result("Method");
  result.add_options()
    ("weight,w", text("W")->default_value(default_weight()), joined(weight_names()).c_str())
    ("energy", text("E")->default_value(default_energy()),
     (joined(energy_names()) + ": what the minimization lowers, the weighted inertia of the clusters, the residuals of their "
                               "quadrics, or the deviation of their normals").c_str())
    ("maximum-density", text("R")->default_value(number_text(Defaults::maximum_density)),
     "densities run from 1 on flat parts to R on the sharpest ones, and to 4 R on borders; the weight variance does well with 3")
    ("placement", text("P")->default_value(default_placement()), joined(placement_names()).c_str())
    ("angle", text("A")->default_value(number_text(Defaults::mean_angle)),
     "with the placement fitted: the mean of the triangles' smallest angles to aim at, in degrees from 0 to 60; smaller angles "
     "bring the surfaces closer")
    ("error-feedback", text("R")->default_value(std::to_string(Defaults::error_feedback)),
     "with the placement fitted: in at most R rounds, relocate vertices to places of large distance; with 0, the densities alone "
     "distribute the vertices")
    ("rounds", text("R"),
     "stop after R rounds of minimization; 0 shows seeds and growth alone (default: up to --convergence-tolerance, at most 1000)")
    ("convergence-tolerance", text("T")->default_value(number_text(Defaults::convergence_tolerance)),
     "stop after the round of minimization that lowers the energy by no more than this part of it; 0: after a round without "
     "changes")
    ("paper",
     "follow the article as closely as the guarantee permits: densities up to 50 (variance: 3) and none for borders, merging "
     "by area, the check by boundary-edge counts, rounds over the whole mesh, the end when a round changes nothing, vertices at "
     "centroids, no feedback and no repair; options beside it take precedence")
    ("threads", text("T"),
     "upper bound for the number of threads, as many as there are processors by default; the result does not depend on it. "
     "More than one need oneTBB");
  return result;
}

po::options_description questions()
{
  po::options_description result("Questions");
  result.add_options()
    (",h", "print the most important options, with examples")
    ("help", "print this text")
    ("version", "print the version");
  return result;
}

// clang-format on

} // namespace

std::string joined(const std::vector<std::string>& names)
{
  std::string result;
  for (const std::string& name : names)
    result += (result.empty() ? "" : ", ") + name;
  return result;
}

po::options_description described_options()
{
  po::options_description result;
  result.add(size_options()).add(kept_options()).add(preparing_options()).add(output_options()).add(method_options());
  return result.add(questions());
}

void print_short_help()
{
  std::cout << "Usage: coarsen_mesh [options] INPUT... OUTPUT\n"
               "\n"
               "Coarsens a polygon mesh to a triangle mesh with exactly N vertices.\n"
               "\n"
               "  -n, --vertices N      number of vertices, or a part of the input's such as 10%\n"
               "  --maximum-distance D  instead: as few vertices as keep the result within D of\n"
               "                        the input, in parts of its diagonal, such as 0.01\n"
               "  --range               instead of writing OUTPUT, print the possible numbers\n"
               "  --features [ANGLE]    keep sharp edges and corners\n"
               "  --repair              repair the input first\n"
               "  --fill-holes LENGTH   fill holes: a length, 10% of the diagonal, or all\n"
               "  --subdivide           for results hardly coarser, or finer, than the input\n"
               "  --measure             print the distance from the input, angles, intersections\n"
               "  --picture FILE.png    draw the input, its clusters and the result\n"
               "  --report FILE.json    write counts, topology, warnings and times\n"
               "  --force               let OUTPUT replace INPUT\n"
               "\n"
               "Examples:\n"
               "  coarsen_mesh fandisk.off coarse.off -n 527 --picture coarse.png\n"
               "  coarsen_mesh part.stl coarse.ply -n 5% --features --measure\n"
               "  coarsen_mesh scan.ply coarse.ply -n 2000 --repair --fill-holes all\n"
               "\n"
               "All options: coarsen_mesh --help\n";
}

void print_help(const po::options_description& described)
{
  std::cout << "Usage: coarsen_mesh [options] INPUT... OUTPUT\n"
               "       coarsen_mesh --range [options] INPUT\n"
               "\n"
               "Coarsens a polygon mesh to a triangle mesh with few vertices that keeps the\n"
               "features of the surface, by multiplicatively weighted centroidal Voronoi\n"
               "diagrams. INPUT is an oriented 2-manifold mesh; INPUT and OUTPUT are .off, .obj,\n"
               ".ply or .stl files, or - with --format; where the program is built with the\n"
               "library Assimp, .glb, .gltf, .3mf, .dae and other files, too. With several\n"
               "inputs, OUTPUT is a directory or a pattern such as coarse/%.ply, in which % is\n"
               "the input's name without its ending (%% is a %). Messages number faces and\n"
               "vertices from 0.\n"
            << described
            << "\n"
               "Exit status: 0 done, 1 could not (one line on standard error says why), 2 wrong\n"
               "usage; 128 + the number of the signal when SIGINT (130), SIGTERM (143) or SIGHUP\n"
               "(129) ended it, or when the reader of an OUTPUT of - was gone (141). The files\n"
               "of an input appear only if all went well with it; with several, the status is 1\n"
               "if one could not be done.\n";
}

} // namespace coarsen_mesh_tool
