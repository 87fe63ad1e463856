// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tetrahedra with a symmetric tensor at each vertex.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "kernel/arithmetic/vec3.hpp"

namespace crest::io {

/// Writes .vtu; the tensors, xx yy zz xy yz xz, as a point array of 6 components of that name.
/// Throws: kernel::InputError for another extension or a place that cannot be written.
void write_tets(const std::string& path, const std::vector<kernel::Vec3>& points,
                const std::vector<std::array<std::uint32_t, 4>>& tets, const std::string& name,
                const std::vector<std::array<double, 6>>& tensors);

}  // namespace crest::io
