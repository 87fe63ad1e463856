// SPDX-License-Identifier: GPL-3.0-or-later
// Claims 11 to 13: numbers at the ends of doubles, words that are no counts, sizes that lie.
#include <catch2/catch.hpp>
#include <cmath>

#include "certify/container/container.hpp"
#include "certify/spline_cubic/encode.hpp"
#include "certify/spline_isosurface/encode.hpp"
#include "certify/spline_rays/encode.hpp"
#include "certify/verify.hpp"
#include "tests/certify_splines/reference_cubic.hpp"
#include "tests/certify_splines/reference_isosurface.hpp"
#include "tests/certify_splines/reference_rays.hpp"
#include "tests/support/verdicts.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

double distance_like(double x, double y, double z) {
  return (x - 1.4) * (x - 1.4) + (y - 1.6) * (y - 1.6) + (z - 1.5) * (z - 1.5) - 1;
}
SplineRaysCertificate some_rays(double scale = 1) {
  auto volume = sampled_volume({5, 5, 5}, 0.3 * scale, [&](double x, double y, double z) {
    return scale * distance_like(x, y, z);
  });
  return reference_rays(volume, {{-1, 1.5, 1.25, 1, 0, 0.0625},
                                 {1.5, 1.5, 1.5, 0, 1, 0},
                                 {0.5, 0.5, -3, 1, 1, 4},
                                 {9, 9, 9, 1, 0, 0}});
}
SplineIsosurfaceCertificate some_surface(double scale = 1) {
  return *reference_isosurface(
      sampled_volume({5, 5, 5}, 0.3 * scale,
                     [&](double x, double y, double z) { return scale * distance_like(x, y, z); }));
}

std::vector<Bytes> all_kinds() {
  Random random(kSeed);
  return {encode(some_rays()), encode(some_surface()),
          encode(random_cubic({1, 1, 1}, false, random)),
          encode(random_cubic({1, 1, 1}, true, random))};
}

}  // namespace

TEST_CASE("splines: samples at the ends of doubles climb to rationals and change nothing") {
  const auto rays = some_rays();
  require_accepted(rays);
  const auto surface = some_surface();
  for (const int power : {-1022, -1000, -500, 500, 1000, 1018}) {
    const double scale = std::ldexp(1.0, power);
    auto other = rays;
    auto mesh = surface;
    for (SplineVolume* volume : {&other.volume, &mesh.volume}) {
      volume->level *= scale;
      for (std::size_t i = 0; i < volume->samples.size(); i += 8) {
        double x;
        std::memcpy(&x, volume->samples.data() + i, 8);
        x = x * scale + 0.0;
        std::memcpy(volume->samples.data() + i, &x, 8);
      }
    }
    INFO(power);
    // Below the normal numbers products round, so the function is another one: made anew.
    if (power < -1000) {
      const auto anew = reference_rays(other.volume, other.rays);
      require_accepted(anew);
      continue;
    }
    require_accepted(other);
    require_accepted(mesh);
    other.meets[3] = 1;
    other.hits.push_back({0, 0, 0, 1});
    CHECK_FALSE(verify(encode(other)).accepted);
  }
}

TEST_CASE("splines: frames and rays at the ends of doubles") {
  const auto rays = some_rays();
  for (const int power : {-900, -300, 300, 900}) {
    const double scale = std::ldexp(1.0, power);
    auto other = rays;
    for (double& h : other.volume.spacing) h *= scale;
    for (auto& ray : other.rays)
      for (double& x : ray) x *= scale;
    INFO(power);
    require_accepted(other);
    // Directions that shrink: parameters grow.
    if (power != 300 && power != -300) continue;
    for (auto& ray : other.rays)
      for (std::size_t d = 3; d < 6; ++d) ray[d] /= scale;
    for (SplineHit& hit : other.hits) {
      hit.low *= scale;
      hit.high *= scale;
    }
    require_accepted(other);
  }
  auto none = rays;
  none.rays[1] = {1, 1, 1, 0, 0, 0};
  CHECK(verify(encode(none)).reason == "ray 1 has no direction");
  // A zero whose parameter is beyond all doubles.
  const SplineRaysCertificate slow{rays.volume, {{1.5, 1.5, 1.5, 0, 5e-324, 0}}, {0}, {}};
  CHECK(verify(encode(slow)).reason == "ray 0 has a zero");
}

TEST_CASE("splines: infinite numbers, NaN and -0 are malformed wherever they are") {
  for (const Bytes& bytes : all_kinds()) {
    const std::size_t data = open_container(bytes).data.size();
    std::size_t malformed = 0, tried = 0;
    for (std::size_t at = kHeaderSize; at + 8 <= kHeaderSize + data; ++at)
      for (const double x : {HUGE_VAL, -HUGE_VAL, std::nan(""), -0.0}) {
        // Few of many.
        if (at % 29 != 0) continue;
        Bytes mutant = bytes;
        std::memcpy(mutant.data() + at, &x, 8);
        if (mutant == bytes) continue;
        rebind(mutant);
        const Verdict verdict = verify(mutant);
        ++tried;
        malformed += verdict.reason.starts_with("malformed: ");
      }
    CHECK(tried > 20);
    CHECK(malformed > 0);
  }
}

TEST_CASE("splines: words of the claim that are no counts") {
  for (const Bytes& bytes : all_kinds()) {
    const std::size_t first = kHeaderSize + open_container(bytes).data.size();
    const std::size_t step = std::max<std::size_t>(1, (bytes.size() - first) / 50);
    for (std::size_t at = first; at + 4 + kSealSize <= bytes.size(); at += step)
      for (const std::uint32_t word : {0U, 1U, 0x80000000U, 0xffffffffU}) {
        Bytes mutant = bytes;
        std::memcpy(mutant.data() + at, &word, 4);
        if (mutant == bytes) continue;
        rebind(mutant);
        // Whatever is accepted here makes a bracket or a bound wider; the tests of mutants ask.
        CHECK_NOTHROW(verify(mutant));
      }
    // Counts of the data section: no memory is asked for before they are compared with the bytes.
    for (std::size_t at = kHeaderSize; at < kHeaderSize + 128; at += 2) {
      Bytes mutant = bytes;
      const std::uint32_t word = 0x07ffffffU;
      std::memcpy(mutant.data() + at, &word, 4);
      rebind(mutant);
      CHECK_NOTHROW(verify(mutant));
    }
  }
}
