// SPDX-License-Identifier: GPL-3.0-or-later
// Decimals of more than 53 bits, which a double would round before it is divided: no encoder writes
// them, and both decoders refuse them.
#include <bit>
#include <catch2/catch.hpp>

#include "algorithms/coding/positions.hpp"
#include "algorithms/coding/real_form.hpp"
#include "algorithms/coding/stream_error.hpp"
#include "algorithms/coding/triple_model.hpp"
#include "algorithms/coding/visit_order.hpp"
#include "certify/coding/stream.hpp"
#include "certify/container/reject.hpp"
#include "tests/coding/meshes.hpp"

namespace crest::tests {
namespace {

using coding::Form;
using coding::Triple;

const std::vector<kernel::Triangle> kTriangle = {{0, 1, 2}};

/// A section of exact places: x is these integers over 10, y and z are 0 as doubles, so that the
/// integers may have 64 bits.
coding::Bytes section_of(const std::vector<std::int64_t>& xs) {
  const coding::Surface surface(3, kTriangle);
  coding::RangeEncoder range;
  std::array<coding::RealForm, 3> forms = {{{Form::decimal, 1}, {Form::doubles}, {Form::doubles}}};
  for (coding::RealForm& form : forms) coding::code_form(range, form);
  std::vector<Triple> values;
  for (const std::int64_t x : xs) values.push_back({x, 0, 0});
  const auto code = [&](auto&& model) {
    model.code_hints();
    coding::VisitOrder order(surface);
    for (auto v = order.take(); v != kernel::kNone; v = order.take()) {
      model.code(v, coding::surroundings(
                        surface, [&](auto&& each) { surface.around(v, each); },
                        [&](coding::Index h) { return surface.from(h); },
                        [&](coding::Index w) { return order.known(w); }));
      order.visit(v);
    }
  };
  coding::with_model(range, std::span<Triple>(values), 3, true, {}, code);
  for (int axis = 0; axis < 3; ++axis) coding::SmallNumber().code(range, 0);
  return range.finish();
}

TEST_CASE("decimals: integers beyond 2^53 are refused by both decoders, 2^53 by neither") {
  constexpr std::int64_t most = std::int64_t{1} << 53;
  const coding::Surface surface(3, kTriangle);
  for (const std::int64_t x : {most, -most, std::int64_t{0}}) {
    const coding::Bytes section = section_of({1, x, 3});
    const auto points = coding::decode_exact(section, surface);
    CHECK(points[1][0] == static_cast<double>(x) / 10);
    const auto patterns = certify::decode_positions(section, {{0, 1, 2}}, 3, 1);
    for (std::size_t v = 0; v < 3; ++v)
      CHECK(patterns[v][0] == std::bit_cast<std::uint64_t>(points[v][0]));
  }
  for (const std::int64_t x : {most + 1, -most - 1, std::int64_t{1} << 62}) {
    const coding::Bytes section = section_of({1, x, 3});
    CHECK_THROWS_AS(coding::decode_exact(section, surface), coding::StreamError);
    CHECK_THROWS_AS(certify::decode_positions(section, {{0, 1, 2}}, 3, 1), certify::Reject);
  }
}

TEST_CASE("decimals: coordinates of more than 53 bits before the point come back") {
  const coding::Surface surface(3, kTriangle);
  const std::vector<coding::Point> points = {
      {9007199254740993.0, 1e300, -0.0}, {9007199254740996.0, 1.5e22, 0.1}, {1e16, -1e23, 1e-300}};
  CHECK(coding::decode_exact(coding::encode_exact(surface, points), surface) == points);
}

}  // namespace
}  // namespace crest::tests
