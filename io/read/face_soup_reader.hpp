// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Faces as a file has them, cut into triangles and nothing else: what needs no surface reads these.
#include <string>
#include <vector>

#include "io/clean/clean_up.hpp"
#include "kernel/geometry/index.hpp"

namespace crest::io {

struct FaceSoup {
  std::vector<kernel::Vec3> points;
  std::vector<kernel::Triangle> faces;
  CleanUp cleanup;
  std::vector<std::string> warnings;
};

/// Throws: kernel::InputError as read_mesh() does for what no file may hold; edges of many faces,
/// one-sided and overlapping ones pass.
FaceSoup read_face_soup(const std::string& path);

}  // namespace crest::io
