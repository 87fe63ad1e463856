// SPDX-License-Identifier: GPL-3.0-or-later
// What is written reads back exactly, and appears whole or not at all.
#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <random>

#include "io/read/mesh_reader.hpp"
#include "io/write/atomic_file.hpp"
#include "io/write/mesh_writer.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/support/random.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

using crest::kernel::Triangle;
using crest::kernel::Vec3;
using crest::tests::read_text;
using crest::tests::TemporaryFolder;
using crest::tests::write_text;

/// A triangulated height field whose coordinates use all bits of a double.
struct Field {
  std::vector<Vec3> points;
  std::vector<Triangle> faces;
};
Field random_field(unsigned n) {
  crest::tests::Random random(crest::tests::kSeed);
  std::uniform_real_distribution<double> offset(-0.3, 0.3);
  Field field;
  for (unsigned i = 0; i < n; ++i)
    for (unsigned j = 0; j < n; ++j)
      field.points.push_back({i + offset(random), j + offset(random), offset(random) * 1e-7});
  for (unsigned i = 0; i + 1 < n; ++i) {
    for (unsigned j = 0; j + 1 < n; ++j) {
      const unsigned a = i * n + j, b = a + n;
      field.faces.push_back({a, b, b + 1});
      field.faces.push_back({a, b + 1, a + 1});
    }
  }
  return field;
}

}  // namespace

TEST_CASE("meshes read back exactly in every format that is written", "[io]") {
  const Field field = random_field(12);
  const TemporaryFolder folder;
  for (const char* name : {"a.off", "a.obj", "a.ply", "a.vtp", "B.OFF", "B.Vtp"}) {
    INFO(name);
    crest::io::write_mesh(folder / name, field.points, field.faces);
    const auto file = crest::io::read_mesh(folder / name);
    CHECK(file.mesh.points() == field.points);
    CHECK(file.mesh.faces() == field.faces);
    CHECK(file.warnings.empty());
    const std::string first = read_text(folder / name);
    crest::io::write_mesh(folder / name, field.points, field.faces);
    CHECK(read_text(folder / name) == first);
  }
  CHECK(folder.entries() == 6);
}

TEST_CASE("data sets of many blocks read back, stored in their places and compressed", "[io]") {
  const Field field = random_field(80);  // VTK compresses blocks of 32 kB
  const TemporaryFolder folder;
  crest::io::write_mesh(folder / "a.vtp", field.points, field.faces);
  const auto file = crest::io::read_mesh(folder / "a.vtp");
  CHECK(file.mesh.points() == field.points);
  CHECK(file.mesh.faces() == field.faces);
  // Equal points compress to almost nothing: no reason to refuse the file.
  std::vector<Vec3> flat(5000, Vec3{0, 0, 0});
  flat[0] = {1, 0, 0};
  flat[1] = {0, 1, 0};
  crest::io::write_mesh(folder / "b.vtp", flat, {{0, 1, 2}});
  CHECK_NOTHROW(crest::io::read_mesh(folder / "b.vtp"));
  for (const char* name : {"a.vtp", "b.vtp"})
    CHECK(read_text(folder / name).find("AppendedData") == std::string::npos);
}

TEST_CASE("extreme coordinates survive", "[io]") {
  const std::vector<Vec3> points = {
      {0.1, 1e300, 5e-324}, {-0.1, -1e300, 1.0 / 3}, {2.2250738585072014e-308, 7, 1e-200}};
  const TemporaryFolder folder;
  for (const char* name : {"a.off", "a.obj", "a.ply", "a.vtp"}) {
    INFO(name);
    crest::io::write_mesh(folder / name, points, {{0, 1, 2}});
    CHECK(crest::io::read_mesh(folder / name).mesh.points() == points);
  }
}

TEST_CASE("output appears whole or not at all", "[io]") {
  const TemporaryFolder folder;
  const auto fails = [](const std::string& path) {
    try {
      crest::io::write_atomically(path, "new");
    } catch (const crest::kernel::InputError& error) {
      const std::string line = error.what();
      CHECK(line.starts_with(path + ": file: cannot be written"));
      CHECK(line.find('\n') == std::string::npos);
      return true;
    }
    return false;
  };
  CHECK(fails(folder / "absent/a.txt"));
  std::filesystem::create_directory(folder / "sub");
  CHECK(fails(folder / "sub"));
  CHECK(folder.entries() == 1);

  write_text(folder / "a.txt", "old");
  crest::io::write_atomically(folder / "a.txt", "new");
  CHECK(read_text(folder / "a.txt") == "new");
  std::filesystem::create_symlink("a.txt", folder / "link.txt");
  crest::io::write_atomically(folder / "link.txt", "newer");
  CHECK(std::filesystem::is_symlink(folder / "link.txt"));
  CHECK(read_text(folder / "a.txt") == "newer");
  CHECK(folder.entries() == 3);
  crest::io::write_atomically("/dev/null", "gone");
  CHECK(std::filesystem::is_character_file("/dev/null"));
  // A device without room: the write itself fails.
  CHECK(fails("/dev/full"));

  // A folder without permission to write: root, who writes anywhere, is nobody for a moment.
  REQUIRE(::chmod(folder.path().c_str(), 0555) == 0);
  const uid_t user = ::geteuid();
  constexpr uid_t kNobody = 65534;
  if (user == 0) REQUIRE(::seteuid(kNobody) == 0);
  const bool failed = fails(folder / "a.txt");
  REQUIRE(::seteuid(user) == 0);
  CHECK(failed);
  CHECK(read_text(folder / "a.txt") == "newer");
}

TEST_CASE("an unknown extension is refused before anything is written", "[io]") {
  const TemporaryFolder folder;
  CHECK_THROWS_AS(crest::io::write_mesh(folder / "a.xyz", {}, {}), crest::kernel::InputError);
  CHECK(folder.entries() == 0);
}

TEST_CASE("new files obey the umask", "[io]") {
  const TemporaryFolder folder;
  const mode_t before = ::umask(027);
  crest::io::write_atomically(folder / "a.txt", "a");
  ::umask(before);
  struct stat info {};
  REQUIRE(::stat((folder / "a.txt").c_str(), &info) == 0);
  CHECK((info.st_mode & 0777) == 0640);
}
