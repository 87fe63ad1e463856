// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is said of ridges and umbilics, of meshes as of smooth surfaces. The numbers are those of
// files and certificates.
#include <cstdint>

namespace crest::kernel {

/// Blue: k1, the larger principal curvature; red: k2 (paper 002, section 3).
enum class Colour : std::uint8_t { blue = 0, red = 1 };

/// Elliptic: maximum of k1 or minimum of k2 (P < 0). Hyperbolic: the other extremum (P > 0).
/// Turning: from one to the other. None: neither is claimed (P is exactly zero, a rule has a tie,
/// or the place is in an umbilic's patch).
enum class RidgeType : std::uint8_t { none = 0, elliptic = 1, hyperbolic = 2, turning = 3 };

/// 1-ridge (hyperbolic) or 3-ridge (elliptic) by the sign of the cubic form's discriminant.
enum class UmbilicKind : std::uint8_t { degenerate = 0, one_ridge = 1, three_ridge = 3 };

}  // namespace crest::kernel
