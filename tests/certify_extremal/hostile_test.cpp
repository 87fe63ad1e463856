// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 8: damaged and hostile bytes get an answer, quickly.
#include <chrono>
#include <cstring>
#include <limits>
#include <utility>

#include "certify/container/compose.hpp"
#include "certify/container/container.hpp"
#include "tests/certify_extremal/extremal_samples.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

const ExtremalCertificate& small() {
  static const auto c = reference_extremal(with_level(sampled({8, 7, 1}, sphere(0.6, 0.5)), 0.4));
  return c;
}
const ExtremalCertificate& small_volume() {
  static const auto c = reference_extremal(with_level(sampled({7, 7, 7}, sphere(0.6, 0.5)), 0.4));
  return c;
}
/// The claim section as version 2 had it: whole directions, codes alone.
Bytes as_version_2(const ExtremalCertificate& c, std::uint32_t version) {
  const Bytes now = encode(c);
  const auto container = open_container(now);
  // What follows the leaves is as it was.
  const std::size_t d = c.data.dimension, offsets = 2 * (d - 1);
  const std::size_t head = 4 + 8 * c.cells.size(),
                    since = head + 4 + c.codes.size() +
                            offsets * (c.directions.size() + c.gradients.size()) + 4 +
                            4 * c.edges.size() + 4 + c.trees.size() + offsets * c.leaves.size();
  const auto rows = [&](ByteWriter& out, const std::vector<ExtremalDirection>& list) {
    for (const auto& row : list)
      for (std::size_t k = 0; k < d; ++k) out.integer(row[k]);
  };
  return compose(
      {kExtremal, version}, container.data.size(),
      [&](ByteWriter& out) { out.bytes(container.data); },
      [&](ByteWriter& out) {
        out.bytes(container.claims.first(head));
        out.count(c.codes.size());
        out.bytes(c.codes);
        rows(out, c.directions);
        rows(out, c.gradients);
        out.count(c.edges.size());
        out.numbers(c.edges);
        out.count(c.trees.size());
        out.bytes(c.trees);
        rows(out, c.leaves);
        out.bytes(container.claims.subspan(since));
      });
}
/// Rejected for that reason.
void require_rejected(const Bytes& bytes, const std::string& reason) {
  const Verdict verdict = verify(bytes);
  CAPTURE(verdict.reason, reason);
  CHECK_FALSE(verdict.accepted);
  CHECK(verdict.reason.find(reason) != std::string::npos);
}
void require_rejected(const ExtremalCertificate& c, const std::string& reason) {
  require_rejected(encode(c), reason);
}

}  // namespace

TEST_CASE("extremal: sections that end anywhere are refused") {
  const Bytes bytes = encode(small());
  const auto container = open_container(bytes);
  const std::size_t data = container.data.size(), claims = container.claims.size();
  for (std::size_t length = 0; length < claims; ++length) {
    Bytes cut(bytes.begin(), bytes.begin() + static_cast<long>(kHeaderSize + data + length));
    cut.resize(cut.size() + kSealSize);
    for (std::size_t i = 0; i < 8; ++i)
      cut[kLengthsOffset + 8 + i] = static_cast<std::uint8_t>(length >> (8 * i));
    rebind(cut);
    REQUIRE_FALSE(verify(cut).accepted);
  }
}

TEST_CASE("extremal: data sections that end anywhere are refused") {
  for (const ExtremalCertificate* c : {&small(), &small_volume()}) {
    const Bytes bytes = encode(*c);
    const auto container = open_container(bytes);
    for (std::size_t length = 0; length < container.data.size(); ++length) {
      Bytes cut = compose(
          {kExtremal, kExtremalVersion}, length,
          [&](ByteWriter& out) { out.bytes(container.data.first(length)); },
          [&](ByteWriter& out) { out.bytes(container.claims); });
      REQUIRE_FALSE(verify(cut).accepted);
    }
  }
}

TEST_CASE("extremal: versions are not taken for one another") {
  for (const ExtremalCertificate* c : {&small(), &small_volume()}) {
    const Bytes bytes = encode(*c);
    REQUIRE(verify(bytes).accepted);
    REQUIRE(open_container(bytes).version == kExtremalVersion);
    for (const std::uint32_t version : {0U, 1U, 2U, 4U, 256U + 3U, 65536U + 3U, ~0U}) {
      Bytes other = bytes;
      for (std::size_t i = 0; i < 4; ++i)
        other[kMagic.size() + i] = static_cast<std::uint8_t>(version >> (8 * i));
      rebind(other);
      require_rejected(other, "version " + std::to_string(version) + " of extremal is not known");
      require_rejected(as_version_2(*c, version), "is not known");
    }
    CHECK_FALSE(verify(as_version_2(*c, kExtremalVersion)).accepted);
  }
}

TEST_CASE("extremal: numbers that are none are refused") {
  const float odd[] = {std::numeric_limits<float>::infinity(),
                       std::numeric_limits<float>::quiet_NaN(), -0.0F};
  for (const float x : odd) {
    auto c = small();
    std::memcpy(c.data.samples.data() + 20, &x, 4);
    require_rejected(c, "infinite, NaN or -0");
  }
  for (const double x : {HUGE_VAL, std::nan("")}) {
    for (int which = 0; which < 7; ++which) {
      auto c = small();
      auto& data = c.data;
      double* const places[] = {
          &data.spacing[0],   &data.min_value,     &data.min_strength,        &data.sigma,
          &data.tensor_sigma, &data.weights[1][0], &data.tensor_weights[0][1]};
      *places[which] = x;
      CHECK_FALSE(is_accepted(c));
    }
  }
  auto c = small();
  c.data.spacing[1] = 1e-300;
  require_rejected(c, "spacing");
  c = small();
  c.data.sigma = -1;
  require_rejected(c, "negative");
  c = small();
  c.data.weights[0][0] = -1;
  require_rejected(c, "weights");
}

TEST_CASE("extremal: integers that no double holds are refused") {
  for (const int type : {6, 7})  // signed, unsigned
    for (const std::int64_t beyond : {(std::int64_t{1} << 53) + 1, -(std::int64_t{1} << 53) - 1}) {
      auto c = small();
      c.data.type = static_cast<std::uint8_t>(type);
      c.data.samples.assign(c.data.samples.size() * 2, 0);
      std::memcpy(c.data.samples.data() + 40, &beyond, 8);
      require_rejected(c, "an integer is larger than 2^53");
    }
}

TEST_CASE("extremal: numbers of any size are held or refused, never believed") {
  // Largest and least floats: coefficients overflow, or T vanishes.
  for (const double size : {3e38, 1e25, 1e-25, 1e-45}) {
    auto data = small().data;
    for (std::size_t i = 0; i + 4 <= data.samples.size(); i += 4) {
      float x;
      std::memcpy(&x, data.samples.data() + i, 4);
      x = static_cast<float>(static_cast<double>(x) * size);
      std::memcpy(data.samples.data() + i, &x, 4);
    }
    auto c = small();
    c.data = data;
    c.data.min_value *= size;
    CHECK_FALSE(verify(encode(c)).reason == "");
  }
}

TEST_CASE("extremal: lists longer than their bytes, runs beyond the grid") {
  auto c = small();
  c.cells[0].length = ~0U;
  require_rejected(c, "cells: ");
  c = small();
  c.cells.assign(3, {~0U, 1});
  c.codes.assign(3, 0);
  c.directions.clear();
  c.gradients.clear();
  require_rejected(c, "leaves the grid");
  c = small();
  c.cells = {{6, 2}};
  c.codes = {0, 0};
  c.directions.clear();
  c.gradients.clear();
  require_rejected(c, "leaves its row");
  c = small();
  c.edges = {~0U};
  require_rejected(c, "is none");
  c = small();
  c.directions[0] = {0, 0, 0};
  CHECK_THROWS(encode(c));
  c = small();
  c.directions.pop_back();
  CHECK_THROWS(encode(c));
  c = small();
  c.data.nodes = {1U << 16U, 1U << 16U, 1};
  CHECK_THROWS(encode(c));

  // Every word of the claim section as a count.
  const Bytes bytes = encode(small());
  const auto data = open_container(bytes).data.size();
  for (std::size_t at = kHeaderSize + data; at + 4 + kSealSize < bytes.size(); ++at)
    for (const std::uint32_t word : {~0U, 0x7fffffffU, 0x10000U}) {
      Bytes mutant = bytes;
      std::memcpy(mutant.data() + at, &word, 4);
      rebind(mutant);
      (void)verify(mutant);  // any answer but a crash
    }
}

TEST_CASE("extremal: bytes of cells and trees that nothing writes are refused") {
  for (const auto& c :
       {small(), reference_extremal(with_level(sampled({8, 8, 8}, sphere(0.6, 0.5)), 0.4)),
        reference_extremal(small().data, {true})}) {
    const Bytes bytes = encode(c);
    const unsigned d = c.data.dimension;
    // Runs, then the cells' bytes; w and a; edges, then the trees' bytes.
    const std::size_t cells =
        open_container(bytes).data.size() + kHeaderSize + 4 + 8 * c.cells.size() + 4;
    const std::size_t trees = cells + c.codes.size() +
                              2 * (d - 1) * (c.directions.size() + c.gradients.size()) + 4 +
                              4 * c.edges.size() + 4;
    const auto refused = [&](std::size_t at, unsigned byte, const char* why) {
      Bytes mutant = bytes;
      mutant[at] = static_cast<std::uint8_t>(byte);
      rebind(mutant);
      require_rejected(mutant, why);
    };
    std::array<bool, 5> seen{};
    for (std::size_t i = 0; i < c.codes.size(); ++i) {
      if (std::exchange(seen.at(c.codes[i]), true)) continue;
      const unsigned byte = bytes[cells + i];
      const bool open = c.codes[i] == 0, regular = c.codes[i] >= 3;
      CHECK((byte & 7) == c.codes[i]);
      for (const unsigned none : {5U, 6U, 7U})
        refused(cells + i, (byte & ~7U) | none, "no such code of a cell");
      for (unsigned axis = open ? 1 : d; axis < 4; ++axis)
        refused(cells + i, (byte & ~(3U << 3)) | axis << 3, "no such code of a cell");
      for (unsigned axis = regular ? d : 1; axis < 4; ++axis)
        refused(cells + i, (byte & ~(3U << 5)) | axis << 5, "no such code of a cell");
      if (!regular) refused(cells + i, byte | 128, "no such code of a cell");
    }
    if (c.trees.empty()) continue;
    for (const unsigned none : {d, 4U, 255U})
      if (none != 3) refused(trees, none, "no such code of a node");
  }
}

TEST_CASE("extremal: deep trees are refused, and cost what they weigh") {
  auto c = reference_extremal(with_level(sampled({8, 7, 1}, sphere(0.6, 0.5)), 0.4), {true});
  require_accepted(c);
  // The first edge's leaf, split 15 times at its low end.
  auto deep = c;
  std::size_t first = 0;
  while (deep.trees[first] != 0) ++first;
  std::vector<std::uint8_t> chain(15, 1);
  chain.insert(chain.end(), 16, 0);
  deep.trees.erase(deep.trees.begin() + static_cast<long>(first));
  deep.trees.insert(deep.trees.begin() + static_cast<long>(first), chain.begin(), chain.end());
  deep.leaves.insert(deep.leaves.begin(), 15, deep.leaves[0]);
  require_rejected(deep, "too deep");

  // All edges split to 64 leaves.
  auto wide = c;
  wide.trees.clear();
  wide.leaves.clear();
  std::size_t leaf = 0;
  bool plain = true;
  for (std::size_t i = 0; i < c.trees.size(); ++i) plain = plain && c.trees[i] == 0;
  REQUIRE(plain);
  for (std::size_t i = 0; i < c.edges.size(); ++i, ++leaf) {
    const std::function<void(int)> split = [&](int depth) {
      wide.trees.push_back(depth < 6 ? 1 : 0);
      if (depth == 6) return wide.leaves.push_back(c.leaves[leaf]);
      split(depth + 1);
      split(depth + 1);
    };
    split(0);
  }
  const auto start = std::chrono::steady_clock::now();
  CHECK(is_accepted(wide));
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  CHECK(time.count() < 5e-5 * static_cast<double>(wide.trees.size()) + 1);
}

TEST_CASE("extremal: wide smoothing costs what it must") {
  std::vector<float> samples(24 * 24, 0);
  samples[100] = 1;
  const auto data = make_data({24, 24, 1}, samples, {1, 1, 1}, 341);
  CHECK(data.weights[0].size() == 1024);
  require_accepted(reference_extremal(with_level(data, 1)));
  const auto wider = make_data({24, 24, 1}, samples, {1, 1, 1}, 400);
  ExtremalCertificate c;
  c.data = with_level(wider, 1);
  require_rejected(c, "1025 weights");
}

TEST_CASE("extremal: cells that are not listed are compared exactly, whatever the exponents") {
  // L is (3 + 4 3 + tiny) / 6 at the border: below the level by far less than doubles see. The
  // first fits into whole numbers, the last does not.
  for (const float tiny : {0x1p-40F, 0x1p-60F, 0x1p-120F})
    for (const float sign : {-1.0F, 0.0F, 1.0F}) {
      std::vector<float> samples;
      for (int i = 0; i < 64; ++i) samples.push_back(i % 2 == 0 ? 3 : sign == 0 ? 0 : sign * tiny);
      ExtremalCertificate c;
      c.data = with_level(make_data({8, 8, 1}, samples, {1, 1, 1}, 0), 2.5);
      INFO(sign * tiny);
      if (sign < 0)
        require_accepted(c);
      else
        require_rejected(c, "it is not listed, but L may reach the least value");
      c.data.min_value = std::nextafter(2.5, 3.0);
      CHECK(is_accepted(c) == (sign <= 0 || tiny < 0x1p-50F));
    }
}

TEST_CASE("extremal: cells of a volume that are not listed are compared exactly, all of them") {
  // In every cell's reach a sample is above the level and one is -1: no double decides, exponents
  // are 126 bits apart, and seven of eight cells have controls that the -1 does not touch.
  constexpr float kLevel = 0x1p-100F;
  constexpr std::uint32_t n = 13;
  for (const float high : {1.25F, 2.0F, 2.5F}) {
    std::vector<float> samples;
    for (std::uint32_t z = 1; z <= n; ++z)
      for (std::uint32_t y = 1; y <= n; ++y)
        for (std::uint32_t x = 1; x <= n; ++x) {
          const std::uint32_t all = x | y | z;
          samples.push_back(all % 4 == 0 ? -1 : kLevel * (all % 2 == 0 ? high : 0.5F));
        }
    ExtremalCertificate c;
    c.data = with_level(make_data({n, n, n}, samples, {1, 1, 1}, 0), kLevel);
    INFO(high);
    // At the nodes with high samples, its maxima, L is (8 high + 19 / 2) / 27 times the level.
    CHECK(is_accepted(c) == (high < 2.18F));
  }
}
