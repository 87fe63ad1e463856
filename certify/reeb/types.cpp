// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "certify/container/reject.hpp"
#include "certify/reeb/checks.hpp"

namespace crest::certify::reeb {
namespace {

/// A tile's nodes by rank.
struct Sorted {
  u32 low, middle, high;
};
/// Without a branch: in noise every comparison is a coin's toss.
Sorted sorted(const Corners& tile, const Buffer<u32>& rank) {
  static constexpr std::uint8_t kOrders[8][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {0, 1, 2},
                                                 {2, 1, 0}, {2, 0, 1}, {1, 2, 0}, {0, 1, 2}};
  const u32 a = rank[tile[0]], b = rank[tile[1]], c = rank[tile[2]];
  const auto& [low, middle, high] =
      kOrders[unsigned{a < b} | unsigned{b < c} << 1U | unsigned{c < a} << 2U];
  return {tile[low], tile[middle], tile[high]};
}

/// A tile is where its middle node's link leads from a lower to an upper node.
void read_tiles(const Complex& k, Buffer<NodeTypes::Node>& nodes) {
  for (const auto& tile : k.tiles()) {
    const auto [low, middle, high] = sorted(tile, k.rank);
    nodes[low].up = high;
    nodes[high].down = low;
    auto& node = nodes[middle];
    ++node.transitions;
    node.down = low;
    node.up = high;
  }
}

void read_boundary(const Complex& k, Buffer<NodeTypes::Node>& nodes) {
  const auto edge = [&](u32 a, u32 b) {
    if (k.rank[a] > k.rank[b]) std::swap(a, b);
    nodes[a].ends |= 4;
    nodes[b].ends = (nodes[b].ends | 4) + 1;
  };
  for (u32 side = 0; side < k.mesh.twin.size(); ++side) {
    if (k.mesh.twin[side] != kNone) continue;
    const u32 a = vertex_of(k.faces, side), b = vertex_of(k.faces, next_corner(side));
    const u32 between = k.line_node(side);
    if (between == kNone) {
      edge(a, b);
    } else {
      edge(a, between);
      edge(between, b);
    }
  }
}

/// Counts, and where each critical node's neighbours go: at start[v + 1], which then moves on.
void classify(const ReebContents& c, NodeTypes& out) {
  const auto size = static_cast<u32>(out.nodes.size());
  out.start.resize(size + 1);
  out.start[0] = 0;
  std::uint64_t total = 0;
  std::int64_t index_sum = 0;
  for (u32 v = 0; v < size; ++v) {
    const auto& node = out.nodes[v];
    out.start[v + 1] = static_cast<u32>(total);
    const auto [l, u] = runs_of(node);
    if (l == 1 && u == 1) continue;
    total += std::max(u32{1}, node.transitions);
    const u32 multiplicity = l == 0 || u == 0 ? 0 : std::max(l, u) - 1;
    out.minima += l == 0;
    out.maxima += u == 0;
    out.saddles += multiplicity;
    out.simple = out.simple && multiplicity <= 1;
    index_sum += index_of(node);
  }
  require(total < kNone, "nodes: more runs than the checker numbers");
  out.lower.resize(static_cast<std::size_t>(total));
  out.upper.resize(static_cast<std::size_t>(total));
  // Theorem 5 says so for any data: a difference would be an error of the checker.
  if (index_sum != c.euler_characteristic)
    throw std::logic_error("indices and Euler characteristic contradict theorem 5");
}

/// Every run ends at a transition unless it is the whole link: then any neighbour is in it.
void collect_neighbours(const Complex& k, NodeTypes& out) {
  const auto& nodes = out.nodes;
  const auto add = [&](u32 v, u32 low, u32 high) {
    u32& at = out.start[v + 1];
    out.lower[at] = low;
    out.upper[at++] = high;
  };
  for (const auto& tile : k.tiles()) {
    const auto [low, middle, high] = sorted(tile, k.rank);
    const auto [l, u] = runs_of(nodes[middle]);
    if (l != 1 || u != 1) add(middle, low, high);
  }
  for (u32 v = 0; v < nodes.size(); ++v)
    if (nodes[v].transitions == 0) add(v, nodes[v].down, nodes[v].up);
}

/// The listed nodes are critical and ascend, and there are no others.
void check_list(const ReebContents& c, const Complex& k, const NodeTypes& types) {
  const auto& list = c.critical_nodes;
  for (std::size_t i = 0; i < list.size(); ++i) {
    require(list[i] < k.nodes(), "critical nodes: no node {}", list[i]);
    require(types.critical(list[i]), "node {}: regular and listed", list[i]);
    require(i == 0 || k.rank[list[i - 1]] < k.rank[list[i]], "node {}: listed out of order",
            list[i]);
  }
  std::size_t critical = 0;
  for (u32 v = 0; v < k.nodes(); ++v) critical += types.critical(v);
  if (critical == list.size()) return;
  std::size_t i = 0;
  for (const u32 v : c.order)
    if (types.critical(v))
      require(i < list.size() && list[i++] == v, "node {}: critical and not listed", v);
}

}  // namespace

NodeTypes check_types(const ReebContents& c, const Complex& k) {
  NodeTypes out;
  out.nodes.assign(k.nodes(), {kNone, kNone, 0, 0});
  read_tiles(k, out.nodes);
  read_boundary(k, out.nodes);
  classify(c, out);
  collect_neighbours(k, out);
  check_list(c, k, out);
  require(out.minima == c.minima, "minima: {} stated, {} found", c.minima, out.minima);
  require(out.saddles == c.saddles, "saddles: {} stated, {} found", c.saddles, out.saddles);
  require(out.maxima == c.maxima, "maxima: {} stated, {} found", c.maxima, out.maxima);
  return out;
}

}  // namespace crest::certify::reeb
