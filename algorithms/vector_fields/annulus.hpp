// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Closed orbits: a line that comes back to a side ever closer to a place is at an annulus, a gate
// whose lines return strictly inside it. It is looked for at once, where the line seems to go.
#include <optional>
#include <unordered_map>

#include "algorithms/vector_fields/corridor.hpp"
#include "algorithms/vector_fields/trace.hpp"

namespace crest::vector_fields {

/// Whether an annulus' gate overlaps this one.
bool overlaps(const Annulus& annulus, bool forward, const PassedGate& gate);

/// Along one line.
class AnnulusSearch {
 public:
  AnnulusSearch(const Surroundings& around, AnnulusNotes& notes)
      : around_(around), maker_(around.domain, kDoubles), notes_(notes) {
    maker_.be_quick();
  }

  /// The line enters a side's triangle at a share of the side from its tail, after so many turns.
  /// Whether an annulus was found and added.
  bool visit(bool forward, HalfEdge side, double place, std::size_t turns);
  /// Adds the annulus behind a door, if there is one.
  bool try_door(const AnnulusDoor& door) {
    most_turns_ = kMostTurns;
    maker_.be_quick(false);
    const bool found = try_between(door.forward, door.side, door.low, door.high);
    maker_.be_quick();
    return found;
  }
  /// The line came back to the same places again and again, and no annulus was found.
  bool hopeless() const;

  /// The annulus whose gate holds this one.
  template <class Real>
  std::optional<Index> holding(bool forward, const Gate<Real>& gate) const {
    for (Index i = 0; i < notes_.size(); ++i) {
      const Annulus& a = notes_[i];
      if (a.side == gate.side && a.forward == forward &&
          strictly_inside(gate, Gate<double>{a.side, a.left, a.right}))
        return i;
    }
    return std::nullopt;
  }

 private:
  static constexpr std::size_t kMostTurns = 100'000;
  bool known(bool forward, const Gate<double>& gate);
  bool try_between(bool forward, HalfEdge side, double low, double high);

  struct Visit {
    double place;
    std::size_t turns;
  };
  const Surroundings& around_;
  BarrierMaker<double> maker_;  ///< annuli need no more
  AnnulusNotes& notes_;
  std::unordered_map<HalfEdge, std::vector<Visit>> visits_;
  std::size_t next_try_ = 0, fruitless_ = 0;
  std::size_t most_turns_ = 0;  ///< cells of a trial: twice around
};

}  // namespace crest::vector_fields
