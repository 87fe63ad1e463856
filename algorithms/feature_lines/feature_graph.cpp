// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/feature_lines/feature_graph.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/feature_lines/topology.hpp"

namespace crest::feature_lines {
namespace {

using kernel::TriangleMesh;

/// Vertices with three or more marked neighbours or in a marked face.
Marks node_vertices(const TriangleMesh& mesh, const Marks& marks) {
  Marks node(mesh.vertex_count(), 0);
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (marks[v] && marked_neighbours(mesh, marks, v) >= 3) node[v] = 1;
  for (const kernel::Triangle& f : mesh.faces())
    if (marks[f[0]] && marks[f[1]] && marks[f[2]]) node[f[0]] = node[f[1]] = node[f[2]] = 1;
  return node;
}

/// Numbers the connected sets of vertices with marks[v] == mark; returns their sizes.
std::vector<Index> components(const TriangleMesh& mesh, const Marks& marks, std::uint8_t mark,
                              std::vector<Index>& number) {
  number.assign(mesh.vertex_count(), kNone);
  std::vector<Index> sizes, stack;
  for (Index seed = 0; seed < mesh.vertex_count(); ++seed) {
    if (marks[seed] != mark || number[seed] != kNone) continue;
    const Index n = static_cast<Index>(sizes.size());
    sizes.push_back(0);
    stack.assign(1, seed);
    number[seed] = n;
    while (!stack.empty()) {
      const Index v = stack.back();
      stack.pop_back();
      ++sizes[n];
      for (const Index w : mesh.ring(v)) {
        if (marks[w] != mark || number[w] != kNone) continue;
        number[w] = n;
        stack.push_back(w);
      }
    }
  }
  return sizes;
}

class Tracer {
 public:
  Tracer(const TriangleMesh& mesh, const Marks& marks, const Marks& node,
         const std::vector<Index>& node_of, FeatureGraph& graph)
      : mesh_(mesh), marks_(marks), node_(node), node_of_(node_of), graph_(graph) {
    traced_.assign(mesh.vertex_count(), 0);
  }

  void trace_all() {
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      if (!node_[v]) continue;
      for (const Index w : mesh_.ring(v))
        if (marks_[w] && !node_[w] && !traced_[w]) trace(v, w);
    }
    for (Index v = 0; v < mesh_.vertex_count(); ++v)
      if (untraced(v) && marked_neighbours(mesh_, marks_, v) < 2) trace(kNone, v);
    for (Index v = 0; v < mesh_.vertex_count(); ++v)
      if (untraced(v)) trace(kNone, v);
  }

 private:
  bool untraced(Index v) const { return marks_[v] && !node_[v] && !traced_[v]; }

  /// A line's end holds the complement's sides apart only on the boundary.
  EndKind end_without_node(Index v) const {
    return mesh_.on_boundary(v) && !is_simple(mesh_, marks_, v) ? EndKind::boundary : EndKind::open;
  }

  /// From a node's vertex, or (kNone) from `v` as an end or as any vertex of a loop.
  void trace(Index from, Index v) {
    FeatureLine line;
    if (from != kNone) {
      line.vertices.push_back(from);
      line.ends[0] = EndKind::node;
      line.nodes[0] = node_of_[from];
    } else {
      line.ends[0] = end_without_node(v);
    }
    const Index first = v;
    for (Index before = from;;) {
      line.vertices.push_back(v);
      traced_[v] = 1;
      const Index next = next_after(before, v);
      if (next == kNone) {
        line.ends[1] = end_without_node(v);
        break;
      }
      if (node_[next]) {
        line.vertices.push_back(next);
        line.ends[1] = EndKind::node;
        line.nodes[1] = node_of_[next];
        break;
      }
      if (next == first) {
        line.ends = {EndKind::none, EndKind::none};
        break;
      }
      before = v;
      v = next;
    }
    finish(std::move(line));
  }

  /// The marked neighbour that is not `before`; the first one at the start of a loop.
  Index next_after(Index before, Index v) const {
    for (const Index w : mesh_.ring(v))
      if (marks_[w] && w != before) return w;
    return kNone;
  }

  void finish(FeatureLine line) {
    const auto open = std::count(line.ends.begin(), line.ends.end(), EndKind::open);
    line.kind = line.ends[0] == EndKind::none ? LineKind::loop
                : open == 0                   ? LineKind::arc
                : open == 1                   ? LineKind::branch
                                              : LineKind::isolated;
    const auto& p = mesh_.points();
    const std::size_t n = line.vertices.size();
    for (std::size_t i = 0; i + (line.kind == LineKind::loop ? 0 : 1) < n; ++i)
      line.length += kernel::distance(p[line.vertices[i]], p[line.vertices[(i + 1) % n]]);
    const Label label = line.kind == LineKind::arc      ? Label::arc
                        : line.kind == LineKind::branch ? Label::branch
                        : line.kind == LineKind::loop   ? Label::loop
                                                        : Label::isolated;
    for (const Index v : line.vertices)
      if (!node_[v]) graph_.labels[v] = label;
    graph_.lines.push_back(std::move(line));
  }

  const TriangleMesh& mesh_;
  const Marks &marks_, &node_;
  const std::vector<Index>& node_of_;
  FeatureGraph& graph_;
  Marks traced_;
};

}  // namespace

Index FeatureGraph::count(LineKind kind) const {
  return static_cast<Index>(std::count_if(
      lines.begin(), lines.end(), [&](const FeatureLine& line) { return line.kind == kind; }));
}

FeatureGraph build_feature_graph(const TriangleMesh& mesh, const Marks& marks) {
  FeatureGraph graph;
  graph.labels.assign(mesh.vertex_count(), Label::patch);
  graph.patch_sizes = components(mesh, marks, 0, graph.patch_of);
  const Marks node = node_vertices(mesh, marks);
  std::vector<Index> node_of;
  graph.nodes.resize(components(mesh, node, 1, node_of).size());
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (!node[v]) continue;
    graph.nodes[node_of[v]].push_back(v);
    graph.labels[v] = Label::node;
  }
  for (const kernel::Edge& e : mesh.edges())
    if (node[e.v0] && node[e.v1]) graph.node_edges.push_back({e.v0, e.v1});
  Tracer(mesh, marks, node, node_of, graph).trace_all();
  return graph;
}

Marks fill_small_patches(const FeatureGraph& graph, const Marks& marks, Index least) {
  if (graph.patch_sizes.empty()) return marks;
  const auto largest =
      static_cast<Index>(std::max_element(graph.patch_sizes.begin(), graph.patch_sizes.end()) -
                         graph.patch_sizes.begin());
  Marks filled = marks;
  for (std::size_t v = 0; v < marks.size(); ++v) {
    const Index patch = graph.patch_of[v];
    if (patch != kNone && patch != largest && graph.patch_sizes[patch] < least) filled[v] = 1;
  }
  return filled;
}

}  // namespace crest::feature_lines
