// SPDX-License-Identifier: GPL-3.0-or-later
// Claims 11 and 13: every edited byte is rejected unless the claim is true of its own data.
#include <catch2/catch.hpp>
#include <functional>
#include <iostream>

#include "certify/container/container.hpp"
#include "certify/spline_isosurface/decode.hpp"
#include "certify/spline_isosurface/encode.hpp"
#include "certify/spline_rays/decode.hpp"
#include "certify/spline_rays/encode.hpp"
#include "certify/verify.hpp"
#include "tests/certify_splines/reference_isosurface.hpp"
#include "tests/certify_splines/reference_rays.hpp"
#include "tests/support/random.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

/// The reference's brackets have one zero in each, at one end or inside.
bool is_true(const SplineRaysCertificate& c) {
  const auto anew = reference_rays(c.volume, c.rays);
  if (anew.meets != c.meets) return false;
  for (std::size_t i = 0; i < c.hits.size(); ++i) {
    const SplineHit &stated = c.hits[i], &found = anew.hits[i];
    if (stated.cube != found.cube || stated.tetrahedron != found.tetrahedron ||
        stated.low > found.high || stated.high < found.low)
      return false;
  }
  return true;
}
bool is_true(const SplineIsosurfaceCertificate& c) {
  IsosurfaceOptions options;
  options.roots = c.bisected;
  options.trees = c.trees;
  options.depth = 20;
  const auto anew = reference_isosurface(c.volume, options);
  if (!anew || anew->trees != c.trees || anew->bisected != c.bisected ||
      anew->triangles != c.triangles || anew->brackets.size() != c.brackets.size() ||
      anew->euler_characteristic != c.euler_characteristic || anew->components != c.components ||
      anew->boundary_loops != c.boundary_loops)
    return false;
  for (std::size_t i = 0; i < c.brackets.size(); ++i)
    if (c.brackets[i][0] > anew->brackets[i][1] || c.brackets[i][1] < anew->brackets[i][0])
      return false;
  return true;
}

struct Tally {
  std::uint64_t mutants = 0, accepted = 0;

  template <class Certificate, class Decode>
  void edit_bytes(const Certificate& original, const Decode& decode, std::uint64_t times,
                  Random& random) {
    const Bytes bytes = encode(original);
    REQUIRE(verify(bytes).accepted);
    const std::size_t data = open_container(bytes).data.size();
    for (std::uint64_t i = 0; i < times; ++i) {
      Bytes mutant = bytes;
      // One in four in the data.
      const std::size_t first = i % 4 == 1 ? kHeaderSize : kHeaderSize + data;
      const std::size_t end = i % 4 == 1 ? kHeaderSize + data : mutant.size() - kSealSize;
      if (first == end) continue;
      const auto at = first + random() % (end - first);
      if (i % 16 == 0)
        mutant.resize(at);
      else if (i % 2 == 0)
        mutant[at] = static_cast<std::uint8_t>(random());
      else
        mutant[at] ^= static_cast<std::uint8_t>(1U << random() % 8);
      if (mutant == bytes) continue;
      CHECK_FALSE(verify(mutant).accepted);
      if (mutant.size() != bytes.size()) continue;
      rebind(mutant);
      judge<Certificate>(mutant, decode);
    }
  }
  template <class Certificate, class Decode>
  void judge(const Bytes& mutant, const Decode& decode) {
    ++mutants;
    if (!verify(mutant).accepted) return;
    ++accepted;
    const Container container = open_container(mutant);
    const Certificate read = decode(container.data, container.claims);
    CHECK(is_true(read));
  }
  void say(const char* what) const {
    std::cout << what << ": " << mutants << " mutants, " << accepted << " accepted\n";
    CHECK(mutants > 0);
    CHECK(accepted < mutants);
  }
};

SplineVolume random_volume(double level, Random& random, bool extended) {
  return sampled_volume(
      {4, 4, extended ? 2U : 4U}, level,
      [&](double, double, double) { return static_cast<double>(random() % 21) - 10; }, extended);
}

SplineRaysCertificate random_rays(std::uint64_t i, Random& random) {
  auto volume = random_volume(0.5, random, i % 2 == 1);
  if (i % 3 == 0) volume.direction = {0, 1, 0, 1, 0, 0.25, 0, 0, 2};
  std::vector<std::array<double, 6>> rays;
  for (int k = 0; k < 12; ++k) {
    std::array<double, 6> ray{};
    for (std::size_t d = 0; d < 3; ++d) {
      ray[d] = static_cast<double>(random() % 13) - 4;
      ray[3 + d] = (1.5 - ray[d] + static_cast<double>(random() % 5) / 4) / (k % 2 + 1);
    }
    rays.push_back(ray);
  }
  return reference_rays(volume, rays);
}

}  // namespace

TEST_CASE("splines: edited bytes of rays' certificates are rejected unless true") {
  Random random(kSeed);
  Tally tally;
  for (std::uint64_t i = 0; i < 4; ++i)
    tally.edit_bytes(random_rays(i, random), decode_spline_rays, scaled(70), random);
  tally.say("spline-rays, bytes");
}

TEST_CASE("splines: edited hits are rejected unless true") {
  Random random(kSeed);
  Tally tally;
  using Edit = std::function<void(SplineRaysCertificate&)>;
  const auto hit = [&](SplineRaysCertificate& c) -> SplineHit& {
    return c.hits[random() % c.hits.size()];
  };
  const std::vector<Edit> edits = {
      [&](auto& c) { hit(c).cube ^= 1U << random() % 4; },
      [&](auto& c) { hit(c).tetrahedron = static_cast<std::uint8_t>(random() % 26); },
      [&](auto& c) {
        auto& h = hit(c);
        h.low = h.high;
      },
      [&](auto& c) {
        auto& h = hit(c);
        h.high = h.low;
      },
      [&](auto& c) {
        auto& h = hit(c);
        h.low = h.low / 2;
        h.high = h.high / 2;
      },
      [&](auto& c) { hit(c).low = 0; },
      [&](auto& c) { hit(c).high *= 2; },
      [&](auto& c) {
        auto& h = hit(c);
        h.low = h.high * 1.5;
        h.high = h.high * 3;
      },
      [&](auto& c) {
        const std::size_t at = random() % c.rays.size();
        const auto before = static_cast<long>(
            std::count(c.meets.begin(), c.meets.begin() + static_cast<long>(at), 1));
        if (c.meets[at] != 0)
          c.hits.erase(c.hits.begin() + before);
        else
          c.hits.insert(c.hits.begin() + before, SplineHit{0, 0, 0, 10});
        c.meets[at] ^= 1;
      },
      [&](auto& c) { std::swap(c.rays[random() % c.rays.size()], c.rays[0]); },
      [&](auto& c) { c.rays[random() % c.rays.size()][random() % 6] += 0.125; },
      [&](auto& c) { c.volume.level += random() % 2 == 0 ? 0.01 : -3; },
      [&](auto& c) { c.volume.spacing[random() % 3] *= 1.01; },
      [&](auto& c) { c.rays[0] = {1, 1, 1, 0, 0, 0}; },
  };
  for (std::uint64_t i = 0; i < 4; ++i) {
    const auto original = random_rays(i, random);
    REQUIRE(original.hits.size() > 1);
    for (const Edit& edit : edits)
      for (std::uint64_t k = 0; k < scaled(6); ++k) {
        SplineRaysCertificate mutant = original;
        edit(mutant);
        tally.judge<SplineRaysCertificate>(encode(mutant), decode_spline_rays);
      }
  }
  tally.say("spline-rays, records");
}

TEST_CASE("splines: edited bytes of isosurfaces' certificates are rejected unless true") {
  Random random(kSeed);
  Tally tally;
  std::size_t made = 0;
  for (std::uint64_t i = 0; made < 3 && i < 20; ++i) {
    IsosurfaceOptions options;
    options.depth = 14;
    const auto volume = sampled_volume({3, 3, 3}, 0.5, [&](double, double, double) {
      return static_cast<double>(random() % 21) - 10;
    });
    const auto c = reference_isosurface(volume, options);
    if (!c || c->bisected.empty()) continue;
    ++made;
    tally.edit_bytes(*c, decode_spline_isosurface, scaled(60), random);
  }
  CHECK(made == 3);
  tally.say("spline-isosurface, bytes");
}
