// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is asked of a soup that was read.
#include <algorithm>
#include <map>
#include <string>

#include "io/formats/files.hpp"
#include "io/formats/readers.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::tests {

/// Of a file with that name and these bytes.
inline io::Soup soup_of(const std::string& name, std::string bytes,
                        const io::FieldRequest& request = {}) {
  return io::soup_reader(io::lower_extension(name))(std::move(bytes), request);
}

/// The message, without the file's name.
inline std::string soup_error(const std::string& name, std::string bytes,
                              const io::FieldRequest& request = {}) {
  try {
    soup_of(name, std::move(bytes), request);
  } catch (const kernel::InputError& error) {
    return error.what();
  }
  return "no error";
}

/// "642 points, 1280 of type 5, 2 of type 9".
inline std::string counts(const io::Soup& soup) {
  std::map<int, std::size_t> types;
  for (std::size_t c = 0; c < soup.cells.size(); ++c) ++types[static_cast<int>(soup.cells.type(c))];
  std::string text = std::to_string(soup.points.size()) + " points";
  for (const auto& [type, count] : types)
    text += ", " + std::to_string(count) + " of type " + std::to_string(type);
  return text;
}

/// "height 1, velocity 3; cells: area 1", with * behind normals.
inline std::string field_names(const io::Soup& soup) {
  const auto list = [](const std::vector<io::Field>& fields) {
    std::string text;
    for (const io::Field& f : fields)
      text += (text.empty() ? "" : ", ") + f.name + " " + std::to_string(f.components) +
              (f.normals ? "*" : "");
    return text;
  };
  const std::string cells = list(soup.cell_fields);
  return list(soup.point_fields) + (cells.empty() ? "" : "; cells: " + cells);
}

inline std::vector<io::Cells::Node> nodes_of(const io::Soup& soup, std::size_t cell) {
  const auto nodes = soup.cells.nodes(cell);
  return {nodes.begin(), nodes.end()};
}

/// The numbers of a point or cell field.
template <class Number>
std::vector<Number> numbers_of(const std::vector<io::Field>& fields, const std::string& name) {
  const auto field = std::find_if(fields.begin(), fields.end(),
                                  [&](const io::Field& f) { return f.name == name; });
  if (field == fields.end()) return {};
  const auto* numbers = std::get_if<std::vector<Number>>(&field->numbers);
  return numbers ? *numbers : std::vector<Number>();
}

/// Inside the faces, each a fan from its first corner, strips turned at every other triangle.
inline double signed_volume(const io::Soup& soup) {
  double volume = 0;
  const auto add = [&](io::Cells::Node a, io::Cells::Node b, io::Cells::Node c) {
    const auto& p = soup.points[static_cast<std::size_t>(a)];
    const auto& q = soup.points[static_cast<std::size_t>(b)];
    const auto& r = soup.points[static_cast<std::size_t>(c)];
    volume += (p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
               p[2] * (q[0] * r[1] - q[1] * r[0])) /
              6;
  };
  for (std::size_t c = 0; c < soup.cells.size(); ++c) {
    const auto nodes = soup.cells.nodes(c);
    const bool strip = soup.cells.type(c) == io::CellType::triangle_strip;
    if (io::dimension_of(soup.cells.type(c)) != 2) continue;
    for (std::size_t k = 2; k < nodes.size(); ++k)
      if (!strip)
        add(nodes[0], nodes[k - 1], nodes[k]);
      else
        add(nodes[k - (k % 2 == 0 ? 2 : 1)], nodes[k - (k % 2 == 0 ? 1 : 2)], nodes[k]);
  }
  return volume;
}

}  // namespace crest::tests
