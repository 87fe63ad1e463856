// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Soups by hand, and what cleaning makes of them.
#include <initializer_list>
#include <string>

#include "io/clean/clean.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::tests {

using io::CellType;
using io::CleanUp;
using io::Purpose;
using io::Soup;
using io::Surface;
using kernel::Index;
using kernel::Triangle;
using kernel::Vec3;

using Face = std::vector<io::Cells::Node>;

inline Soup soup_of(std::vector<Vec3> points, const std::vector<Face>& faces) {
  Soup soup;
  soup.points = std::move(points);
  for (const Face& face : faces) soup.cells.add(io::face_type(face.size()), face);
  return soup;
}

inline Soup soup_of(const Surface& surface) {
  std::vector<Face> faces;
  for (const auto& [a, b, c] : surface.faces) faces.push_back({a, b, c});
  return soup_of(surface.points, faces);
}

/// Surface, counts and the message if there is no surface.
struct Cleaned {
  Surface surface;
  CleanUp done;
  std::string error;
};

inline Cleaned cleaned(const Soup& soup, const io::CleanOptions& options = {},
                       Purpose purpose = Purpose::geometry) {
  Cleaned result;
  try {
    result.surface = clean(soup, options, purpose, result.done);
  } catch (const kernel::InputError& error) {
    result.error = error.what();
  }
  return result;
}

inline const std::vector<Vec3> kTetrahedronPoints = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
inline const std::vector<Face> kTetrahedronFaces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

}  // namespace crest::tests
