// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tries half-edge collapses in the order of a priority, and flips of edges where none is left, and
// keeps those that leave the skeleton as it is.
#include "algorithms/vector_fields/search.hpp"

namespace crest::vector_fields {

class Collapser {
 public:
  /// Requires: both outlive the collapser.
  Collapser(SearchState& state, const CompressionOptions& options)
      : state_(state),
        options_(options),
        minor_(std::any_of(state.zeros.begin(), state.zeros.end(),
                           [](const SearchZero& z) { return !z.kept; })),
        changed_(state.mesh.vertex_count(), 0),
        changed_at_(state.mesh.vertex_count(), 1),
        stuck_at_(state.mesh.vertex_count(), 0),
        in_star_(state.mesh.triangle_count(), 0),
        seen_(state.line_count() + state.orbits.size(), 0),
        failed_(state.line_count(), 0) {}

  /// Until nothing more collapses.
  void run(CompressionCounts& counts);

 private:
  enum class Answer : std::uint8_t { yes, geometry, boundary, critical, ends, order, orbit, open };
  struct Retraced {
    Index line;
    std::size_t from;        ///< the first step that is new
    std::vector<Step> tail;  ///< the old ones
    Start start;             ///< the old one
    std::optional<Step> first;
  };
  struct MovedZero {
    Index zero;
    SearchZero old, now;
    /// Of a saddle: its separatrices (forward, backward) and their old directions.
    std::vector<Index> lines = {};
    std::vector<Vec2> rays = {};
  };
  struct NewZero {
    ZeroKind kind;
    Index triangle;
  };

  bool pass(CompressionCounts& counts);
  bool try_collapse(Index from, Index to, CompressionCounts& counts);
  static bool note(Answer answer, CompressionCounts& counts);
  void loosen(CompressionCounts& counts);
  void loosen(Index vertex, CompressionCounts& counts);
  bool may_go(Index vertex) const;
  bool as_it_was(Index vertex) const;
  bool take_out(Index vertex, CompressionCounts& counts);
  Answer attempt_filling();
  bool cancels(Index from, Index to);
  double priority(Index from, Index to) const;
  Answer attempt(Index from, Index to);
  Answer attempt_flip(HalfEdge side);
  Answer change();
  void note_change();
  Answer examine_zeros();
  Answer examine_minor(const std::vector<Index>& old);
  bool find_new_zeros(std::vector<NewZero>& found) const;
  void collect();
  Answer examine_orbits();
  Answer prove_orbit(Index orbit);
  bool enters_moved_orbit(const SearchLine& line, std::size_t step) const;
  Answer examine_lines();
  Answer retrace(Index line, std::size_t from);
  bool note_rays(MovedZero& saddle) const;
  Answer retrace_saddle(const MovedZero& saddle);
  Answer examine_orders();
  void commit();
  void take_back();

  SearchState& state_;
  const CompressionOptions& options_;
  const bool minor_;          ///< there are zeros that may vanish
  std::vector<int> changed_;  ///< by vertex: the pass in which its star changed last
  int pass_ = 0;
  /// By vertex: the attempts made when its star changed last, when nothing around it would do.
  std::vector<std::size_t> changed_at_, stuck_at_;
  // Of the attempt at hand.
  Collapse plan_;
  std::vector<Index> corners_;  ///< of a hole
  std::vector<std::uint8_t> in_star_;
  std::vector<std::size_t> seen_;    ///< by line, then orbit: the last attempt it was met in
  std::vector<std::size_t> failed_;  ///< by line: the last attempt refused for it
  std::size_t attempts_ = 1;
  std::vector<Index> lines_, chains_;  ///< through the star
  std::vector<HalfEdge> lost_sides_;   ///< sides of the star that change
  std::vector<MovedZero> moved_zeros_;
  std::vector<std::pair<Index, SearchOrbit>> moved_orbits_;
  std::vector<Retraced> retraced_;
};

}  // namespace crest::vector_fields
