// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>
#include <vector>

#include "certify/container/parallel.hpp"
#include "certify/container/reject.hpp"
#include "certify/reeb/checks.hpp"

namespace crest::certify::reeb {
namespace {

enum class Direction { up, down };

/// The components of a growing forest at any time, each named by one of the leaves it began with:
/// union by size without shortening, so that every merge stays readable. Cost: log n a question.
class Merges {
 public:
  explicit Merges(std::size_t leaves) : into_(leaves), size_(leaves, 1) {
    for (u32 leaf = 0; leaf < leaves; ++leaf) into_[leaf] = {leaf, kNone};
  }
  /// Before `time`.
  u32 find(u32 leaf, u32 time) const {
    while (into_[leaf].time < time) leaf = into_[leaf].leaf;
    return leaf;
  }
  /// Of the components a and b, which must be current; returns the name of both.
  u32 join(u32 a, u32 b, u32 time) {
    if (size_[a] < size_[b]) std::swap(a, b);
    size_[a] += size_[b];
    into_[b] = {a, time};
    return a;
  }
  /// When the leaf lost its name to another; kNone if it has it still.
  u32 time(u32 leaf) const { return into_[leaf].time; }

 private:
  struct Into {
    u32 leaf, time;
  };
  Buffer<Into> into_;
  Buffer<u32> size_;
};

/// One sweep over G'', upwards for its join tree, downwards for its split tree; then K'' is
/// compared with it, node by node in the order of the mesh, where neighbours are near in memory.
///
/// The nodes of K'' keep their numbers in K; cut k adds the maximum N + 2 k below it and the
/// minimum N + 2 k + 1 above it. A node's time is its rank, downwards counted from above. Its label
/// is the component it is in as soon as it has been met.
class Sweep {
 public:
  Sweep(const ReebContents& c, const Complex& k, const NodeTypes& types, const Cuts& cuts,
        Direction direction)
      : c_(c),
        k_(k),
        types_(types),
        cuts_(cuts),
        up_(direction == Direction::up),
        neighbours_(up_ ? types.lower : types.upper),
        label_(k.nodes() + 2 * c.cuts.size(), kNone),
        merges_(name_leaves()) {}

  void run() {
    collect_arcs();
    reached_.resize(k_.nodes());
    for (u32 v = 0; v < k_.nodes(); ++v) reached_[v] = types_.critical(v) ? v : kNone;
    sweep_graph();
    compare();
  }
  /// The component as far as the sweep has come.
  u32 component(u32 node) const { return merges_.find(label_[node], kNone); }

 private:
  u32 lower_end(u32 cut) const { return c_.arcs[c_.cuts[cut].arc].lower; }
  u32 maximum_below(u32 cut) const { return static_cast<u32>(k_.nodes()) + 2 * cut; }
  u32 minimum_above(u32 cut) const { return maximum_below(cut) + 1; }
  u32 end_at(u32 cut) const { return up_ ? minimum_above(cut) : maximum_below(cut); }
  u32 time(u32 v) const { return up_ ? k_.rank[v] : static_cast<u32>(k_.nodes()) - 1 - k_.rank[v]; }

  /// Labels K's minima or maxima and the ends of cuts, where components begin; returns how many.
  std::size_t name_leaves() {
    u32 leaves = 0;
    for (u32 v = 0; v < k_.nodes(); ++v)
      if ((up_ ? types_.nodes[v].down : types_.nodes[v].up) == kNone) label_[v] = leaves++;
    for (u32 cut = 0; cut < c_.cuts.size(); ++cut) label_[end_at(cut)] = leaves++;
    return leaves;
  }

  /// G'' by the later ends of its arcs: the nodes of K'' at their earlier ends.
  void collect_arcs() {
    arc_start_.assign(c_.critical_nodes.size() + 2, 0);
    for (const ArcRecord& arc : c_.arcs) ++arc_start_[(up_ ? arc.upper : arc.lower) + 2];
    std::partial_sum(arc_start_.begin(), arc_start_.end(), arc_start_.begin());
    arc_end_.resize(c_.arcs.size());
    u32 cut = 0;
    for (u32 a = 0; a < c_.arcs.size(); ++a) {
      const ArcRecord& arc = c_.arcs[a];
      u32& end = arc_end_[arc_start_[(up_ ? arc.upper : arc.lower) + 1]++];
      const bool is_cut = cut < c_.cuts.size() && c_.cuts[cut].arc == a;
      end = is_cut ? end_at(cut++) : c_.critical_nodes[up_ ? arc.lower : arc.upper];
    }
  }

  void sweep_graph() {
    const auto nodes = static_cast<u32>(c_.critical_nodes.size());
    auto cut = up_ ? u32{0} : static_cast<u32>(c_.cuts.size());
    for (u32 step = 0; step < nodes; ++step) {
      const u32 i = up_ ? step : nodes - 1 - step;
      // The order is random: nothing else tells the processor in time what is read next.
      constexpr u32 kAhead = 16;
      if (nodes - step > kAhead) fetch(up_ ? i + kAhead : i - kAhead);
      // The cuts just above a node, whose arcs begin there, come after it upwards.
      if (up_) visit(i);
      for (; up_ && cut < c_.cuts.size() && lower_end(cut) == i; ++cut) visit_cut(cut);
      for (; !up_ && cut > 0 && lower_end(cut - 1) == i; --cut) visit_cut(cut - 1);
      if (!up_) visit(i);
    }
  }
  void fetch(u32 i) const {
    __builtin_prefetch(&label_[c_.critical_nodes[i]]);
    if (arc_start_[i + 1] - arc_start_[i] > 1) __builtin_prefetch(&k_.rank[c_.critical_nodes[i]]);
    for (u32 arc = arc_start_[i]; arc < arc_start_[i + 1]; ++arc)
      __builtin_prefetch(&label_[arc_end_[arc]]);
  }

  void visit(u32 i) {
    const u32 v = c_.critical_nodes[i], first = arc_start_[i], end = arc_start_[i + 1];
    if (first == end) return require_same(label_[v] != kNone, v);
    require_same(label_[v] == kNone, v);
    u32 all = component(arc_end_[first]);
    for (u32 arc = first + 1; arc < end; ++arc) {
      const u32 found = component(arc_end_[arc]);
      require(found != all, "graph: a loop without cut {} node {}", up_ ? "below" : "above", v);
      all = merges_.join(all, found, time(v));
    }
    label_[v] = all;
  }
  void require_same(bool same, u32 v) const {
    require(same, "graph: {} node {} other components meet than in the surface",
            up_ ? "below" : "above", v);
  }

  /// Of the two new nodes of a cut one ends what comes along its arc; with the other a component
  /// begins.
  void visit_cut(u32 cut) {
    const ArcRecord& arc = c_.arcs[c_.cuts[cut].arc];
    const u32 low = c_.critical_nodes[arc.lower];
    // Upwards the edge v w leads down to v, downwards up to the next cut across it or to w.
    const u32 found = component(up_ ? low : above(cut, low));
    require(found == component(up_ ? low : c_.critical_nodes[arc.upper]),
            "cut {}: its arc leads to another component", cut);
    label_[up_ ? maximum_below(cut) : minimum_above(cut)] = found;
  }
  u32 above(u32 cut, u32 v) {
    const auto cuts = cuts_.across(v, c_.cuts[cut].node);
    const auto next =
        std::upper_bound(cuts.begin(), cuts.end(), cut,
                         [](u32 to, const Cuts::Crossing& crossing) { return to < crossing.cut; });
    return next != cuts.end() ? maximum_below(next->cut) : reach(c_.cuts[cut].node);
  }

  /// The node of K'' in which the part of the edge v w next to its later end v ends; kNone if that
  /// is w.
  u32 at_cut(u32 v, u32 w) const {
    const auto cuts = up_ ? cuts_.across(w, v) : cuts_.across(v, w);
    if (cuts.empty()) return kNone;
    return end_at(up_ ? cuts.back().cut : cuts.front().cut);
  }
  u32 before(u32 v, u32 w) {
    const u32 end = at_cut(v, w);
    return end != kNone ? end : reach(w);
  }

  /// The critical node of K'' at the end of a monotone path from v; kept for all of the path. A
  /// regular node has one run to choose from, all of which is in one component.
  u32 reach(u32 v) {
    path_.clear();
    u32 end = kNone;
    while (end == kNone && (end = reached_[v]) == kNone) {
      path_.push_back(v);
      const u32 w = up_ ? types_.nodes[v].down : types_.nodes[v].up;
      end = at_cut(v, w);
      v = w;
    }
    for (const u32 node : path_) reached_[node] = end;
    return end;
  }

  /// The components in which the runs of a node's link end are among those that its arcs come from:
  /// its label's, and those that merged at its time. All of them are met if as many are as there
  /// are arcs in all.
  void compare() {
    std::size_t met = 0;
    std::vector<u32> found;
    for (u32 v = 0; v < k_.nodes(); ++v) {
      const u32 first = types_.start[v], last = types_.start[v + 1];
      if (first == last || neighbours_[first] == kNone) continue;
      const u32 now = time(v);
      found.clear();
      u32 end = kNone;
      for (u32 at = first; at < last; ++at) {
        const u32 previous = end;
        end = before(v, neighbours_[at]);
        if (end == previous) continue;
        const u32 leaf = merges_.find(label_[end], now);
        require_same(leaf == label_[v] || merges_.time(leaf) == now, v);
        if (found.empty() || found.back() != leaf) found.push_back(leaf);
      }
      if (found.size() > 1) std::sort(found.begin(), found.end());
      met += static_cast<std::size_t>(std::unique(found.begin(), found.end()) - found.begin());
    }
    require(met == c_.arcs.size(), "graph: {} nodes components meet that do not in the surface",
            up_ ? "below" : "above");
  }

  const ReebContents& c_;
  const Complex& k_;
  const NodeTypes& types_;
  const Cuts& cuts_;
  bool up_;
  const Buffer<u32>& neighbours_;
  Buffer<u32> label_, arc_start_, arc_end_, reached_;
  Merges merges_;
  std::vector<u32> path_;
};

/// Theorem 6's hypothesis. `join` has swept upwards: its components are those of K''.
void check_components(const ReebContents& c, const NodeTypes& types, const Cuts& cuts,
                      const Sweep& join) {
  struct Sum {
    std::int64_t euler = 0;
    std::uint64_t saddles = 0;
  };
  // By a component's name: one of K's minima or a cut's end.
  std::vector<Sum> sums(types.nodes.size() + c.cuts.size());
  const auto nodes = static_cast<u32>(types.nodes.size());
  const auto add = [&](u32 node, std::int64_t euler, bool saddle) {
    Sum& sum = sums[join.component(node)];
    sum.euler += euler;
    sum.saddles += saddle;
  };
  for (u32 v = 0; v < nodes; ++v) {
    if (!types.critical(v)) continue;
    const auto [l, u] = runs_of(types.nodes[v]);
    add(v, index_of(types.nodes[v]), l != 0 && u != 0);
  }
  // A cone over a path adds nothing as a maximum.
  for (u32 cut = 0; cut < c.cuts.size(); ++cut) {
    add(nodes + 2 * cut, cuts.cycle[cut], false);
    add(nodes + 2 * cut + 1, 1, false);
  }
  // Names that are no longer in use have no saddle.
  for (const Sum& s : sums)
    require(s.euler >= 1 || s.saddles <= 1,
            "cuts: a component with Euler characteristic {} and {} saddles is left", s.euler,
            s.saddles);
}

}  // namespace

void check_trees(const ReebContents& c, const Complex& k, const NodeTypes& types,
                 const Cuts& cuts) {
  require(k.nodes() + 2 * c.cuts.size() < kNone, "cuts: more than the checker numbers");
  const auto sweep = [&](int, std::size_t direction) {
    if (direction == 1) return Sweep(c, k, types, cuts, Direction::down).run();
    Sweep join(c, k, types, cuts, Direction::up);
    join.run();
    check_components(c, types, cuts, join);
  };
  parallel_for(
      2, [] { return 0; }, sweep);
}

}  // namespace crest::certify::reeb
