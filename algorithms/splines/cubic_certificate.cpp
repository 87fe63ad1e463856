// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/splines/cubic_certificate.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/splines/cubic_extension.hpp"
#include "algorithms/splines/normal_form.hpp"
#include "certify/spline_cubic/records.hpp"

namespace crest::splines {
namespace {

/// Beyond the rounding of a formula whose terms are numbers of the model times small constants.
constexpr double kRounding = 0x1p-40;

double largest_number(const CubicModel& model) {
  double largest = 0;
  const auto see = [&](const auto& all) {
    for (const auto& numbers : all)
      for (const double x : numbers) largest = std::max(largest, std::fabs(x));
  };
  see(model.vertices);
  see(model.slopes);
  see(model.centres);
  return largest;
}

}  // namespace

GradientJump gradient_jump(const CubicModel& model) {
  if (model.smoothness == Smoothness::c1) return {};
  double residual = 0;
  Place at{};
  for_each_place(model.domain.cubes, [&](const Place& cube) {
    const auto targets = fourfold_targets(model, cube);
    for (std::size_t c = 0; c < 8; ++c) {
      const auto& centre = model.centres[model.domain.cube(cube)];
      const double r = std::fabs(eightfold_residual(centre, targets, c)) / 8;
      if (r <= residual) continue;
      residual = r;
      at = cube;
    }
  });
  GradientJump jump;
  double steepest = 0;
  const Vec3 density = model.domain.density();
  for (std::size_t a = 0; a < 3; ++a) {
    const auto [b, c] = kAcross[a];
    steepest = std::max(steepest, std::hypot(density[b], density[c]));
    jump.where[a] = model.domain.low[a] + (at[a] + 0.5) / density[a];
  }
  jump.bound = 3 * (residual + kRounding * largest_number(model)) * steepest * (1 + kRounding);
  return jump;
}

double error_bound(const CubicModel& model, double max_error) {
  // Coordinates are rounded in units of n, and the slope in cube coordinates is small beside the
  // numbers times 32.
  const auto& n = model.domain.cubes;
  const double scale = largest_number(model) * (1 + *std::max_element(n.begin(), n.end()));
  return max_error * (1 + kRounding) + kRounding * 0x1p-4 * scale;
}

certify::SplineCubicCertificate cubic_certificate(const CubicModel& model,
                                                  std::span<const Vec3> points,
                                                  std::span<const double> values,
                                                  double max_error) {
  certify::SplineCubicCertificate certificate;
  certify::SplineCubicData& data = certificate.data;
  const Domain& domain = model.domain;
  for (std::size_t d = 0; d < 3; ++d) {
    data.box[2 * d] = domain.low[d];
    data.box[2 * d + 1] = domain.high[d];
  }
  data.cubes = domain.cubes;
  data.domain = {{0, static_cast<std::uint32_t>(domain.cube_count())}};
  data.integers = model.smoothness == Smoothness::c1;
  if (data.integers) data.exponent = std::ilogb(model.unit);
  data.vertices = model.vertices;
  data.slopes = model.slopes;
  data.centres = model.centres;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (domain.contains(points[i]))
      data.samples.push_back({points[i][0], points[i][1], points[i][2], values[i]});
    else
      ++data.outside;
  certificate.jump = gradient_jump(model).bound;
  certificate.error = error_bound(model, max_error);
  return certificate;
}

}  // namespace crest::splines
