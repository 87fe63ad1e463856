// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/container/reject.hpp"
#include "certify/ridges_smooth/patches.hpp"

namespace crest::certify::smooth {
namespace {

using u32 = std::uint32_t;

/// The ridges of one colour: crossed edges joined through faces outside patches.
class RidgeWalk {
 public:
  RidgeWalk(const Mesh& mesh, const std::vector<std::uint8_t>& crossed)
      : mesh_(mesh), crossed_(crossed), seen_(crossed.size(), 0) {
    for (u32 e = 0; e < crossed.size(); ++e) {
      if (crossed[e] == 0 || seen_[e] != 0) continue;
      for (const u32 side : sides(e)) {
        if (!is_end(side)) continue;
        // From this end through the other side.
        follow(e, mesh_.topology.edges[e].forward == side ? mesh_.topology.edges[e].backward
                                                          : mesh_.topology.edges[e].forward);
        ++paths_;
        break;
      }
    }
    for (u32 e = 0; e < crossed.size(); ++e) {
      if (crossed[e] == 0 || seen_[e] != 0) continue;
      follow(e, mesh_.topology.edges[e].forward);
      ++loops_;
    }
  }

  u32 loops() const { return loops_; }
  u32 paths() const { return paths_; }

 private:
  std::array<u32, 2> sides(u32 e) const {
    return {mesh_.topology.edges[e].forward, mesh_.topology.edges[e].backward};
  }
  /// The side belongs to no face, or to one in a patch.
  bool is_end(u32 side) const { return side == kNone || mesh_.patch_of[side / 3] != kNone; }

  /// Marks edges from e on into the face of `side`.
  void follow(u32 e, u32 side) {
    seen_[e] = 1;
    while (!is_end(side)) {
      u32 out = next_corner(side);
      if (crossed_[mesh_.topology.edge_of[out]] == 0) out = previous_corner(side);
      e = mesh_.topology.edge_of[out];
      if (seen_[e] != 0) return;
      seen_[e] = 1;
      side = mesh_.topology.twin[out];
    }
  }

  const Mesh& mesh_;
  const std::vector<std::uint8_t>& crossed_;
  std::vector<std::uint8_t> seen_;
  u32 loops_ = 0, paths_ = 0;
};

/// Item 6 of "Patches".
void check_borders(const Claim& claim, const Crossings& crossed) {
  const Mesh& mesh = claim.mesh;
  const auto& patches = claim.certificate.patches;
  for (u32 p = 0; p < patches.size(); ++p)
    for (std::size_t j = 0; j < 2; ++j) {
      u32 found = 0;
      for (const u32 f : patches[p].faces)
        for (u32 side = 3 * f; side < 3 * f + 3; ++side) {
          const u32 twin = mesh.topology.twin[side];
          if (twin == kNone || mesh.patch_of[twin / 3] != p)
            found += crossed[j][mesh.topology.edge_of[side]];
        }
      require(found == patches[p].branches[j],
              "patch {}: {} {} branches, {} crossings on its border", p, patches[p].branches[j],
              j == 0 ? "blue" : "red", found);
    }
}

}  // namespace

void check_graph(const Claim& claim, const Crossings& crossed) {
  const RidgesSmoothCertificate& c = claim.certificate;
  check_borders(claim, crossed);
  for (std::size_t j = 0; j < 2; ++j) {
    const RidgeWalk walk(claim.mesh, crossed[j]);
    require_equal(c.counts[2 * j], walk.loops(), j == 0 ? "blue loops" : "red loops");
    require_equal(c.counts[2 * j + 1], walk.paths(), j == 0 ? "blue paths" : "red paths");
    u32 turning = 0;
    for (const auto& record : c.face_records) turning += !record.in_patch && record.type[j] == 3;
    require_equal(c.turning_points[j], turning,
                  j == 0 ? "blue turning points" : "red turning points");
  }
  u32 purple = 0;
  std::array<u32, 4> umbilics{};
  std::int64_t twice_index = 0;
  for (const auto& record : c.face_records) purple += !record.in_patch && record.purple;
  for (const auto& patch : c.patches) {
    ++umbilics[patch.twice_index > 0 ? 0 : 1];
    ++umbilics[patch.branches[0] == 1 ? 2 : 3];
    twice_index += patch.twice_index;
  }
  require_equal(c.purple_points, purple, "purple points");
  const std::array names = {"umbilics of index +1/2", "umbilics of index -1/2",
                            "umbilics with one blue branch", "umbilics with three"};
  for (std::size_t k = 0; k < 4; ++k) require_equal(c.umbilics[k], umbilics[k], names[k]);
  if (claim.mesh.topology.boundary_loops == 0)
    require(twice_index == 2 * claim.mesh.topology.euler_characteristic,
            "umbilics: their indices do not sum to the Euler characteristic");
}

}  // namespace crest::certify::smooth
