// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/ridges_mesh/canonical.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace crest::certify {
namespace {

constexpr std::uint8_t kSegment = 0xc;

void sort_patches(RidgesMeshCertificate& certificate) {
  auto& patches = certificate.patches;
  for (auto& patch : patches) std::sort(patch.faces.begin(), patch.faces.end());
  std::vector<std::uint32_t> order(patches.size()), place(patches.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return patches[a].centre < patches[b].centre; });
  std::vector<PatchRecord> sorted;
  sorted.reserve(patches.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    place[order[i]] = i;
    sorted.push_back(std::move(patches[order[i]]));
  }
  patches = std::move(sorted);
  for (auto& ridge : certificate.ridges)
    for (std::size_t end = 0; end < 2; ++end) {
      if (ridge.end_kind[end] != 1) continue;
      if (ridge.end_patch[end] >= place.size())
        throw std::invalid_argument("a ridge ends at a patch that is not listed");
      ridge.end_patch[end] = place[ridge.end_patch[end]];
    }
}

/// Reverses the nodes; the type of a segment stays with that segment. In a loop the first node
/// stays first.
void reverse(RidgeRecord& ridge, bool loop) {
  auto& nodes = ridge.nodes;
  const std::size_t m = nodes.size();
  std::vector<NodeRecord> out(m);
  for (std::size_t i = 0; i < m; ++i) {
    const std::size_t node = loop ? (m - i) % m : m - 1 - i;
    const std::size_t before = (node + m - 1) % m;
    const int segment = loop || i + 1 < m ? nodes[before].type & kSegment : 0;
    out[i] = {nodes[node].edge,
              static_cast<std::uint8_t>((nodes[node].type & ~kSegment) | segment)};
  }
  nodes = std::move(out);
  std::swap(ridge.end_kind[0], ridge.end_kind[1]);
  std::swap(ridge.end_patch[0], ridge.end_patch[1]);
}

void direct_ridge(RidgeRecord& ridge) {
  auto& nodes = ridge.nodes;
  if (nodes.empty()) throw std::invalid_argument("a ridge without a node");
  if (ridge.flags & 2U) {
    const auto least = std::min_element(nodes.begin(), nodes.end(),
                                        [](auto& a, auto& b) { return a.edge < b.edge; });
    std::rotate(nodes.begin(), least, nodes.end());
    if (nodes.size() > 2 && nodes.back().edge < nodes[1].edge) reverse(ridge, true);
    return;
  }
  const auto end = [&](std::size_t i) { return std::pair(ridge.end_kind[i], ridge.end_patch[i]); };
  const std::uint32_t first = nodes.front().edge, last = nodes.back().edge;
  if (last < first || (first == last && end(1) < end(0))) reverse(ridge, false);
}

}  // namespace

void make_canonical(RidgesMeshCertificate& certificate) {
  auto& indices = certificate.face_indices;
  std::sort(indices.begin(), indices.end(), [](auto& a, auto& b) { return a.face < b.face; });
  sort_patches(certificate);
  std::vector<std::pair<std::uint64_t, std::size_t>> keys;
  for (std::size_t i = 0; i < certificate.ridges.size(); ++i) {
    RidgeRecord& ridge = certificate.ridges[i];
    direct_ridge(ridge);
    std::uint32_t least = ridge.nodes.front().edge;
    for (const auto& node : ridge.nodes) least = std::min(least, node.edge);
    keys.emplace_back((std::uint64_t{ridge.flags & 1U} << 32) | least, i);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<RidgeRecord> sorted;
  sorted.reserve(keys.size());
  for (const auto& [key, i] : keys) sorted.push_back(std::move(certificate.ridges[i]));
  certificate.ridges = std::move(sorted);
}

}  // namespace crest::certify
