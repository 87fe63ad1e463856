// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Cubic splines of scattered samples (paper 001, chapter 9): the public call.
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "algorithms/splines/cubic_model.hpp"

namespace crest::splines {

struct CubicOptions {
  Smoothness smoothness = Smoothness::c1;
  /// One number: of cubes along each axis. Unless given, ten samples a cube, of as equal sides as
  /// possible.
  std::optional<std::array<Index, 3>> cubes;
  std::optional<std::array<Vec3, 2>> box;  ///< low, high; unless given, that of the points
};

struct CubicFit {
  CubicModel model;
  std::size_t samples = 0, outside = 0;  ///< in the closed box, and not
  std::size_t empty_cubes = 0;           ///< without a sample
  std::size_t local_fits = 0;
  std::array<std::size_t, 4> degrees{};  ///< of the local fits
  double samples_per_fit = 0;            ///< mean
  std::vector<std::string> warnings;
};

/// The spline that approximates values at points.
/// Requires: as many values as points. Guarantees: the same numbers for any order of the samples
/// and any number of threads; polynomials of degree 3 are reproduced up to rounding where the
/// samples determine them; smoothness as asked for. Throws kernel::InputError: no sample in the
/// box, a number that is not finite, a box or numbers of cubes out of range.
CubicFit fit_cubic(std::span<const Vec3> points, std::span<const double> values,
                   const CubicOptions& options = {});

/// The largest and the mean |s - f| at the samples in the box.
struct FitError {
  double mean = 0, max = 0;
};
FitError error_at_samples(const CubicModel& model, std::span<const Vec3> points,
                          std::span<const double> values);

}  // namespace crest::splines
