// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/vector_fields/annulus.hpp"

#include <algorithm>
#include <cmath>

namespace crest::vector_fields {

namespace {

constexpr std::size_t kMostFruitless = 12;  ///< returns to the same place without an annulus
constexpr double kSettled = 0x1p-40;        ///< of a side: so near is the same place

bool overlaps(const Gate<double>& a, const Gate<double>& b) {
  return nearer_to_tail(a.left, b.right) && nearer_to_tail(b.left, a.right);
}

}  // namespace

bool overlaps(const Annulus& a, bool forward, const PassedGate& gate) {
  return a.side == gate.side && a.forward == forward &&
         overlaps(Gate<double>{gate.side, gate.left, gate.right},
                  Gate<double>{a.side, a.left, a.right});
}

bool AnnulusSearch::hopeless() const {
  return fruitless_ > kMostFruitless;
}

bool AnnulusSearch::visit(bool forward, HalfEdge side, double place, std::size_t turns) {
  std::vector<Visit>& seen = visits_[side];
  seen.push_back({place, turns});
  const std::size_t n = seen.size();
  if (n < 3 || turns < next_try_) return false;
  const double a = seen[n - 2].place - seen[n - 3].place;
  const double b = seen[n - 1].place - seen[n - 2].place;
  const bool settled = std::fabs(b) < kSettled;
  if (!settled && !(b / a > 0 && b / a < 1)) return false;
  const std::size_t period = seen[n - 1].turns - seen[n - 2].turns;
  next_try_ = turns + period / 4 + 1;
  most_turns_ = 2 * period + 16;
  if (settled) {
    for (const double radius : {0x1p-24, 0x1p-17, 0x1p-30, 0x1p-10})
      if (try_between(forward, side, place - radius, place + radius)) return true;
    ++fruitless_;
    return false;
  }
  // Geometric convergence tells the limit.
  const double ahead = b * (b / a) / (1 - b / a);
  for (const double reach : {1.0, 4.0, 0.25}) {
    const double far = place + ahead * (1 + reach), near = place - ahead * reach * 0x1p-4;
    if (try_between(forward, side, std::min(near, far), std::max(near, far))) return true;
  }
  return false;
}

/// Whether the way through a gate leads into an annulus that was found, or around it.
bool AnnulusSearch::known(bool forward, const Gate<double>& gate) {
  notes_.asked.push_back({gate.side, 0, gate.left, gate.right, 0});
  for (std::size_t i = 0; i < notes_.size(); ++i)
    if (overlaps(notes_[i], forward, notes_.asked.back())) return true;
  return false;
}

/// Between two shares of the side, once around.
bool AnnulusSearch::try_between(bool forward, HalfEdge side, double low, double high) {
  if (!(low > 0 && high < 1 && low < high)) return false;
  const auto coordinate = [](double x) { return x <= 0.5 ? x : x - 1; };
  const Gate<double> door{side, coordinate(low), coordinate(high)};
  Annulus found;
  found.setting = maker_.setting();
  found.forward = forward;
  found.side = side;
  found.left = door.left;
  found.right = door.right;
  Gate<double> at = door;
  while (found.turns.size() < most_turns_) {
    found.line.push_back(place_on(around_.domain, at.side, near_middle(at)));
    const auto cell = cross_cell(maker_, forward, at, around_.trap_in(at.side / 3, forward));
    if (cell.end != CellEnd::crossed) return false;
    if (cell.special)
      found.special.push_back({static_cast<Index>(found.turns.size()), cell.setting});
    found.turns.push_back(cell.turn);
    at = cell.gate;
    if (known(forward, at)) return false;
    if (at.side != door.side) continue;
    if (strictly_inside(at, door)) {
      found.back_left = at.left;
      found.back_right = at.right;
      notes_.found.push_back(std::move(found));
      return true;
    }
    if (overlaps(at, door)) return false;
  }
  return false;
}

}  // namespace crest::vector_fields
