// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/reeb/simplify.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <queue>
#include <tuple>

namespace crest::reeb {
namespace {

/// A graph that loses leaf arcs and double arcs. An arc that goes on through a node keeps the
/// number of its lowest part, so arcs above a node keep theirs.
class Shrinking {
 public:
  Shrinking(const ReebGraph& graph, std::span<const double> values, bool loops)
      : graph_(graph),
        values_(values),
        loops_(loops),
        arcs_(graph.arcs),
        taken_by_(graph.arcs.size(), kNone),
        next_part_(graph.arcs.size(), kNone),
        last_part_(graph.arcs.size()),
        up_(graph.nodes.size()),
        down_(graph.nodes.size()),
        first_up_(graph.nodes.size() + 1, 0) {
    for (Index a = 0; a < arcs_.size(); ++a) {
      last_part_[a] = a;
      up_[arcs_[a].lower].add(a);
      down_[arcs_[a].upper].add(a);
      ++first_up_[arcs_[a].lower + 1];
    }
    for (std::size_t i = 1; i < first_up_.size(); ++i) first_up_[i] += first_up_[i - 1];
    for (Index node = 0; node < up_.size(); ++node) pass_through(node);
    for (Index a = 0; a < arcs_.size(); ++a)
      if (alive(a)) consider(a);
  }

  /// Cancels the next arc; false if none is left with persistence <= p.
  bool cancel_next(double p, std::vector<Branch>* branches);

  CoarserGraph result() const;
  Branch branch(Index arc, PairKind kind) const;
  bool alive(Index arc) const { return taken_by_[arc] == kNone; }
  const std::vector<ReebArc>& arcs() const { return arcs_; }
  bool is_end(Index node) const { return up_[node].count == 0 || down_[node].count == 0; }

 private:
  /// A set of arcs of which the last one left can be told.
  struct Arcs {
    Index count = 0, sum = 0;
    void add(Index a) {
      ++count;
      sum ^= a;
    }
    void remove(Index a) {
      --count;
      sum ^= a;
    }
  };
  struct Candidate {
    double persistence;
    Index span, arc;
    bool operator>(const Candidate& o) const {
      return std::tuple(persistence, span, arc) > std::tuple(o.persistence, o.span, o.arc);
    }
  };

  double rise(Index arc) const {
    return values_[graph_.nodes[arcs_[arc].upper].vertex] -
           values_[graph_.nodes[arcs_[arc].lower].vertex];
  }
  bool is_lower_leaf(const ReebArc& a) const {
    return down_[a.lower].count == 0 && up_[a.lower].count == 1 && down_[a.upper].count > 1;
  }
  bool is_upper_leaf(const ReebArc& a) const {
    return up_[a.upper].count == 0 && down_[a.upper].count == 1 && up_[a.lower].count > 1;
  }
  /// The first arc with the same ends, if it is another one.
  Index twin(Index arc) const {
    const auto it = twins_.find({arcs_[arc].lower, arcs_[arc].upper});
    return it == twins_.end() || it->second == arc ? kNone : it->second;
  }
  void consider(Index arc);
  void pass_through(Index node);
  Index first_above(Index node);
  void take(Index arc, Index by) {
    taken_by_[arc] = by;
    up_[arcs_[arc].lower].remove(arc);
    down_[arcs_[arc].upper].remove(arc);
  }

  const ReebGraph& graph_;
  std::span<const double> values_;
  bool loops_;
  std::vector<ReebArc> arcs_;
  std::vector<Index> taken_by_;
  std::vector<Index> next_part_, last_part_;  ///< the old arcs along an arc, from below
  std::vector<Arcs> up_, down_;
  std::vector<Index> first_up_;  ///< arcs are sorted by lower node: where those of a node begin
  std::map<std::array<Index, 2>, Index> twins_;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue_;
};

void Shrinking::consider(Index arc) {
  const ReebArc& a = arcs_[arc];
  bool candidate = is_lower_leaf(a) || is_upper_leaf(a);
  if (loops_) {
    // While two arcs have the same ends neither of them can change.
    const auto [it, fresh] = twins_.try_emplace({a.lower, a.upper}, arc);
    const ReebArc& other = arcs_[it->second];
    if (!alive(it->second) || other.lower != a.lower || other.upper != a.upper) it->second = arc;
    candidate = candidate || it->second != arc;
  }
  if (candidate) queue_.push({rise(arc), a.upper - a.lower, arc});
}

/// Makes one arc of the two at a node that has one below and one above it.
void Shrinking::pass_through(Index node) {
  if (up_[node].count != 1 || down_[node].count != 1) return;
  const Index below = down_[node].sum, above = up_[node].sum;
  taken_by_[above] = below;
  const Index upper = arcs_[above].upper;
  down_[upper].remove(above);
  down_[upper].add(below);
  up_[node] = down_[node] = {};
  arcs_[below].upper = upper;
  arcs_[below].open_above = arcs_[above].open_above;
  next_part_[last_part_[below]] = above;
  last_part_[below] = last_part_[above];
}

Index Shrinking::first_above(Index node) {
  Index& a = first_up_[node];
  while (!alive(a)) ++a;
  return a;
}

bool Shrinking::cancel_next(double p, std::vector<Branch>* branches) {
  while (!queue_.empty() && queue_.top().persistence <= p) {
    const Candidate c = queue_.top();
    queue_.pop();
    if (!alive(c.arc)) continue;
    const ReebArc a = arcs_[c.arc];
    if (rise(c.arc) != c.persistence || a.upper - a.lower != c.span) continue;  // has grown
    const bool low = is_lower_leaf(a), high = is_upper_leaf(a);
    const Index other = loops_ ? twin(c.arc) : kNone;
    if (!low && !high && other == kNone) continue;
    if (branches != nullptr)
      branches->push_back(branch(c.arc, low ? PairKind::minimum : PairKind::maximum));
    take(c.arc, c.arc);
    if (low)
      taken_by_[c.arc] = first_above(a.upper);
    else if (high)
      taken_by_[c.arc] = down_[a.lower].count == 1 ? down_[a.lower].sum : first_above(a.lower);
    else
      taken_by_[c.arc] = other;
    for (const Index node : {a.lower, a.upper}) {
      const Index below = down_[node].sum;
      if (up_[node].count != 1 || down_[node].count != 1) continue;
      pass_through(node);
      consider(below);
    }
    return true;
  }
  return false;
}

Branch Shrinking::branch(Index arc, PairKind kind) const {
  Branch b{kind, arcs_[arc].lower, arcs_[arc].upper, rise(arc), {}};
  for (Index part = arc; part != kNone; part = next_part_[part]) b.arcs.push_back(part);
  return b;
}

CoarserGraph Shrinking::result() const {
  CoarserGraph out;
  out.graph.components = graph_.components;
  std::vector<Index> node(graph_.nodes.size(), kNone), place(arcs_.size(), kNone), kept;
  for (Index i = 0; i < node.size(); ++i) {
    if (up_[i].count + down_[i].count == 0) continue;
    node[i] = static_cast<Index>(out.graph.nodes.size());
    out.graph.nodes.push_back(graph_.nodes[i]);
  }
  for (Index a = 0; a < arcs_.size(); ++a)
    if (alive(a)) kept.push_back(a);
  std::stable_sort(kept.begin(), kept.end(), [&](Index a, Index b) {
    return std::tuple(arcs_[a].lower, arcs_[a].upper) < std::tuple(arcs_[b].lower, arcs_[b].upper);
  });
  for (const Index a : kept) {
    place[a] = static_cast<Index>(out.graph.arcs.size());
    ReebArc arc = arcs_[a];
    arc.lower = node[arc.lower];
    arc.upper = node[arc.upper];
    out.graph.arcs.push_back(arc);
  }
  out.arc_of_arc.resize(arcs_.size());
  std::vector<Index> chain;
  for (Index a = 0; a < arcs_.size(); ++a) {
    chain.clear();
    Index by = a;
    for (; place[by] == kNone; by = taken_by_[by]) chain.push_back(by);
    for (const Index c : chain) place[c] = place[by];
    out.arc_of_arc[a] = place[a];
  }
  return out;
}

}  // namespace

CoarserGraph simplify(const ReebGraph& graph, std::span<const double> values, double p,
                      bool loops) {
  Shrinking shrinking(graph, values, loops);
  while (shrinking.cancel_next(p, nullptr)) {
  }
  return shrinking.result();
}

std::vector<Branch> branch_decomposition(const ReebGraph& graph, std::span<const double> values) {
  Shrinking shrinking(graph, values, false);
  std::vector<Branch> branches;
  while (shrinking.cancel_next(std::numeric_limits<double>::infinity(), &branches)) {
  }
  for (Index a = 0; a < shrinking.arcs().size(); ++a) {
    if (!shrinking.alive(a)) continue;
    const ReebArc& arc = shrinking.arcs()[a];
    const bool whole = shrinking.is_end(arc.lower) && shrinking.is_end(arc.upper);
    branches.push_back(shrinking.branch(a, whole ? PairKind::component : PairKind::loop));
  }
  return branches;
}

}  // namespace crest::reeb
