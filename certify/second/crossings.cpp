// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/second/crossings.hpp"

#include <cmath>

namespace crest::recheck {
namespace {

constexpr int kTurning = 3;

Barycentric on_side(Index k, double t) {
  Barycentric l{};
  l[k] = 1 - t;
  l[(k + 1) % 3] = t;
  return l;
}

}  // namespace

double Crossings::parameter() {
  const double t = in_.f64();
  if (t < 0 || t > 1 || std::ldexp(t, 50) != std::floor(std::ldexp(t, 50)))
    in_.fail("a point of an edge is no multiple of 2^-50 in [0, 1]");
  return t;
}
int Crossings::sign_at(Index side, double t, std::size_t colour) const {
  return sampler_.signs_at(on_side(side, t), outcome_.c, 1U << colour)[colour];
}

void Crossings::type(std::size_t j, bool by_turn) {
  std::vector<int> signs;
  bool any_loose = false, any = false;
  for (Index k = 0; k < 3; ++k) {
    any_loose = any_loose || loose_[j][k];
    if (!outcome_.crossed(j, k)) continue;
    any = true;
    if (record_.type[j] != 0 && by_turn) signs.push_back(growth(j, k));
  }
  if (any != (record_.type[j] != 0)) in_.fail("a type without crossed edges, or none");
  if (!any) return;
  if (!by_turn) {
    if (record_.type[j] == kTurning) in_.fail("a turning point is shown by growth");
    return;
  }
  if (any_loose) in_.fail("a type at a loose corner is shown by turn");
  const int elliptic = j == 0 ? -1 : 1;
  const int found = signs[0] != signs[1]   ? kTurning
                    : signs[0] == elliptic ? kElliptic
                                           : kHyperbolic;
  if (found != record_.type[j]) in_.fail("the type is " + std::to_string(found));
}
int Crossings::growth(std::size_t j, Index k) {
  const double t0 = parameter(), t1 = parameter();
  if (t0 >= t1) in_.fail("the part of an edge around a crossing is empty");
  if (sign_at(k, t0, j) != outcome_.sign[j][k] ||
      sign_at(k, t1, j) != outcome_.sign[j][(k + 1) % 3])
    in_.fail("a crossing is not in the part of the edge that is said");
  int sign = 0;
  shown<Piece>(Piece::segment(on_side(k, t0), on_side(k, t1)), kFurther, [&](const Piece& p) {
    const Scope scope;
    context.order = 4;
    sign = sampler_.forms(p, outcome_.c, 1, 1U << j).growth[j].sign();
    require(sign != 0, "the type: G_j at a crossing");
  });
  return sign;
}

void Crossings::purple(bool by_cross) {
  if (!by_cross) {
    if (record_.purple) in_.fail("a purple point is shown by a combination, or without crossings");
    return;
  }
  std::vector<int> red;  // the sign of E2 at the blue crossings
  for (Index k = 0; k < 3; ++k) {
    if (loose_[0][k] || loose_[1][k]) in_.fail("purple at a loose corner is shown by cross");
    if (!outcome_.crossed(0, k)) continue;
    int sign = outcome_.sign[1][k];
    if (outcome_.crossed(1, k)) {
      const double t = parameter();
      if (t == 0 || t == 1) in_.fail("the point between two crossings is a corner");
      const bool blue = sign_at(k, t, 0) != outcome_.sign[0][k];
      if (blue == (sign_at(k, t, 1) != sign))
        in_.fail("a point does not separate the crossings of its edge");
      if (!blue) sign = -sign;
    }
    red.push_back(sign);
  }
  if (record_.purple != (red[0] != red[1])) in_.fail("the bit of the purple point is wrong");
}

namespace {

/// At a loose corner the true sign of E_j may be another than the one it counts as, and the arc
/// may run through a face at the corner in which it is not drawn: there, too, it is of its type.
void show_undrawn(const Problem& problem, Index face, int c, std::size_t j, int type) {
  const Sampler sampler(problem, face);
  const int expected = type == (j == 0 ? kElliptic : kHyperbolic) ? -1 : 1;
  shown<Piece>(Piece::face(), kFurther, [&](const Piece& p) {
    const Scope scope;
    context.order = 5;
    require(sampler.forms(p, c, 1, 1U << j).growth[j].sign() == expected,
            "a loose corner: the type in the faces around it");
  });
}

/// The conditions of a loose corner that several faces share.
void check_loose(const Problem& problem, const LooseCorners& loose, std::size_t j,
                 std::uint32_t vertex, const std::vector<FaceOutcome>& outcomes) {
  const Certificate& c = problem.certificate;
  const auto demand = [](bool holds) {
    if (!holds) throw Rejected("the conditions of a loose corner do not hold");
  };
  const FaceRecord* first = nullptr;
  std::vector<int> slopes, ends;
  std::vector<Index> undrawn;
  int opposite_crossed = 0, type = 0, number = 0;
  for (Index f = 0; f < c.faces.size(); ++f)
    for (Index k = 0; k < 3; ++k) {
      if (c.faces[f][k] != vertex) continue;
      const FaceRecord& r = c.records[f];
      if (first == nullptr) first = &r;
      demand(!r.in_patch && r.w == first->w && r.verdict[j] == first->verdict[j] &&
             r.verdict[j] != 255);
      for (const std::size_t colour : {0U, 1U})
        demand(!loose.at(colour, c.faces[f][(k + 1) % 3]) &&
               !loose.at(colour, c.faces[f][(k + 2) % 3]));
      ++number;
      opposite_crossed += outcomes[f].crossed(j, (k + 1) % 3) ? 1 : 0;
      if (r.type[j] == 0) {
        undrawn.push_back(f);
        demand(r.type[1 - j] == 0);
      } else {
        demand(type == 0 || type == r.type[j]);
        type = r.type[j];
      }
      for (const Index side : {k, (k + 2) % 3}) {
        if (problem.complex.edges[problem.complex.edge_of[f][side]].faces == 2) continue;
        demand(outcomes[f].decided[j][side] && outcomes[f].slope[j][side] != 0);
        slopes.push_back(outcomes[f].slope[j][side]);
        ends.push_back(outcomes[f].sign[j][side == k ? (k + 1) % 3 : side]);
      }
    }
  demand(slopes.size() == 2 && slopes[0] == slopes[1] && ends[0] != ends[1] &&
         opposite_crossed == 1 && (number == 1 || !loose.at(1 - j, vertex)));
  for (const Index f : undrawn) show_undrawn(problem, f, outcomes[f].c, j, type);
}

}  // namespace

std::array<std::vector<bool>, 2> crossed_edges(const Problem& problem, const LooseCorners& loose,
                                               const std::vector<FaceOutcome>& outcomes) {
  const Certificate& c = problem.certificate;
  std::array<std::vector<bool>, 2> crossed;
  for (std::size_t j = 0; j < 2; ++j)
    for (const Edge& e : problem.complex.edges) {
      bool decided = problem.complex.interior_to_patch(e), is_crossed = false, none = false;
      for (Index i = 0; i < static_cast<Index>(e.faces); ++i) {
        const Index f = e.face[i], side = e.side[i];
        if (c.records[f].in_patch) continue;
        none = none || c.records[f].verdict[j] == 255;
        decided = decided || none || outcomes[f].decided[j][side];
        is_crossed = is_crossed || outcomes[f].crossed(j, side);
        // Its other edges at a loose corner need no decision.
        for (const Index k : {side, (side + 1) % 3})
          decided = decided || (e.faces == 2 && loose.at(j, c.faces[f][k]));
      }
      if (!decided || (none && is_crossed))
        throw Rejected("face " + std::to_string(e.face[0]) + ": edge " + std::to_string(e.side[0]) +
                       " is not decided" + (j == 0 ? " for blue" : " for red"));
      crossed[j].push_back(is_crossed);
    }
  for (std::size_t j = 0; j < 2; ++j)
    for (const std::uint32_t vertex : loose.of(j)) check_loose(problem, loose, j, vertex, outcomes);
  return crossed;
}

}  // namespace crest::recheck
