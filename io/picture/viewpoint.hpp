// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// From where a picture shows a shape, as a caller asks for it.
#include <optional>

#include "kernel/arithmetic/vec3.hpp"

namespace crest::io {

/// What is not given is chosen by the shape (camera.hpp).
struct Viewpoint {
  std::optional<kernel::Vec3> view = {};  ///< from the eye into the scene
  std::optional<kernel::Vec3> up = {};    ///< what points up in the picture
};

}  // namespace crest::io
