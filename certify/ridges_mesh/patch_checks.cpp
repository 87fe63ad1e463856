// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "certify/container/reject.hpp"
#include "certify/ridges_mesh/checks.hpp"

namespace crest::certify {
namespace {

using u32 = std::uint32_t;

/// Working memory of all patches: stamps say for which patch an entry was last seen.
class PatchChecker {
 public:
  PatchChecker(const CheckedMesh& mesh, SignLadder& sign)
      : mesh_(mesh),
        sign_(sign),
        patch_of_(mesh.data.faces.size(), kNone),
        vertex_stamp_(mesh.data.positions.size(), kNone),
        fan_starts_(mesh.data.positions.size(), 0) {}

  void check(u32 p, const PatchRecord& patch) {
    claim_faces(p, patch);
    check_disk(p, patch);
    check_numbers(p, patch);
    require(patch.coherent == (is_coherent(p, patch) ? 1 : 0), "patch {}: coherence", p);
    require(patch.coherent == 1 || patch.faces.size() == 1,
            "patch {}: not coherent, yet of several faces", p);
  }

  std::vector<u32>& patch_of() { return patch_of_; }

 private:
  /// The patch across a side, or kNone.
  u32 across(u32 side) const {
    const u32 twin = mesh_.topology.twin[side];
    return twin == kNone ? kNone : patch_of_[twin / 3];
  }

  void claim_faces(u32 p, const PatchRecord& patch) {
    require(!patch.faces.empty(), "patch {}: no faces", p);
    u32 least = 0;
    for (const u32 f : patch.faces) {
      require(f < patch_of_.size(), "patch {}: no face {}", p, f);
      require(f >= least, "patch {}: faces not ascending", p);
      require(patch_of_[f] == kNone, "patch {}: face {} is in another patch", p, f);
      patch_of_[f] = p;
      least = f + 1;
    }
    require(patch.centre < patch_of_.size() && patch_of_[patch.centre] == p,
            "patch {}: its central face is outside", p);
    require(mesh_.twice_index[patch.centre] != 0, "patch {}: its central face has index zero", p);
    require(patch.centre == central_face(patch), "patch {}: face {} is not the central one", p,
            patch.centre);
  }

  /// Requires: a face of non-zero index.
  u32 central_face(const PatchRecord& patch) {
    u32 central = kNone, least = kNone;
    for (const u32 f : patch.faces) {
      if (mesh_.twice_index[f] == 0) continue;
      const u32 corner = least_gap_corner(mesh_.data, f, sign_);
      if (central != kNone && !less_gap(mesh_.data, corner, least, sign_)) continue;
      central = f;
      least = corner;
    }
    return central;
  }

  /// Faces reached from the first one through shared sides.
  std::size_t reachable(u32 p, const PatchRecord& patch) {
    std::vector<u32> stack = {patch.faces.front()};
    std::vector<std::uint8_t> seen(patch.faces.size(), 0);
    const auto place = [&](u32 f) {
      return static_cast<std::size_t>(std::lower_bound(patch.faces.begin(), patch.faces.end(), f) -
                                      patch.faces.begin());
    };
    seen[0] = 1;
    std::size_t count = 0;
    while (!stack.empty()) {
      const u32 f = stack.back();
      stack.pop_back();
      ++count;
      for (u32 c = 3 * f; c < 3 * f + 3; ++c) {
        if (across(c) != p) continue;
        const u32 g = mesh_.topology.twin[c] / 3;
        if (auto& mark = seen[place(g)]; !mark) {
          mark = 1;
          stack.push_back(g);
        }
      }
    }
    return count;
  }

  void check_disk(u32 p, const PatchRecord& patch) {
    require(reachable(p, patch) == patch.faces.size(), "patch {}: not connected", p);
    std::int64_t vertices = 0, sides = 0, shared = 0;
    for (const u32 f : patch.faces)
      for (u32 c = 3 * f; c < 3 * f + 3; ++c) {
        const u32 v = vertex_of(mesh_.data.faces, c);
        if (vertex_stamp_[v] != p) {
          vertex_stamp_[v] = p;
          fan_starts_[v] = 0;
          ++vertices;
        }
        ++sides;
        if (across(c) == p) {
          ++shared;
        } else {
          // Side c is clockwise of its face around v: a fan of the patch begins here.
          require(++fan_starts_[v] == 1, "patch {}: pinched at vertex {}", p, v);
        }
      }
    const auto faces = static_cast<std::int64_t>(patch.faces.size());
    require(vertices - (sides - shared / 2) + faces == 1, "patch {}: not a disk", p);
  }

  void check_numbers(u32 p, const PatchRecord& patch) {
    int twice = 0;
    for (const u32 f : patch.faces) twice += mesh_.twice_index[f];
    require(twice != 0, "patch {}: index zero", p);
    require(patch.twice_index == twice, "patch {}: twice the index is {}, {} stated", p, twice,
            patch.twice_index);
    require(patch.kind == umbilic_kind(mesh_.data, patch.centre, sign_), "patch {}: kind", p);
  }

  bool is_coherent(u32 p, const PatchRecord& patch) const {
    std::array<std::size_t, 2> crossings{};
    for (const u32 f : patch.faces)
      for (u32 c = 3 * f; c < 3 * f + 3; ++c)
        for (const Colour colour : {blue, red})
          if (across(c) != p && mesh_.signs.crossed(mesh_.topology.edge_of[c], colour))
            ++crossings[colour];
    const bool half = patch.twice_index == 1 || patch.twice_index == -1;
    return half && crossings[0] == crossings[1] && (crossings[0] == 1 || crossings[0] == 3);
  }

  const CheckedMesh& mesh_;
  SignLadder& sign_;
  std::vector<u32> patch_of_, vertex_stamp_;
  std::vector<std::uint8_t> fan_starts_;
};

}  // namespace

std::vector<u32> check_patches(const CheckedMesh& mesh, const std::vector<PatchRecord>& patches,
                               SignLadder& sign) {
  PatchChecker checker(mesh, sign);
  for (u32 p = 0; p < patches.size(); ++p) {
    require(p == 0 || patches[p - 1].centre < patches[p].centre,
            "patch {}: central faces not ascending", p);
    checker.check(p, patches[p]);
  }
  const std::vector<u32>& patch_of = checker.patch_of();
  for (std::size_t f = 0; f < patch_of.size(); ++f) {
    if (patch_of[f] != kNone) continue;
    require(mesh.twice_index[f] == 0, "face {}: non-zero index outside the patches", f);
    require(!mesh.signs.conflict[f], "face {}: a conflict triangle outside the patches", f);
  }
  return std::move(checker.patch_of());
}

}  // namespace crest::certify
