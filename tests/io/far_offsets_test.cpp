// SPDX-License-Identifier: GPL-3.0-or-later
// Cells' offsets that end beyond the file: VTK would make room for as many corners.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "tests/io/soups.hpp"
#include "tests/support/memory_limit.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

using namespace crest::tests;

std::string array(const char* type, const char* name, const std::string& numbers) {
  return fmt::format("<DataArray type=\"{}\" Name=\"{}\" format=\"ascii\">{}</DataArray>", type,
                     name, numbers);
}

/// Two triangles; a field of points has the offsets' name and larger numbers.
std::string file_of(bool grid, const std::string& last_offset) {
  const char* const type = grid ? "UnstructuredGrid" : "PolyData";
  const char* const cells = grid ? "Cells" : "Polys";
  return fmt::format(
      "<VTKFile type=\"{0}\" version=\"1.0\" byte_order=\"LittleEndian\"><{0}>"
      "<Piece NumberOfPoints=\"4\" NumberOf{1}=\"2\"><PointData>{2}</PointData><Points>"
      "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">"
      "0 0 0 1 0 0 0 1 0 1 1 0</DataArray></Points><{1}>{3}{4}{5}</{1}></Piece></{0}></VTKFile>",
      type, cells, array("Float64", "offsets", "1e300 1e300 1e300 1e300"),
      array("Int64", "connectivity", "0 1 2 2 1 3"), array("Int64", "offsets", "3 " + last_offset),
      grid ? array("UInt8", "types", "5 5") : "");
}

std::string error_of(const std::string& name, const std::string& bytes) {
  return soup_error(name, bytes, {.wanted = true, .name = "offsets"});
}

}  // namespace

TEST_CASE("VTK's cells end within the file", "[io]") {
  for (const bool grid : {false, true}) {
    const std::string name = grid ? "mesh.vtu" : "mesh.vtp";
    CHECK(error_of(name, file_of(grid, "6")) == "no error");
    for (const char* last : {"1073741836", "4611686018427387904", "-1", "9223372036854775807"}) {
      INFO(name << ", " << last);
      const std::string text = file_of(grid, last);
      const MemoryLimit limit(std::size_t{1} << 30);
      CHECK(error_of(name, text).find("cannot be read as") != std::string::npos);
    }
  }
  const std::string raw =
      read_text(CREST_SOURCE_DIR "/tests/fuzz/corpus/vtu/far_offsets");  // found by fuzzing
  const MemoryLimit limit(std::size_t{1} << 30);
  CHECK(error_of("mesh.vtu", raw).find("cannot be read as") != std::string::npos);
}
