// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Quadratic splines as .vti files: the samples in their type, and as field data `type` "quadratic",
// `border` and `frame` (origin, spacings, directions: the file's own are rounded copies).
#include <optional>
#include <string>

#include "algorithms/splines/quadratic.hpp"

namespace crest::io {

/// Guarantees: read back it is the same, bit by bit; no half-written file.
void write_quadratic_model(const std::string& path, const splines::QuadraticSpline& spline);

/// What a model has besides the samples that every reader of volumes finds in it.
struct QuadraticHeader {
  splines::Border border = splines::Border::none;
  kernel::Vec3 origin{}, spacing{};
  std::array<kernel::Vec3, 3> directions{};

  void restore(kernel::SampledGrid& grid) const;
};

/// Nothing where the file is no model but, if anything, a plain volume.
/// Throws: kernel::InputError, one line: it calls itself a model and is not sound.
std::optional<QuadraticHeader> read_quadratic_header(const std::string& path);

}  // namespace crest::io
