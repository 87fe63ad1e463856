// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "certify/reeb_checks.hpp"
#include "certify/reject.hpp"

namespace crest::certify::reeb {
namespace {

using u8 = std::uint8_t;
using u32 = std::uint32_t;

/// A tile's node of middle rank: its link's edge there leads from a lower to an upper run.
struct Middle {
  u32 corner, to_lower, to_upper;  ///< sides
};
Middle middle_of(const Complex& k, u32 tile) {
  const auto& [a, b, c] = k.tiles[tile];
  const u32 ra = k.rank[a], rb = k.rank[b], rc = k.rank[c];
  const bool ab = ra < rb, bc = rb < rc, ca = rc < ra;
  // The middle corner is the one between two sides that run the same way.
  const u32 i = ab == bc ? 1 : bc == ca ? 2 : 0;
  const bool leaves_upwards = i == 0 ? ab : i == 1 ? bc : ca;
  const u32 corner = 3 * tile + i, next = corner, previous = previous_corner(corner);
  return leaves_upwards ? Middle{corner, previous, next} : Middle{corner, next, previous};
}

/// Of every node: 0 in the interior, 4 + the number of lower ends of its link at the boundary.
using BoundaryEnds = std::vector<u8>;

BoundaryEnds read_links(const Complex& k, NodeTypes& out) {
  out.nodes.resize(k.rank.size());
  for (u32 t = 0; t < k.tiles.size(); ++t) {
    const Middle m = middle_of(k, t);
    // The side of the middle corner's number leaves it, the other one ends there.
    const u32 next = k.node(next_corner(m.corner)), previous = k.node(previous_corner(m.corner));
    const bool upwards = m.to_upper == m.corner;
    auto& middle = out.nodes[k.node(m.corner)];
    ++middle.transitions;
    out.nodes[upwards ? previous : next].up = middle.down = m.to_lower;
    out.nodes[upwards ? next : previous].down = middle.up = m.to_upper;
  }
  BoundaryEnds ends(k.rank.size(), 0);
  for (u32 c = 0; c < k.twin.size(); ++c) {
    if (k.twin[c] != kNone) continue;
    const auto [low, high] = k.ends(c);
    ends[low] |= 4;
    ends[high] = static_cast<u8>((ends[high] | 4) + 1);
  }
  return ends;
}

struct Runs {
  u32 lower, upper;
};
/// A cycle with t > 0 transitions has t / 2 runs of each kind, one with none a single run that is
/// all of it. A path has t + 1 runs; l - u is the number of its ends in lower runs, minus 1.
Runs runs_of(const NodeTypes::Node& node, u8 ends) {
  const u32 t = node.transitions;
  if (ends == 0) {
    if (t > 0) return {t / 2, t / 2};
    return node.down == kNone ? Runs{0, 1} : Runs{1, 0};
  }
  const u32 lower = (t + (ends & 3U)) / 2;
  return {lower, t + 1 - lower};
}

void classify(const ReebCertificate& c, const BoundaryEnds& ends, NodeTypes& out) {
  out.start.assign(1, 0);
  std::int64_t index_sum = 0;
  for (const u32 v : c.order) {
    auto& node = out.nodes[v];
    const auto [l, u] = runs_of(node, ends[v]);
    if (l == 1 && u == 1) continue;
    const u32 position = static_cast<u32>(out.index.size());
    require(position < c.critical_nodes.size() && c.critical_nodes[position] == v,
            "node {}: critical and not listed in its place", v);
    node.critical = position;
    const bool extremum = l == 0 || u == 0;
    const u32 multiplicity = extremum ? 0 : std::max(l, u) - 1;
    const bool whole_cycle = u == 0 && ends[v] == 0;
    out.index.push_back(whole_cycle ? 1 : 1 - static_cast<std::int32_t>(l));
    out.saddle.push_back(!extremum);
    out.minima += l == 0;
    out.maxima += u == 0;
    out.saddles += multiplicity;
    out.simple = out.simple && multiplicity <= 1;
    out.start.push_back(out.start.back() + std::max(u32{1}, node.transitions));
    index_sum += out.index.back();
  }
  require(out.index.size() == c.critical_nodes.size(), "critical nodes: a regular one is listed");
  // Theorem 5 says so for any data: a difference would be an error of the checker.
  if (index_sum != c.euler_characteristic)
    throw std::logic_error("indices and Euler characteristic contradict theorem 5");
}

/// Every run ends at a transition unless it is the whole link: then any side meets it.
void collect_sides(const Complex& k, NodeTypes& out) {
  out.lower.assign(out.start.back(), kNone);
  out.upper.assign(out.start.back(), kNone);
  for (u32 v = 0; v < out.nodes.size(); ++v) {
    const auto& node = out.nodes[v];
    if (node.critical == kNone) continue;
    u32 at = out.start[node.critical];
    if (node.transitions == 0) {
      out.lower[at] = node.down;
      out.upper[at] = node.up;
      continue;
    }
    const u32 start = k.node(node.down) == v ? node.down : next_corner(node.down);
    for_corners_around(k, start, [&](u32 corner) {
      const Middle m = middle_of(k, corner / 3);
      if (m.corner != corner || at == out.start[node.critical + 1]) return false;
      out.lower[at] = m.to_lower;
      out.upper[at++] = m.to_upper;
      return false;
    });
    // The walk has found what the count over all tiles has.
    if (at != out.start[node.critical + 1]) throw std::logic_error("a node's star is not a disk");
  }
}

}  // namespace

NodeTypes check_types(const ReebCertificate& c, const Complex& k) {
  NodeTypes out;
  const BoundaryEnds ends = read_links(k, out);
  classify(c, ends, out);
  require(out.minima == c.minima, "minima: {} stated, {} found", c.minima, out.minima);
  require(out.saddles == c.saddles, "saddles: {} stated, {} found", c.saddles, out.saddles);
  require(out.maxima == c.maxima, "maxima: {} stated, {} found", c.maxima, out.maxima);
  collect_sides(k, out);
  return out;
}

}  // namespace crest::certify::reeb
