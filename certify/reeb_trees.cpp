// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>

#include "certify/reeb_checks.hpp"
#include "certify/reject.hpp"

namespace crest::certify::reeb {
namespace {

using u32 = std::uint32_t;

/// The critical nodes of K'' in ascending order: after the critical node v, for each cut just
/// above it, the maximum below the cut and then the minimum above it.
struct Sequence {
  std::vector<u32> of_critical, of_cut;  ///< positions; of_cut: of the maximum, the minimum follows
  std::vector<u32> critical, cut;        ///< at a position: one of the two, the other kNone
  bool is_minimum(u32 s) const { return of_cut[cut[s]] != s; }
};

Sequence make_sequence(const ReebCertificate& c) {
  Sequence q;
  const auto add = [&](u32 critical, u32 cut) {
    q.critical.push_back(critical);
    q.cut.push_back(cut);
    return static_cast<u32>(q.critical.size() - 1);
  };
  u32 k = 0;
  for (u32 i = 0; i < c.critical_nodes.size(); ++i) {
    q.of_critical.push_back(add(i, kNone));
    for (; k < c.cuts.size() && c.arcs[c.cuts[k].arc].lower == i; ++k) {
      q.of_cut.push_back(add(kNone, k));
      add(kNone, k);
    }
  }
  return q;
}

/// Arcs of G by their upper or lower end.
struct ArcsAt {
  std::vector<u32> start, arcs;
};
template <class End>
ArcsAt arcs_by(const ReebCertificate& c, const End& end) {
  ArcsAt at;
  at.start.assign(c.critical_nodes.size() + 1, 0);
  for (const ArcRecord& arc : c.arcs) ++at.start[end(arc) + 1];
  std::partial_sum(at.start.begin(), at.start.end(), at.start.begin());
  at.arcs.resize(c.arcs.size());
  std::vector<u32> fill(at.start.begin(), at.start.end() - 1);
  for (u32 a = 0; a < c.arcs.size(); ++a) at.arcs[fill[end(c.arcs[a])]++] = a;
  return at;
}

enum class Direction { up, down };

/// One sweep over K'' and G'': upwards for the join trees, downwards for the split trees. As long
/// as every node joins the same components in both, one union-find serves both.
class Sweep {
 public:
  Sweep(const ReebCertificate& c, const Complex& k, const NodeTypes& types, const Cuts& cuts,
        const Sequence& q, Direction direction)
      : c_(c), k_(k), types_(types), cuts_(cuts), q_(q), up_(direction == Direction::up) {
    arcs_ = up_ ? arcs_by(c, [](const ArcRecord& a) { return a.upper; })
                : arcs_by(c, [](const ArcRecord& a) { return a.lower; });
    arc_cut_.assign(c.arcs.size(), kNone);
    for (u32 k_cut = 0; k_cut < c.cuts.size(); ++k_cut) arc_cut_[c.cuts[k_cut].arc] = k_cut;
    component_.resize(q.critical.size());
    std::iota(component_.begin(), component_.end(), u32{0});
    size_.assign(q.critical.size(), 1);
  }

  void run() {
    reached_.assign(k_.rank.size(), kNone);
    look_along_sides();
    const auto size = static_cast<u32>(q_.critical.size());
    for (u32 i = 0; i < size; ++i) visit(up_ ? i : size - 1 - i);
  }
  /// The component. Comparing roots compares the last nodes that joined: each has one.
  u32 find(u32 s) {
    while (component_[s] != s) s = component_[s] = component_[component_[s]];
    return s;
  }

 private:
  /// The smaller of the two components below the root of the larger one: short ways to the root.
  void attach(u32 s, u32 root) {
    s = find(s);
    if (size_[s] > size_[root]) std::swap(s, root);
    component_[s] = root;
    size_[root] += size_[s];
  }

  /// The node of K'' in which the part of an edge next to its later end ends; kNone if that is the
  /// edge's other end.
  u32 at_cut(u32 side) const {
    const u32 cut = up_ ? cuts_.highest(k_, side) : cuts_.lowest(k_, side);
    return cut == kNone ? kNone : q_.of_cut[cut] + (up_ ? 1 : 0);
  }
  u32 before(u32 side) {
    const u32 end = at_cut(side);
    if (end != kNone) return end;
    const auto [low, high] = k_.ends(side);
    return reach(up_ ? low : high);
  }

  /// The critical node of K'' at the end of a monotone path from v; kept for all of the path. A
  /// regular node has one run to choose from, all of which is in one component.
  u32 reach(u32 v) {
    path_.clear();
    u32 end = kNone;
    while (end == kNone) {
      const auto& node = types_.nodes[v];
      if (node.critical != kNone) {
        end = q_.of_critical[node.critical];
      } else if (reached_[v] != kNone) {
        end = reached_[v];
      } else {
        path_.push_back(v);
        const u32 side = up_ ? node.down : node.up;
        end = at_cut(side);
        const auto [low, high] = k_.ends(side);
        v = up_ ? low : high;
      }
    }
    for (const u32 w : path_) reached_[w] = end;
    return end;
  }

  /// In the order of the mesh, where neighbours are near in memory; the sweep's order is random.
  void look_along_sides() {
    const auto& sides = up_ ? types_.lower : types_.upper;
    target_.assign(sides.size(), kNone);
    for (const auto& node : types_.nodes) {
      if (node.critical == kNone) continue;
      for (u32 at = types_.start[node.critical]; at < types_.start[node.critical + 1]; ++at)
        if (sides[at] != kNone) target_[at] = before(sides[at]);
    }
  }

  void visit(u32 s) {
    if (q_.critical[s] == kNone) return visit_cut(s);
    surface_.clear();
    graph_.clear();
    const u32 i = q_.critical[s];
    for (u32 at = types_.start[i]; at < types_.start[i + 1]; ++at)
      if (target_[at] != kNone) surface_.push_back(find(target_[at]));
    for (u32 at = arcs_.start[i]; at < arcs_.start[i + 1]; ++at)
      graph_.push_back(find(graph_end(arcs_.arcs[at])));
    std::sort(surface_.begin(), surface_.end());
    surface_.erase(std::unique(surface_.begin(), surface_.end()), surface_.end());
    std::sort(graph_.begin(), graph_.end());
    require(std::adjacent_find(graph_.begin(), graph_.end()) == graph_.end(),
            "graph: a loop without cut {} node {}", up_ ? "below" : "above", c_.critical_nodes[i]);
    require(surface_ == graph_, "graph: {} node {} other components meet than in the surface",
            up_ ? "below" : "above", c_.critical_nodes[i]);
    for (const u32 found : surface_) attach(s, found);
  }

  /// Of the two new nodes of a cut one ends what comes along its arc; with the other a component
  /// begins.
  void visit_cut(u32 s) {
    if (q_.is_minimum(s) == up_) return;
    const u32 cut = q_.cut[s];
    const ArcRecord& arc = c_.arcs[c_.cuts[cut].arc];
    // Upwards the edge v w leads down to v, downwards up to the next cut across it or to w.
    const u32 next = cuts_.next_above(k_, cut);
    const u32 end = up_             ? q_.of_critical[arc.lower]
                    : next != kNone ? q_.of_cut[next]
                                    : reach(c_.cuts[cut].node);
    const u32 found = find(end);
    require(found == find(q_.of_critical[up_ ? arc.lower : arc.upper]),
            "cut {}: its arc leads to another component", cut);
    attach(s, found);
  }
  u32 graph_end(u32 arc) const {
    const u32 cut = arc_cut_[arc];
    if (cut != kNone) return q_.of_cut[cut] + (up_ ? 1 : 0);
    return q_.of_critical[up_ ? c_.arcs[arc].lower : c_.arcs[arc].upper];
  }

  const ReebCertificate& c_;
  const Complex& k_;
  const NodeTypes& types_;
  const Cuts& cuts_;
  const Sequence& q_;
  bool up_;
  ArcsAt arcs_;
  std::vector<u32> arc_cut_, component_, size_, reached_, path_, target_, surface_, graph_;
};

/// Theorem 6's hypothesis. `join` has swept upwards: its components are those of K''.
void check_components(const NodeTypes& types, const Cuts& cuts, const Sequence& q, Sweep& join) {
  const auto size = static_cast<u32>(q.critical.size());
  std::vector<std::int64_t> euler(size, 0);
  std::vector<u32> saddles(size, 0);
  for (u32 s = 0; s < size; ++s) {
    const u32 component = join.find(s), i = q.critical[s];
    // A cone over a path adds nothing as a maximum.
    const int of_cut = i != kNone || q.is_minimum(s) ? 1 : cuts.cycle[q.cut[s]];
    euler[component] += i != kNone ? types.index[i] : of_cut;
    saddles[component] += i != kNone && types.saddle[i];
  }
  for (u32 s = 0; s < size; ++s)
    require(join.find(s) != s || euler[s] >= 1 || saddles[s] <= 1,
            "cuts: a component with Euler characteristic {} and {} saddles is left", euler[s],
            saddles[s]);
}

}  // namespace

void check_trees(const ReebCertificate& c, const Complex& k, const NodeTypes& types,
                 const Cuts& cuts) {
  const Sequence q = make_sequence(c);
  Sweep join(c, k, types, cuts, q, Direction::up);
  join.run();
  check_components(types, cuts, q, join);
  Sweep(c, k, types, cuts, q, Direction::down).run();
}

}  // namespace crest::certify::reeb
