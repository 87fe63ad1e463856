// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read/surface_reader.hpp"

#include <fmt/format.h>

#include <utility>

#include "io/clean/clean.hpp"
#include "io/formats/files.hpp"
#include "io/formats/readers.hpp"

namespace crest::io {
namespace {

void refuse_mended(const CleanUp& done) {
  const auto refuse = [](std::size_t count, const char* what) {
    if (count == 0) return;
    fail("mesh", fmt::format("{}: {}", what, count), "mend it with crest clean first");
  };
  refuse(done.repeated_corners, "faces with repeated corners");
  refuse(done.duplicate_faces, "faces with the vertices of another");
  refuse(done.split_vertices, "vertices in which several fans of faces meet");
  refuse(done.turned_faces, "faces oriented against their neighbours");
}

/// One line that names what is left out.
void warn_of_fields(const Soup& soup, std::vector<std::string>& warnings) {
  std::string names;
  for (const auto* fields : {&soup.point_fields, &soup.cell_fields})
    for (const Field& field : *fields) names += (names.empty() ? "" : ", ") + field.name;
  if (!names.empty()) warnings.push_back("left out the fields " + names);
}

SurfaceFile surface_of(const Soup& soup) {
  SurfaceFile file;
  Surface surface = clean(soup, {}, Purpose::connectivity, file.cleanup);
  refuse_mended(file.cleanup);
  file.warnings = soup.warnings;
  const std::vector<std::string> lines = words(file.cleanup);
  file.warnings.insert(file.warnings.end(), lines.begin(), lines.end());
  warn_of_fields(soup, file.warnings);
  file.numbers = file_numbers(soup, surface);
  file.points = std::move(surface.points);
  file.faces = std::move(surface.faces);
  return file;
}

}  // namespace

SurfaceFile read_surface(const std::string& path) {
  SurfaceFile file;
  read_named(path, [&] { file = surface_of(read_soup(path, {})); });
  return file;
}

}  // namespace crest::io
