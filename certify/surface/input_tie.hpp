// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// `--input FILE`: are the data of a certificate the mesh of a file? (ridges_mesh/SPEC.md, last
// section)
#include <string>

#include "certify/container/verdict.hpp"
#include "certify/surface/corners.hpp"

namespace crest::certify {

/// Requires: the faces are an oriented manifold. Returns whether its components are oriented as the
/// input is, in words that go on "the same positions and faces, ...". Throws Reject if positions or
/// faces differ (faces up to rotation and orientation).
std::string check_input(const InputMesh& input, std::span<const std::array<double, 3>> positions,
                        Faces faces);

}  // namespace crest::certify
