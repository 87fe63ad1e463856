// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/reeb/graph_layout.hpp"

#include <algorithm>
#include <queue>
#include <tuple>
#include <utility>

namespace crest::io {
namespace {

using reeb::Index;
using reeb::kNone;
using reeb::ReebArc;
using reeb::ReebGraph;

struct Branch {
  std::vector<Index> arcs;  ///< ascending
  Index low, high;          ///< nodes
};

/// The arcs below or above each node.
using ArcsOf = std::vector<std::vector<Index>>;

/// For each arc the one that goes on above it, or kNone.
std::vector<Index> successors(const ReebGraph& graph, const ArcsOf& below, const ArcsOf& above) {
  const auto n = static_cast<Index>(graph.nodes.size());
  std::vector<Index> highest(n), start(graph.arcs.size());  // start: of the branch an arc is in
  for (Index v = n; v-- > 0;) {
    highest[v] = v;
    for (const Index a : above[v]) highest[v] = std::max(highest[v], highest[graph.arcs[a].upper]);
  }
  std::vector<Index> next(graph.arcs.size(), kNone);
  for (Index v = 0; v < n; ++v) {
    std::vector<Index> in = below[v], out = above[v];
    std::sort(in.begin(), in.end(),
              [&](Index a, Index b) { return std::pair(start[a], a) < std::pair(start[b], b); });
    std::sort(out.begin(), out.end(), [&](Index a, Index b) {
      const Index x = highest[graph.arcs[a].upper], y = highest[graph.arcs[b].upper];
      return x != y ? x > y : a < b;
    });
    for (std::size_t i = 0; i < out.size(); ++i) {
      start[out[i]] = i < in.size() ? start[in[i]] : v;
      if (i < in.size()) next[in[i]] = out[i];
    }
  }
  return next;
}

std::vector<Branch> branches_of(const ReebGraph& graph, const std::vector<Index>& next) {
  std::vector<bool> continues(graph.arcs.size(), false);
  for (const Index a : next)
    if (a != kNone) continues[a] = true;
  std::vector<Branch> branches;
  std::vector<bool> alone(graph.nodes.size(), true);
  for (const ReebArc& arc : graph.arcs) alone[arc.lower] = alone[arc.upper] = false;
  for (Index v = 0; v < alone.size(); ++v)
    if (alone[v]) branches.push_back({{}, v, v});
  for (Index first = 0; first < graph.arcs.size(); ++first) {
    if (continues[first]) continue;
    Branch branch{{}, graph.arcs[first].lower, 0};
    for (Index a = first; a != kNone; a = next[a]) branch.arcs.push_back(a);
    branch.high = graph.arcs[branch.arcs.back()].upper;
    branches.push_back(std::move(branch));
  }
  return branches;
}

/// LayoutColumns with the spans that are taken in them.
class LayoutColumns {
 public:
  /// The free column nearest to `start`, left before right.
  int take(int start, double low, double high) {
    for (int away = 0;; ++away) {
      for (const int column : {start - away, start + away}) {
        if (!free(column, low, high)) continue;
        taken_.push_back({column, low, high});
        return column;
      }
    }
  }
  int beyond() const {
    int last = 0;
    for (const auto& [column, low, high] : taken_) last = std::max(last, column + 1);
    return last;
  }
  int first() const {
    int least = 0;
    for (const auto& [column, low, high] : taken_) least = std::min(least, column);
    return least;
  }

 private:
  bool free(int column, double low, double high) const {
    return std::none_of(taken_.begin(), taken_.end(), [&](const auto& span) {
      const auto& [c, a, b] = span;
      return c == column && a <= high && low <= b;
    });
  }
  std::vector<std::tuple<int, double, double>> taken_;
};

class Placement {
 public:
  Placement(const ReebGraph& graph, const std::vector<double>& heights,
            std::vector<Branch> branches)
      : graph_(graph), heights_(heights), branches_(std::move(branches)) {
    layout_.node_column.assign(graph.nodes.size(), kNoColumn);
    layout_.arc_column.assign(graph.arcs.size(), kNoColumn);
    at_node_.resize(graph.nodes.size());
    for (std::size_t b = 0; b < branches_.size(); ++b) {
      for_nodes(branches_[b], [&](Index v) { at_node_[v].push_back(b); });
      order_.push_back(b);
    }
    std::sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
      return std::pair(-length(a), a) < std::pair(-length(b), b);
    });
  }

  GraphLayout run(std::size_t most) {
    std::size_t placed = 0;
    done_.assign(branches_.size(), false);
    for (const std::size_t root : order_) {
      if (done_[root] || placed >= most) continue;
      place(root, columns_.beyond());
      ++placed;
      while (!waiting_.empty()) {
        const auto [key, b, node] = waiting_.top();
        waiting_.pop();
        if (done_[b] || placed >= most) continue;
        place(b, layout_.node_column[node]);
        ++placed;
      }
    }
    finish();
    return std::move(layout_);
  }

 private:
  double length(std::size_t b) const {
    return heights_[branches_[b].high] - heights_[branches_[b].low];
  }

  template <class Visit>
  void for_nodes(const Branch& branch, Visit&& visit) const {
    visit(branch.low);
    for (const Index a : branch.arcs) visit(graph_.arcs[a].upper);
  }

  void place(std::size_t b, int start) {
    const Branch& branch = branches_[b];
    const int column = columns_.take(start, heights_[branch.low], heights_[branch.high]);
    done_[b] = true;
    for (const Index a : branch.arcs) layout_.arc_column[a] = column;
    for_nodes(branch, [&](Index v) {
      if (layout_.node_column[v] != kNoColumn) return;
      layout_.node_column[v] = column;
      for (const std::size_t other : at_node_[v])
        if (!done_[other]) waiting_.push({length(other), other, v});
    });
  }

  /// LayoutColumns from 0 on: until then some are negative.
  void finish() {
    const int first = columns_.first();
    for (auto* columns : {&layout_.node_column, &layout_.arc_column}) {
      for (int& column : *columns)
        if (column != kNoColumn) column -= first;
    }
    const auto& arcs = layout_.arc_column;
    layout_.left_out = static_cast<std::size_t>(std::count(arcs.begin(), arcs.end(), kNoColumn));
    layout_.columns = columns_.beyond() - first;
  }

  /// The longest first, then the least number.
  struct Waiting {
    double length;
    std::size_t branch;
    Index node;
    bool operator<(const Waiting& other) const {
      return std::tie(length, other.branch, other.node) < std::tie(other.length, branch, node);
    }
  };

  const ReebGraph& graph_;
  const std::vector<double>& heights_;
  std::vector<Branch> branches_;
  std::vector<std::vector<std::size_t>> at_node_;
  std::vector<std::size_t> order_;
  std::vector<bool> done_;
  std::priority_queue<Waiting> waiting_;
  LayoutColumns columns_;
  GraphLayout layout_;
};

}  // namespace

GraphLayout lay_out(const ReebGraph& graph, const std::vector<double>& heights, std::size_t most) {
  ArcsOf below(graph.nodes.size()), above(graph.nodes.size());
  for (Index a = 0; a < graph.arcs.size(); ++a) {
    below[graph.arcs[a].upper].push_back(a);
    above[graph.arcs[a].lower].push_back(a);
  }
  return Placement(graph, heights, branches_of(graph, successors(graph, below, above))).run(most);
}

}  // namespace crest::io
