// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What valence coding keeps of a surface's growing boundary, and how it predicts from that
// (docs/cmc-format.md, "Method valence").
#include <algorithm>
#include <array>
#include <vector>

#include "algorithms/coding/connectivity.hpp"
#include "algorithms/coding/mixer.hpp"
#include "algorithms/coding/numbers.hpp"

namespace crest::coding {

/// Of an extra vertex; of others min(valence, 13).
inline constexpr std::uint8_t kExtraKind = 15;
inline std::uint8_t kind_of(std::uint32_t valence) {
  return static_cast<std::uint8_t>(std::min(valence, 13u));
}

/// A corner of an active loop, and the edge to the next one.
struct Slot {
  Index vertex, next, previous;
  std::int32_t free;  ///< edges between its two neighbours still to come; -1: no more there
  std::uint8_t kind, opposite;  ///< classes of its vertex and of that across the edge
};

/// The active loops, and which slot is next: of those with the fewest free edges the latest.
class ActiveLoops {
 public:
  Slot& operator[](Index s) { return slots_[s]; }
  const Slot& operator[](Index s) const { return slots_[s]; }
  Index size() const { return static_cast<Index>(slots_.size()); }

  Index add(const Slot& slot) {
    slots_.push_back(slot);
    return size() - 1;
  }
  void link(Index a, Index b) {
    slots_[a].next = b;
    slots_[b].previous = a;
  }
  /// To be called whenever a slot's free edges have changed.
  void wait(Index s) {
    const auto k = static_cast<std::size_t>(std::min(slots_[s].free, kMost));
    stacks_[k].push_back({s, slots_[s].free});
    least_ = std::min(least_, k);
  }
  /// kNone if no loop is left.
  Index take() {
    for (; least_ < stacks_.size(); ++least_) {
      auto& stack = stacks_[least_];
      while (!stack.empty()) {
        const auto [s, free] = stack.back();
        stack.pop_back();
        if (slots_[s].free == free) return s;
      }
    }
    return kNone;
  }

  struct Place {
    bool same, ahead;
    std::uint32_t distance;
  };
  /// Where `wanted` stands from f. Walks both ways at once, so that the cost is the shorter
  /// distance.
  Place find(Index f, Index wanted) const;
  /// The slot at a place on the loop of f. Throws: StreamError.
  Index at(Index f, bool ahead, std::uint32_t distance) const;
  /// May the triangle at f's edge have its tip there? Throws: StreamError.
  void require_tip(Index f, Index s) const;

 private:
  static constexpr std::int32_t kMost = 63;
  struct Entry {
    Index slot;
    std::int32_t free;
  };
  std::vector<Slot> slots_;
  std::array<std::vector<Entry>, kMost + 1> stacks_;
  std::size_t least_ = 0;
};

/// Codes the valences of new vertices.
template <class Range>
class VertexModel {
 public:
  struct Answer {
    std::uint32_t valence;
    bool extra;
  };
  static constexpr std::size_t kContexts = 6;

  explicit VertexModel(Range& range) : range_(range), lines_(16) {}

  /// Corner k of a component's first triangle, an extra one or not; `last`: the corner before.
  std::uint32_t code_first(std::size_t k, bool extra, std::uint32_t wanted) {
    if (k == 0) before_ = first_;
    const std::uint64_t last = k == 0 ? 0 : first_[k - 1];
    std::uint32_t valence = 0;
    if (extra) {
      valence = loop_length_.code(range_, wanted - 3) + 3;
    } else {
      const Context<kContexts> context = {
          &plain_,
          &lines_.of(pack(6, {k})),
          &lines_.of(pack(7, {k, last})),
          &lines_.of(pack(8, {k, before_[k]})),
          &lines_.of(pack(9, {k, before_[k], last})),
          &lines_.of(pack(10, {k, before_[0], before_[1], before_[2], last}))};
      valence = code(context, 0, {wanted, false}, false).valence;
    }
    first_[k] = extra ? kExtraKind : kind_of(valence);
    return valence;
  }
  /// The vertex at the edge of slot f.
  Answer code_next(const ActiveLoops& loops, Index f, Answer wanted, bool may_be_extra) {
    const auto row = static_cast<std::size_t>(std::min(loops[f].free, 3));
    return code(contexts(loops, f), row, wanted, may_be_extra);
  }

 private:
  Answer code(const Context<kContexts>& context, std::size_t row, Answer wanted,
              bool may_be_extra) {
    const auto [valence, extra] = wanted;
    const auto decide = [&](std::size_t number, bool bit) {
      return code_mixed(range_, context, number, weights_[row][number], bit);
    };
    if (decide(0, !extra && valence == 6)) return {6, false};
    if (decide(1, !extra && valence < 6)) {
      if (decide(2, valence == 5)) return {5, false};
      return {decide(3, valence == 4) ? 4u : 3u, false};
    }
    for (std::uint32_t k = 7; k < 13; ++k)
      if (decide(k - 3, !extra && valence == k)) return {k, false};
    if (may_be_extra && code_alone(range_, is_extra_, extra))
      return {loop_length_.code(range_, valence - 3) + 3, true};
    return {large_.code(range_, valence - 13) + 13, false};
  }

  static std::uint64_t pack(std::uint64_t which, std::initializer_list<std::uint64_t> parts) {
    for (const std::uint64_t part : parts) which = which << 6 | part;
    return which;
  }
  Context<kContexts> contexts(const ActiveLoops& loops, Index s) {
    const Slot &f = loops[s], &n = loops[f.next], &p = loops[f.previous], &nn = loops[n.next];
    const auto dev = [](std::uint8_t kind) { return kind == kExtraKind ? 0 : int{kind} - 6; };
    const auto odd = [](std::uint8_t kind) { return kind != 6 ? 1 : 0; };
    const int five = dev(f.kind) + dev(n.kind) + dev(f.opposite) + dev(p.kind) + dev(nn.kind);
    const int five_odd = odd(f.kind) + odd(n.kind) + odd(f.opposite) + odd(p.kind) + odd(nn.kind);
    const int all = five + dev(f.kind) + dev(n.kind) + dev(p.opposite) + dev(n.opposite);
    const int all_odd = five_odd + odd(p.opposite) + odd(n.opposite);
    const auto ff = static_cast<std::uint64_t>(std::min(f.free, 15)),
               fn = static_cast<std::uint64_t>(std::min(n.free, 15)),
               fp = static_cast<std::uint64_t>(std::min(p.free, 15));
    return {&plain_,
            &lines_.of(pack(1, {f.kind, n.kind, std::min<std::uint64_t>(ff, 3)})),
            &lines_.of(pack(2, {static_cast<std::uint64_t>(five + 32) & 63,
                                static_cast<std::uint64_t>(five_odd), ff})),
            &lines_.of(pack(3, {static_cast<std::uint64_t>(std::clamp(all, -32, 31) + 32),
                                static_cast<std::uint64_t>(all_odd), ff, fn})),
            &lines_.of(pack(4, {f.kind, n.kind, f.opposite, p.kind, ff == 1 ? 1u : 0u})),
            &lines_.of(pack(5, {p.kind, fp, f.kind, p.opposite, n.opposite}))};
  }

  Range& range_;
  Lines lines_;
  Line plain_{};
  std::array<std::array<Weights<kContexts>, 10>, 4> weights_;
  Counter is_extra_;
  SmallNumber loop_length_, large_;
  std::array<std::uint8_t, 3> first_{}, before_{};  ///< kinds in first triangles
};

/// Codes the slots at which triangles split loops or join them.
template <class Range>
class SplitModel {
 public:
  explicit SplitModel(Range& range) : range_(range) {}

  /// By its distance along the loop or by number. Throws: StreamError.
  Index code(const ActiveLoops& loops, Index f, Index wanted) {
    const auto [same, ahead, distance] = loops.find(f, wanted);
    Index s = kNone;
    if (code_alone(range_, same_, same)) {
      const bool forward = code_alone(range_, ahead_, ahead);
      s = loops.at(f, forward, distance_.code(range_, distance));
    } else {
      s = code_below(range_, wanted, loops.size());
    }
    loops.require_tip(f, s);
    return s;
  }

 private:
  Range& range_;
  Counter same_, ahead_;
  SmallNumber distance_;
};

}  // namespace crest::coding
