// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Vertex positions: exact to the bit, or multiples of a step; predicted by parallelograms
// (Touma and Gotsman 1998, Cohen-Or et al. 2002) over the decoded connectivity
// (docs/cmc-format.md, "Positions").
#include <array>
#include <span>
#include <vector>

#include "algorithms/coding/range_coder.hpp"
#include "algorithms/coding/surface.hpp"

namespace crest::coding {

using Point = std::array<double, 3>;

/// The section's bytes for finite points in the decoded order.
Bytes encode_exact(const Surface& decoded, std::span<const Point> points);

/// Bit for bit what encode_exact() was given.
/// Throws: StreamError.
std::vector<Point> decode_exact(std::span<const std::uint8_t> bytes, const Surface& decoded);

/// The largest number of at most 20 significant bits whose square is at most 4 / 3 of
/// `tolerance`^2: points rounded to multiples of it move by the tolerance at most.
/// Requires: a finite, positive tolerance.
/// Throws: kernel::InputError if it is below 2^-1022.
double step_within(double tolerance);

/// Are the nearest multiples of `step` below 2^31?
bool in_reach(const Point& point, double step);
/// A point in reach as it is decoded: the nearest multiples.
Point rounded(const Point& point, double step);

/// The same for points, all in reach, rounded to the nearest multiples of `step`.
Bytes encode_rounded(const Surface& decoded, std::span<const Point> points, double step);
std::vector<Point> decode_rounded(std::span<const std::uint8_t> bytes, const Surface& decoded);

}  // namespace crest::coding
