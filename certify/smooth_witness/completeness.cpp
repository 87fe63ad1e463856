// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes: how F's signs on them are shown; the tree's leaves.
#include <algorithm>

#include "certify/container/reject.hpp"
#include "certify/smooth_witness/loop.hpp"
#include "certify/smooth_witness/parts.hpp"

namespace crest::certify::witness {

using smooth::Box;
using BoxProver = smooth::BoxProver<kernel::Interval>;

bool record_box(BoxProver& prover, const Box& box, const std::array<double, 3>* direction,
                std::uint8_t leaf, int depth, Bytes& out) {
  if (smooth::nonzero(prover.on_box(box, direction))) {
    out.push_back(leaf);
    return true;
  }
  std::size_t longest = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (box.high[i] - box.low[i] > box.high[longest] - box.low[longest]) longest = i;
  const auto halves = box.split(longest);
  if (depth == 0 || !halves) return false;
  out.push_back(static_cast<std::uint8_t>(longest));
  return record_box(prover, (*halves)[0], direction, leaf, depth - 1, out) &&
         record_box(prover, (*halves)[1], direction, leaf, depth - 1, out);
}

namespace {

constexpr int kDepth = 9;

void record_graph_box(BoxProver& prover, GraphBoxRecord& record, std::size_t number) {
  const auto& b = record.box;
  const Box box = {{b[0], b[2], b[4]}, {b[1], b[3], b[5]}};
  Box below = box, above = box;
  below.high[record.axis] = box.low[record.axis];
  above.low[record.axis] = box.high[record.axis];
  std::array<double, 3> axis{};
  axis[record.axis] = 1;
  record.witness.clear();
  if (!record_box(prover, below, nullptr, 3, kDepth, record.witness) ||
      !record_box(prover, above, nullptr, 3, kDepth, record.witness) ||
      !record_box(prover, box, &axis, 3, kDepth, record.witness))
    throw Undecided(fmt::format("graph box {}: signs", number));
}

}  // namespace

void record_completeness(const Claim& claim, RidgesSmoothCertificate& c) {
  std::vector<smooth::TreeLeaf> leaves = smooth::leaves_of(c);
  std::vector<Bytes> divided(leaves.size());
  for_all(
      c.graph_boxes.size() + leaves.size(), [&] { return BoxProver(claim.surface); },
      [&](BoxProver& prover, std::size_t i) {
        if (i < c.graph_boxes.size()) return record_graph_box(prover, c.graph_boxes[i], i);
        i -= c.graph_boxes.size();
        const auto& leaf = leaves[i];
        if (leaf.code == 6) return;
        const auto* direction = smooth::leaf_direction(leaf.code);
        if (!record_box(prover, leaf.cell, direction, leaf.code, kDepth, divided[i]))
          throw Undecided(fmt::format("tree: leaf {}, code {}", i, leaf.code));
      });
  Bytes tree;
  std::size_t next = 0;
  for (std::size_t at = 0; at < c.tree.size(); ++at) {
    if (c.tree[at] < 3) {
      tree.push_back(c.tree[at]);
      continue;
    }
    if (c.tree[at] == 6)
      for (std::size_t k = 0; k < 5; ++k) tree.push_back(c.tree[at + k]);
    else
      for (const std::uint8_t byte : divided[next]) tree.push_back(byte);
    if (c.tree[at] == 6) at += 4;
    ++next;
  }
  c.tree = std::move(tree);
}

}  // namespace crest::certify::witness
