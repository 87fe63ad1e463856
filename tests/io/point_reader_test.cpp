// SPDX-License-Identifier: GPL-3.0-or-later
// Points with normals in every format, with and without faces.
#include "io/read/point_reader.hpp"

#include <catch2/catch.hpp>

#include "io/write/volume_writer.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace crest::tests;
using crest::io::read_points_bytes;
using crest::kernel::Vec3;

TEST_CASE("points with normals: the same in every format", "[io]") {
  const std::string rows = "0 0 0.5 0 0 1\n1 0 0 0 -2 0\n";
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty "
      "double z\nproperty float nx\nproperty float ny\nproperty float nz\nend_header\n";
  for (const auto& [name, bytes] :
       {std::pair<std::string, std::string>{"p.xyz", "# x y z nx ny nz\n" + rows},
        {"p.pwn", rows},
        {"p.ply", header + rows},
        {"p.off", "NOFF\n2 0 0\n" + rows},
        {"p.obj", "v 0 0 0.5\nv 1 0 0\nvn 0 0 1\nvn 0 -2 0\n"},
        {"p.obj", "vn 0 -2 0\nvn 0 0 1\nv 0 0 0.5\nv 1 0 0\nf 1//2 2//1 2//1\n"}}) {
    INFO(name);
    const auto file = read_points_bytes(name, bytes);
    REQUIRE(file.points.size() == 2);
    CHECK(file.points == std::vector<Vec3>{{0, 0, 0.5}, {1, 0, 0}});
    CHECK(file.normals == std::vector<Vec3>{{0, 0, 1}, {0, -2, 0}});
    CHECK(file.warnings.empty());
  }
}

TEST_CASE("points whose normal is zero are left out, equal points are kept", "[io]") {
  const auto file = read_points_bytes("p.xyz", "1 0 0 0 0 0\n2 0 0 0 0 1\n2 0 0 0 0 1\n");
  CHECK(file.points == std::vector<Vec3>{{2, 0, 0}, {2, 0, 0}});
  REQUIRE(file.warnings.size() == 1);
  CHECK(file.warnings[0] == "left out 1 points whose normal is zero");
}

TEST_CASE("points that are written are read again", "[io]") {
  const TemporaryFolder folder;
  const std::vector<Vec3> points = {{0.1, 1e-300, -3}, {1.0 / 3, 2, 3}},
                          normals = {{0, 0, 1}, {0, 1, 0}};
  for (const std::string name : {"p.xyz", "p.pwn"}) {
    crest::io::write_points(folder / name, points, normals);
    const auto file = crest::io::read_points(folder / name);
    CHECK(file.points == points);
    CHECK(file.normals == normals);
  }
}
