// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read/point_field.hpp"

#include <fmt/format.h>

#include "io/formats/fields.hpp"
#include "io/formats/files.hpp"
#include "io/formats/readers.hpp"
#include "io/read/soup_to_mesh.hpp"

namespace crest::io {

std::vector<double> read_point_field(const std::string& path, const std::string& name) {
  std::vector<double> values;
  read_named(path, [&] {
    if (lower_extension(path) != ".vtp")
      fail(fmt::format("field '{}'", name.substr(0, 60)), "only .vtp files give fields",
           "convert the mesh");
    const Soup soup = read_vtp(load(path), {true, name});
    const std::vector<double> numbers =
        exact_doubles(soup, choose_scalar(soup, name, "choose a curvature with --method"));
    for (const kernel::Index v : used_points(soup)) values.push_back(numbers[v]);
  });
  return values;
}

}  // namespace crest::io
