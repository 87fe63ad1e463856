// SPDX-License-Identifier: GPL-3.0-or-later
// Every mesh of the shared data set, sound or broken, gives the mesh or the one line expected.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "io/read/mesh_reader.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/support/shared_data.hpp"

namespace {

using crest::io::MeshFile;
using crest::io::read_mesh;

struct Expected {
  const char* file;
  unsigned vertices, faces;  ///< 0 faces: an error
  int euler;
  unsigned loops, components;
  const char* text;  ///< part of the error or of the warnings; nothing: there are none
};

const Expected kExpected[] = {
    {"anchor.off", 519, 1050, -6, 0, 1, ""},
    {"angle_block.STL", 431, 704, -4, 4, 1, "split 33 vertices where several fans of faces meet"},
    {"armadillo.off", 26002, 52000, 2, 0, 1, ""},
    {"b9_mesh.off", 5951, 10174, 10, 76, 47, "4 closed components have negative volume"},
    {"bones.off", 2154, 4204, 52, 0, 26, ""},
    {"bunny_3k.off", 3485, 6966, 2, 0, 1, ""},
    {"cheese.off", 8629, 17786, -264, 0, 1, ""},
    {"cow.obj", 2904, 5804, 2, 0, 1, "split 1 vertex where several fans of faces meet"},
    {"cube_no_bottom.obj", 25, 40, 1, 1, 1, ""},
    {"cycloidal.ply", 0, 0, 0, 0, 0, "edge 43-48: is in faces 630, 4743 and 18188"},
    {"dino.off", 3916, 7828, 2, 0, 1, ""},
    {"disk.obj", 5000, 9769, 1, 1, 1, ""},
    {"double-torus-example.off", 231, 466, -2, 0, 1, "split 220 polygons into triangles"},
    {"dragon_vrip_res3.ply", 0, 0, 0, 0, 0,
     "edge 6-7: is in faces 6, 11 and 15, 1564 edges are so in all"},
    {"elephant.off", 2775, 5558, -4, 0, 1, ""},
    {"fandisk.off", 6475, 12946, 2, 0, 1, ""},
    {"featuretype.STL", 2010, 3476, -16, 16, 1, ""},
    {"fertility.off", 4494, 9000, -6, 0, 1, ""},
    {"head.off", 1487, 2918, -1, 3, 1, ""},
    {"homer.obj", 6002, 12000, 2, 0, 1, ""},
    {"horse.ply", 48485, 96966, 2, 0, 1, "1 closed component has negative volume"},
    {"igea.ply.xz", 134345, 268686, 2, 0, 1, ""},
    {"joint.off", 221, 446, -2, 0, 1, ""},
    {"kitten.obj", 9447, 18894, 0, 0, 1, ""},
    {"klein-donut.off", 0, 0, 0, 0, 0,
     "the surface is one-sided (not orientable); cut it open with --split"},
    {"knot1.off", 3200, 6400, 0, 0, 1, ""},
    {"lilium.obj", 3389, 6590, 1, 1, 1, ""},
    {"lion-head.off", 8356, 16674, 1, 1, 1, ""},
    {"man.off", 17495, 34986, 2, 0, 1, ""},
    {"max-planck_decimated.obj", 5272, 10540, 2, 0, 1, ""},
    {"moebius.obj", 0, 0, 0, 0, 0,
     "the surface is one-sided (not orientable); cut it open with --split"},
    {"penguin.obj", 3362, 6720, 2, 0, 1, ""},
    {"pinion.off", 650, 1300, 0, 0, 1, ""},
    {"plane_holes.obj", 8519, 16747, -25, 27, 1, ""},
    {"rocker-arm.obj", 10044, 20088, 0, 0, 1, ""},
    {"rotor.off", 600, 1200, 0, 0, 1, ""},
    {"spot.obj", 2930, 5856, 2, 0, 1, ""},
    {"springer.obj", 9686, 19368, 2, 0, 1, ""},
    {"stanford-bunny.obj", 34834, 69451, -3, 5, 1, "left out 1113 vertices that no face uses"},
    {"stratocaster.ply", 4500, 8660, 170, 0, 94, ""},
    {"suzanne.obj", 507, 968, 2, 4, 3, "split 468 polygons into triangles"},
    {"teapot.obj", 3691, 6320, 13, 25, 19, "403 vertices stand at the place of another one"},
    {"torus.obj", 3840, 7680, 0, 0, 1, ""},
    {"triple_vierbein.obj", 0, 0, 0, 0, 0, "edge 0-1: is in faces 0, 2 and 55"},
    {"broken/3holes.off", 3596, 7200, -4, 0, 1, ""},
    {"broken/blobby-shuffled_orientation.off", 2027, 4050, 2, 0, 1, "flipped 2017 faces"},
    {"broken/busted.STL", 1941, 3878, 2, 0, 1, ""},
    {"broken/dino_bad_index.off", 0, 0, 0, 0, 0, "face 5 (line 3924): vertex 3919 does not exist"},
    {"broken/dino_duplicate_degenerate.off", 3916, 7828, 2, 0, 1,
     "left out 10 faces with repeated corners; left out 40 faces with"},
    {"broken/dino_flipped.off", 3916, 7828, 2, 0, 1, "flipped 1558 faces"},
    {"broken/dino_nan_inf.off", 0, 0, 0, 0, 0,
     "vertex 705 (line 708): its coordinate x is not finite"},
    {"broken/elephant-with-holes.off", 2798, 4463, -110, 106, 1,
     "65 vertices stand at the place of another one"},
    {"broken/empty.ply", 0, 0, 0, 0, 0, "faces: there are none"},
    {"broken/empty.stl", 0, 0, 0, 0, 0, "faces: there are none"},
    {"broken/horse_truncated.ply", 0, 0, 0, 0, 0, "announces 48485 of element 'vertex', more than"},
    {"broken/igea_tristrips.ply.xz", 134345, 268686, 2, 0, 1,
     "split 31922 polygons into triangles"},
    {"broken/jacked.obj", 8, 12, 2, 0, 1, ""},
    {"broken/nancolor.obj", 8, 12, 2, 0, 1, ""},
    {"broken/notenoughindices.obj", 3, 1, 1, 1, 1, "left out 1 face with repeated corners"},
    {"broken/openscad-nonmanifold-crash.obj", 717, 1442, -4, 0, 2,
     "flipped 1 edge of a face of area zero"},
    {"broken/self_intersectA.obj", 8582, 17160, 2, 0, 1, ""},
    {"broken/soup.stl", 300, 100, 100, 100, 100, ""},
    {"broken/tetra_intersected_by_triangle.off", 7, 5, 3, 1, 2,
     "1 closed component has negative volume"},
    {"broken/thingi_58011.stl", 13215, 26430, 0, 0, 1, ""},
    {"broken/thingi_72214.stl", 830, 1660, 0, 0, 1,
     "coordinates look rounded: they are multiples of 1, "},
    {"broken/triangular_hole.off", 6, 6, 0, 2, 1, ""},
    {"broken/truck_multi_component.obj", 0, 0, 0, 0, 0, "edge 358-408: is in faces 1424, 1612"},
    {"broken/two-boxes-bad-self-union.ply", 486, 708, 12, 12, 12,
     "102 vertices stand at the place of another one"},
};

/// The file itself, or its unpacked copy in the build directory.
std::string unpacked(const std::string& path) {
  if (!path.ends_with(".xz")) return path;
  const auto stem = std::filesystem::path(path).stem();
  const auto folder = std::filesystem::path(CREST_BINARY_DIR) / "unpacked";
  std::filesystem::create_directories(folder);
  const std::string copy = (folder / stem).string();
  const std::string command = "xz -dc '" + path + "' > '" + copy + "'";
  REQUIRE(std::system(command.c_str()) == 0);
  return copy;
}

void check(const Expected& expected, const std::string& path) {
  INFO(expected.file);
  if (expected.faces == 0) {
    try {
      read_mesh(path);
      FAIL_CHECK("no error");
    } catch (const crest::kernel::InputError& error) {
      const std::string line = error.what();
      INFO(line);
      CHECK(line.starts_with(path + ": "));
      CHECK(line.find(expected.text) != std::string::npos);
      CHECK(line.find("; ") != std::string::npos);
      CHECK(line.find('\n') == std::string::npos);
    }
    return;
  }
  const MeshFile file = read_mesh(path);
  CHECK(file.mesh.vertex_count() == expected.vertices);
  CHECK(file.mesh.face_count() == expected.faces);
  CHECK(file.mesh.euler_characteristic() == expected.euler);
  CHECK(file.mesh.boundary_loops() == expected.loops);
  CHECK(file.mesh.components() == expected.components);
  const std::string text = expected.text;
  std::string warnings;
  for (const std::string& line : file.warnings) warnings += (warnings.empty() ? "" : "; ") + line;
  INFO(warnings);
  CHECK(text.empty() == warnings.empty());
  CHECK(warnings.find(text) != std::string::npos);
}

}  // namespace

TEST_CASE("every mesh of the data set gives a mesh or one clear line", "[io]") {
  for (const Expected& expected : kExpected) {
    const auto path = crest::tests::shared_data(std::string("meshes/") + expected.file);
    if (!path) return;
    check(expected, unpacked(*path));
  }
}
