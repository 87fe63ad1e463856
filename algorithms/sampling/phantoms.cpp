// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/sampling/phantoms.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "algorithms/sampling/mesh_surface.hpp"
#include "algorithms/sampling/uniform.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::sampling {
namespace {

using kernel::Vec3;
constexpr double kWidth = 0.09;

double square(double x) {
  return x * x;
}
/// Of a distance.
double profile(double d) {
  return std::exp(-square(d / kWidth));
}

double sphere(const Vec3& p) {
  return profile(std::sqrt(dot(p, p)) - 0.6);
}

/// The first-order distance.
double ellipsoid(const Vec3& p) {
  constexpr Vec3 radii = {0.7, 0.55, 0.45};
  double k = 0, gradient = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    k += square(p[i] / radii[i]);
    gradient += square(p[i] / square(radii[i]));
  }
  k = std::sqrt(k);
  return gradient == 0 ? 0 : profile(k * (k - 1) / std::sqrt(gradient));
}

double circle(const Vec3& p, double x, double radius) {
  return std::hypot(std::hypot(p[0] - x, p[1]) - radius, p[2]);
}

double torus(const Vec3& p) {
  return profile(circle(p, 0, 0.5) - 0.28);
}

double genus2(const Vec3& p) {
  constexpr double blend = 0.06;
  const double a = circle(p, 0.36, 0.34), b = circle(p, -0.36, 0.34);
  return profile(-blend * std::log(std::exp(-a / blend) + std::exp(-b / blend)) - 0.17);
}

double moebius(const Vec3& p) {
  const double u = std::atan2(p[1], p[0]), r = std::hypot(p[0], p[1]) - 0.6;
  const double c = std::cos(u / 2), s = std::sin(u / 2);
  const double t = c * r + s * p[2];
  return profile(-s * r + c * p[2]) * profile(std::fmax(0, std::fabs(t) - 0.27));
}

double junction(const Vec3& p) {
  double most = 0;
  for (int m = 0; m < 3; ++m) {
    const double angle = 2 * std::numbers::pi * m / 3 + 0.2;
    const double t = std::cos(angle) * p[0] + std::sin(angle) * p[1];
    const double d = -std::sin(angle) * p[0] + std::cos(angle) * p[1];
    most = std::fmax(most, profile(std::hypot(d, std::fmin(t, 0))));
  }
  return most;
}

using Field = double (*)(const Vec3&);
constexpr Field kFields[] = {sphere, ellipsoid, torus, genus2, moebius, junction};

const Phantom* find(const std::vector<Phantom>& phantoms, const std::string& name) {
  const auto found = std::find_if(phantoms.begin(), phantoms.end(),
                                  [&](const Phantom& p) { return p.name == name; });
  return &*found;
}

/// The strip's point and unit normal.
std::pair<Vec3, Vec3> on_strip(double u, double w) {
  const double c = std::cos(u / 2), s = std::sin(u / 2), r = 1 + w * c;
  const Vec3 point = {r * std::cos(u), r * std::sin(u), w * s};
  const Vec3 along_w = {c * std::cos(u), c * std::sin(u), s};
  const double dr = -w * s / 2;
  const Vec3 along_u = {dr * std::cos(u) - r * std::sin(u), dr * std::sin(u) + r * std::cos(u),
                        w * c / 2};
  Vec3 normal = cross(along_u, along_w);
  const double length = std::sqrt(dot(normal, normal));
  for (double& x : normal) x /= length;
  return {point, normal};
}

}  // namespace

const std::vector<Phantom>& volume_phantoms() {
  static const std::vector<Phantom> phantoms = {
      {"sphere-shell", "a sphere of radius 0.6", {2, 0, true}},
      {"ellipsoid-shell", "an ellipsoid of half axes 0.7, 0.55, 0.45", {2, 0, true}},
      {"torus-shell", "a torus of radii 0.5 and 0.28", {0, 0, true}},
      {"genus2-shell", "a surface of genus 2", {-2, 0, true}},
      {"moebius-sheet", "a Moebius strip", {0, 1, false}},
      {"junction", "three half planes that meet in a line", {1, 1, true}}};
  return phantoms;
}

const std::vector<Phantom>& point_phantoms() {
  static const std::vector<Phantom> phantoms = {
      {"moebius-points", "random points on a Moebius strip", {0, 1, false}},
      {"hemisphere-points", "random points on the upper half of the unit sphere", {1, 1, true}}};
  return phantoms;
}

kernel::SampledGrid volume_phantom(const std::string& name, std::size_t nodes) {
  const auto& phantoms = volume_phantoms();
  const Field field = kFields[find(phantoms, name) - phantoms.data()];
  const double step = 2 / static_cast<double>(nodes - 1);
  kernel::SampledGrid grid;
  grid.size = {nodes, nodes, nodes};
  grid.spacing = {step, step, step};
  grid.origin = {-1, -1, -1};
  const auto place = [&](std::size_t i) {
    return -1 + 2 * static_cast<double>(i) / static_cast<double>(nodes - 1);
  };
  std::vector<float> samples(grid.count());
  kernel::parallel_for(std::size_t{0}, nodes, [&](std::size_t z) {
    for (std::size_t y = 0; y < nodes; ++y)
      for (std::size_t x = 0; x < nodes; ++x)
        samples[(z * nodes + y) * nodes + x] =
            static_cast<float>(field({place(x), place(y), place(z)}));
  });
  grid.samples = std::move(samples);
  return grid;
}

OrientlessPoints point_phantom(const std::string& name, int count, double noise,
                               std::uint64_t seed) {
  OrientlessPoints result;
  Uniform uniform(seed);
  const bool strip = name == "moebius-points";
  for (int i = 0; i < count; ++i) {
    const double a = uniform(), b = uniform();
    std::pair<Vec3, Vec3> at;
    if (strip) {
      at = on_strip(2 * std::numbers::pi * a, 0.45 * (2 * b - 1));
    } else {
      const double r = std::sqrt(1 - b * b);
      at.first = at.second = {r * std::cos(2 * std::numbers::pi * a),
                              r * std::sin(2 * std::numbers::pi * a), b};
    }
    if (uniform() < 0.5)
      for (double& x : at.second) x = -x;
    result.points.push_back(at.first);
    result.normals.push_back(at.second);
  }
  if (noise > 0) add_normal_noise(result.points, result.normals, noise, seed + 1);
  return result;
}

}  // namespace crest::sampling
