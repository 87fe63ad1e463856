// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A stream compared with the mesh it was made from.
#include <span>

#include "algorithms/coding/coding.hpp"

namespace crest::coding {

/// Decodes the stream.
/// Guarantees: its faces are the mesh's under vertex_order, each turned as it may be; with a kept
///   order face by face; its points are the mesh's bit for bit, or within the tolerance; so are
///   its attributes, corner by corner.
/// Returns the largest distance between a point and its decoded place, rounded.
/// Throws: std::logic_error if one of these does not hold.
double verify(const Encoded& encoded, std::span<const Triangle> faces,
              std::span<const Point> points, const EncodeOptions& options,
              std::span<const kernel::Attribute> attributes = {});

}  // namespace crest::coding
