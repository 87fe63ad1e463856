// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 8: true certificates are accepted, with the counts that the sheets have.
#include <algorithm>
#include <cstring>

#include "tests/certify_extremal/extremal_samples.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

/// The same volume with samples of another type, 0 to 200.
ExtremalData with_type(const ExtremalData& data, std::uint8_t type) {
  ExtremalData out = data;
  out.type = type;
  out.samples.clear();
  for (std::size_t i = 0; i + 4 <= data.samples.size(); i += 4) {
    float x;
    std::memcpy(&x, data.samples.data() + i, 4);
    const double value = std::round(100 * static_cast<double>(x));
    const auto write = [&](auto sample) {
      std::uint8_t bytes[sizeof sample];
      std::memcpy(bytes, &sample, sizeof sample);
      out.samples.insert(out.samples.end(), bytes, bytes + sizeof sample);
    };
    switch (type) {
      case 0:
        write(static_cast<std::int8_t>(value));
        break;
      case 1:
        write(static_cast<std::uint8_t>(value));
        break;
      case 2:
        write(static_cast<std::int16_t>(value));
        break;
      case 3:
        write(static_cast<std::uint16_t>(value));
        break;
      case 4:
        write(static_cast<std::int32_t>(value));
        break;
      case 5:
        write(static_cast<std::uint32_t>(value));
        break;
      case 6:
        write(static_cast<std::int64_t>(value));
        break;
      case 7:
        write(static_cast<std::uint64_t>(value));
        break;
      case 8:
        write(static_cast<float>(value));
        break;
      default:
        write(value);
    }
  }
  return out;
}

}  // namespace

TEST_CASE("extremal: a sphere is one closed component, isotopic to the field's") {
  const auto c =
      reference_extremal(with_level(sampled({26, 26, 26}, sphere(0.78, 0.25), 1.8), 0.4));
  require_accepted(c);
  REQUIRE(c.components.size() == 1);
  const auto& sphere = c.components[0];
  CHECK(sphere.euler_characteristic == 2);
  CHECK(sphere.loops == 0);
  CHECK(sphere.orientable);
  CHECK_FALSE(sphere.cut);
  CHECK(sphere.isotopic);
  CHECK(sphere.extremal);
  CHECK(c.odd_faces == 0);

  // Not with a vertex nearer than 1/64 to a face, nor with a neighbour that is not proven empty.
  auto moved = c;
  moved.vertices[100][2] = 1023;
  CHECK_FALSE(is_accepted(moved));
  auto weak = c;
  const auto regular = std::ranges::find(c.codes, extremal_code::kRegularExtremal);
  weak.codes[static_cast<std::size_t>(regular - c.codes.begin()) - 1] = extremal_code::kCone;
  CHECK_FALSE(is_accepted(weak));
  weak.components[0].isotopic = weak.components[0].extremal = false;
  CHECK(is_accepted(weak));
}

TEST_CASE("extremal: without a proven cell every edge has a tree, and the mesh is the same") {
  const auto data = with_level(sampled({12, 12, 12}, sphere(0.6, 0.35)), 0.4);
  const auto cells = reference_extremal(data), trees = reference_extremal(data, {true});
  require_accepted(cells);
  require_accepted(trees);
  CHECK(trees.edges.size() > 2000);
  REQUIRE(trees.components.size() == 1);
  CHECK(largest(trees).euler_characteristic == 2);
  CHECK(largest(trees).polygons == largest(cells).polygons);
  CHECK(trees.types == cells.types);
}

TEST_CASE("extremal: a Moebius strip is not orientable and has one boundary loop") {
  const auto c = reference_extremal(with_level(sampled({24, 24, 16}, moebius), 0.4));
  require_accepted(c);
  const auto& strip = largest(c);
  CHECK(strip.euler_characteristic == 0);
  CHECK(strip.loops == 1);
  CHECK_FALSE(strip.orientable);
  CHECK_FALSE(strip.isotopic);
}

TEST_CASE("extremal: a bowl is cut where it fades") {
  const auto c = reference_extremal(with_level(sampled({14, 14, 14}, bowl), 0.5));
  require_accepted(c);
  CHECK(largest(c).euler_characteristic == 1);
  CHECK(largest(c).loops == 1);
  CHECK(largest(c).cut);
  CHECK(c.valences.one[2] > 10);
}

TEST_CASE("extremal: a plane through nodes, where g is exactly zero") {
  const auto plane = [](double, double, double z) { return sheet(z, 0.5); };
  const auto c = reference_extremal(with_level(sampled({9, 9, 9}, plane), 0.6));
  require_accepted(c);
  REQUIRE(c.components.size() == 1);
  CHECK(c.components[0].polygons == 49);
  CHECK(c.components[0].euler_characteristic == 1);
  CHECK(c.valences.one == std::array<std::uint32_t, 5>{0, 0, 0, 28, 0});
}

TEST_CASE("extremal: a polygon whose middle alone is dropped keeps a ring") {
  const auto plane = [](double, double, double z) { return sheet(z, 0.5); };
  auto c = reference_extremal(with_level(sampled({9, 9, 9}, plane), 0.75));
  require_accepted(c);
  REQUIRE(c.fan_points.size() == 49);
  c.fan_points[24] = c.fan_points[24] < 32768 ? 65535 : 0;
  CHECK_FALSE(is_accepted(c));
  const auto anew = reference_of(c);
  c.valences = anew.valences;
  c.components = anew.components;
  require_accepted(c);
  CHECK(c.components.at(0).euler_characteristic == 0);
  CHECK(c.components.at(0).loops == 2);
  CHECK(c.valences.one[2] == 4);
}

TEST_CASE("extremal: curves of images") {
  const auto ring = reference_extremal(with_level(sampled({32, 32, 1}, sphere(0.6, 0.3)), 0.4));
  require_accepted(ring);
  REQUIRE(ring.components.size() == 1);
  CHECK(ring.components[0].euler_characteristic == 0);
  CHECK(ring.components[0].loops == 0);
  CHECK(ring.components[0].extremal);

  const auto stroke = reference_extremal(with_level(sampled({32, 32, 1}, fading), 0.6));
  require_accepted(stroke);
  CHECK(largest(stroke).euler_characteristic == 1);
  CHECK(largest(stroke).loops == 2);
  CHECK(largest(stroke).cut);
  CHECK(stroke.valences.one == std::array<std::uint32_t, 5>{0, 0, 2, 0, 0});

  // A ray ends where n is singular, in an odd cell, and at the border.
  const auto ray = reference_extremal(with_level(sampled({24, 24, 1}, half_plane), 0.4));
  require_accepted(ray);
  CHECK(ray.odd_faces == 1);
  CHECK(largest(ray).loops == 2);
  CHECK(ray.valences.one == std::array<std::uint32_t, 5>{1, 0, 0, 1, 0});
}

TEST_CASE("extremal: second derivatives, valleys, strengths") {
  auto data = with_level(sampled({14, 14, 14}, sphere(0.6, 0.35)), 0.4);
  data.hessian = true;
  data.tensor_weights = {{{1}, {1}, {1}}};
  const auto c = reference_extremal(data);
  require_accepted(c);
  CHECK(largest(c).euler_characteristic == 2);
  CHECK_FALSE(largest(c).isotopic);

  data.min_strength = 0.05;
  require_accepted(reference_extremal(data));

  auto image = sampled({24, 24, 1}, [](double x, double y, double) {
    return 1 - sheet(std::hypot(x, y) - 0.6, 0.3);
  });
  image.valley = true;
  const auto valley = reference_extremal(image);
  require_accepted(valley);
  CHECK(valley.components[0].euler_characteristic == 0);
  image.hessian = true;
  image.tensor_weights = {{{1}, {1}, {1}}};
  require_accepted(reference_extremal(image));
}

TEST_CASE("extremal: an image's curves do not depend on the unit of length") {
  auto image = sampled({24, 24, 1}, [](double x, double y, double) {
    const double along = std::cos(0.4) * x + std::sin(0.4) * y;
    const double across = std::cos(0.4) * y - std::sin(0.4) * x;
    return std::exp(-across * across / 0.04 - along * along / 0.81);
  });
  image.hessian = true;
  image.tensor_weights = {{{1}, {1}, {1}}};
  image.min_strength = 0.03;
  const ExtremalCertificate unscaled = reference_extremal(image);
  require_accepted(unscaled);
  for (const int power : {-56, -20, 20, 44, 50, 56}) {
    INFO("2^" << power);
    ExtremalCertificate c = unscaled;
    for (std::size_t k = 0; k < 2; ++k) c.data.spacing[k] = std::ldexp(c.data.spacing[k], power);
    c.data.min_strength = std::ldexp(c.data.min_strength, -2 * power);
    require_accepted(c);
  }
}

TEST_CASE("extremal: a sphere with other spacings stays a sphere") {
  const auto c = reference_extremal(
      with_level(sampled({20, 20, 9}, sphere(0.65, 0.3), 1, {1, 1, 19.0 / 8}), 0.4));
  require_accepted(c);
  CHECK(largest(c).euler_characteristic == 2);
  CHECK(largest(c).loops == 0);
}

TEST_CASE("extremal: samples of all types") {
  const auto data = sampled({12, 10, 1}, sphere(0.6, 0.4));
  const auto first = reference_extremal(with_type(data, 0));
  for (std::uint8_t type = 0; type < 10; ++type) {
    const auto c = reference_extremal(with_type(data, type));
    require_accepted(c);
    CHECK(c.components == first.components);
  }
}

TEST_CASE("extremal: directions are read as they were made, up to the sign of w") {
  for (const auto& data : {with_level(sampled({40, 40, 1}, sphere(0.7, 0.28), 1.6), 0.4),
                           with_level(sampled({22, 22, 22}, sphere(0.7, 0.28), 1.6), 0.4)}) {
    auto made = reference_extremal(data);
    // Half of them reversed: what a says goes with its w.
    for (std::size_t i = 0; i < made.directions.size(); i += 2)
      for (auto& x : made.directions[i]) x = static_cast<std::int16_t>(-x);
    const auto read = as_read(made);
    CHECK(read.codes == made.codes);
    REQUIRE(read.directions.size() == made.directions.size());
    REQUIRE(read.gradients.size() == made.gradients.size());
    std::size_t direction = 0, gradient = 0, reversed = 0;
    const auto times = [](const ExtremalDirection& v, int sign) {
      return std::array<int, 3>{sign * v[0], sign * v[1], sign * v[2]};
    };
    for (const auto cell : made.codes) {
      if (cell == extremal_code::kOpen) continue;
      const auto &w = made.directions[direction], &v = read.directions[direction];
      const int sign = times(w, 1) == times(v, 1) ? 1 : -1;
      CHECK(times(w, sign) == times(v, 1));
      ++direction;
      if (cell < extremal_code::kRegular) continue;
      reversed += sign < 0 ? 1 : 0;
      CHECK(times(made.gradients[gradient], sign) == times(read.gradients[gradient], 1));
      ++gradient;
    }
    CHECK(reversed > 0);
    CHECK(reversed < gradient);
    CHECK(encode(read) == encode(made));
  }
}
