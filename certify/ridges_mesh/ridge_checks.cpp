// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "certify/container/reject.hpp"
#include "certify/ridges_mesh/checks.hpp"

namespace crest::certify {
namespace {

using u32 = std::uint32_t;

/// Kind (0 none, 1 patch, 2 boundary) and patch number of an end.
using End = std::pair<std::uint8_t, u32>;

class RidgeChecker {
 public:
  RidgeChecker(const CheckedMesh& mesh, const std::vector<u32>& patch_of, SignLadder& sign)
      : mesh_(mesh), patch_of_(patch_of), sign_(sign), used_(mesh.topology.edges.size(), 0) {}

  void check(std::size_t number, const RidgeRecord& ridge) {
    number_ = number;
    need((ridge.flags & ~3U) == 0, "flags");
    colour_ = (ridge.flags & 1U) != 0 ? red : blue;
    const bool loop = (ridge.flags & 2U) != 0;
    need(ridge.nodes.size() >= (loop ? 3U : 1U), "too few nodes");
    for (const NodeRecord& node : ridge.nodes) check_node(node);
    check_order(ridge);
    if (loop)
      check_loop(ridge);
    else
      check_path(ridge);
    ++found_[2 * colour_ + (loop ? 0U : 1U)];
  }

  /// Every crossing that is not interior to a patch has been used.
  void check_complete() const {
    for (u32 e = 0; e < used_.size(); ++e) {
      const auto missing = static_cast<unsigned>(mesh_.signs.crossings[e] & ~used_[e]);
      require(missing == 0 || interior_to_patch(e), "edge {}: a crossing is on no ridge", e);
    }
  }

  const std::array<std::uint64_t, 4>& found() const { return found_; }

 private:
  void need(bool condition, const char* what) const {
    require(condition, "ridge {}: {}", number_, what);
  }

  /// The faces of an edge; kNone beyond the boundary.
  std::array<u32, 2> faces_of(u32 edge) const {
    const Edge& e = mesh_.topology.edges[edge];
    return {e.forward == kNone ? kNone : e.forward / 3,
            e.backward == kNone ? kNone : e.backward / 3};
  }

  bool interior_to_patch(u32 edge) const {
    const auto [f, g] = faces_of(edge);
    return f != kNone && g != kNone && patch_of_[f] != kNone && patch_of_[f] == patch_of_[g];
  }

  void check_node(const NodeRecord& node) {
    need(node.edge < used_.size(), "no such edge");
    need(mesh_.signs.crossed(node.edge, colour_), "an edge that is not crossed");
    const auto bit = static_cast<std::uint8_t>(1U << colour_);
    need((used_[node.edge] & bit) == 0, "a crossing used before");
    used_[node.edge] |= bit;
    need(!interior_to_patch(node.edge), "a node interior to a patch");
    need((node.type & ~0xfU) == 0, "type bits");
    need((node.type & 3U) ==
             crossing_type(mesh_.data, mesh_.topology.edges[node.edge], colour_, sign_),
         "type of a crossing");
  }

  /// Blue before red; in a colour by ascending smallest edge.
  void check_order(const RidgeRecord& ridge) {
    u32 least = kNone;
    for (const NodeRecord& node : ridge.nodes) least = std::min(least, node.edge);
    const std::uint64_t key = (std::uint64_t{colour_} << 32) | least;
    need(key >= next_key_, "out of order");
    next_key_ = key + 1;
  }

  /// The face outside the patches that holds both edges; checks the type of its segment.
  u32 check_segment(const NodeRecord& from, const NodeRecord& to) {
    u32 face = kNone;
    for (const u32 f : faces_of(from.edge))
      for (const u32 g : faces_of(to.edge))
        if (f == g && f != kNone && from.edge != to.edge) face = f;
    need(face != kNone && patch_of_[face] == kNone,
         "consecutive nodes without a common face outside the patches");
    // The corner between the sides: the third side is across from it.
    u32 corner = kNone;
    for (u32 c = 3 * face; c < 3 * face + 3; ++c) {
      const u32 across = mesh_.topology.edge_of[next_corner(c)];
      if (across != from.edge && across != to.edge) corner = c;
    }
    need((from.type >> 2 & 3U) == segment_type(mesh_.data, mesh_.signs, corner, colour_, sign_),
         "type of a segment");
    return face;
  }

  void check_loop(const RidgeRecord& ridge) {
    const auto& nodes = ridge.nodes;
    for (std::size_t i = 0; i < 2; ++i)
      need(ridge.end_kind[i] == 0 && ridge.end_patch[i] == 0, "a loop with an end");
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      check_segment(nodes[i], nodes[(i + 1) % nodes.size()]);
      need(nodes[0].edge <= nodes[i].edge, "a loop's start");
    }
    need(nodes[1].edge < nodes.back().edge, "a loop's direction");
  }

  /// Where a ridge stops on this side of a crossing; a face outside the patches is no end.
  End end_at(u32 face) const {
    if (face == kNone) return {std::uint8_t{2}, 0};
    need(patch_of_[face] != kNone, "an end at a face where the ridge goes on");
    return {std::uint8_t{1}, patch_of_[face]};
  }

  void check_path(const RidgeRecord& ridge) {
    const auto& nodes = ridge.nodes;
    const std::array<End, 2> stated = {End{ridge.end_kind[0], ridge.end_patch[0]},
                                       End{ridge.end_kind[1], ridge.end_patch[1]}};
    need((nodes.back().type >> 2) == 0, "a segment after the last node");
    if (nodes.size() == 1) {
      const auto [f, g] = faces_of(nodes[0].edge);
      std::array<End, 2> ends = {end_at(f), end_at(g)};
      std::sort(ends.begin(), ends.end());
      need(stated == ends, "ends");
      return;
    }
    u32 first = kNone, last = kNone;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
      last = check_segment(nodes[i], nodes[i + 1]);
      if (i == 0) first = last;
    }
    need(nodes.front().edge < nodes.back().edge, "a path's direction");
    need(stated[0] == end_at(other_face(nodes.front().edge, first)), "first end");
    need(stated[1] == end_at(other_face(nodes.back().edge, last)), "last end");
  }

  u32 other_face(u32 edge, u32 face) const {
    const auto [f, g] = faces_of(edge);
    return f == face ? g : f;
  }

  const CheckedMesh& mesh_;
  const std::vector<u32>& patch_of_;
  SignLadder& sign_;
  std::vector<std::uint8_t> used_;  ///< E: colours, as in MeshSigns::crossings
  std::array<std::uint64_t, 4> found_{};
  std::uint64_t next_key_ = 0;
  std::size_t number_ = 0;
  Colour colour_ = blue;
};

}  // namespace

void check_ridges(const CheckedMesh& mesh, const std::vector<u32>& patch_of,
                  const std::vector<RidgeRecord>& ridges, const std::array<u32, 4>& counts,
                  SignLadder& sign) {
  RidgeChecker checker(mesh, patch_of, sign);
  for (std::size_t i = 0; i < ridges.size(); ++i) checker.check(i, ridges[i]);
  checker.check_complete();
  static constexpr const char* kNames[] = {"blue loops", "blue paths", "red loops", "red paths"};
  for (std::size_t i = 0; i < 4; ++i) require_equal(counts[i], checker.found()[i], kNames[i]);
}

}  // namespace crest::certify
