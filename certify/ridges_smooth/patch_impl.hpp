// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// PatchProver's branches, for the translation units that instantiate it.
#include "certify/ridges_smooth/patch_rays.hpp"

namespace crest::certify::smooth {

/// +1 if v1 of the two frames agree on their common ray, -1 if they are opposite.
template <class M>
std::optional<int> PatchProver<M>::turn(const Leaf& from, const Leaf& to) {
  const Sector& a = sectors_[from.sector];
  const Sector& b = sectors_[to.sector];
  if (a.w == b.w) return 1;
  // One r is enough: on all of the ray S(w) > 0 in both frames. At r = 0 it is cheapest.
  const auto f = ray_forms(*centre_, a.fan, from.t.side, a.w, M(0.0), M(from.t.t1));
  if (!f) return std::nullopt;
  const auto sign = certain(inner(values(f->i), b.w, Pair<M>{f->v1[0].value(), f->v1[1].value()}));
  if (!nonzero(sign)) return std::nullopt;
  return static_cast<int>(*sign);
}

/// Once around: runs of leaves where E_t has one sign lie between leaves where E has one, so each
/// holds one zero for every r if those signs differ, else none.
template <class M>
std::optional<std::uint32_t> PatchProver<M>::count(const std::vector<Leaf>& leaves) {
  const std::size_t n = leaves.size();
  std::size_t start = 0;
  while (start < n && leaves[start].running) ++start;
  if (start == n) return std::nullopt;
  int frame = 1, before = leaves[start].sign, run = 0;
  std::uint32_t branches = 0;
  for (std::size_t k = 1; k <= n; ++k) {
    const Leaf& leaf = leaves[(start + k) % n];
    const auto turned = turn(leaves[(start + k - 1) % n], leaf);
    if (!turned) return std::nullopt;
    frame *= *turned;
    const int sign = frame * leaf.sign;
    if (leaf.running) {
      if (run != 0 && run != sign) return std::nullopt;
      run = sign;
      continue;
    }
    if (sign != before) {
      // Without a run between them the signs would be those of one ray.
      if (run != sign) return std::nullopt;
      ++branches;
    }
    before = sign;
    run = 0;
  }
  // d1 turns by half a turn.
  return frame == -1 ? std::optional(branches) : std::nullopt;
}

template <class M>
std::array<std::uint32_t, 2> PatchProver<M>::branches(WitnessReader& in) {
  if (!find_centre()) in.fail("the surface about the umbilic");
  for (int side = 0; side < 4; ++side)
    for (int k = 0; k < 4; ++k) divide({side, -1 + k * 0.5, -0.5 + k * 0.5}, 0, 3, in);
  in.end();
  const auto blue = count(leaves_[0]), red = count(leaves_[1]);
  if (!blue || !red) in.fail("its branches");
  return {*blue, *red};
}

}  // namespace crest::certify::smooth
