// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 8.1, 8.4 and 8.6 to 8.9 as numbers: errors of value and angles of the gradient on an
// isosurface of Marschner and Lobb's function and on a sphere, quadratic super splines beside the
// models of section 8.6.3.
#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "algorithms/splines/comparison.hpp"
#include "algorithms/splines/pinhole.hpp"
#include "experiments/001-splines/test_functions.hpp"
#include "experiments/program.hpp"

namespace crest::experiments {
namespace {

using kernel::operator*;
using kernel::operator+;
using kernel::operator-;
using splines::ValueAndGradient;

double radius_of(const Vec3& p) {
  return std::hypot(p[0], p[1], p[2]);
}

Vec3 gradient_of(Function f, const Vec3& p) {
  constexpr double h = 1e-6;
  Vec3 g;
  for (std::size_t k = 0; k < 3; ++k) {
    Vec3 low = p, high = p;
    low[k] -= h;
    high[k] += h;
    g[k] = (f(high) - f(low)) / (2 * h);
  }
  return g;
}

struct Model {
  const char* name;
  ValueAndGradient (*at)(const kernel::SampledGrid&, const Vec3&);
};
constexpr Model kModels[] = {{"linear on the partition", splines::linear_on_partition},
                             {"Freudenthal quadratic", splines::freudenthal_quadratic},
                             {"trilinear", splines::trilinear},
                             {"trilinear, differences", splines::trilinear_differences},
                             {"triquadratic", splines::triquadratic}};

/// Points of {f = c} that a camera sees, by Newton's steps from the spline's.
std::vector<Vec3> visible_points(const splines::QuadraticSpline& spline, Function f, double c,
                                 int size, double& largest) {
  const auto rays = splines::automatic_view(spline, size).rays();
  std::vector<splines::Hit> hits(rays.size());
  splines::RayCaster(spline, c).cast(rays, hits);
  std::vector<Vec3> points;
  for (const auto& hit : hits) {
    if (!hit.hit) continue;
    Vec3 p = hit.place;
    largest = std::max(largest, std::fabs(f(p) - c));
    for (int i = 0; i < 20; ++i) {
      const Vec3 g = gradient_of(f, p);
      p = p - ((f(p) - c) / kernel::dot(g, g)) * g;
    }
    const bool inside =
        spline.evaluate(p).value == spline.evaluate(p).value && std::fabs(f(p) - c) < 1e-12;
    if (inside) points.push_back(p);
  }
  return points;
}

void compare(const char* title, int n, Function f, double c, int size) {
  const splines::QuadraticSpline spline(volume_of(f, n));
  double largest = 0;
  const auto points = visible_points(spline, f, c, size, largest);
  fmt::print(
      "{}, {}^3 samples, {} points; the function less c on the spline's isosurface: at most "
      "{:.4f}\n\n"
      "| model | value: mean | max | gradient, degrees: mean | max |\n|---|---|---|---|---|\n",
      title, n, points.size(), largest);
  const auto row = [&](const char* name,
                       const std::function<ValueAndGradient(const Vec3&)>& model) {
    double mean = 0, max = 0, angle = 0, widest = 0;
    for (const Vec3& p : points) {
      const auto s = model(p);
      const Vec3 g = gradient_of(f, p);
      const double e = std::fabs(s.value - c);
      const double a =
          std::atan2(kernel::norm(kernel::cross(g, s.gradient)), kernel::dot(g, s.gradient)) * 180 /
          std::numbers::pi;
      mean += e;
      angle += a;
      max = std::max(max, e);
      widest = std::max(widest, a);
    }
    const auto count = static_cast<double>(points.size());
    fmt::print("| {} | {:.5f} | {:.5f} | {:.2f} | {:.2f} |\n", name, mean / count, max,
               angle / count, widest);
  };
  row("quadratic super spline", [&](const Vec3& p) { return spline.evaluate(p); });
  for (const Model& model : kModels)
    row(model.name, [&](const Vec3& p) {
      const double h = spline.grid().spacing[0];
      auto s = model.at(spline.grid(), (1 / h) * (p + Vec3{1, 1, 1}));
      s.gradient = (1 / h) * s.gradient;
      return s;
    });
  fmt::print("\n");
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  using namespace crest::experiments;
  Program program("errors of models of volumes on isosurfaces");
  int size = 256;
  program.option("--size", size, "pixels along each side");
  return program.run(argc, argv, [&] {
    for (const int n : {41, 164})
      compare("Marschner and Lobb, c = 0.5", n, marschner_lobb, 0.5, size);
    for (const int n : {8, 16}) compare("distance to a point, c = 0.6", n, radius_of, 0.6, size);
    return 0;
  });
}
