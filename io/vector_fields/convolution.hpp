// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Line integral convolution: noise smeared along the stream lines, a picture of a plane field.
#include <cstdint>
#include <vector>

#include "algorithms/vector_fields/planar_field.hpp"
#include "io/picture/camera.hpp"

namespace crest::io {

/// How dark each sample of a canvas is, row by row from the upper left: 0 outside the domain and
/// where the field is zero. `samples`: a pixel and axis. To look at, in doubles; the same bytes on
/// every machine. Cost: about 40 steps a sample inside.
std::vector<std::uint8_t> convolve(const vector_fields::PlanarField& field, const Camera& camera,
                                   int samples);

}  // namespace crest::io
