// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read/normals_reader.hpp"

#include <algorithm>

#include "io/formats/fields.hpp"
#include "io/formats/files.hpp"
#include "io/formats/readers.hpp"
#include "io/read/soup_to_mesh.hpp"

namespace crest::io {
namespace {

/// Those that the file says are normals, else a field of that name.
const Field& normals_of(const Soup& soup) {
  const auto& fields = soup.point_fields;
  auto found = std::find_if(fields.begin(), fields.end(), [](const Field& f) { return f.normals; });
  if (found == fields.end())
    found = std::find_if(fields.begin(), fields.end(),
                         [](const Field& f) { return f.name == "Normals" && f.components > 0; });
  if (found == fields.end()) fail("normals", "the file has none", "use --normals estimated");
  if (found->components != 3)
    fail("normals", "they have not three components", "export the mesh again");
  return *found;
}

}  // namespace

std::vector<kernel::Vec3> read_normals(const std::string& path) {
  std::vector<kernel::Vec3> normals;
  read_named(path, [&] {
    const std::string extension = lower_extension(path);
    if (extension != ".vtp" && extension != ".ply")
      fail("normals", "only .ply and .vtp give them", "convert the mesh or estimate them");
    const Soup soup = soup_reader(extension)(load(path), {true, ""});
    const std::vector<double> numbers = exact_doubles(soup, normals_of(soup));
    for (const kernel::Index v : used_points(soup))
      normals.push_back({numbers[3 * v], numbers[3 * v + 1], numbers[3 * v + 2]});
  });
  return normals;
}

}  // namespace crest::io
