// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/reeb/strands.hpp"

#include <algorithm>

namespace crest::reeb {
namespace {

class Builder {
 public:
  Builder(const OrderedComplex& complex, VertexStars& stars, std::span<const std::uint8_t> asked)
      : rank_(complex.rank), order_of_ranks_(complex.order), stars_(stars), asked_(asked) {}

  StrandLists build() {
    classify();
    trace_down();
    collect_up();
    return std::move(out_);
  }

 private:
  Index vertex_count() const { return static_cast<Index>(rank_.size()); }
  void classify();
  void add_stop(Index v, bool critical);
  void trace_down();
  void collect_up();
  void collect_runs(Index stop);
  void follow(Index edge, Index from, bool turned);
  void children_in_order(Index v, std::vector<Index>& out);
  /// Marked edges are named by their upper end v, or by n + s if that is where strand s starts.
  Index upper_end(Index edge) const {
    return edge < vertex_count() ? edge : strand_top_[edge - vertex_count()];
  }

  std::span<const Index> rank_, order_of_ranks_;
  VertexStars& stars_;
  std::span<const std::uint8_t> asked_;
  StrandLists out_;
  std::vector<Index> down_;        ///< designated lower neighbour, kNone for stops
  std::vector<Index> strand_top_;  ///< by lower run: its vertex
  std::vector<Index> strand_low_;  ///< by lower run: the designated neighbour
  std::vector<Index> first_up_;    ///< by vertex: a marked edge that ends there
  std::vector<Index> next_up_;     ///< by marked edge: another one that ends where it does
  std::vector<Index> edge_from_;   ///< scratch: marked edge from this neighbour
  std::vector<Index> children_, edges_;
  struct Pending {
    Index edge, from;
    bool turned;
  };
  std::vector<Pending> pending_;
  Link link_;
};

void Builder::classify() {
  const Index n = vertex_count();
  down_.assign(n, kNone);
  for (Index v = 0; v < n; ++v) {
    const Index own = rank_[v];
    Index lowest = kNone, ends = 0;
    unsigned changes = 0;
    for (const VertexStars::Side& s : stars_.star(v)) {
      const Index a = rank_[s[0]], b = rank_[s[1]];
      changes += (a < own) != (b < own);
      ends ^= s[0] ^ s[1];
      lowest = std::min(lowest, std::min(a, b));
    }
    // Every vertex of a cycle occurs twice, the two ends of a path once.
    const bool regular = changes == (ends == 0 ? 2u : 1u);
    if (regular && (asked_.empty() || asked_[v] == 0))
      down_[v] = order_of_ranks_[lowest];
    else
      add_stop(v, !regular);
  }
  out_.stops.push_back({kNone, static_cast<Index>(strand_top_.size()),
                        static_cast<Index>(out_.upper.size()), 0, 0, 0});
}

void Builder::add_stop(Index v, bool critical) {
  stars_.link(v, link_);
  rotate_to_lower_run(link_, rank_, v);
  const auto& ring = link_.vertices;
  const bool starts_lower = rank_[ring[0]] < rank_[v];
  out_.stops.push_back(
      {v, static_cast<Index>(strand_top_.size()), static_cast<Index>(out_.upper.size()),
       static_cast<std::uint8_t>(link_.closed), static_cast<std::uint8_t>(starts_lower),
       static_cast<std::uint8_t>(critical)});
  bool was_lower = !starts_lower;
  for (const Index w : ring) {
    const bool lower = rank_[w] < rank_[v];
    if (lower != was_lower) {
      if (lower) {
        strand_top_.push_back(v);
        strand_low_.push_back(w);
      } else {
        out_.upper.push_back({0, w});
      }
    } else if (lower) {
      if (rank_[w] < rank_[strand_low_.back()]) strand_low_.back() = w;
    } else {
      out_.upper.back().least = std::min(out_.upper.back().least, w);
    }
    was_lower = lower;
  }
}

void Builder::trace_down() {
  const Index n = vertex_count();
  const auto strands = static_cast<Index>(strand_top_.size());
  first_up_.assign(n, kNone);
  next_up_.assign(std::size_t{n} + strands, kNone);
  for (Index s = 0; s < strands; ++s) {
    Index edge = n + s, w = strand_low_[s];
    for (;;) {
      const bool seen = first_up_[w] != kNone;
      next_up_[edge] = first_up_[w];
      first_up_[w] = edge;
      if (seen || down_[w] == kNone) break;
      edge = w;
      w = down_[w];
    }
  }
}

/// The marked edges that end in v, in the order of its link from link_.vertices[0].
void Builder::children_in_order(Index v, std::vector<Index>& out) {
  out.clear();
  for (Index e = first_up_[v]; e != kNone; e = next_up_[e]) edge_from_[upper_end(e)] = e;
  for (const Index w : link_.vertices) {
    if (edge_from_[w] == kNone) continue;
    out.push_back(edge_from_[w]);
    edge_from_[w] = kNone;
  }
}

/// Appends the strands that go on together over this marked edge, which ends in `from`.
void Builder::follow(Index edge, Index from, bool turned) {
  const Index n = vertex_count();
  pending_.push_back({edge, from, turned});
  std::vector<Index>& children = children_;
  while (!pending_.empty()) {
    Pending p = pending_.back();
    pending_.pop_back();
    for (;;) {
      const Index v = upper_end(p.edge);
      p.turned ^= stars_.flips(p.from, v);
      if (p.edge >= n) {
        out_.strand_above[p.edge - n] = static_cast<Index>(out_.turned.size());
        out_.turned.push_back(p.turned);
        break;
      }
      const Index first = first_up_[v];
      if (next_up_[first] == kNone) {
        p = {first, v, p.turned};
        continue;
      }
      stars_.link(v, link_);
      rotate_to_lower_run(link_, rank_, v);
      children_in_order(v, children);
      // The last one pushed comes first: against the link's direction.
      if (p.turned) std::reverse(children.begin(), children.end());
      for (const Index e : children) pending_.push_back({e, v, p.turned});
      break;
    }
  }
}

void Builder::collect_runs(Index stop) {
  const Index v = out_.stops[stop].vertex, begin = out_.stops[stop].upper_begin;
  const Index count = out_.upper_count(stop);
  if (first_up_[v] == kNone || count == 0) {
    for (Index j = 0; j < count; ++j)
      out_.upper[begin + j].strand_begin = static_cast<Index>(out_.turned.size());
    return;
  }
  stars_.link(v, link_);
  rotate_to_lower_run(link_, rank_, v);
  // A marked edge, or kNone where the next upper run begins.
  edges_.clear();
  for (Index e = first_up_[v]; e != kNone; e = next_up_[e]) edge_from_[upper_end(e)] = e;
  bool was_upper = false;
  for (const Index w : link_.vertices) {
    const bool upper = rank_[w] > rank_[v];
    if (upper && !was_upper) edges_.push_back(kNone);
    if (edge_from_[w] != kNone) edges_.push_back(edge_from_[w]);
    edge_from_[w] = kNone;
    was_upper = upper;
  }
  std::size_t at = 0;
  for (Index j = 0; j < count; ++j) {
    out_.upper[begin + j].strand_begin = static_cast<Index>(out_.turned.size());
    std::size_t end = ++at;
    while (end < edges_.size() && edges_[end] != kNone) ++end;
    for (std::size_t i = end; i-- > at;) follow(edges_[i], v, false);
    at = end;
  }
}

void Builder::collect_up() {
  edge_from_.assign(vertex_count(), kNone);
  out_.strand_above.assign(strand_top_.size(), kNone);
  out_.turned.reserve(strand_top_.size());
  for (Index stop = 0; stop + 1 < out_.stops.size(); ++stop) collect_runs(stop);
  out_.upper.push_back({static_cast<Index>(out_.turned.size()), kNone});
}

}  // namespace

void rotate_to_lower_run(Link& link, std::span<const Index> rank, Index v) {
  if (!link.closed) return;
  auto& ring = link.vertices;
  const auto is_lower = [&](Index w) { return rank[w] < rank[v]; };
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (is_lower(ring[i]) && !is_lower(ring[i == 0 ? ring.size() - 1 : i - 1])) {
      std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(i), ring.end());
      return;
    }
  }
}

StrandLists find_strands(const OrderedComplex& complex, VertexStars& stars,
                         std::span<const std::uint8_t> asked) {
  return Builder(complex, stars, asked).build();
}

}  // namespace crest::reeb
