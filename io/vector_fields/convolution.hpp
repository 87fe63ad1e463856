// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Line integral convolution: noise smeared along the stream lines, a picture of a plane field.
#include <cstdint>
#include <vector>

#include "algorithms/vector_fields/planar_field.hpp"
#include "io/picture/camera.hpp"

namespace crest::io {

/// How dark each pixel is, row by row from the upper left: 0 outside the domain and where the field
/// is zero. To look at, in doubles; the same bytes on every machine. Cost: about 30 steps a pixel.
std::vector<std::uint8_t> convolve(const vector_fields::PlanarField& field, const Camera& camera);

}  // namespace crest::io
