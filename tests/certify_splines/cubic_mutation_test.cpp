// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 12: every edited byte or record is rejected unless the claim is true of its own data.
#include <catch2/catch.hpp>
#include <functional>
#include <iostream>

#include "certify/container/container.hpp"
#include "certify/spline_cubic/decode.hpp"
#include "certify/spline_cubic/encode.hpp"
#include "certify/verify.hpp"
#include "tests/certify_splines/reference_cubic.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

bool is_true(const SplineCubicCertificate& c) {
  return c.jump >= least_jump(c.data) && c.error >= least_error(c.data);
}

struct Tally {
  std::uint64_t mutants = 0, accepted = 0;

  void judge(const Bytes& mutant) {
    ++mutants;
    if (!verify(mutant).accepted) return;
    ++accepted;
    const Container container = open_container(mutant);
    CHECK(is_true(decode_spline_cubic(container.data, container.claims)));
  }
  void say(const char* what) const {
    std::cout << "spline-cubic, " << what << ": " << mutants << " mutants, " << accepted
              << " accepted\n";
    CHECK(mutants > 0);
    CHECK(accepted < mutants);
  }
};

std::vector<SplineCubicCertificate> originals(Random& random) {
  auto some = random_cubic({2, 2, 1}, false, random);
  std::vector<SplineCubicCertificate> all = {random_cubic({1, 1, 1}, false, random),
                                             random_cubic({2, 1, 2}, false, random),
                                             random_cubic({2, 1, 1}, true, random), some};
  for (auto& c : all) c.data.samples.resize(6);
  return all;
}

}  // namespace

TEST_CASE("splines: edited bytes of cubic certificates are rejected unless true") {
  Random random(kSeed);
  Tally tally;
  for (const auto& original : originals(random)) {
    const Bytes bytes = encode(original);
    REQUIRE(verify(bytes).accepted);
    for (std::uint64_t i = 0; i < scaled(150); ++i) {
      Bytes mutant = bytes;
      const auto at = kHeaderSize + random() % (mutant.size() - kHeaderSize - kSealSize);
      if (i % 9 == 0)
        mutant.resize(at);
      else if (i % 9 < 4)
        mutant[at] = static_cast<std::uint8_t>(random());
      else
        mutant[at] ^= static_cast<std::uint8_t>(1U << random() % 8);
      if (mutant == bytes) continue;
      CHECK_FALSE(verify(mutant).accepted);
      if (mutant.size() != bytes.size()) continue;
      rebind(mutant);
      tally.judge(mutant);
    }
  }
  tally.say("bytes");
}

TEST_CASE("splines: edited numbers of cubic certificates are rejected unless true") {
  Random random(kSeed);
  Tally tally;
  using Edit = std::function<void(SplineCubicCertificate&)>;
  const auto step = [&](double& x, double unit) {
    x += unit * (random() % 2 == 0 ? 1 : -1) * static_cast<double>(1 + random() % 3);
  };
  const std::vector<Edit> edits = {
      [&](auto& c) {
        const std::size_t k = random() % 4;
        step(c.data.vertices[random() % c.data.vertices.size()][k],
             std::ldexp(k == 0 ? 1 : 2, c.data.integers ? c.data.exponent : -20));
      },
      [&](auto& c) {
        step(c.data.slopes[random() % c.data.slopes.size()][random() % 6],
             std::ldexp(1.0, c.data.integers ? c.data.exponent : -20));
      },
      [&](auto& c) {
        const std::size_t k = random() % 4;
        step(c.data.centres[random() % c.data.centres.size()][k],
             std::ldexp(k == 0 ? 1 : 2, c.data.integers ? c.data.exponent - 3 : -20));
      },
      [&](auto& c) { c.data.samples[random() % c.data.samples.size()][random() % 4] *= 1.0001; },
      [&](auto& c) { c.data.box[random() % 6] += random() % 2 == 0 ? 0.01 : -0.01; },
      [&](auto& c) { c.error *= random() % 2 == 0 ? 0.999 : 1.001; },
      [&](auto& c) { c.jump *= random() % 2 == 0 ? 0.999 : 1.001; },
      [&](auto& c) { c.jump = c.jump == 0 ? 1e-9 : 0; },
      [&](auto& c) { c.data.domain[0].length += random() % 2 == 0 ? 1 : ~0U; },
      [&](auto& c) { c.data.domain[0].first += 1; },
      [&](auto& c) { c.data.domain.push_back(c.data.domain[0]); },
      [&](auto& c) { c.data.integers = !c.data.integers; },
      [&](auto& c) { c.data.exponent += random() % 2 == 0 ? 1 : -1; },
      [&](auto& c) { c.data.outside ^= 1; },
  };
  for (const auto& original : originals(random))
    for (const Edit& edit : edits)
      for (std::uint64_t i = 0; i < scaled(8); ++i) {
        SplineCubicCertificate mutant = original;
        edit(mutant);
        try {
          tally.judge(encode(mutant));
        } catch (const std::invalid_argument&) {
          continue;  // no such bytes
        }
      }
  tally.say("numbers");
}
