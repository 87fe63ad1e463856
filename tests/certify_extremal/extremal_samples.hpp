// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Volumes and images with known sheets, in [-1, 1]^d.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "certify/container/container.hpp"
#include "certify/extremal/decode.hpp"
#include "certify/extremal/encode.hpp"
#include "certify/verify.hpp"
#include "tests/certify_extremal/reference_extremal.hpp"

namespace crest::tests {

using Profile = std::function<double(double, double, double)>;

inline certify::ExtremalData sampled(std::array<std::uint32_t, 3> nodes, const Profile& profile,
                                     double sigma = 1, Vec spacing = {1, 1, 1}) {
  std::vector<float> samples;
  const auto at = [&](std::uint32_t i, std::size_t k) {
    return nodes[k] == 1 ? 0 : -1 + 2.0 * i / (nodes[k] - 1);
  };
  for (std::uint32_t z = 0; z < nodes[2]; ++z)
    for (std::uint32_t y = 0; y < nodes[1]; ++y)
      for (std::uint32_t x = 0; x < nodes[0]; ++x)
        samples.push_back(static_cast<float>(profile(at(x, 0), at(y, 1), at(z, 2))));
  return make_data(nodes, samples, spacing, sigma);
}
inline double sheet(double distance, double width) {
  return std::exp(-(distance / width) * (distance / width));
}
inline certify::ExtremalData with_level(certify::ExtremalData data, double level) {
  data.has_min_value = true;
  data.min_value = level;
  return data;
}
inline Profile sphere(double radius, double width) {
  return [=](double x, double y, double z) {
    return sheet(std::sqrt(x * x + y * y + z * z) - radius, width);
  };
}
/// A half plane (ray) along and across a direction: an open sheet.
inline double half_plane(double x, double y, double) {
  const double t = std::cos(0.4) * x + std::sin(0.4) * y,
               d = -std::sin(0.4) * x + std::cos(0.4) * y;
  return std::exp(-(d * d + std::pow(std::min(t + 0.2, 0.0), 2)) / 0.09);
}
/// A stroke whose height falls along it.
inline double fading(double x, double y, double) {
  const double t = std::cos(0.4) * x + std::sin(0.4) * y,
               d = -std::sin(0.4) * x + std::cos(0.4) * y;
  return sheet(d, 0.2) * sheet(t, 0.9);
}
/// A sphere that fades below.
inline double bowl(double x, double y, double z) {
  return sheet(std::sqrt(x * x + y * y + z * z) - 0.6, 0.3) * sheet(std::max(0.0, -z), 0.7);
}
inline double moebius(double x, double y, double z) {
  const double u = std::atan2(y, x), r = std::hypot(x, y) - 0.6;
  const double d = -std::sin(u / 2) * r + std::cos(u / 2) * z;
  const double t = std::cos(u / 2) * r + std::sin(u / 2) * z;
  return sheet(d, 0.2) * sheet(std::max(0.0, std::fabs(t) - 0.2), 0.2);
}

/// Written and read again: every w is positive along its axis.
inline certify::ExtremalCertificate as_read(const certify::ExtremalCertificate& c) {
  const certify::Bytes bytes = certify::encode(c);
  const certify::Container container = certify::open_container(bytes);
  return certify::decode_extremal(container.data, container.claims);
}
inline void require_accepted(const certify::ExtremalCertificate& c) {
  const auto verdict = certify::verify(certify::encode(c));
  INFO(verdict.reason);
  REQUIRE(verdict.accepted);
}
inline bool is_accepted(const certify::ExtremalCertificate& c) {
  return certify::verify(certify::encode(c)).accepted;
}
/// The component with most polygons.
inline const certify::ExtremalComponent& largest(const certify::ExtremalCertificate& c) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < c.components.size(); ++i)
    if (c.components[i].polygons > c.components[best].polygons) best = i;
  return c.components.at(best);
}

}  // namespace crest::tests
