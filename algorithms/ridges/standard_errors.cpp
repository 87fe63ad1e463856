// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/standard_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crest::ridges {
namespace {

std::array<double, 6> gradient(const Jet& jet, double k, const Vec3& direction, double w) {
  const double fx = jet.c[1], fy = jet.c[2], a = direction[0], b = direction[1];
  const double t = fx * a + fy * b;
  return {0,
          -k * (fx / (w * w) + 2 * t * a),
          -k * (fy / (w * w) + 2 * t * b),
          2 * a * a / w,
          2 * a * b / w,
          2 * b * b / w};
}

/// Half a unit in the last place of the largest coordinate; files of single precision are told by
/// their numbers.
double rounding(const kernel::TriangleMesh& mesh) {
  double largest = 0;
  bool single = true;
  for (const Vec3& p : mesh.points())
    for (const double x : p) {
      largest = std::max(largest, std::fabs(x));
      single = single && static_cast<double>(static_cast<float>(x)) == x;
    }
  return largest * (single ? 0x1p-24 : 0x1p-53);
}

}  // namespace

CurvatureGradients curvature_gradients(const Jet& jet, const PrincipalFrame& frame) {
  return {gradient(jet, frame.k1, frame.d1, frame.w), gradient(jet, frame.k2, frame.d2, frame.w)};
}

void scale_errors(const kernel::TriangleMesh& mesh, const std::vector<double>& residuals,
                  const std::vector<FitQuality>& quality, std::vector<CurvatureError>& errors) {
  std::vector<double> known;
  for (std::size_t v = 0; v < residuals.size(); ++v)
    if (quality[v].degree >= 4) known.push_back(residuals[v]);
  double median = 0;
  if (!known.empty()) {
    const auto middle = known.begin() + static_cast<std::ptrdiff_t>(known.size() / 2);
    std::nth_element(known.begin(), middle, known.end());
    median = *middle;
  }
  const double least = rounding(mesh);
  for (std::size_t v = 0; v < errors.size(); ++v) {
    const double s = quality[v].degree >= 4
                         ? std::max(std::clamp(residuals[v], median / 2, 2 * median), least)
                         : std::numeric_limits<double>::infinity();
    for (double* error : {&errors[v].k1, &errors[v].k2, &errors[v].gap})
      *error = s < std::numeric_limits<double>::infinity() ? s * *error : s;
  }
}

}  // namespace crest::ridges
