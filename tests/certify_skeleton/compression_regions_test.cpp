// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 10: a region of the input that lies inside one side of the output. Both certificates were
// accepted before the sides inside a chain were compared.
#include <catch2/catch.hpp>

#include "certify/compression/encode.hpp"
#include "certify/verify.hpp"

using namespace crest::certify;
using u32 = std::uint32_t;

namespace {

/// A disc of triangles around the last point; the output is without the point `left_out`.
CompressionCertificate fans(const std::vector<std::array<double, 2>>& positions,
                            const std::vector<std::array<double, 2>>& vectors, u32 left_out) {
  CompressionCertificate c;
  c.input.positions = positions;
  c.input.vectors = vectors;
  const auto fan = [](SkeletonCertificate& s, u32 corners) {
    for (u32 i = 0; i < corners; ++i) s.triangles.push_back({corners, i, (i + 1) % corners});
  };
  for (u32 v = 0; v < positions.size(); ++v) {
    if (v == left_out) continue;
    c.vertices.push_back(v);
    c.output.positions.push_back(positions[v]);
    c.output.vectors.push_back(vectors[v]);
  }
  fan(c.input, static_cast<u32>(positions.size() - 1));
  fan(c.output, static_cast<u32>(positions.size() - 2));
  return c;
}

void reject_for_region(const CompressionCertificate& c) {
  const Verdict verdict = verify(encode(c));
  INFO(verdict.reason);
  CHECK_FALSE(verdict.accepted);
  CHECK(verdict.reason.find("another region inside it") != std::string::npos);
}

}  // namespace

TEST_CASE("compression: an outflow between slip walls does not become a wall") {
  auto c = fans(
      {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {4, 2}, {4, 4}, {2, 4}, {0, 4}, {0, 2}, {2, 2}},
      {{0, 0}, {1, 0}, {0, -1}, {1, 0}, {0, 0}, {0, 1}, {0, 0}, {-1, 0}, {0, 0}, {0, -1}, {1, .5}},
      2);
  const auto state = [](SkeletonCertificate& s, const std::vector<u32>& triangles) {
    for (const u32 t : triangles) {
      SkeletonZero zero;
      zero.triangle = t;
      zero.place = ZeroPlace::vertex;
      zero.kind = ZeroClass::higher_order;
      s.zeros.push_back(zero);
    }
    SkeletonLoop loop;
    loop.side = 1;
    loop.zero = 1;
    s.loops.push_back(loop);
  };
  state(c.input, {0, 3, 5, 7});
  state(c.output, {0, 2, 4, 6});
  c.zeros = {0, 1, 2, 3};
  reject_for_region(c);
}

TEST_CASE("compression: an outflow does not become a tangent run") {
  auto c = fans({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {4, 2}, {0, 2}, {2, 1}},
                {{1, .5}, {1, 0}, {1, -.2}, {1, 0}, {1, -1}, {1, -.5}, {1, -.5}, {1, -.2}}, 2);
  const auto state = [](SkeletonCertificate& s, u32 right) {
    SkeletonLoop loop;
    loop.side = 1;
    loop.turning = 1;
    loop.exterior = 2;
    loop.inflow = loop.outflow = 1;
    s.loops.push_back(loop);
    s.switches = {{1, 2, 0}, {right, 1, 0}};
  };
  state(c.input, 13);
  state(c.output, 10);
  reject_for_region(c);
}
