// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// On which side a shape stands.
#include "io/picture/camera.hpp"

namespace crest::io {

/// The axis of the file, y, z or x, that points up if the shape stands on its feet; nothing if it
/// has none. Feet are what reaches no higher than 3 % of the height; they carry the shape if the
/// polygon around them, seen from above, has a fifth of the area of that around the shape. Of
/// several axes: of those with 0.7 of the largest share the first. (Their opposites are left out:
/// few files stand on their heads, but heads are broad.)
std::optional<kernel::Vec3> standing_direction(const SurfaceView& mesh);

}  // namespace crest::io
