// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/strips/path_cover.hpp"

#include <algorithm>
#include <array>

#include "kernel/geometry/stop.hpp"

namespace crest::strips {
namespace {

constexpr bool linked(const Links& links, Index h) {
  return (links[h / 3] >> (h % 3) & 1) != 0;
}

/// The side that two links leave free; kFree for fewer links.
constexpr std::uint8_t kFree = 3;
constexpr std::array<std::uint8_t, 8> kFreeSide = {kFree, kFree, kFree, 2, kFree, 1, 0, kFree};

/// Whether the path over side k of a face and side l of the next one turns the same way in both,
/// given their free sides. A face entered by side i is left to the right by side i + 1: then side
/// i + 2 is free.
constexpr bool same_turn(Index k, Index free_before, Index l, Index free_behind) {
  return (free_before == (k + 1) % 3) == (free_behind == (l + 2) % 3);
}

bool equal_turns(const CornerTable& mesh, const Links& links, Index h) {
  const Index o = mesh.opposite(h);
  const std::uint8_t before = kFreeSide[links[h / 3]], behind = kFreeSide[links[o / 3]];
  return before != kFree && behind != kFree && same_turn(h % 3, before, o % 3, behind);
}

class Random {
 public:
  std::uint32_t next() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<std::uint32_t>(state_ >> 32);
  }

 private:
  std::uint64_t state_ = 0x243f6a8885a308d3u;
};

/// Which changes of the energy pass, by Metropolis' rule.
class Temperature {
 public:
  /// `factor` = exp(-1 / T) in 32 bits.
  explicit Temperature(std::uint32_t factor) {
    std::uint64_t p = 0xffffffffu;
    for (std::uint32_t& chance : chances_)
      chance = static_cast<std::uint32_t>(p = p * factor >> 32);
  }
  bool passes(int change, Random& random) const {
    if (change <= 0) return true;
    const auto i = static_cast<std::size_t>(change - 1);
    return i < chances_.size() && random.next() < chances_[i];
  }

 private:
  std::array<std::uint32_t, 6> chances_;
};

class Annealer {
 public:
  Annealer(const CornerTable& mesh, Links& links, int swap_cost)
      : links_(links), swap_cost_(swap_cost), opposite_(4 * std::size_t{mesh.face_count()}) {
    for (Index h = 0; h < 3 * mesh.face_count(); ++h) {
      const Index o = mesh.opposite(h);
      opposite_[side(h)] = o == kernel::kNone ? kernel::kNone : side(o);
    }
  }

  void sweep(const Temperature& temperature) {
    for (Index s = 0; s < opposite_.size(); ++s) {
      const Index o = opposite_[s];
      if (s % 4 == 3 || o == kernel::kNone || o < s) continue;
      if (links_[s / 4] >> s % 4 & 1)
        try_cut(s, o, temperature);
      else
        try_join(s, o, temperature);
    }
  }

 private:
  /// Sides are 4 f + k here: no divisions.
  static Index side(Index h) { return h / 3 * 4 + h % 3; }

  void toggle(Index s) {
    for (const Index t : {s, opposite_[s]})
      links_[t / 4] = static_cast<std::uint8_t>(links_[t / 4] ^ 1u << t % 4);
  }

  /// One of the two links of s's face, at random; kNone if it has a side to spare.
  Index to_drop(Index s) {
    if (kFreeSide[links_[s / 4]] == kFree) return kernel::kNone;
    return s - s % 4 + (s % 4 + 1 + (random_.next() >> 31)) % 3;
  }

  void concern(Index s) {
    const Index f = s / 4;
    for (std::size_t i = 0; i < concerned_; ++i)
      if (faces_[i] == f) return;
    faces_[concerned_++] = f;
  }
  bool is_concerned(Index f) const {
    for (std::size_t i = 0; i < concerned_; ++i)
      if (faces_[i] == f) return true;
    return false;
  }

  /// The swaps at the links of the faces concerned. A link between two of them is met twice, and
  /// has half the weight.
  int swaps() const {
    int halves = 0;
    for (std::size_t i = 0; i < concerned_; ++i) {
      const Index f = faces_[i];
      const std::uint8_t before = kFreeSide[links_[f]];
      if (before == kFree) continue;
      for (Index k = 0; k < 3; ++k) {
        if (k == before) continue;
        const Index o = opposite_[4 * f + k];
        const std::uint8_t behind = kFreeSide[links_[o / 4]];
        if (behind != kFree && same_turn(k, before, o % 4, behind))
          halves += is_concerned(o / 4) ? 1 : 2;
      }
    }
    return halves / 2;
  }

  void try_cut(Index s, Index o, const Temperature& temperature) {
    concerned_ = 0;
    concern(s);
    concern(o);
    const int before = swaps();
    toggle(s);
    if (!temperature.passes(2 + swap_cost_ * (swaps() - before), random_)) toggle(s);
  }

  void try_join(Index s, Index o, const Temperature& temperature) {
    concerned_ = 0;
    concern(s);
    concern(o);
    const std::array<Index, 2> dropped = {to_drop(s), to_drop(o)};
    int paths = -1;
    for (const Index d : dropped) {
      if (d == kernel::kNone) continue;
      concern(opposite_[d]);
      ++paths;
    }
    const auto apply = [&] {
      toggle(s);
      for (const Index d : dropped)
        if (d != kernel::kNone) toggle(d);
    };
    const int before = swaps();
    apply();
    if (!temperature.passes(2 * paths + swap_cost_ * (swaps() - before), random_)) apply();
  }

  Links& links_;
  int swap_cost_;
  std::vector<Index> opposite_;  // of a side
  Random random_;
  std::array<Index, 4> faces_{};  // whose links may change their turns
  std::size_t concerned_ = 0;
};

/// From `face` over `exit` to the path's end, or round to `face` again.
Path walk(const CornerTable& mesh, const Links& links, Index face, Index entry) {
  Path path;
  const Index first = face;
  do {
    Step step{face, entry, kernel::kNone};
    for (Index h = 3 * face; h < 3 * face + 3; ++h)
      if (h != entry && linked(links, h)) {
        step.exit = h;
        break;
      }
    path.push_back(step);
    if (step.exit == kernel::kNone) break;
    entry = mesh.opposite(step.exit);
    face = entry / 3;
  } while (face != first);
  return path;
}

/// What goes when the link over `h` is cut: the swaps at it and at its neighbours in the path.
int gain_of_cut(const CornerTable& mesh, const Links& links, const Path& cycle, std::size_t i) {
  const std::size_t n = cycle.size();
  int gain = 0;
  for (const std::size_t j : {(i + n - 1) % n, i, (i + 1) % n})
    gain += equal_turns(mesh, links, cycle[j].exit) ? 1 : 0;
  return gain;
}

}  // namespace

void anneal(const CornerTable& mesh, Links& links, int sweeps, int swap_cost) {
  // exp(-1/T) falls linearly from 1/8 to 0: the start's strips are good already.
  Annealer annealer(mesh, links, swap_cost);
  for (int i = 1; i <= sweeps; ++i) {
    kernel::stop_point();
    const auto left = static_cast<std::uint64_t>(sweeps - i);
    annealer.sweep(
        Temperature(static_cast<std::uint32_t>((left << 29) / static_cast<std::uint64_t>(sweeps))));
  }
}

std::vector<Path> paths_of(const CornerTable& mesh, Links links) {
  std::vector<Path> paths;
  std::vector<std::uint8_t> seen(mesh.face_count(), 0);
  const auto take = [&](Index f) {
    paths.push_back(walk(mesh, links, f, kernel::kNone));
    for (const Step& step : paths.back()) seen[step.face] = 1;
  };
  const auto cut_cycle = [&](Index f) {
    const Path cycle = walk(mesh, links, f, kernel::kNone);
    std::size_t best = 0;
    for (std::size_t i = 1; i < cycle.size(); ++i)
      if (gain_of_cut(mesh, links, cycle, i) > gain_of_cut(mesh, links, cycle, best)) best = i;
    for (const Index h : {cycle[best].exit, mesh.opposite(cycle[best].exit)})
      links[h / 3] = static_cast<std::uint8_t>(links[h / 3] ^ 1u << h % 3);
    take(cycle[best].face);
  };
  for (Index f = 0; f < mesh.face_count(); ++f)
    if (!seen[f] && kFreeSide[links[f]] == kFree) take(f);
  for (Index f = 0; f < mesh.face_count(); ++f)
    if (!seen[f]) cut_cycle(f);
  return paths;
}

Path reversed(const Path& path) {
  Path other(path.rbegin(), path.rend());
  for (Step& step : other) std::swap(step.entry, step.exit);
  return other;
}

}  // namespace crest::strips
