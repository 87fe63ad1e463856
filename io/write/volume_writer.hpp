// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Volumes, and points with normals, to files.
#include <string>
#include <vector>

#include "kernel/geometry/sampled_grid.hpp"

namespace crest::io {

/// .nrrd (raw) or .vti (compressed), the samples in their own type. Guarantees: the same bytes
/// for the same grid; no half-written file. Throws: kernel::InputError for another extension or a
/// place that cannot be written.
void write_volume(const std::string& path, const kernel::SampledGrid& grid);

/// .xyz or .pwn: x y z nx ny nz a line, in shortest decimals. The same guarantees.
void write_points(const std::string& path, const std::vector<kernel::Vec3>& points,
                  const std::vector<kernel::Vec3>& normals);

}  // namespace crest::io
