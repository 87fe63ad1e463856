// SPDX-License-Identifier: GPL-3.0-or-later
// Every file the fuzzers keep gives a mesh (a volume, points) or an InputError of one line, nothing
// else.
#include <catch2/catch.hpp>
#include <filesystem>

#include "io/read/mesh_reader.hpp"
#include "io/read/planar_field_reader.hpp"
#include "io/read/point_reader.hpp"
#include "io/read/quadratic_reader.hpp"
#include "io/read/volume_reader.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

/// Faces, samples or points. `folder`: of the corpus, the fuzzer's name.
std::size_t read_count(const std::string& folder, const std::string& name,
                       const std::string& bytes) {
  if (folder.starts_with("planar_")) {
    const crest::tests::TemporaryFolder place;
    const std::string path = place / name;
    std::ofstream(path, std::ios::binary) << bytes;
    try {
      return crest::io::read_planar_field(path, {}).triangles.size();
    } catch (const crest::kernel::InputError& error) {
      throw crest::kernel::InputError(name + std::string(error.what()).substr(path.size()));
    }
  }
  if (folder == "volume_xyz") return crest::io::read_points_bytes(name, bytes).points.size();
  if (folder.starts_with("volume_")) return crest::io::read_volume_bytes(name, bytes).grid.count();
  if (folder == "vtu" || folder == "msh")
    return crest::io::read_quadratic_mesh_bytes(name, bytes, {}).mesh.face_count();
  return crest::io::read_mesh_bytes(name, bytes).mesh.face_count();
}

}  // namespace

TEST_CASE("the fuzzers' corpus gives meshes or input errors", "[io]") {
  const std::filesystem::path corpus =
      std::filesystem::path(CREST_SOURCE_DIR) / "tests" / "fuzz" / "corpus";
  std::size_t files = 0, meshes = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(corpus)) {
    if (!entry.is_regular_file()) continue;
    ++files;
    // corpus/<format>/<name> or corpus/volume_<format>/<name>
    const std::string folder = entry.path().parent_path().filename().string();
    const std::string format = folder.substr(folder.find('_') + 1);
    const std::string bytes = crest::tests::read_text(entry.path().string());
    INFO(entry.path());
    try {
      const std::size_t count = read_count(folder, "mesh." + format, bytes);
      CHECK(count > 0);
      ++meshes;
    } catch (const crest::kernel::InputError& error) {
      const std::string line = error.what();
      CHECK(line.starts_with("mesh." + format + ": "));
      CHECK(line.find("; ") != std::string::npos);
      CHECK(line.find('\n') == std::string::npos);
    }
  }
  CHECK(files >= 10);
  CHECK(meshes >= 5);
}
