// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 6: positions of pieces, against rationals from the definition; edited ones.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <iostream>

#include "kernel/arithmetic/rational.hpp"
#include "tests/certify_modes/modes_judge.hpp"
#include "tests/certify_modes/modes_samples.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/random.hpp"
#include "tests/support/verdicts.hpp"

using namespace crest::certify;
using namespace crest::tests;
using crest::kernel::Rational;

namespace {

using Plane = std::array<Rational, 2>;
using Weights = std::array<Rational, 4>;

Rational cross(const Plane& a, const Plane& b, const Plane& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
int sign(const Rational& x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}
bool on(const Plane& p, const Plane& a, const Plane& b) {
  return cross(a, b, p) == 0 && (p[0] - a[0]) * (p[0] - b[0]) + (p[1] - a[1]) * (p[1] - b[1]) <= 0;
}
bool meet(const Plane& a, const Plane& b, const Plane& c, const Plane& d) {
  return on(a, c, d) || on(b, c, d) || on(c, a, b) || on(d, a, b) ||
         (sign(cross(a, b, c)) != sign(cross(a, b, d)) &&
          sign(cross(c, d, a)) != sign(cross(c, d, b)));
}

/// The loops of a level in a tetrahedron that is a cell as a whole, from the lists alone.
class WholeCell {
 public:
  explicit WholeCell(const ModeLevel& level) : level_(level) {}

  /// Nothing unless no edge, no face and no cell is split, all is decided, and there is a piece.
  std::optional<std::array<std::uint32_t, 2>> count() {
    std::size_t code = 0, root = 0, arc = 0, point = 0;
    for (const auto& [a, b] : level_.edges) {
      const int roots = level_.codes[code++] - 64;
      if (roots < 0 || roots > 6) return std::nullopt;
      for (int i = 0; i < roots; ++i) on_edge_[{a, b}].push_back(root++);
    }
    for (const auto& face : level_.faces) {
      const int kind = level_.codes[code++];
      if (kind < 3 || kind == 6) return std::nullopt;
      if (kind > 3) read_face(face, arc, point);
    }
    if (level_.tets.empty() || level_.codes[code] < 7 || level_.codes[code] > 8)
      return std::nullopt;
    std::array<std::uint32_t, 2> found{};
    for (const int of : {1, -1}) {
      const auto pieces = level_.tet_witnesses[0].pieces[of > 0 ? 0 : 1];
      if (pieces > 0) found[is_placed(of, pieces) ? 0 : 1] += pieces;
    }
    if (found[0] + found[1] == 0) return std::nullopt;
    return found;
  }

 protected:
  struct Line {
    std::size_t first, second;
    std::vector<Weights> points;
  };

  void read_face(const std::array<std::uint32_t, 3>& face, std::size_t& arc, std::size_t& point) {
    std::vector<std::size_t> around;
    std::map<std::size_t, Weights> place;
    for (unsigned k = 0; k < 3; ++k) {
      const auto a = face[k], b = face[(k + 1) % 3];
      auto roots = on_edge_[{std::min(a, b), std::max(a, b)}];
      for (const auto r : roots) {
        Weights w{};
        w[std::min(a, b)] = 1 - Rational(level_.root_places[r]);
        w[std::max(a, b)] = Rational(level_.root_places[r]);
        place[r] = w;
      }
      if (a > b) std::ranges::reverse(roots);
      around.insert(around.end(), roots.begin(), roots.end());
    }
    for (std::size_t i = 0; i < around.size() / 2; ++i, ++arc) {
      const auto first = around[level_.arcs[arc].first], second = around[level_.arcs[arc].second];
      Line line = {first, second, {place[first]}};
      for (unsigned k = 0; k < level_.arc_points[arc]; ++k, ++point) {
        const auto [a, b] = level_.points[point];
        Weights w{};
        w[face[0]] = Rational(a), w[face[1]] = Rational(b);
        w[face[2]] = 1 - Rational(a) - Rational(b);
        line.points.push_back(w);
      }
      line.points.push_back(place[second]);
      lines_.push_back(line);
    }
  }

  Plane project(const Weights& b) const {
    const auto& v = level_.tet_witnesses[0].w;
    const std::array<int, 4> w = {v[0], v[1], v[2], -(v[0] + v[1] + v[2])};
    unsigned j = 3;
    while (w[j] == 0) --j;
    Plane p;
    for (unsigned i = 0, at = 0; i < 4 && at < 2; ++i)
      if (i != j) p[at++] = b[i] - b[j] * Rational(w[i]) / Rational(w[j]);
    return p;
  }

  static bool is_along_a_side(const Line& line) {
    int corners = 0;
    for (unsigned k = 0; k < 4; ++k)
      corners += line.points.front()[k] != 0 || line.points.back()[k] != 0 ? 1 : 0;
    return line.points.size() == 2 && corners == 2;
  }
  bool is_placed(int of, std::uint32_t pieces) const {
    std::vector<std::vector<Plane>> loops;
    std::vector<Line> left;
    for (const Line& line : lines_)
      if (level_.roots[line.first].level == of) {
        if (is_along_a_side(line)) return false;
        left.push_back(line);
      }
    while (!left.empty()) {
      std::vector<Plane> loop;
      std::size_t from = left[0].first;
      const std::size_t start = from;
      do {
        auto at = std::ranges::find_if(
            left, [&](const Line& l) { return l.first == from || l.second == from; });
        if (at->first != from) std::ranges::reverse(at->points);
        for (std::size_t i = 0; i + 1 < at->points.size(); ++i)
          loop.push_back(project(at->points[i]));
        from = at->first == from ? at->second : at->first;
        left.erase(at);
      } while (from != start);
      loops.push_back(loop);
    }
    return all_simple(loops) && nested(loops, pieces);
  }

  static bool all_simple(const std::vector<std::vector<Plane>>& loops) {
    for (std::size_t m = 0; m < loops.size(); ++m)
      for (std::size_t n = m; n < loops.size(); ++n)
        for (std::size_t i = 0; i < loops[m].size(); ++i)
          for (std::size_t k = m == n ? i + 1 : 0; k < loops[n].size(); ++k) {
            const std::size_t p = loops[m].size(), q = loops[n].size();
            const auto &a = loops[m][i], &b = loops[m][(i + 1) % p], &c = loops[n][k],
                       &d = loops[n][(k + 1) % q];
            if (a == b || c == d) return false;
            const bool next = m == n && k == i + 1, last = m == n && (k + 1) % q == i;
            if (next && last) return false;
            if (next   ? on(d, a, b) || on(a, c, d)
                : last ? on(c, a, b) || on(b, c, d)
                       : meet(a, b, c, d))
              return false;
          }
    return true;
  }
  /// Twice the winding number, by signed crossings.
  static bool inside(const std::vector<Plane>& loop, const Plane& q) {
    bool in = false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto &a = loop[i], &b = loop[(i + 1) % loop.size()];
      if ((a[1] > q[1]) == (b[1] > q[1])) continue;
      const Rational x = a[0] + (q[1] - a[1]) * (b[0] - a[0]) / (b[1] - a[1]);
      in ^= x > q[0];
    }
    return in;
  }
  static bool nested(const std::vector<std::vector<Plane>>& loops, std::uint32_t pieces) {
    std::size_t pairs = 0, most = 0;
    for (const auto& outer : loops) {
      std::size_t held = 0;
      for (const auto& inner : loops) held += &inner != &outer && inside(outer, inner[0]);
      pairs += held, most = std::max(most, held);
    }
    if (pieces == loops.size()) return pairs == 0;
    return most + 1 == loops.size() && pairs == most;
  }

  const ModeLevel& level_;
  std::map<std::array<std::uint32_t, 2>, std::vector<std::size_t>> on_edge_;
  std::vector<Line> lines_;
};

/// The vertices of such a tetrahedron.
class NearCell : public WholeCell {
 public:
  using WholeCell::WholeCell;

  /// Vertices whose mode is within 2^-40 of the level, by the definition. After count(), where that
  /// is something.
  std::uint32_t near(const ModesInput& input) const {
    std::uint32_t count = 0;
    for (const Line& line : lines_)
      for (std::size_t i = 1; i + 1 < line.points.size(); ++i)
        count += is_near(input, line.points[i], level_.roots[line.first].level);
    for (const auto& [ends, roots] : on_edge_)
      for (const auto r : roots) {
        Weights w{};
        w[ends[1]] = Rational(level_.root_places[r]);
        w[ends[0]] = 1 - w[ends[1]];
        count += is_near(input, w, level_.roots[r].level);
      }
    for (const InnerVertex& vertex : level_.inner) {
      Weights w{};
      for (unsigned k = 0; k < 3; ++k) w[k] = Rational(vertex.weights[k]);
      w[3] = 1 - w[0] - w[1] - w[2];
      count += is_near(input, w, vertex.level);
    }
    return count;
  }

 private:
  /// mode |mode| is monotonic in the mode, and rational.
  bool is_near(const ModesInput& input, const Weights& b, int of) const {
    std::array<Rational, 6> t;
    for (unsigned i = 0; i < 4; ++i)
      for (unsigned k = 0; k < 6; ++k) t[k] += b[i] * Rational(input.tensors[i][k]);
    const Rational mean = (t[0] + t[1] + t[2]) / 3;
    for (unsigned k = 0; k < 3; ++k) t[k] -= mean;
    const Rational det = t[0] * t[1] * t[2] + 2 * t[3] * t[4] * t[5] - t[0] * t[4] * t[4] -
                         t[1] * t[5] * t[5] - t[2] * t[3] * t[3];
    Rational norm = 0;
    for (unsigned k = 0; k < 6; ++k) norm += (k < 3 ? 1 : 2) * t[k] * t[k];
    const auto signed_square = [](const Rational& x) { return x < 0 ? -x * x : x * x; };
    const Rational mode = 54 * signed_square(det) / (norm * norm * norm),
                   level = of * Rational(level_.numerator) / Rational(level_.denominator),
                   room = Rational(0x1p-40);
    return mode >= signed_square(level - room) && mode <= signed_square(level + room);
  }
};

ModesInput random_tet(Random& random) {
  std::uniform_int_distribution<int> entry(-5, 5), change(-4, 4);
  ModesInput input;
  input.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  input.tets = {{0, 1, 2, 3}};
  std::array<double, 6> t{};
  for (double& x : t) x = entry(random);
  for (int v = 0; v < 4; ++v) {
    input.tensors.push_back(t);
    for (double& x : input.tensors.back()) x += change(random);
  }
  return input;
}

}  // namespace

TEST_CASE("modes: placed pieces are those of the definition, in rationals") {
  Random random(kSeed);
  std::array<std::uint64_t, 2> seen{}, near{};
  for (std::uint64_t i = 0; i < scaled(150); ++i) {
    const ModesInput input = random_tet(random);
    auto c = reference_modes(input, {{0, 1}, {1, 2}}, 0);
    for (const unsigned points : {0U, 1U, 3U}) {
      add_positions(c, points, random());
      const Verdict verdict = verify(encode(c));
      INFO(verdict.reason);
      REQUIRE(verdict.accepted);
      for (const auto& level : c.levels) {
        NearCell cell(level);
        const auto expected = cell.count();
        if (!expected) continue;
        CHECK(level.near == cell.near(input));
        near[0] += level.near, near[1] += level.inner.size();
        CHECK(level.placed == (*expected)[0]);
        CHECK(level.not_placed == (*expected)[1]);
        seen[0] += level.placed, seen[1] += level.not_placed;
      }
    }
  }
  std::cout << seen[0] << " pieces placed, " << seen[1] << " not; " << near[0] << " vertices near, "
            << near[1] << " inside\n";
  CHECK(near[0] > 40);
  CHECK(seen[0] > 20);
  CHECK(seen[1] > 20);
}

TEST_CASE("modes: hole 8, positions are claimed of polygons that are simple and nested") {
  // Divided cells, faces finer than cells, cones.
  LinearField centred = kReferenceFields[2];
  centred[0] = {};
  for (auto c : {reference_modes(grid(1, -2, 2, kReferenceFields[3]), {{0, 1}}),
                 reference_modes(grid(1, -1, 1, centred), {{0, 1}}, 30, {{{0, 7}}})}) {
    require_accepted(c);
    add_positions(c);
    require_accepted(c);
    auto& level = c.levels[0];
    CHECK(level.placed > 0);
    std::cout << level.placed << " pieces placed, " << level.not_placed << " not\n";
    const auto all = level.placed + level.not_placed;
    // A tetrahedron turned inside out, or flat: nothing is.
    for (const bool flat : {false, true}) {
      auto folded = c;
      if (flat)
        for (auto& p : folded.points) p[2] = 0;
      else
        folded.points[1] = {-10, 10, -2};
      CHECK_FALSE(verify(encode(folded)).accepted);
      count_positions(folded);
      CHECK(folded.levels[0].placed == 0);
      CHECK(folded.levels[0].not_placed == all);
      require_accepted(folded);
    }
    const auto before = level.not_placed;
    add_positions(c, 2, 7);
    CHECK(level.not_placed > before);
    require_accepted(c);
  }
}

TEST_CASE("modes: arcs along a side of two faces place nothing without a point") {
  // The tensor is the same along edge 01, and det = 0 twice on edge 23: the arcs of the faces at
  // that edge join its roots, and so do those of the face between two tetrahedra there.
  const Traceless same = {1, -0.5, 0, 0, 2}, third = {1, -1.5, 0, 0, 0},
                  fourth = {1, 0.5, 0, 0, 0.2};
  ModesInput one, two;
  one.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  one.tets = {{0, 1, 2, 3}};
  two.points = {{0, 0, 0}, {0.5, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
  two.tets = {{0, 1, 2, 3}, {1, 4, 2, 3}};
  for (const auto& t : {same, same, third, fourth}) one.tensors.push_back(tensor(t));
  two.tensors = one.tensors;
  two.tensors.push_back(tensor(same));
  for (const ModesInput& input : {one, two}) {
    auto c = reference_modes(input, {{0, 1}});
    require_accepted(c);
    add_positions(c);
    const auto pieces = static_cast<std::uint32_t>(input.tets.size());
    CHECK(c.levels[0].placed == 0);
    CHECK(c.levels[0].not_placed == pieces);
    require_accepted(c);
    c.levels[0].placed = 1;
    c.levels[0].not_placed = pieces - 1;
    CHECK_FALSE(verify(encode(c)).accepted);
  }
}

namespace {

using Edit = std::function<bool(ModeLevel&, Random&)>;

/// All must be rejected.
const std::vector<std::pair<std::string, Edit>> kEdits = {
    {"a piece more", [](ModeLevel& l, Random&) { return ++l.placed, true; }},
    {"a piece more, of as many",
     [](ModeLevel& l, Random&) { return ++l.placed, --l.not_placed, true; }},
    {"a piece less", [](ModeLevel& l, Random&) { return --l.placed, true; }},
    {"a piece more that is not", [](ModeLevel& l, Random&) { return ++l.not_placed, true; }},
    {"place at an end",
     [](ModeLevel& l, Random& r) {
       l.root_places[r() % l.root_places.size()] = static_cast<double>(r() % 2);
       return true;
     }},
    {"place not finite",
     [](ModeLevel& l, Random& r) {
       l.root_places[r() % l.root_places.size()] = std::array{HUGE_VAL, std::nan("")}[r() % 2];
       return true;
     }},
    {"place outside its enclosure",
     [](ModeLevel& l, Random& r) {
       const auto at = r() % l.roots.size();
       const auto& [low, high, level] = l.roots[at];
       if (low == high) return false;
       l.root_places[at] = r() % 2 ? std::nextafter(low, -1) : std::nextafter(high, 2);
       return true;
     }},
    {"place dropped", [](ModeLevel& l, Random&) { return l.root_places.pop_back(), true; }},
    {"count of points dropped",
     [](ModeLevel& l, Random&) { return l.arc_points.pop_back(), true; }},
    {"count of points changed",
     [](ModeLevel& l, Random& r) { return ++l.arc_points[r() % l.arc_points.size()], true; }},
    {"point dropped", [](ModeLevel& l, Random&) { return l.points.pop_back(), true; }},
    {"point on an edge",
     [](ModeLevel& l, Random& r) {
       auto& [a, b] = l.points[r() % l.points.size()];
       const auto kind = r() % 3;
       if (kind == 0) a = 0;
       if (kind == 1) b = 1 - a;
       if (kind == 2) b = -0.25;
       return true;
     }},
    {"lists dropped",
     [](ModeLevel& l, Random&) {
       l.root_places.clear(), l.arc_points.clear(), l.points.clear();
       return true;
     }},
    {"lists dropped but inner vertices",
     [](ModeLevel& l, Random&) {
       l.root_places.clear(), l.arc_points.clear(), l.points.clear();
       l.placed = l.not_placed = l.near = 0;
       return true;
     }},
    {"a vertex more near", [](ModeLevel& l, Random&) { return ++l.near, true; }},
    {"all vertices near",
     [](ModeLevel& l, Random&) {
       l.near = static_cast<std::uint32_t>(l.roots.size() + l.points.size() + l.inner.size());
       return true;
     }},
    {"inner vertex of no witness",
     [](ModeLevel& l, Random&) {
       l.inner.back().witness = static_cast<std::uint32_t>(l.tet_witnesses.size());
       return true;
     }},
    {"inner vertex of no level",
     [](ModeLevel& l, Random& r) {
       l.inner[r() % l.inner.size()].level = std::array{std::int8_t{0}, std::int8_t{3}}[r() % 2];
       return true;
     }},
    {"inner vertex of a level that is not there",
     [](ModeLevel& l, Random& r) { return l.inner[r() % l.inner.size()].level = -1, true; }},
    {"inner vertices not in order",
     [](ModeLevel& l, Random&) {
       return std::swap(l.inner.front(), l.inner.back()),
              l.inner.front().witness != l.inner.back().witness;
     }},
    {"inner vertex twice",
     [](ModeLevel& l, Random& r) {
       l.inner.insert(l.inner.begin(), l.inner.front());
       return ++l.near, r() % 2 < 2;
     }},
    {"inner vertex outside",
     [](ModeLevel& l, Random& r) {
       auto& w = l.inner[r() % l.inner.size()].weights;
       w[r() % 3] = std::array{-0.25, 1.0, std::nan("")}[r() % 3];
       return true;
     }},
    {"inner vertices dropped", [](ModeLevel& l, Random&) { return l.inner.clear(), true; }},
};

}  // namespace

TEST_CASE("modes: edited positions are rejected") {
  Random random(kSeed);
  auto c = reference_modes(grid(1, -2, 2, kReferenceFields[2]), {{0, 1}});
  add_positions(c, 1, 3);
  require_accepted(c);
  REQUIRE(c.levels[0].placed > 0);
  for (const auto& [kind, edit] : kEdits) {
    CAPTURE(kind);
    std::uint64_t tried = 0;
    for (std::uint64_t i = 0; i < scaled(3); ++i) {
      auto mutant = c;
      if (!edit(mutant.levels[0], random)) continue;
      ++tried;
      CHECK_FALSE(verify(encode(mutant)).accepted);
    }
    CHECK(tried > 0);
  }
  // Fewer may be stated.
  auto modest = c;
  --modest.levels[0].placed, ++modest.levels[0].not_placed, --modest.levels[0].near;
  require_accepted(modest);
  // Nothing stated is no claim.
  auto silent = c;
  auto& level = silent.levels[0];
  level.root_places.clear(), level.arc_points.clear(), level.points.clear();
  level.inner.clear();
  level.placed = level.not_placed = level.near = 0;
  require_accepted(silent);
}
