// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 6: the cases in which an earlier form of the theorem was false, each with its numbers.
#include <catch2/catch.hpp>
#include <cmath>

#include "certify/container/reject.hpp"
#include "certify/modes/encode.hpp"
#include "certify/modes/faces.hpp"
#include "certify/verify.hpp"
#include "tests/certify_modes/modes_samples.hpp"
#include "tests/support/verdicts.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

bool accepted(const ModesCertificate& c) {
  return verify(encode(c)).accepted;
}

ModesInput input_of(const std::array<Traceless, 4>& corners) {
  ModesInput input;
  input.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  input.tets = {{0, 1, 2, 3}};
  for (const auto& t : corners) input.tensors.push_back(tensor(t));
  return input;
}

ModesInput turned(ModesInput input) {
  for (auto& t : input.tensors)
    for (double& x : t) x = x == 0 ? 0 : -x;
  return input;
}

/// T0 = 0 at `zero`: x Tx + y Ty + z Tz of a reference field, moved.
ModesInput with_zero(std::uint32_t n, const std::array<double, 3>& zero, std::size_t field = 2) {
  LinearField f = kReferenceFields[field];
  f[0] = {};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 5; ++i) f[0][i] -= zero[k] * f[k + 1][i];
  return grid(n, -1, 1, f);
}

using Component = SurfaceComponent;

}  // namespace

TEST_CASE("modes: a lone vertex exactly at the level is a small sphere, for T and -T alike") {
  // Mode 143/343 at the centre, lower around it: f = 0 counts as f > 0.
  ModesInput input = grid(2, -1, 1, LinearField{});
  for (auto& t : input.tensors) t = tensor({-12, 13, 0, 0, 0});
  input.tensors[13] = tensor({-11, 13, 0, 0, 0});
  const auto c = reference_modes(input, {{143, 343}});
  require_accepted(c);
  CHECK(c.levels[0].positive.components == std::vector<Component>{{2, 0}});
  CHECK(c.levels[0].negative.components.empty());
  const auto d = reference_modes(turned(input), {{143, 343}});
  require_accepted(d);
  CHECK(d.levels[0].positive.components.empty());
  CHECK(d.levels[0].negative.components == std::vector<Component>{{2, 0}});
  SECTION("and no one may reject the cells around it") {
    auto wrong = c;
    auto& level = wrong.levels[0];
    level = {143, 343, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, 0};
    CHECK_FALSE(accepted(wrong));
  }
}

TEST_CASE("modes: a derivative that is only not negative is no witness") {
  // det < 0 but at the midpoint of edge 01, where D_w = 0, too, for w along the edge.
  const ModesInput input =
      input_of({{{1, -1, 0, 0, -1}, {1, -1, 0, 0, 1}, {1, -3, 0, 0, 0}, {1, -3, 1, 0, 0}}});
  const auto c = reference_modes(input, {{0, 1}});
  require_accepted(c);
  CHECK(c.levels[0].positive.components == std::vector<Component>{{1, 1}});
  // The certificate that the weak rule would have allowed: no piece.
  modes::Field field(input.tensors);
  const ModeLevel neutral;
  const modes::LevelContext context(neutral, field, {});
  modes::Worker worker(field);
  for (const double lambda : {-4.0, -1.0, 0.0, 1.0, 4.0})
    for (const int sign : {-1, 1}) {
      const modes::Witnessed<4> stated{{0, 1, 2, 3}, {sign, -sign, 0, 0}, lambda};
      CHECK_THROWS_AS(modes::check_witnesses(context, {&stated, 1}, worker), Reject);
    }
}

TEST_CASE("modes: an edge that the level touches has two roots from below, none from above") {
  // det = t^2 and det = -t^2 along the edge from -1 to 1.
  for (const bool below : {false, true}) {
    const Traceless a = below ? Traceless{1, -1, 0, 0, -1} : Traceless{1, -1, 0, -1, 0};
    const Traceless b = below ? Traceless{1, -1, 0, 0, 1} : Traceless{1, -1, 0, 1, 0};
    const ModesInput input = input_of({{a, b, {1, -3, 0, 0, 0}, {2, -3, 1, 0, 0}}});
    // Not split: the edge comes first.
    const auto c = reference_modes(input, {{0, 1}}, 0);
    require_accepted(c);
    CHECK(c.levels[0].codes[0] == (below ? 66 : 64));
    const auto d = reference_modes(input, {{0, 1}});
    require_accepted(d);
    const auto& roots = d.levels[0].roots;
    if (!below) continue;
    for (std::size_t drop = 0; drop < roots.size(); ++drop) {
      auto wrong = d;
      wrong.levels[0].roots.erase(wrong.levels[0].roots.begin() +
                                  static_cast<std::ptrdiff_t>(drop));
      for (auto& code : wrong.levels[0].codes)
        if (code > 64 && code <= 70) {
          --code;
          break;
        }
      CHECK_FALSE(accepted(wrong));
    }
  }
}

TEST_CASE("modes: two sheets that touch in a face are open, whatever the depth") {
  ModesInput input =
      input_of({{{1, -1, 0, 2, 1}, {1, -1, 0, -1, 1}, {1, -1, 0, -1, -2}, {-1, -1, 0, 0, 0}}});
  input.points.push_back({1, 1, 1});
  input.tensors.push_back(tensor({-1, -1, 0, 0, 0}));
  input.tets.push_back({0, 1, 2, 4});
  for (const unsigned depth : {4U, 8U}) {
    const auto c = reference_modes(input, {{0, 1}}, depth);
    require_accepted(c);
    CHECK(c.levels[0].open_tets > 0);
    CHECK(c.levels[0].positive.touched > 0);
    CHECK(c.levels[0].positive.components.empty());
  }
}

TEST_CASE("modes: where the tensor is zero the surface is a cone, one apex a curve around it") {
  // At a vertex: the link is the level's curves on a sphere around it.
  const auto c = reference_modes(with_zero(2, {0, 0, 0}), {{0, 1}, {1, 2}});
  require_accepted(c);
  for (const auto& level : c.levels)
    for (const auto* counts : {&level.positive, &level.negative})
      for (const Component& disk : counts->components) CHECK(disk == Component{1, 1});
  CHECK(!c.levels[0].positive.components.empty());
}

TEST_CASE("modes: a zero inside a simplex is inserted, and gives what a finer mesh gives") {
  const std::vector<Component> disks =
      reference_modes(with_zero(2, {0, 0, 0}), {{0, 1}}).levels[0].positive.components;
  struct Case {
    std::array<double, 3> place;
    std::vector<std::uint32_t> corners;
  };
  // Of the cube [-1, 1]^3 in six: on the diagonal, on a diagonal face, inside the first.
  for (const Case& one : {Case{{0, 0, 0}, {0, 7}}, Case{{0.5, 0, 0}, {0, 1, 7}},
                          Case{{0.5, 0, -0.5}, {0, 1, 3, 7}}}) {
    const ModesInput input = with_zero(1, one.place);
    CHECK_THROWS(reference_modes(input, {{0, 1}}, 30, {{{0, 1}}}));
    const auto c = reference_modes(input, {{0, 1}}, 30, {{one.corners}});
    require_accepted(c);
    CHECK(c.levels[0].open_tets == 0);
    CHECK(c.levels[0].positive.components == disks);
    auto wrong = c;
    wrong.zeros.clear();
    CHECK_FALSE(accepted(wrong));
  }
}

TEST_CASE("modes: a region of zeros ends the surface at its edges") {
  ModesInput input = grid(3, -2, 2, kReferenceFields[2]);
  for (std::size_t v = 0; v < input.points.size(); ++v)
    if (input.points[v][0] < 0) input.tensors[v] = {};
  const auto c = reference_modes(input, {{0, 1}, {3, 5}});
  require_accepted(c);
  for (const auto& level : c.levels) {
    CHECK(level.open_tets == 0);
    CHECK(!level.positive.components.empty());
    for (const Component& part : level.positive.components) CHECK(part.boundary_loops > 0);
  }
}

TEST_CASE("modes: uniform mode, constant tensors and planes of zero determinant") {
  ModesInput input = grid(2, -1, 1, LinearField{});
  for (auto& t : input.tensors) t = tensor({-11, 13, 0, 0, 0});
  // f = 0 everywhere counts as above: nothing.
  const auto c = reference_modes(input, {{143, 343}, {0, 1}, {1, 2}});
  require_accepted(c);
  for (const auto& level : c.levels) CHECK(level.positive.components.empty());
  // det = 0 everywhere, with T not zero: above, too.
  for (std::size_t v = 0; v < input.points.size(); ++v) {
    const auto& p = input.points[v];
    input.tensors[v] = {0, 0, 0, 0, 3 + p[0], 2 - p[1]};
  }
  const auto d = reference_modes(input, {{0, 1}});
  require_accepted(d);
  CHECK(d.levels[0].positive.components.empty());
}
