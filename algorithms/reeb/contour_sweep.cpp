// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/reeb/contour_sweep.hpp"

#include <algorithm>
#include <utility>

namespace crest::reeb {
namespace {

// At every gap two ends meet: that of a stretch and that of an upper run.
constexpr Index stretch_end(Index gap) {
  return 2 * gap;
}
constexpr Index upper_end(Index gap) {
  return 2 * gap + 1;
}
constexpr int kFront = 0, kBack = 1;

}  // namespace

ContourSweep::ContourSweep(const StrandLists& strands)
    : arc_of_lower_run(strands.strand_above.size(), kNone),
      arc_of_upper_run(strands.upper.size() - 1, kNone),
      strands_(strands),
      sequences_(static_cast<Index>(strands.turned.size())) {
  for (Index s = 0; s < strands.turned.size(); ++s)
    if (strands.turned[s]) sequences_.set_sense(s, true);
}

void ContourSweep::announce(const std::vector<Index>& stops, std::size_t i) const {
  if (i + 24 < stops.size()) __builtin_prefetch(&strands_.stops[stops[i + 24]]);
  if (i + 16 < stops.size()) {
    const Stop& s = strands_.stops[stops[i + 16]];
    __builtin_prefetch(strands_.strand_above.data() + s.lower_begin);
    __builtin_prefetch(strands_.upper.data() + s.upper_begin);
  }
  if (i + 8 < stops.size()) {
    const Index stop = stops[i + 8], begin = strands_.stops[stop].lower_begin;
    for (Index k = 0; k < std::min(strands_.lower_count(stop), Index{3}); ++k)
      sequences_.prefetch(strands_.strand_above[begin + k]);
  }
}

Index ContourSweep::new_piece() {
  Index piece;
  if (free_pieces_.empty()) {
    piece = static_cast<Index>(pieces_.size());
    pieces_.emplace_back();
  } else {
    piece = free_pieces_.back();
    free_pieces_.pop_back();
    pieces_[piece] = {};
  }
  touched_.push_back(piece);
  return piece;
}

void ContourSweep::set_end(Index piece, int which, Index end) {
  pieces_[piece].ends[static_cast<std::size_t>(which)] = end;
  if (end != kNone) end_owner_[end] = piece;
}

void ContourSweep::set_root(Index piece, Index root) {
  pieces_[piece].root = root;
  if (root != kNone) sequences_.set_label(root, piece);
}

Index ContourSweep::find_piece(Index strand) {
  sequences_.splay(strand);
  return sequences_.label(strand);
}

/// Takes a strand out of its sequence, what is before it (along the link) ending at gap_before.
void ContourSweep::cut_at(Index strand, Index gap_before, Index gap_after) {
  const Index piece = find_piece(strand);
  const std::array<Index, 2> parts = sequences_.remove(strand);
  if (sequences_.turned(strand)) std::swap(gap_before, gap_after);
  if (pieces_[piece].closed) {
    pieces_[piece].closed = false;
    set_root(piece, sequences_.join(parts[1], parts[0]));
    set_end(piece, kFront, stretch_end(gap_after));
    set_end(piece, kBack, stretch_end(gap_before));
    return;
  }
  const Index rest = new_piece();
  set_root(rest, parts[1]);
  set_end(rest, kFront, stretch_end(gap_after));
  set_end(rest, kBack, pieces_[piece].ends[kBack]);
  set_root(piece, parts[0]);
  set_end(piece, kBack, stretch_end(gap_before));
}

// Gap 2 i is before L_i in the link's direction, gap 2 i + 1 after it.
void ContourSweep::cut_lower_runs(Index stop) {
  const Index count = strands_.lower_count(stop);
  const Index* strand = strands_.strand_above.data() + strands_.stops[stop].lower_begin;
  end_owner_.assign(std::size_t{4} * count, kNone);
  for (Index i = 0; i < count; ++i) cut_at(strand[i], 2 * i, 2 * i + 1);
}

void ContourSweep::reverse(Index piece) {
  sequences_.reverse(pieces_[piece].root);
  std::swap(pieces_[piece].ends[kFront], pieces_[piece].ends[kBack]);
}

void ContourSweep::join_at(Index gap) {
  Index a = end_owner_[stretch_end(gap)], b = end_owner_[upper_end(gap)];
  if (a == b) {
    pieces_[a].ends = {kNone, kNone};
    pieces_[a].closed = true;
    return;
  }
  int of_a = pieces_[a].ends[kBack] == stretch_end(gap) ? kBack : kFront;
  int of_b = pieces_[b].ends[kBack] == upper_end(gap) ? kBack : kFront;
  if (of_a == kFront && of_b == kBack) {
    std::swap(a, b);
    std::swap(of_a, of_b);
  }
  // Only on a surface whose links disagree:
  if (of_a == kFront) reverse(a);
  if (of_b == kBack) reverse(b);
  set_root(a, sequences_.join(pieces_[a].root, pieces_[b].root));
  set_end(a, kBack, pieces_[b].ends[kBack]);
  pieces_[a].least = std::min(pieces_[a].least, pieces_[b].least);
  pieces_[b].root = kNone;
  pieces_[b].least = kNone;
  pieces_[b].joined_to = a;
}

void ContourSweep::join_upper_runs(Index stop) {
  const Stop& s = strands_.stops[stop];
  const Index lower = strands_.lower_count(stop), upper = strands_.upper_count(stop);
  // The gaps at the two sides of U_j, along the link; there is none at the end of a path.
  const auto gap_before = [&](Index j) {
    if (s.starts_lower) return 2 * j + 1;
    return j > 0 ? 2 * j - 1 : kNone;
  };
  const auto gap_after = [&](Index j) {
    const Index next = s.starts_lower ? j + 1 : j;
    if (next < lower) return 2 * next;
    return s.closed && lower > 0 ? 0 : kNone;
  };
  run_pieces_.clear();
  for (Index j = 0; j < upper; ++j) {
    const UpperRun& run = strands_.upper[s.upper_begin + j];
    const Index piece = new_piece();
    set_root(piece, sequences_.build(run.strand_begin,
                                     strands_.upper[s.upper_begin + j + 1].strand_begin));
    run_pieces_.push_back(piece);
    pieces_[piece].least = run.least;
    pieces_[piece].closed = s.closed && lower == 0;
    if (gap_after(j) != kNone) set_end(piece, kFront, upper_end(gap_after(j)));
    if (gap_before(j) != kNone) set_end(piece, kBack, upper_end(gap_before(j)));
  }
  for (Index j = 0; j < upper; ++j) {
    if (gap_before(j) != kNone) join_at(gap_before(j));
    if (gap_after(j) != kNone) join_at(gap_after(j));
  }
}

void ContourSweep::pass_node(Index stop, Index node) {
  touched_.clear();
  const Stop& s = strands_.stops[stop];
  const Index lower_end = strands_.stops[stop + 1].lower_begin;
  for (Index i = s.lower_begin; i < lower_end; ++i)
    arc_of_lower_run[i] = pieces_[find_piece(strands_.strand_above[i])].arc;
  for (Index i = s.lower_begin; i < lower_end; ++i) {
    const Index piece = find_piece(strands_.strand_above[i]);
    if (pieces_[piece].arc == kNone) continue;
    touched_.push_back(piece);
    arcs[pieces_[piece].arc].upper = node;
    pieces_[piece].arc = kNone;
  }
  cut_lower_runs(stop);
  join_upper_runs(stop);
  for (const Index piece : touched_) {
    Piece& p = pieces_[piece];
    if (p.least == kNone) {
      free_pieces_.push_back(piece);
      continue;
    }
    const std::uint8_t open = p.closed ? 0 : 1;
    p.arc = static_cast<Index>(arcs.size());
    arcs.push_back({node, kNone, p.least, open, open});
    p.least = kNone;
  }
  record_upper_runs(stop);
}

void ContourSweep::record_upper_runs(Index stop) {
  const Index begin = strands_.stops[stop].upper_begin;
  for (Index j = 0; j < run_pieces_.size(); ++j) {
    Index piece = run_pieces_[j];
    while (pieces_[piece].joined_to != kNone) {
      const Index next = pieces_[piece].joined_to;
      if (pieces_[next].joined_to != kNone) pieces_[piece].joined_to = pieces_[next].joined_to;
      piece = next;
    }
    arc_of_upper_run[begin + j] = pieces_[piece].arc;
  }
}

Index ContourSweep::pass_regular(Index stop) {
  touched_.clear();
  const Index old = find_piece(strands_.strand_above[strands_.stops[stop].lower_begin]);
  const Index arc = pieces_[old].arc;
  arc_of_lower_run[strands_.stops[stop].lower_begin] = arc;
  arc_of_upper_run[strands_.stops[stop].upper_begin] = arc;
  touched_.push_back(old);
  cut_lower_runs(stop);
  join_upper_runs(stop);
  for (const Index piece : touched_) {
    if (pieces_[piece].least == kNone) {
      free_pieces_.push_back(piece);
    } else {
      pieces_[piece].arc = arc;
      pieces_[piece].least = kNone;
    }
  }
  return arc;
}

}  // namespace crest::reeb
