// SPDX-License-Identifier: GPL-3.0-or-later
// Every file the fuzzers keep gives a mesh or an InputError of one line, nothing else.
#include <catch2/catch.hpp>
#include <filesystem>

#include "io/read/mesh_reader.hpp"
#include "io/read/quadratic_reader.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/io/temporary_folder.hpp"

TEST_CASE("the fuzzers' corpus gives meshes or input errors", "[io]") {
  const std::filesystem::path corpus =
      std::filesystem::path(CREST_SOURCE_DIR) / "tests" / "fuzz" / "corpus";
  std::size_t files = 0, meshes = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(corpus)) {
    if (!entry.is_regular_file()) continue;
    ++files;
    // corpus/<format>/<name>
    const std::string format = entry.path().parent_path().filename().string();
    const std::string bytes = crest::tests::contents(entry.path().string());
    INFO(entry.path());
    try {
      const std::string name = "mesh." + format;
      const bool fields = format == "vtu" || format == "msh";
      const auto faces =
          fields ? crest::io::read_quadratic_mesh_bytes(name, bytes, {}).mesh.face_count()
                 : crest::io::read_mesh_bytes(name, bytes).mesh.face_count();
      CHECK(faces > 0);
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
