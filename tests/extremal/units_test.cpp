// SPDX-License-Identifier: GPL-3.0-or-later
// The unit of length decides nothing: with all spacings times a power of two, and the least
// strength divided by its square, the same cells, edges and components are found.
#include <catch2/catch.hpp>
#include <cmath>

#include "certify/extremal/encode.hpp"
#include "certify/verify.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/extremal/reference_sheets.hpp"

using namespace crest;
using namespace crest::tests;
using extremal::Definition;
using extremal::Options;
using extremal::Volume;

namespace {

/// A ring, a sphere; samples are whole numbers up to 250.
Volume ring(kernel::Index layers) {
  Volume v;
  v.size = {26, 24, layers};
  v.spacing = {1, 1.125, 0.875};
  std::vector<float> samples;
  for (int z = 0; z < static_cast<int>(layers); ++z)
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 26; ++x) {
        const double r =
            std::hypot((x - 12.3) / 12, (y - 11.6) / 11, layers == 1 ? 0 : (z - 9.2) / 9);
        samples.push_back(
            static_cast<float>(std::floor(250 * std::exp(-std::pow((r - 0.6) / 0.2, 2)))));
      }
  v.samples = std::move(samples);
  return v;
}

certify::ExtremalCertificate certificate_of(Volume volume, Options options, int power) {
  for (double& d : volume.spacing) d = std::ldexp(d, power);
  options.min_strength = std::ldexp(options.min_strength, -2 * power);
  certify::ExtremalCertificate c;
  extremal::extract(volume, options, &c);
  const auto verdict = certify::verify(certify::encode(c));
  INFO(verdict.reason);
  CHECK(verdict.accepted);
  return c;
}

}  // namespace

TEST_CASE("extremal units: a power of two as unit of length changes nothing") {
  for (const kernel::Index layers : {1U, 20U})
    for (const Definition definition : {Definition::structure, Definition::hessian}) {
      Options options;
      options.definition = definition;
      options.min_value = 60;
      options.min_strength = 0.5;
      const Volume volume = ring(layers);
      const auto one = certificate_of(volume, options, 0);
      REQUIRE(one.types.size() > 50);
      // By Hess there are small ones besides.
      if (definition == Definition::structure) {
        REQUIRE(one.components.size() == 1);
        CHECK(one.components[0].euler_characteristic == (layers == 1 ? 0 : 2));
      }
      // T's coefficients are floats of the unit's inverse square.
      for (const int power : {-50, -31, -7, 6, 13, 20, 33, 50}) {
        INFO(layers << " layers, " << int(definition) << ", 2^" << power);
        const auto other = certificate_of(volume, options, power);
        CHECK(other.codes == one.codes);
        CHECK(other.directions == one.directions);
        CHECK(other.edges == one.edges);
        CHECK(other.trees == one.trees);
        CHECK(other.types == one.types);
        CHECK(other.vertices == one.vertices);
        CHECK(other.fan_points == one.fan_points);
        CHECK(other.components == one.components);
      }
    }
}

TEST_CASE("extremal units: spacings beyond the checker's are refused by name") {
  for (const kernel::Index layers : {1U, 20U})
    for (const double spacing : {0x1p-61, 0x1p61, 0x1p-500, 0x1p500, 5e-324, 1e308}) {
      Volume volume = ring(layers);
      volume.spacing[1] = spacing;
      std::string why;
      try {
        extremal::extract(volume, {});
      } catch (const kernel::InputError& error) {
        why = error.what();
      }
      CHECK(why.find("spacing along axis 1: not from 2^-60") == 0);
    }
}
