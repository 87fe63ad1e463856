// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/splines/cubic_fit.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/splines/cubic_evaluate.hpp"
#include "algorithms/splines/cubic_extension.hpp"
#include "algorithms/splines/integer_march.hpp"
#include "algorithms/splines/sine_projection.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::splines {
namespace {

using kernel::InputError;

constexpr double kSamplesPerCube = 10;
constexpr double kMostCubes = 1 << 28;

void require_finite(std::span<const Vec3> points, std::span<const double> values) {
  if (points.empty()) throw InputError("samples: there are none; give at least one");
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!std::isfinite(points[i][0]) || !std::isfinite(points[i][1]) ||
        !std::isfinite(points[i][2]) || !std::isfinite(values[i]))
      throw InputError("sample " + std::to_string(i) +
                       ": has a number that is not finite; leave it out");
}

std::array<Vec3, 2> box_of(std::span<const Vec3> points) {
  std::array<Vec3, 2> box{points[0], points[0]};
  for (const Vec3& p : points)
    for (std::size_t d = 0; d < 3; ++d) {
      box[0][d] = std::min(box[0][d], p[d]);
      box[1][d] = std::max(box[1][d], p[d]);
    }
  return box;
}

/// Gives axes along which all points have one coordinate the length of the shortest other one.
void thicken(Domain& domain, const std::array<bool, 3>& flat) {
  double length = HUGE_VAL;
  for (std::size_t d = 0; d < 3; ++d)
    if (!flat[d]) length = std::min(length, domain.high[d] - domain.low[d]);
  for (std::size_t d = 0; d < 3; ++d) {
    if (!flat[d]) continue;
    // Beside large coordinates a short length is lost.
    const double size = std::fabs(domain.low[d]);
    const double half = std::max(length == HUGE_VAL ? 0.5 : length / 2, size / 1024);
    domain.low[d] -= half;
    domain.high[d] += half;
  }
}

/// Numbers of cubes of as equal sides as they divide the axes that are not flat.
void divide(Domain& domain, const std::array<bool, 3>& flat, std::size_t samples) {
  double volume = 1;
  int axes = 0;
  for (std::size_t d = 0; d < 3; ++d) {
    if (flat[d]) continue;
    volume *= domain.high[d] - domain.low[d];
    ++axes;
  }
  if (axes == 0) return;
  const double side = std::pow(volume * kSamplesPerCube / static_cast<double>(samples), 1.0 / axes);
  for (std::size_t d = 0; d < 3; ++d)
    if (!flat[d])
      domain.cubes[d] = static_cast<Index>(
          std::clamp(std::floor((domain.high[d] - domain.low[d]) / side), 1.0, kMostCubes));
}

void require_sound(const Domain& domain) {
  double cubes = 1;
  for (std::size_t d = 0; d < 3; ++d) {
    const double length = domain.high[d] - domain.low[d];
    if (!(std::isfinite(domain.low[d]) && std::isfinite(length) && length > 0))
      throw InputError("box: is empty or not finite; give LOW < HIGH along every axis");
    if (domain.cubes[d] < 1) throw InputError("cubes: one axis has none; give 1 or more");
    // Cubes so narrow beside the coordinates would have borders that rounding moves.
    const double size = std::max(std::fabs(domain.low[d]), std::fabs(domain.high[d]));
    if (!(length / domain.cubes[d] > size * 0x1p-40))
      throw InputError(
          "box: its cubes are too small beside its coordinates; move it to the origin");
    cubes *= domain.cubes[d] + 1.0;
  }
  if (cubes > kMostCubes) throw InputError("cubes: more than 2^28; give fewer (-n)");
}

Domain domain_of(std::span<const Vec3> points, const CubicOptions& options,
                 std::array<bool, 3>& flat) {
  Domain domain;
  const auto around = box_of(points);
  const auto box = options.box.value_or(around);
  domain.low = box[0];
  domain.high = box[1];
  for (std::size_t d = 0; d < 3; ++d) flat[d] = around[0][d] == around[1][d];
  if (!options.box) thicken(domain, flat);
  std::size_t inside = 0;
  for (const Vec3& p : points) inside += domain.contains(p) ? 1 : 0;
  if (inside == 0) throw InputError("box: holds no sample; give a larger one");
  if (options.cubes)
    domain.cubes = *options.cubes;
  else
    divide(domain, flat, inside);
  require_sound(domain);
  return domain;
}

/// What the fits say of themselves.
void count(const std::vector<LocalCubic>& fits, CubicFit& result) {
  result.local_fits = fits.size();
  double samples = 0;
  for (const LocalCubic& fit : fits) {
    ++result.degrees[static_cast<std::size_t>(fit.degree)];
    samples += fit.samples;
  }
  result.samples_per_fit = samples / static_cast<double>(fits.size());
}

}  // namespace

CubicFit fit_cubic(std::span<const Vec3> points, std::span<const double> values,
                   const CubicOptions& options) {
  require_finite(points, values);
  CubicFit result;
  std::array<bool, 3> flat;
  const Domain domain = domain_of(points, options, flat);
  if (flat[0] || flat[1] || flat[2])
    result.warnings.push_back(
        "all samples lie in a plane across an axis: the spline is constant along it");
  const Scattered samples(domain, points, values);
  result.samples = samples.size();
  result.outside = points.size() - samples.size();
  result.empty_cubes = samples.empty_cubes();
  if (result.empty_cubes > 0)
    result.warnings.push_back(std::to_string(result.empty_cubes) + " of " +
                              std::to_string(domain.cube_count()) +
                              " cubes hold no sample: the spline is extrapolated there");
  Extension extension = options.smoothness == Smoothness::sequential
                            ? extend_sequentially(domain, samples, flat)
                            : extend_locally(domain, samples, flat);
  count(extension.fits, result);
  result.model = std::move(extension.model);
  result.model.smoothness = options.smoothness;
  if (options.smoothness == Smoothness::c1) {
    project_to_c1(result.model);
    march_to_c1(result.model);
  }
  return result;
}

FitError error_at_samples(const CubicModel& model, std::span<const Vec3> points,
                          std::span<const double> values) {
  FitError error;
  std::size_t count = 0;
  const auto at = evaluate(model, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::isnan(at[i].value)) continue;
    const double e = std::fabs(at[i].value - values[i]);
    error.mean += e;
    error.max = std::max(error.max, e);
    ++count;
  }
  error.mean /= static_cast<double>(count);
  return error;
}

}  // namespace crest::splines
