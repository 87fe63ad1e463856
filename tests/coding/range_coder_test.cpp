// SPDX-License-Identifier: GPL-3.0-or-later
// The entropy coder: what goes in comes out, at the cost that the probabilities say.
#include <openssl/evp.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "algorithms/coding/mixer.hpp"
#include "algorithms/coding/numbers.hpp"
#include "algorithms/coding/stream_error.hpp"
#include "tests/support/failures.hpp"
#include "tests/support/random.hpp"

namespace crest::tests {
namespace {

using namespace coding;

struct Decision {
  bool bit;
  Probability one;
};

std::vector<Decision> random_decisions(Random& random, std::size_t count) {
  std::vector<Decision> decisions;
  for (std::size_t i = 0; i < count; ++i) {
    const int bits = 1 + static_cast<int>(random() % 32);
    const std::uint64_t all = std::uint64_t{1} << bits;
    std::uint64_t units = 1 + random() % (all - 1);
    if (random() % 4 == 0) units = random() % 2 == 0 ? 1 : all - 1;
    decisions.push_back({random() % all < units || random() % 50 == 0, {units, bits}});
  }
  return decisions;
}

TEST_CASE("range coder: what goes in comes out, carries and dropped zeros included") {
  Random random(kSeed);
  Failures failures;
  for (std::uint64_t i = 0; i < 3000 * multiplier(); ++i) {
    const std::vector<Decision> decisions = random_decisions(random, random() % 300);
    RangeEncoder encoder;
    double bits = 0;
    for (const Decision& d : decisions) {
      encoder.code(d.bit, d.one);
      const double p = std::ldexp(static_cast<double>(d.one.units), -d.one.bits);
      bits -= std::log2(d.bit ? p : 1 - p);
    }
    const coding::Bytes bytes = encoder.finish();
    failures.expect(8.0 * static_cast<double>(bytes.size()) < bits * 1.001 + 16, "size", bits, bytes.size());
    RangeDecoder decoder(bytes);
    bool same = true;
    for (const Decision& d : decisions) same = decoder.code(false, d.one) == d.bit && same;
    CHECK_NOTHROW(decoder.finish());
    failures.expect(same, "decisions", decisions.size());
  }
  CHECK(failures.report() == "");
}

TEST_CASE("range decoder: a stream that ends too early is refused after four bytes") {
  RangeDecoder decoder(std::span<const std::uint8_t>{});
  int decisions = 0;
  CHECK_THROWS_AS([&] { for (;; ++decisions) decoder.code(false, {1, 1}); }(), StreamError);
  CHECK(decisions < 9);
  const coding::Bytes spare = {1, 2, 3, 4, 5};
  CHECK_THROWS_AS(RangeDecoder(spare).finish(), StreamError);
}

TEST_CASE("numbers: all sizes come back") {
  const std::vector<std::uint64_t> large = {0, 1, 2, 3, 255, 1u << 20, ~std::uint64_t{0}, std::uint64_t{1} << 63};
  const std::vector<std::uint32_t> small = {0, 1, 2, 6, 7, 1000, (1u << 30) - 2};
  RangeEncoder encoder;
  LargeNumber large_in;
  SmallNumber small_in;
  for (const auto x : large) large_in.code(encoder, x);
  for (const auto x : small) small_in.code(encoder, x);
  code_below(encoder, 6, 7);
  const coding::Bytes bytes = encoder.finish();
  RangeDecoder decoder(bytes);
  LargeNumber large_out;
  SmallNumber small_out;
  for (const auto x : large) CHECK(large_out.code(decoder, 0) == x);
  for (const auto x : small) CHECK(small_out.code(decoder, 0) == x);
  CHECK(code_below(decoder, 0, 7) == 6);
  CHECK_NOTHROW(decoder.finish());
}

TEST_CASE("tables: logistic, its inverse, counters' steps are these integers for ever") {
  CHECK(kLogistic.probability[kLogitLimit] == 32768);
  CHECK(kLogistic.logit[2047] <= 0);
  CHECK(kLogistic.logit[2048] >= 0);
  for (std::size_t i = 1; i < kLogistic.logit.size(); ++i) CHECK(kLogistic.logit[i - 1] <= kLogistic.logit[i]);
  for (std::size_t k = 0; k < kLogisticNodes.size(); ++k)
    CHECK(kLogisticNodes[k] == std::lround(65536 / (1 + std::exp(-static_cast<double>(k) / 4))));
  std::vector<std::uint8_t> bytes;
  const auto put = [&](std::uint64_t x) {
    for (int i = 0; i < 8; ++i) bytes.push_back(static_cast<std::uint8_t>(x >> (8 * i)));
  };
  for (const auto x : kLogistic.probability) put(x);
  for (const auto x : kLogistic.logit) put(static_cast<std::uint64_t>(std::int64_t{x}));
  for (const auto x : kCounter.step) put(x);
  for (const auto x : kCounter.confidence) put(static_cast<std::uint64_t>(std::int64_t{x}));
  std::array<std::uint8_t, 32> digest;
  REQUIRE(EVP_Digest(bytes.data(), bytes.size(), digest.data(), nullptr, EVP_sha256(), nullptr) == 1);
  std::string head;
  for (int i = 0; i < 8; ++i) head += "0123456789abcdef"[digest[static_cast<std::size_t>(i)] >> 4], head += "0123456789abcdef"[digest[static_cast<std::size_t>(i)] & 15];
  CHECK(head == "TABLE_DIGEST");
}

}  // namespace
}  // namespace crest::tests
