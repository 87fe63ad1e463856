// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 7: the producer's certificates are accepted; edited ones are rejected unless true.
#include <catch2/catch.hpp>
#include <functional>
#include <iostream>
#include <map>
#include <numeric>
#include <set>

#include "algorithms/modes/curves_certificate.hpp"
#include "algorithms/modes/degenerate_curves.hpp"
#include "certify/modes_curves/decode.hpp"
#include "certify/modes_curves/encode.hpp"
#include "certify/modes_curves/near.hpp"
#include "certify/modes_curves/tet_arcs.hpp"
#include "certify/verify.hpp"
#include "tests/certify_modes/byte_mutants.hpp"
#include "tests/certify_modes/modes_samples.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/failures.hpp"
#include "tests/support/random.hpp"
#include "tests/support/verdicts.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

using Certificate = ModesCurvesCertificate;

Certificate produced(const ModesInput& input) {
  const auto curves = crest::modes::degenerate_curves(input.points, input.tets, input.tensors);
  return crest::modes::curves_certificate(input.points, input.tets, input.tensors, curves);
}

/// Tensors at random on a grid; of one vertex in `zeros`, if any, zero.
ModesInput random_grid(std::uint32_t n, Random& random, unsigned zeros) {
  ModesInput input = grid(n, 0, 1, kReferenceFields[0]);
  for (auto& t : input.tensors) {
    const bool zero = zeros > 0 && random() % zeros == 0;
    for (double& x : t) x = zero ? 0 : static_cast<double>(random() % 2001) / 1000.0 - 1;
  }
  return input;
}

auto counts(const CurveCounts& c) {
  return std::array{c.open, c.closed, c.touched};
}

}  // namespace

namespace {

/// For tensors with xx = yy: whether pairs of points are ends of the parts of the lines (1, 1, t),
/// (1, -1, t) on which all weights have one sign, by sampling.
bool lines_join(const Certificate& c, const std::vector<std::array<std::uint32_t, 2>>& pairs) {
  using Row = std::array<double, 5>;
  const auto weights = [&](double line, double angle) {
    // b in sum b_i D_i = v v^T - I / 3, of 3 zz, xy, yz, xz.
    const double t = std::tan(angle), third = (2 + t * t) / 3;
    std::array<Row, 4> rows{};
    const std::array<double, 4> right = {t * t - third, line, line * t, t};
    for (std::size_t r = 0; r < 4; ++r) {
      for (std::size_t i = 0; i < 4; ++i) rows[r][i] = c.tensors[i][std::array{2, 3, 4, 5}[r]];
      rows[r][4] = right[r];
    }
    for (std::size_t k = 0; k < 4; ++k) {
      std::size_t best = k;
      for (std::size_t r = k; r < 4; ++r)
        if (std::fabs(rows[r][k]) > std::fabs(rows[best][k])) best = r;
      std::swap(rows[k], rows[best]);
      for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t j = 5; r != k && j-- > k;)
          rows[r][j] -= rows[r][k] / rows[k][k] * rows[k][j];
    }
    std::array<double, 4> b{};
    for (std::size_t k = 0; k < 4; ++k) b[k] = rows[k][4] / rows[k][k];
    return b;
  };
  constexpr int kSteps = 20000;
  for (const double line : {1.0, -1.0}) {
    bool before = false;
    std::vector<std::array<double, 4>> ends;
    for (int k = 1; k < kSteps; ++k) {
      const auto b = weights(line, (k / static_cast<double>(kSteps) - 0.5) * 3.14159265358979);
      const bool inside = std::ranges::min(b) > 0 || std::ranges::max(b) < 0;
      if (inside != before) ends.push_back(b);
      before = inside;
    }
    // The point whose face and weights are nearest to an end.
    const auto nearest = [&](const std::array<double, 4>& b) {
      const double sum = b[0] + b[1] + b[2] + b[3];
      std::uint32_t best = 0;
      double least = HUGE_VAL;
      for (std::uint32_t p = 0; p < c.face_points.size(); ++p) {
        const auto& point = c.face_points[p];
        std::array<double, 4> there{};
        const auto& face = c.faces[point.face];
        for (std::size_t k = 0; k < 2; ++k) there[face[k]] = (point.low[k] + point.high[k]) / 2;
        there[face[2]] = 1 - there[face[0]] - there[face[1]];
        double distance = 0;
        for (std::size_t k = 0; k < 4; ++k) distance += std::fabs(there[k] - b[k] / sum);
        if (distance < least) least = distance, best = p;
      }
      return best;
    };
    for (std::size_t k = 0; k + 1 < ends.size(); k += 2) {
      const auto [low, high] = std::minmax({nearest(ends[k]), nearest(ends[k + 1])});
      if (std::ranges::find(pairs, std::array{low, high}) == pairs.end()) return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("modes-curves: the curves of linear fields are those of the table") {
  constexpr std::array<std::array<std::uint32_t, 2>, 6> kPieces = {
      {{1, 2}, {2, 1}, {2, 1}, {1, 2}, {1, 1}, {2, 2}}};
  for (std::size_t f = 0; f < 6; ++f)
    for (const bool mirrored : {false, true})
      for (const std::uint32_t n : {1U, 2U, 3U}) {
        CAPTURE(f + 1, n, mirrored);
        const auto c = produced(grid(n, -2, 2, kReferenceFields[f], mirrored));
        require_accepted(c);
        CHECK(counts(c.linear) == std::array{kPieces[f][0], 0U, 0U});
        CHECK(counts(c.planar) == std::array{kPieces[f][1], 0U, 0U});
      }
}

TEST_CASE("modes-curves: random fields, with closed curves, and with zeros at vertices") {
  Random random(kSeed);
  std::uint32_t closed = 0, touched = 0, four = 0;
  for (const unsigned zeros : {0U, 0U, 12U}) {
    const auto c = produced(random_grid(3, random, zeros));
    require_accepted(c);
    closed += c.linear.closed + c.planar.closed;
    touched += c.linear.touched + c.planar.touched;
    CHECK((zeros > 0) == !c.special_tets.empty());
    for (std::size_t i = 1; i < c.arcs.size(); ++i) four += c.arcs[i].tet == c.arcs[i - 1].tet;
  }
  std::cout << closed << " closed curves, " << touched << " at special places, " << four
            << " tetrahedra with two arcs or more\n";
  CHECK(closed > 0);
  CHECK(touched > 0);
  CHECK(four > 0);  // several points on a conic
}

TEST_CASE("modes-curves: doubles, pairs and integers say the same of a tetrahedron") {
  Random random(kSeed);
  const auto c = produced(random_grid(2, random, 0));
  const modes::Field field(c.tensors);
  modes::ExactTensors exact(field);
  std::uint64_t several = 0;
  for (auto corners : c.tets) {
    std::ranges::sort(corners);
    std::vector<std::vector<curves::NearPoint>> near(4);
    std::vector<curves::NearTetPoint> near_points;
    std::vector<curves::TetPoint> points;
    for (unsigned i = 0; i < 4; ++i) {
      std::array<std::uint32_t, 3> face{};
      for (unsigned k = 0, at = 0; k < 4; ++k)
        if (k != i) face[at++] = corners[k];
      const auto listed = std::ranges::lower_bound(c.faces, face);
      if (listed == c.faces.end() || *listed != face) continue;
      std::vector<curves::Box> boxes;
      for (std::uint32_t p = 0; p < c.face_points.size(); ++p)
        if (const auto& point = c.face_points[p]; c.faces[point.face] == face)
          boxes.push_back({point.low, point.high, point.type, p});
      const auto found = curves::find_near_points(
          {&c.tensors[face[0]], &c.tensors[face[1]], &c.tensors[face[2]]}, boxes);
      REQUIRE(found);
      near[i] = *found;
      for (const auto& point : near[i]) near_points.push_back({&point, i});
      const auto exactly = curves::find_points(exact, face, boxes);
      REQUIRE(exactly);
      for (const auto& point : *exactly) points.push_back({point, i});
    }
    if (points.empty()) continue;
    several += points.size() > 2;
    const auto name = [](auto pairs, const auto& number) {
      std::set<std::array<std::uint32_t, 2>> names;
      for (const auto& [a, b] : pairs) {
        const auto [low, high] = std::minmax({number(a), number(b)});
        names.insert({low, high});
      }
      return names;
    };
    const auto fast = curves::find_near_arcs({&c.tensors[corners[0]], &c.tensors[corners[1]],
                                              &c.tensors[corners[2]], &c.tensors[corners[3]]},
                                             near_points);
    const auto slow = curves::find_arcs(exact, corners, points);
    REQUIRE((fast && slow));
    CHECK(name(*fast, [&](std::size_t i) { return near_points[i].point->listed; }) ==
          name(*slow, [&](std::size_t i) { return points[i].point.listed; }));
  }
  std::cout << several << " tetrahedra with four points or more\n";
  CHECK(several > 5);
}

TEST_CASE("modes-curves: a pair of lines that meet outside a tetrahedron") {
  // xx = yy: the lines x = y and x = -y, which meet in (0, 0, 1). One pairing is accepted: that of
  // the parts of the lines on which all weights have one sign.
  Random random(kSeed);
  std::uniform_int_distribution<int> entry(-4, 4);
  std::uint64_t decided = 0, four = 0;
  for (std::uint64_t i = 0; i < scaled(120); ++i) {
    ModesInput input;
    input.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    input.tets = {{0, 1, 2, 3}};
    for (int v = 0; v < 4; ++v) {
      const double xx = entry(random);
      input.tensors.push_back({xx, xx, -2 * xx, static_cast<double>(entry(random)),
                               static_cast<double>(entry(random)),
                               static_cast<double>(entry(random))});
    }
    auto c = produced(input);
    if (!c.special_faces.empty() || c.face_points.size() < 2 || c.face_points.size() > 4) continue;
    c.special_tets.clear();
    // Pairings of two or four points of one type each.
    std::vector<std::vector<std::array<std::uint32_t, 2>>> pairings = {{{0, 1}}};
    if (c.face_points.size() == 4)
      pairings = {{{0, 1}, {2, 3}}, {{0, 2}, {1, 3}}, {{0, 3}, {1, 2}}};
    std::uint64_t accepted = 0;
    bool crossing = false;
    std::string reason;
    for (const auto& pairs : pairings) {
      c.arcs.clear();
      c.linear = c.planar = {};
      for (const auto& pair : pairs) {
        c.arcs.push_back({0, pair});
        ++(c.face_points[pair[0]].type > 0 ? c.linear : c.planar).open;
      }
      const Verdict verdict = verify(encode(c));
      reason += verdict.reason + "; ";
      crossing |= verdict.reason.find("pair of lines") != std::string::npos;
      if (!verdict.accepted) continue;
      ++accepted;
      CHECK(lines_join(c, pairs));
    }
    if (crossing) continue;
    CAPTURE(i, c.face_points.size(), reason);
    CHECK(accepted == 1);
    ++decided;
    four += pairings.size() > 1;
  }
  std::cout << decided << " pairs of lines, " << four << " with four points\n";
  CHECK(decided > 5);
}

namespace {

/// Components of the arcs outside special tetrahedra, by passes over all of them.
std::pair<CurveCounts, CurveCounts> recount(const Certificate& c,
                                            const std::vector<DegenerateArc>& arcs,
                                            const std::vector<std::uint32_t>& special_tets) {
  std::vector<std::size_t> name(c.face_points.size());
  std::iota(name.begin(), name.end(), std::size_t{0});
  const auto special = [&](std::uint32_t t) {
    return std::ranges::find(special_tets, t) != special_tets.end();
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& arc : arcs) {
      if (special(arc.tet)) continue;
      auto &a = name[arc.points[0]], &b = name[arc.points[1]];
      if (a != b) a = b = std::min(a, b), changed = true;
    }
  }
  std::map<std::size_t, std::array<bool, 3>> curves;  // linear, touched, open
  for (std::size_t p = 0; p < name.size(); ++p) {
    auto& [linear, touched, open] = curves[name[p]];
    linear = c.face_points[p].type > 0;
    unsigned sides = 0;
    for (std::uint32_t t = 0; t < c.tets.size(); ++t) {
      auto corners = c.tets[t];
      std::ranges::sort(corners);
      if (!std::ranges::includes(corners, c.faces[c.face_points[p].face])) continue;
      ++sides;
      touched |= special(t);
    }
    open |= sides == 1;
  }
  std::pair<CurveCounts, CurveCounts> counts;
  for (const auto& [curve, kind] : curves) {
    auto& of = kind[0] ? counts.first : counts.second;
    ++(kind[1] ? of.touched : kind[2] ? of.open : of.closed);
  }
  return counts;
}

using Edit = std::function<bool(Certificate&, Random&)>;

template <class List>
auto& any_of(List& list, Random& random) {
  return list[static_cast<std::size_t>(random() % list.size())];
}

/// Each returns whether it changed anything.
const std::vector<std::pair<std::string, Edit>> kEdits = {
    {"count changed",
     [](Certificate& c, Random& r) {
       auto& of = r() % 2 ? c.linear : c.planar;
       ++*std::array{&of.open, &of.closed, &of.touched}[r() % 3];
       return true;
     }},
    {"type turned",
     [](Certificate& c, Random& r) {
       auto& type = any_of(c.face_points, r).type;
       type = static_cast<std::int8_t>(-type);
       return true;
     }},
    {"all types turned",
     [](Certificate& c, Random&) {
       for (auto& p : c.face_points) p.type = static_cast<std::int8_t>(-p.type);
       std::swap(c.linear, c.planar);
       return true;
     }},
    {"box moved",
     [](Certificate& c, Random& r) {
       auto& p = any_of(c.face_points, r);
       const auto k = static_cast<std::size_t>(r() % 2);
       const double width = p.high[k] - p.low[k];
       p.low[k] += width, p.high[k] += width;
       return true;
     }},
    {"box of all",
     [](Certificate& c, Random& r) {
       auto& p = any_of(c.face_points, r);
       p.low = {0, 0}, p.high = {1, 1};
       return true;
     }},
    {"box of nothing",
     [](Certificate& c, Random& r) {
       auto& p = any_of(c.face_points, r);
       p.low[r() % 2] = std::array{HUGE_VAL, -HUGE_VAL, std::nan("")}[r() % 3];
       return true;
     }},
    {"arc dropped",
     [](Certificate& c, Random& r) {
       c.arcs.erase(c.arcs.begin() + static_cast<std::ptrdiff_t>(r() % c.arcs.size()));
       return true;
     }},
    {"arc elsewhere",
     [](Certificate& c, Random& r) {
       auto& tet = any_of(c.arcs, r).tet;
       const auto before = tet;
       tet = static_cast<std::uint32_t>(r() % c.tets.size());
       return tet != before;
     }},
    {"arcs exchanged",
     [](Certificate& c, Random& r) {
       if (c.arcs.size() < 2) return false;
       const auto at = 1 + static_cast<std::size_t>(r() % (c.arcs.size() - 1));
       if (c.arcs[at].tet != c.arcs[at - 1].tet) return false;
       std::swap(c.arcs[at].points[1], c.arcs[at - 1].points[1]);
       return true;
     }},
    {"point dropped, with its arcs",
     [](Certificate& c, Random& r) {
       const auto at = static_cast<std::uint32_t>(r() % c.face_points.size());
       c.face_points.erase(c.face_points.begin() + at);
       std::erase_if(c.arcs, [&](const auto& a) { return a.points[0] == at || a.points[1] == at; });
       for (auto& arc : c.arcs)
         for (auto& p : arc.points) p -= p > at;
       return true;
     }},
    {"points exchanged",
     [](Certificate& c, Random& r) {
       const auto at = static_cast<std::size_t>(r() % (c.face_points.size() - 1));
       std::swap(c.face_points[at].low, c.face_points[at + 1].low);
       std::swap(c.face_points[at].high, c.face_points[at + 1].high);
       return true;
     }},
    {"all forgotten",
     [](Certificate& c, Random&) {
       c.faces.clear(), c.face_points.clear(), c.arcs.clear();
       c.linear = c.planar = {};
       return true;
     }},
    {"tetrahedron said to be special",
     [](Certificate& c, Random& r) {
       const auto t = any_of(c.arcs, r).tet;
       if (std::ranges::binary_search(c.special_tets, t)) return false;
       c.special_tets.insert(std::ranges::lower_bound(c.special_tets, t), t);
       if (r() % 2) std::erase_if(c.arcs, [&](const auto& a) { return a.tet == t; });
       return true;
     }},
    {"face exchanged for another",
     [](Certificate& c, Random& r) {
       auto& face = any_of(c.faces, r);
       const auto before = face;
       auto tet = any_of(c.tets, r);
       std::ranges::sort(tet);
       face = {tet[0], tet[1], tet[2]};
       return face != before;
     }},
    {"face without points",
     [](Certificate& c, Random& r) {
       auto tet = any_of(c.tets, r);
       std::ranges::sort(tet);
       const std::array<std::uint32_t, 3> face = {tet[0], tet[1], tet[2]};
       const auto at = std::ranges::lower_bound(c.faces, face);
       if (at != c.faces.end() && *at == face) return false;
       const auto place = static_cast<std::uint32_t>(at - c.faces.begin());
       c.faces.insert(at, face);
       for (auto& p : c.face_points) p.face += p.face >= place;
       return true;
     }},
    {"face of a point",
     [](Certificate& c, Random& r) {
       auto& face = any_of(c.face_points, r).face;
       const auto before = face;
       face = static_cast<std::uint32_t>(r() % c.faces.size());
       return face != before;
     }},
    {"point doubled",
     [](Certificate& c, Random& r) {
       const auto at = static_cast<std::uint32_t>(r() % c.face_points.size());
       c.face_points.insert(c.face_points.begin() + at, c.face_points[at]);
       for (auto& arc : c.arcs)
         for (auto& p : arc.points) p += p > at;
       return true;
     }},
    {"point of an arc",
     [](Certificate& c, Random& r) {
       auto& points = any_of(c.arcs, r).points;
       const auto before = points;
       points[r() % 2] = static_cast<std::uint32_t>(r() % (c.face_points.size() + 2));
       return points != before;
     }},
    {"arc doubled",
     [](Certificate& c, Random& r) {
       const auto at = static_cast<std::ptrdiff_t>(r() % c.arcs.size());
       c.arcs.insert(c.arcs.begin() + at, c.arcs[static_cast<std::size_t>(at)]);
       return true;
     }},
    {"face said to be special",
     [](Certificate& c, Random& r) {
       // Of a special tetrahedron or not, with points or not.
       auto tet = any_of(c.tets, r);
       std::ranges::sort(tet);
       const std::array<std::uint32_t, 3> face = {tet[0], tet[1], tet[2]};
       const auto at = std::ranges::lower_bound(c.special_faces, face);
       if (at != c.special_faces.end() && *at == face) return false;
       c.special_faces.insert(at, face);
       return true;
     }},
    {"face and its tetrahedra said to be special",
     [](Certificate& c, Random& r) {
       auto tet = any_of(c.tets, r);
       std::ranges::sort(tet);
       const std::array<std::uint32_t, 3> face = {tet[0], tet[1], tet[2]};
       if (std::ranges::binary_search(c.faces, face)) return false;
       const auto at = std::ranges::lower_bound(c.special_faces, face);
       if (at != c.special_faces.end() && *at == face) return false;
       c.special_faces.insert(at, face);
       for (std::uint32_t t = 0; t < c.tets.size(); ++t) {
         auto corners = c.tets[t];
         std::ranges::sort(corners);
         if (!std::ranges::includes(corners, face)) continue;
         const auto place = std::ranges::lower_bound(c.special_tets, t);
         if (place == c.special_tets.end() || *place != t) c.special_tets.insert(place, t);
         std::erase_if(c.arcs, [&](const auto& a) { return a.tet == t; });
       }
       std::tie(c.linear, c.planar) = recount(c, c.arcs, c.special_tets);
       return true;
     }},
    {"tetrahedron said to be special, and counted so",
     [](Certificate& c, Random& r) {
       const auto t = any_of(c.arcs, r).tet;
       if (std::ranges::binary_search(c.special_tets, t)) return false;
       c.special_tets.insert(std::ranges::lower_bound(c.special_tets, t), t);
       std::erase_if(c.arcs, [&](const auto& a) { return a.tet == t; });
       std::tie(c.linear, c.planar) = recount(c, c.arcs, c.special_tets);
       if (r() % 2) --c.linear.touched;  // and wrongly
       return true;
     }},
    {"one special tetrahedron forgotten",
     [](Certificate& c, Random& r) {
       if (c.special_tets.empty()) return false;
       c.special_tets.erase(c.special_tets.begin() +
                            static_cast<std::ptrdiff_t>(r() % c.special_tets.size()));
       return true;
     }},
    {"one special face forgotten",
     [](Certificate& c, Random& r) {
       if (c.special_faces.empty()) return false;
       c.special_faces.erase(c.special_faces.begin() +
                             static_cast<std::ptrdiff_t>(r() % c.special_faces.size()));
       return true;
     }},
    {"edge said to be degenerate",
     [](Certificate& c, Random& r) {
       auto tet = any_of(c.tets, r);
       std::ranges::sort(tet);
       c.degenerate_edges = {{tet[r() % 2], tet[2 + r() % 2]}};
       return true;
     }},
    {"face said to be in a plane",
     [](Certificate& c, Random& r) {
       if (c.special_faces.empty()) return false;
       c.plane_faces = {any_of(c.special_faces, r)};
       return true;
     }},
    {"special places forgotten",
     [](Certificate& c, Random& r) {
       if (c.special_tets.empty()) return false;
       if (r() % 2) c.special_tets.clear();
       c.special_faces.clear();
       return true;
     }},
};

std::vector<Certificate> originals() {
  Random random(kSeed);
  std::vector<Certificate> all;
  for (const std::size_t f : {0U, 5U}) all.push_back(produced(grid(1, -2, 2, kReferenceFields[f])));
  all.push_back(produced(random_grid(2, random, 0)));
  all.push_back(produced(random_grid(2, random, 6)));
  for (auto& c : all) {
    require_accepted(c);
    REQUIRE(c.face_points.size() > 2);
    REQUIRE(!c.arcs.empty());
  }
  // An edge of degenerate tensors, its places special.
  Certificate named = all[2];
  const auto axis = std::array<double, 6>{-1, -1, 2, 0, 0, 0};
  auto tet = named.tets[0];
  std::ranges::sort(tet);
  for (const std::size_t k : {0U, 1U})
    for (std::size_t i = 0; i < 6; ++i)
      named.tensors[tet[k]][i] = static_cast<double>(k + 1) * axis[i];
  named = produced({named.points, named.tets, named.tensors});
  named.degenerate_edges = {{tet[0], tet[1]}};
  require_accepted(named);
  all.push_back(named);
  return all;
}

struct Judge {
  std::uint64_t mutants = 0, accepted = 0, anew = 0;

  /// An accepted mutant must be true. Of the same tensors: its points are those of the original,
  /// but on faces it lists as special, and its counts are those of the original's curves outside
  /// its special tetrahedra. Of others: those of what the producer finds.
  bool operator()(const Certificate& original, const Certificate& mutant) {
    ++mutants;
    if (!verify(encode(mutant)).accepted) return false;
    ++accepted;
    const bool same = original.tets == mutant.tets && original.tensors == mutant.tensors;
    anew += !same;
    check_named(mutant);
    const Certificate truth =
        same ? original : produced({mutant.points, mutant.tets, mutant.tensors});
    // The producer's own, too, must be a certificate, and of as many places.
    if (!std::ranges::includes(mutant.special_tets, truth.special_tets) ||
        !std::ranges::includes(mutant.special_faces, truth.special_faces) ||
        !verify(encode(truth)).accepted) {
      ++not_known;
      CHECK((!same || fewer_places(truth, mutant)));
      return true;
    }
    CHECK(mutant.faces == truth.faces);
    CHECK(types(mutant) == types(truth));
    const auto [linear, planar] = recount(truth, truth.arcs, mutant.special_tets);
    CHECK(counts(mutant.linear) == counts(linear));
    CHECK(counts(mutant.planar) == counts(planar));
    return true;
  }

 private:
  static std::vector<int> types(const Certificate& c) {
    std::vector<int> list;
    for (const auto& p : c.face_points) list.push_back(p.type);
    return list;
  }
  /// Special places given up have no points and no arcs: what the checker proves and the producer
  /// did not need to. Then the curves are the same.
  static bool fewer_places(const Certificate& truth, const Certificate& mutant) {
    return mutant.face_points.size() == truth.face_points.size() &&
           mutant.arcs.size() == truth.arcs.size();
  }
  /// By eigenvalues in doubles.
  static void check_named(const Certificate& c) {
    for (const auto& [a, b] : c.degenerate_edges)
      for (const double t : {0.0, 0.3, 0.5, 0.8, 1.0}) {
        std::array<double, 6> d{};
        for (std::size_t k = 0; k < 6; ++k) d[k] = (1 - t) * c.tensors[a][k] + t * c.tensors[b][k];
        const double third = (d[0] + d[1] + d[2]) / 3;
        for (std::size_t k = 0; k < 3; ++k) d[k] -= third;
        const double square =
            d[0] * d[0] + d[1] * d[1] + d[2] * d[2] + 2 * (d[3] * d[3] + d[4] * d[4] + d[5] * d[5]);
        const double det = d[0] * (d[1] * d[2] - d[4] * d[4]) - d[3] * (d[3] * d[2] - d[4] * d[5]) +
                           d[5] * (d[3] * d[4] - d[1] * d[5]);
        CHECK(54 * det * det == Approx(square * square * square));
      }
  }

 public:
  std::uint64_t not_known = 0;
};

}  // namespace

TEST_CASE("modes-curves: edited records are rejected unless true") {
  Random random(kSeed);
  Judge judge;
  std::map<std::string, std::array<std::uint64_t, 2>> kinds;
  for (const auto& original : originals())
    for (const auto& [kind, edit] : kEdits)
      for (std::uint64_t i = 0; i < scaled(2); ++i) {
        Certificate mutant = original;
        if (!edit(mutant, random)) continue;
        CAPTURE(kind);
        ++kinds[kind][0];
        kinds[kind][1] += judge(original, mutant);
      }
  for (const auto& [kind, edit] : kEdits) {
    CAPTURE(kind);
    const auto [made, accepted] = kinds[kind];
    std::cout << kind << ": " << made << " mutants, " << accepted << " accepted\n";
    CHECK(made > 0);
    static const std::set<std::string> may_be_true = {
        "box of all",
        "tetrahedron said to be special, and counted so",
        "face and its tetrahedra said to be special",
        "one special tetrahedron forgotten",
        "one special face forgotten",
        "special places forgotten",
        "face said to be special",
        "edge said to be degenerate",
        "face said to be in a plane"};
    if (!may_be_true.contains(kind)) CHECK(accepted == 0);
  }
}

TEST_CASE("modes-curves: edited bytes, bound again, are rejected unless true") {
  Random random(kSeed);
  Judge judge;
  for (const auto& original : originals()) {
    try_bytes(encode(original), scaled(32), random, decode_modes_curves,
              [&](const Certificate& mutant) { judge(original, mutant); });
  }
  std::cout << "bytes: " << judge.mutants << " mutants, " << judge.accepted << " accepted, "
            << judge.anew << " of them made anew, " << judge.not_known
            << " with fewer special places than the producer's\n";
  CHECK(judge.mutants > 80);
}
