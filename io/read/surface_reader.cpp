// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read/surface_reader.hpp"

#include <fmt/format.h>

#include <utility>

#include "io/clean/clean.hpp"
#include "io/formats/files.hpp"
#include "io/formats/readers.hpp"
#include "io/read/mesh_attributes.hpp"

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
void warn_of(const std::vector<std::string>& left_out, std::vector<std::string>& warnings) {
  if (!left_out.empty())
    warnings.push_back(fmt::format("left out the fields {}", fmt::join(left_out, ", ")));
}

std::vector<std::string> field_names(const Soup& soup) {
  std::vector<std::string> names;
  for (const auto* fields : {&soup.point_fields, &soup.cell_fields})
    for (const Field& field : *fields) names.push_back(field.name);
  return names;
}

SurfaceFile surface_of(const Soup& soup, bool with_attributes) {
  SurfaceFile file;
  Surface surface = clean(soup, {}, Purpose::connectivity, file.cleanup);
  refuse_mended(file.cleanup);
  file.warnings = soup.warnings;
  const std::vector<std::string> lines = words(file.cleanup);
  file.warnings.insert(file.warnings.end(), lines.begin(), lines.end());
  std::vector<std::string> left_out;
  if (with_attributes)
    file.attributes = attributes_of(soup, surface, left_out);
  else
    left_out = field_names(soup);
  warn_of(left_out, file.warnings);
  file.numbers = file_numbers(soup, surface);
  file.points = std::move(surface.points);
  file.faces = std::move(surface.faces);
  return file;
}

}  // namespace

SurfaceFile read_surface(const std::string& path, bool with_attributes) {
  SurfaceFile file;
  read_named(path, [&] {
    const FieldRequest request{
        .wanted = with_attributes, .normals = with_attributes, .corners = with_attributes};
    file = surface_of(read_soup(path, request), with_attributes);
  });
  return file;
}

}  // namespace crest::io
