// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/coding/valence_model.hpp"

namespace crest::coding {

ActiveLoops::Place ActiveLoops::find(Index f, Index wanted) const {
  if (wanted == kNone) return {};
  const Index n = slots_[f].next;
  Index ahead = slots_[slots_[n].next].next, behind = slots_[slots_[f].previous].previous;
  std::uint32_t passed_ahead = 0, passed_behind = 0;
  bool ahead_ends = false, behind_ends = false;
  while (!ahead_ends || !behind_ends) {
    ahead_ends = ahead_ends || ahead == f;
    behind_ends = behind_ends || behind == n;
    if (!ahead_ends) {
      if (ahead == wanted) return {true, true, passed_ahead};
      passed_ahead += slots_[ahead].free >= 2 ? 1 : 0;
      ahead = slots_[ahead].next;
    }
    if (!behind_ends) {
      if (behind == wanted) return {true, false, passed_behind};
      passed_behind += slots_[behind].free >= 2 ? 1 : 0;
      behind = slots_[behind].previous;
    }
  }
  return {false, false, 0};
}

Index ActiveLoops::at(Index f, bool ahead, std::uint32_t distance) const {
  const Index n = slots_[f].next;
  Index s = ahead ? slots_[slots_[n].next].next : slots_[slots_[f].previous].previous;
  for (;; s = ahead ? slots_[s].next : slots_[s].previous) {
    if (s == f || s == n) throw StreamError("splits a loop at a slot that is not there");
    if (slots_[s].free >= 2 && distance-- == 0) return s;
  }
}

void ActiveLoops::require_tip(Index f, Index s) const {
  const Index n = slots_[f].next;
  if (slots_[s].free < 2 || s == f || s == n || s == slots_[f].previous || s == slots_[n].next)
    throw StreamError("has a triangle whose tip has no free edges or is next to it");
}

}  // namespace crest::coding
