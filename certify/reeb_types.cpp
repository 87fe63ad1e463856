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

/// Of every node's link: transitions between lower and upper; at the boundary 4 + the number of
/// lower ends of the path.
struct Links {
  std::vector<u32> transitions;
  std::vector<u8> boundary;
};

Links read_links(const Complex& k, NodeTypes& out) {
  const std::size_t nodes = k.rank.size();
  Links links{std::vector<u32>(nodes, 0), std::vector<u8>(nodes, 0)};
  out.down.assign(nodes, kNone);
  out.up.assign(nodes, kNone);
  for (u32 t = 0; t < k.tiles.size(); ++t) {
    const Middle m = middle_of(k, t);
    const u32 middle = k.node(m.corner);
    // The side that leaves the middle corner leads to the next one.
    const u32 next = k.node(next_corner(m.corner)), previous = k.node(previous_corner(m.corner));
    const bool upwards = m.to_upper == m.corner;
    const u32 low = upwards ? previous : next, high = upwards ? next : previous;
    ++links.transitions[middle];
    out.down[middle] = out.up[low] = m.to_lower;
    out.up[middle] = out.down[high] = m.to_upper;
  }
  for (u32 c = 0; c < k.twin.size(); ++c) {
    if (k.twin[c] != kNone) continue;
    const auto [low, high] = k.ends(c);
    links.boundary[low] |= 4;
    links.boundary[high] = static_cast<u8>((links.boundary[high] | 4) + 1);
  }
  return links;
}

struct Runs {
  u32 lower, upper;
};
/// A cycle with t > 0 transitions has t / 2 runs of each kind, one with none a single run that is
/// all of it. A path has t + 1 runs; l - u is the number of its ends in lower runs, minus 1.
Runs runs_of(const NodeTypes& types, const Links& links, u32 v) {
  const u32 t = links.transitions[v];
  if (links.boundary[v] == 0) {
    if (t > 0) return {t / 2, t / 2};
    return types.down[v] == kNone ? Runs{0, 1} : Runs{1, 0};
  }
  const u32 lower = (t + (links.boundary[v] & 3U)) / 2;
  return {lower, t + 1 - lower};
}

void classify(const Complex& k, const ReebCertificate& c, const Links& links, NodeTypes& out) {
  out.critical_of.assign(k.rank.size(), kNone);
  out.start.assign(1, 0);
  std::int64_t index_sum = 0;
  for (const u32 v : c.order) {
    const auto [l, u] = runs_of(out, links, v);
    if (l == 1 && u == 1) continue;
    const u32 position = static_cast<u32>(out.index.size());
    require(position < c.critical_nodes.size() && c.critical_nodes[position] == v,
            "node {}: critical and not listed in its place", v);
    out.critical_of[v] = position;
    const bool extremum = l == 0 || u == 0;
    const u32 multiplicity = extremum ? 0 : std::max(l, u) - 1;
    const bool whole_cycle = u == 0 && links.boundary[v] == 0;
    out.index.push_back(whole_cycle ? 1 : 1 - static_cast<std::int32_t>(l));
    out.saddle.push_back(!extremum);
    out.minima += l == 0;
    out.maxima += u == 0;
    out.saddles += multiplicity;
    out.simple = out.simple && multiplicity <= 1;
    out.start.push_back(out.start.back() + std::max(u32{1}, links.transitions[v]));
    index_sum += out.index.back();
  }
  require(out.index.size() == c.critical_nodes.size(), "critical nodes: a regular one is listed");
  // Theorem 5 says so for any data: a difference would be an error of the checker.
  if (index_sum != c.euler_characteristic)
    throw std::logic_error("indices and Euler characteristic contradict theorem 5");
}

/// Every run ends at a transition unless it is the whole link: then any side meets it.
void collect_sides(const Complex& k, const ReebCertificate& c, const Links& links, NodeTypes& out) {
  out.lower.assign(out.start.back(), kNone);
  out.upper.assign(out.start.back(), kNone);
  std::vector<u32> fill(out.start.begin(), out.start.end() - 1);
  for (u32 t = 0; t < k.tiles.size(); ++t) {
    const Middle m = middle_of(k, t);
    const u32 position = out.critical_of[k.node(m.corner)];
    if (position == kNone) continue;
    out.lower[fill[position]] = m.to_lower;
    out.upper[fill[position]++] = m.to_upper;
  }
  for (u32 i = 0; i < c.critical_nodes.size(); ++i) {
    const u32 v = c.critical_nodes[i];
    if (links.transitions[v] > 0) continue;
    out.lower[out.start[i]] = out.down[v];
    out.upper[out.start[i]] = out.up[v];
  }
}

}  // namespace

NodeTypes check_types(const ReebCertificate& c, const Complex& k) {
  NodeTypes out;
  const Links links = read_links(k, out);
  classify(k, c, links, out);
  require(out.minima == c.minima, "minima: {} stated, {} found", c.minima, out.minima);
  require(out.saddles == c.saddles, "saddles: {} stated, {} found", c.saddles, out.saddles);
  require(out.maxima == c.maxima, "maxima: {} stated, {} found", c.maxima, out.maxima);
  collect_sides(k, c, links, out);
  return out;
}

}  // namespace crest::certify::reeb
