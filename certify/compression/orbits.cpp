// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/compression/orbits.hpp"

#include <algorithm>
#include <span>

#include "certify/container/reject.hpp"

namespace crest::certify::compression {
namespace {

/// Drops repetitions: one period stays.
void shorten(std::vector<Cell>& cells) {
  const std::size_t n = cells.size();
  for (std::size_t period = 1; period < n; ++period) {
    if (n % period != 0 || !std::equal(cells.begin() + static_cast<std::ptrdiff_t>(period),
                                       cells.end(), cells.begin()))
      continue;
    return cells.resize(period);
  }
}

/// What a closed orbit of the chain has inside.
class Inside {
 public:
  Inside(const Proof& proof, Orbit& orbit, Comparison& comparison, SignLadder& sign)
      : proof_(proof), domain_(proof.domain), orbit_(orbit), comparison_(comparison), sign_(sign) {}

  void find() {
    sort_cells();
    mark_crossings();
    label_fans();
    const Cell& first = orbit_.chain.cells[0];
    orbit_.counter_clockwise =
        inside(domain_.fan[first.name]) != ((crossings_before_first() & 1U) != 0);
    for (u32 f = 0; f < label_.size(); ++f) orbit_.vertices += inside(f);
    for (u32 i = 0; i < domain_.loops.size(); ++i)
      if (inside(domain_.fan[domain_.loops[i][0]])) orbit_.loops.push_back(i);
    for (u32 k = 0; k < proof_.zeros.components.size(); ++k)
      if (const Component& zero = proof_.zeros.components[k];
          !zero.on_boundary && has_inside(zero.stated))  // else its loops tell
        orbit_.zeros.push_back(k);
  }

 private:
  static constexpr u8 kElsewhere = 2;

  bool backward() const { return orbit_.chain.backward; }
  bool inside(u32 fan) const { return label_[fan] != kElsewhere && label_[fan] != outside_; }

  /// Cells by the sides through which they are entered, so that a zero costs those of its triangle.
  void sort_cells() {
    for (std::size_t k = 0; k < orbit_.chain.cells.size(); ++k)
      by_side_.push_back({orbit_.chain.cells[k].name, k});
    std::sort(by_side_.begin(), by_side_.end());
  }
  /// Those entered through sides from `first` on, before `last`.
  std::span<const std::pair<u32, std::size_t>> cells_at(u32 first, u32 last) const {
    const auto from =
        std::lower_bound(by_side_.begin(), by_side_.end(), std::pair{first, std::size_t{0}});
    const auto to = std::lower_bound(from, by_side_.end(), std::pair{last, std::size_t{0}});
    return std::span(by_side_).subspan(static_cast<std::size_t>(from - by_side_.begin()),
                                       static_cast<std::size_t>(to - from));
  }

  void mark_crossings() {
    odd_.assign(domain_.twin.size(), 0);
    for (const Cell& cell : orbit_.chain.cells) {
      odd_[cell.name] ^= 1U;
      odd_[domain_.twin[cell.name]] ^= 1U;
    }
  }

  /// 0 or 1 by the parity of crossings, over the orbit's part of the domain; a vertex with the
  /// least position is outside.
  void label_fans() {
    label_.assign(domain_.open.size(), kElsewhere);
    std::vector<u32> left = {domain_.fan[orbit_.chain.cells[0].name]};
    label_[left[0]] = 0;
    const Pair* least = nullptr;
    const auto reach = [&](u32 corner, u32 label) {
      const u32 fan = domain_.fan[corner];
      if (label_[fan] != kElsewhere) return;
      label_[fan] = static_cast<u8>(label);
      left.push_back(fan);
    };
    while (!left.empty()) {
      const u32 fan = left.back();
      left.pop_back();
      const auto corners = domain_.corners_of(fan);
      const Pair& p = proof_.field.position(corners[0]);
      if (least == nullptr || p < *least) {
        least = &p;
        outside_ = label_[fan];
      }
      for (const u32 c : corners) {
        reach(next_corner(c), label_[fan] ^ odd_[c]);
        reach(previous_corner(c), label_[fan] ^ odd_[previous_corner(c)]);
      }
    }
  }

  /// Crossings of the first cell's side between its tail and this one.
  std::size_t crossings_before_first() {
    const auto& cells = orbit_.chain.cells;
    const u32 side = cells[0].name, twin = domain_.twin[side];
    const bool at_tail = comparison_.enters_at_tail(side, backward());
    std::size_t count = 0;
    for (std::size_t k = 1; k < cells.size(); ++k) {
      if (cells[k].name == twin) count += !at_tail;
      if (cells[k].name == side) count += is_left(k, 0);
    }
    return count;
  }
  /// Of two crossings of one side in the same direction.
  bool is_left(std::size_t i, std::size_t j) {
    const std::size_t n = orbit_.chain.cells.size();
    for (std::size_t steps = 0; steps < n; ++steps) {
      i = (i + n - 1) % n;
      j = (j + n - 1) % n;
      if (const auto order = comparison_.compare_cells(orbit_.chain, i, orbit_.chain, j))
        return *order == Order::left;
    }
    throw Reject("an orbit's chain repeats itself");
  }

  bool has_inside(const SkeletonZero& zero) {
    const u32 c = 3 * zero.triangle;
    if (label_[domain_.fan[c]] == kElsewhere) return false;
    if (zero.place == ZeroPlace::triangle)
      return inside(domain_.fan[c]) != ((arcs_between(c) & 1U) != 0);
    for (const u32 k : {c, c + 1, c + 2})
      if (is_zero(proof_.field.vector(k))) return inside(domain_.fan[k]);
    for (const u32 side : {c, c + 1, c + 2})
      if (has_edge_zero(proof_.field, side, sign_))
        return inside(domain_.fan[side]) != ((crossings_at_tail(side) & 1U) != 0);
    throw Reject("a zero that is nowhere");
  }
  /// Crossings between the tail of a side and the zero in it.
  std::size_t crossings_at_tail(u32 side) {
    const u32 wanted = comparison_.enters_at_tail(side, backward()) ? side : domain_.twin[side];
    return cells_at(wanted, wanted + 1).size();
  }
  /// Arcs in a triangle that separate its corner 0 from the zero inside.
  std::size_t arcs_between(u32 corner) {
    std::size_t count = 0;
    const auto& cells = orbit_.chain.cells;
    for (const auto& [side, k] : cells_at(corner, corner + 3)) {
      // Corner 0 is at the left if it is met between the exit and the entry.
      const u32 entry = side % 3, exit = cells[k].exit % 3;
      const bool left = entry == exit ? comparison_.enters_at_tail(side, backward()) : entry < exit;
      count += left != (comparison_.swirl(orbit_.chain, k) == Sign::positive);
    }
    return count;
  }

  const Proof& proof_;
  const Domain& domain_;
  Orbit& orbit_;
  Comparison& comparison_;
  SignLadder& sign_;
  std::vector<std::pair<u32, std::size_t>> by_side_;
  std::vector<u8> odd_, label_;
  u8 outside_ = 0;
};

/// Of two orbits around the same, whether the first is inside the second.
bool is_inner(const Proof& proof, const std::vector<Orbit>& orbits, u32 a, u32 b) {
  const Orbit &first = orbits[a], &second = orbits[b];
  if (first.vertices != second.vertices) return first.vertices < second.vertices;
  const SkeletonOrbit &p = proof.stated.orbits[a], &q = proof.stated.orbits[b];
  require(first.chain.cells == second.chain.cells && p.backward == q.backward,
          "orbits {} and {} go around the same: which is inside is not known", a, b);
  const bool left = before(p.right, q.left), right = before(q.right, p.left);
  require(left != right, "orbits {} and {} may be one", a, b);
  return left == first.counter_clockwise;
}

void rank(const Proof& proof, std::vector<Orbit>& orbits) {
  std::vector<u32> order(orbits.size());
  for (u32 i = 0; i < order.size(); ++i) order[i] = i;
  const auto around = [&](u32 i) { return std::tie(orbits[i].zeros, orbits[i].loops); };
  std::stable_sort(order.begin(), order.end(), [&](u32 a, u32 b) {
    if (around(a) != around(b)) return around(a) < around(b);
    return a != b && is_inner(proof, orbits, a, b);
  });
  for (std::size_t i = 1; i < order.size(); ++i)
    if (around(order[i]) == around(order[i - 1]))
      orbits[order[i]].rank = orbits[order[i - 1]].rank + 1;
}

}  // namespace

std::vector<Orbit> find_orbits(const Proof& proof, SignLadder& sign) {
  const std::size_t count = proof.stated.orbits.size();
  require(count <= (std::size_t{1} << 31U) / proof.field.corners(), "too many orbits");
  Comparison comparison(proof, sign);
  std::vector<Orbit> orbits(count);
  for (u32 i = 0; i < count; ++i) {
    orbits[i].chain = chain_of(proof, i);
    shorten(orbits[i].chain.cells);
    Inside(proof, orbits[i], comparison, sign).find();
  }
  rank(proof, orbits);
  return orbits;
}

Tail tail_of(Comparison& comparison, const Path& path, const Orbit& orbit) {
  const std::size_t n = orbit.chain.cells.size();
  std::size_t i = path.cells.size() - 1, cells = 0;
  for (;; --i, ++cells) {
    const auto order = comparison.compare_cells(path, i, orbit.chain, (2 * n - 1 - cells % n) % n);
    if (!order) continue;
    require(*order != Order::same, "a line that is the orbit in which it ends");
    return {*order == Order::left, cells % n, i};
  }
}

}  // namespace crest::certify::compression
