// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 6: refereed holes 1, 7, 8 and 10 of its specification, each a case of its own.
#include <catch2/catch.hpp>
#include <cmath>
#include <iostream>

#include "certify/container/reject.hpp"
#include "certify/modes/cells.hpp"
#include "certify/surface/union_find.hpp"
#include "tests/certify_modes/modes_judge.hpp"
#include "tests/certify_modes/modes_samples.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/random.hpp"
#include "tests/support/verdicts.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

/// The simplex conv (-2, -1, 0), (2, -1, 0), (0, 2, 0), (0, 0, 1), w = z, and the surface z = h.
class GraphInSimplex {
 public:
  explicit GraphInSimplex(double a) : a_(a) {}

  struct Found {
    modes::u32 above, below, loops;
    bool left_is_annulus;
  };
  Found count() const {
    // On the roof, which w leaves: above iff roof >= h; on the floor: not above iff 0 < h.
    const auto roof = regions([&](double x, double y) { return height(x, y) >= h(x, y); });
    const auto spots = regions([&](double x, double y) { return h(x, y) <= 0; });
    const auto below = regions([&](double x, double y) { return h(x, y) > 0; });
    // Each spot is away from the rim: one loop of the level around it.
    return {roof, below, roof + spots, h(-0.5, 0) <= 0};
  }

 private:
  static constexpr int kSteps = 400;
  double h(double x, double y) const {
    return 1.5 - 2.2 * std::exp(-((x - a_) * (x - a_) + y * y) / 0.06) -
           1.3 * std::exp(-((x + a_) * (x + a_) + y * y) / 0.06);
  }
  /// Of the roof; negative outside the base.
  static double height(double x, double y) {
    return std::min({1 + y, 1 - y / 2 - 3 * x / 4, 1 - y / 2 + 3 * x / 4});
  }
  template <class Inside>
  static modes::u32 regions(const Inside& inside) {
    std::vector<std::int32_t> number(kSteps * kSteps, -1);
    UnionFind classes(number.size());
    const auto at = [](int i, int k) { return static_cast<modes::u32>(i * kSteps + k); };
    std::vector<std::uint8_t> in(number.size(), 0);
    for (int i = 0; i < kSteps; ++i)
      for (int k = 0; k < kSteps; ++k) {
        const double x = -2 + 4.0 * i / kSteps, y = -1 + 3.0 * k / kSteps;
        if (height(x, y) < 0 || !inside(x, y)) continue;
        in[at(i, k)] = 1;
        if (i > 0 && in[at(i - 1, k)] != 0) classes.join(at(i, k), at(i - 1, k));
        if (k > 0 && in[at(i, k - 1)] != 0) classes.join(at(i, k), at(i, k - 1));
      }
    modes::u32 count = 0;
    for (modes::u32 i = 0; i < in.size(); ++i) count += in[i] != 0 && classes.find(i) == i;
    return count;
  }
  double a_;
};

}  // namespace

TEST_CASE("modes: hole 1, counts do not tell which of three loops bound an annulus") {
  const auto one = GraphInSimplex(-0.5).count(), other = GraphInSimplex(0.5).count();
  for (const auto& found : {one, other}) {
    CHECK(found.above == 2);
    CHECK(found.below == 1);
    CHECK(found.loops == 3);
    const auto pieces = modes::count_components(found.loops, found.above, found.below);
    CHECK(pieces == 2);
    CHECK_FALSE(modes::is_pairing_known(found.loops, pieces));
  }
  // Equal counts, other surfaces: any answer would be false for one of them.
  CHECK(one.left_is_annulus != other.left_is_annulus);
  // The three cases in which it is known.
  CHECK(modes::is_pairing_known(1, modes::count_components(1, 1, 1)));
  CHECK(modes::is_pairing_known(3, modes::count_components(3, 2, 2)));
  CHECK(modes::is_pairing_known(3, modes::count_components(3, 1, 1)));
}

namespace {

/// Two tetrahedra at a face on which all three angles are equal: a rule that is not the same from
/// both sides divides it in two ways.
ModesInput two_with_ties() {
  ModesInput input;
  input.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}};
  input.tets = {{0, 1, 2, 3}, {0, 1, 2, 4}};
  input.tensors = {{3, 1, -4, 2, 2, 2},
                   {1, -4, 3, 2, 2, 2},
                   {-4, 3, 1, 2, 2, 2},
                   {1, 0, -1, 2, 3, 2},
                   {0, -1, 1, 3, 2, 2}};
  return input;
}

}  // namespace

TEST_CASE("modes: hole 7, a facet that is no node of its face's tree") {
  const auto c = reference_modes(two_with_ties(), {{1, 2}});
  require_accepted(c);
  const auto& codes = c.levels[0].codes;
  REQUIRE(std::ranges::count_if(codes, [](auto code) { return code == 32; }) > 2);
  // Every code replaced by every other that its place may hold.
  Tally tally;
  std::size_t elsewhere = 0;
  for (std::size_t at = 0; at < codes.size(); ++at)
    for (const int code : {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 31, 32, 33, 64, 65, 66, 127}) {
      if (code == codes[at]) continue;
      auto mutant = c;
      mutant.levels[0].codes[at] = static_cast<std::uint8_t>(code);
      tally.judge("code", c, mutant);
      elsewhere += reason(mutant).find("split where its faces are not") != std::string::npos ||
                   reason(mutant).find("split where no edge is") != std::string::npos;
    }
  std::cout << "codes: " << tally.mutants << " mutants, " << tally.accepted << " accepted, "
            << elsewhere << " facets that are no nodes\n";
  CHECK(elsewhere > 0);
}

TEST_CASE("modes: hole 7, faces between the parts of a tetrahedron are faces like any other") {
  // One that is bisected: no face of the mesh is, in the tree of codes after the mesh's faces.
  const auto c = reference_modes(grid(1, -2, 2, kReferenceFields[3]), {{0, 1}});
  require_accepted(c);
  auto field = modes::Field(c.tensors);
  const auto domain = modes::build_domain(c, field);
  const auto trees = modes::read_trees(c.levels[0], domain, field);
  std::size_t inner = 0, tried = 0;
  const auto& level = c.levels[0];
  for (const auto& face : trees.faces) {
    const bool of_mesh =
        std::ranges::all_of(face.corners, [&](modes::u32 v) { return v < c.tensors.size(); });
    if (!face.leaf() || of_mesh || face.arcs == 0) continue;
    ++inner;
    for (modes::u32 i = face.arc; i < face.arc + face.arcs && tried < 20; ++i, ++tried) {
      auto dropped = c;
      dropped.levels[0].arcs.erase(dropped.levels[0].arcs.begin() + i);
      CHECK_FALSE(verify(encode(dropped)).accepted);
      auto turned = c;
      auto& arc = turned.levels[0].arcs[i];
      arc = {arc.first, static_cast<std::uint8_t>(arc.second + 1)};
      CHECK_FALSE(verify(encode(turned)).accepted);
    }
  }
  std::cout << inner << " inner faces with arcs of " << level.arcs.size() << "\n";
  CHECK(inner > 10);
}

TEST_CASE("modes: hole 8, lambda is in the tensors' scale") {
  auto input = grid(1, -2, 2, kReferenceFields[3]);
  input.tets.resize(2);
  const auto c = reference_modes(input, {{9, 10}});
  for (const int power : {-40, 40}) {
    auto scaled = c;
    for (auto& t : scaled.tensors)
      for (double& x : t) x = std::ldexp(x, power);
    std::size_t witnesses = 0;
    for (const auto& w : scaled.levels[0].tet_witnesses) witnesses += w.lambda != 0;
    REQUIRE(witnesses > 0);
    CHECK_FALSE(verify(encode(scaled)).accepted);
    for (auto& w : scaled.levels[0].tet_witnesses) w.lambda = std::ldexp(w.lambda, power);
    for (auto& w : scaled.levels[0].face_witnesses) w.lambda = std::ldexp(w.lambda, power);
    require_accepted(scaled);
    CHECK(statement(scaled.levels[0]) == statement(c.levels[0]));
  }
}

TEST_CASE("modes: hole 8, no cell is rejected on f <= 0 with f = 0 at a corner") {
  const auto check = [](const std::array<Traceless, 4>& corners) {
    std::vector<std::array<double, 6>> tensors;
    for (const auto& t : corners) tensors.push_back(tensor(t));
    modes::Field field(tensors);
    ModeLevel level;
    level.numerator = 143, level.denominator = 343;
    const modes::LevelContext context(level, field, {});
    modes::Worker worker(field);
    const std::array<modes::u32, 4> tet{0, 1, 2, 3};
    modes::check_rejected(context, {&tet, 1}, worker);
  };
  // Mode 143 / 343 at diag(-11, 13, -2), lower at diag(-12, 13, -1), higher at diag(-10, 13, -3).
  const Traceless at = {-11, 13, 0, 0, 0}, lower = {-12, 13, 0, 0, 0}, higher = {-10, 13, 0, 0, 0};
  CHECK_THROWS_AS(check({at, lower, lower, lower}), Reject);
  CHECK_NOTHROW(check({lower, lower, lower, lower}));
  CHECK_NOTHROW(check({at, higher, higher, higher}));
  CHECK_NOTHROW(check({at, at, at, at}));
}

TEST_CASE("modes: hole 8, what is deeper than the limit is open, counted, and claimed nowhere") {
  const auto input = grid(1, -2, 2, kReferenceFields[3]);
  unsigned touched = 0;
  for (const unsigned depth : {0U, 2U, 4U}) {
    CAPTURE(depth);
    const auto c = reference_modes(input, {{0, 1}}, depth);
    require_accepted(c);
    const auto& level = c.levels[0];
    CHECK(level.open_tets > 0);
    for (const int change : {-1, 1}) {
      auto wrong = c;
      wrong.levels[0].open_tets += static_cast<std::uint32_t>(change);
      CHECK_FALSE(verify(encode(wrong)).accepted);
    }
    if (level.positive.touched == 0) continue;
    ++touched;
    auto wrong = c;
    --wrong.levels[0].positive.touched;
    auto& list = wrong.levels[0].positive.components;
    list.insert(list.begin(), {1, 1});
    CHECK_FALSE(verify(encode(wrong)).accepted);
  }
  CHECK(touched > 0);
}

TEST_CASE("modes: hole 8, splits of splits of splits end at 64") {
  auto c = reference_modes(two_with_ties(), {{1, 2}});
  auto& codes = c.levels[0].codes;
  // The first edge is cut towards its first end again and again; the parts have no roots.
  const auto at = std::ranges::find(codes, std::uint8_t{modes_code::kRoots});
  REQUIRE(at != codes.end());
  const auto place = at - codes.begin();
  const auto original = codes;
  for (const unsigned depth : {20U, 63U, 64U, 65U, 1000U}) {
    codes = original;
    codes.insert(codes.begin() + place, depth, 1);
    codes.insert(codes.begin() + place + depth + 1, depth, modes_code::kRoots);
    CAPTURE(depth, reason(c));
    // The edge may itself be a split's part.
    if (depth < 60) CHECK(verify(encode(c)).accepted);
    if (depth > 64) CHECK(reason(c).find("more than 64 splits") != std::string::npos);
  }
}

TEST_CASE("modes: hole 10, blocks that touch in an edge have each their own root there") {
  ModesInput input;
  input.points = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}};
  input.tets = {{0, 1, 2, 3}, {0, 1, 4, 5}};
  for (std::size_t v = 0; v < 6; ++v)
    input.tensors.push_back(
        tensor(v == 0 ? Traceless{2, -1, 0, 0, 0} : Traceless{1, -2, 0.1, 0, 0}));
  const auto c = reference_modes(input, {{0, 1}});
  require_accepted(c);
  CHECK(c.levels[0].positive.components == std::vector<SurfaceComponent>{{1, 1}, {1, 1}});
}

namespace {

/// Of the deviator at weights b.
double determinant(const ModesInput& input, const std::array<double, 4>& b) {
  std::array<double, 6> t{};
  for (std::size_t v = 0; v < 4; ++v)
    for (std::size_t k = 0; k < 6; ++k) t[k] += b[v] * input.tensors[v][k];
  const double third = (t[0] + t[1] + t[2]) / 3;
  for (std::size_t k = 0; k < 3; ++k) t[k] -= third;
  return t[0] * (t[1] * t[2] - t[4] * t[4]) - t[3] * (t[3] * t[2] - t[4] * t[5]) +
         t[5] * (t[3] * t[4] - t[1] * t[5]);
}

}  // namespace

TEST_CASE("modes: hole 10, no surface is closed inside one tetrahedron") {
  // Where its faces have no root all points inside are alike; where they have, pieces have loops.
  Random random(kSeed);
  std::uniform_int_distribution<int> entry(-3, 3), change(-1, 1);
  std::exponential_distribution<double> weight;
  std::uint64_t without = 0, with = 0;
  for (std::uint64_t i = 0; i < scaled(30); ++i) {
    ModesInput input;
    input.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    input.tets = {{0, 1, 2, 3}};
    std::array<double, 6> t{};
    for (double& x : t) x = entry(random);
    for (int v = 0; v < 4; ++v) {
      input.tensors.push_back(t);
      for (double& x : input.tensors.back()) x += change(random);
    }
    const auto c = reference_modes(input, {{0, 1}}, 2);
    if (c.levels[0].open_tets > 0) continue;
    for (const auto& component : c.levels[0].positive.components)
      CHECK(component.boundary_loops > 0);
    if (!c.levels[0].positive.components.empty()) {
      ++with;
      continue;
    }
    ++without;
    double least = 1, most = -1;
    for (int k = 0; k < 2000; ++k) {
      std::array<double, 4> b{};
      for (double& x : b) x = weight(random);
      const double det = determinant(input, b);
      least = std::min(least, det), most = std::max(most, det);
    }
    CHECK_FALSE((least < -1e-9 && most > 1e-9));
  }
  std::cout << with << " tetrahedra with the level, " << without << " without\n";
  CHECK(with > 0);
  CHECK(without > 0);
}
