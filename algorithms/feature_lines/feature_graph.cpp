// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/feature_lines/feature_graph.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <span>
#include <utility>

#include "algorithms/feature_lines/topology.hpp"
#include "kernel/geometry/disjoint_sets.hpp"

namespace crest::feature_lines {
namespace {

using kernel::TriangleMesh;
using kernel::Vec3;
using kernel::operator-;

/// The feature edges at each vertex, in the order of the edges.
class Incidence {
 public:
  struct Side {
    Index vertex, edge;
  };
  Incidence(const TriangleMesh& mesh, const Marks& edges) : begin_(mesh.vertex_count() + 1, 0) {
    const auto& all = mesh.edges();
    for (std::size_t e = 0; e < edges.size(); ++e)
      if (edges[e]) ++begin_[all[e].v0 + 1], ++begin_[all[e].v1 + 1];
    for (std::size_t v = 1; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
    sides_.resize(begin_.back());
    std::vector<Index> at(begin_.begin(), begin_.end() - 1);
    for (Index e = 0; e < edges.size(); ++e) {
      if (!edges[e]) continue;
      sides_[at[all[e].v0]++] = {all[e].v1, e};
      sides_[at[all[e].v1]++] = {all[e].v0, e};
    }
  }
  std::span<const Side> at(Index v) const {
    return {sides_.data() + begin_[v], sides_.data() + begin_[v + 1]};
  }
  Index degree(Index v) const { return begin_[v + 1] - begin_[v]; }

 private:
  std::vector<Index> begin_;
  std::vector<Side> sides_;
};

/// What lines are made of.
struct Network {
  Marks vertices;  ///< V: marked, and so on a line or in a node
  Marks edges;     ///< E: feature edges
  Marks full;      ///< F: faces that could not be collapsed
};

/// The cosine of the angle between the normals of an inner edge's faces.
double flatness(const TriangleMesh& mesh, const kernel::Edge& e) {
  const auto normal = [&](Index f) {
    const kernel::Triangle& t = mesh.faces()[f];
    const Vec3& p = mesh.points()[t[0]];
    return kernel::cross(mesh.points()[t[1]] - p, mesh.points()[t[2]] - p);
  };
  const Vec3 m = normal(e.f0), n = normal(e.f1);
  return kernel::dot(m, n) / (kernel::norm(m) * kernel::norm(n));
}

/// The marked complex with its faces collapsed (see build_feature_graph).
class Collapse {
 public:
  Collapse(const TriangleMesh& mesh, const Marks& marks) : mesh_(mesh), net_{marks, {}, {}} {
    for (const kernel::Edge& e : mesh.edges()) net_.edges.push_back(marks[e.v0] & marks[e.v1]);
    for (const kernel::Triangle& f : mesh.faces())
      net_.full.push_back(marks[f[0]] & marks[f[1]] & marks[f[2]]);
  }

  Network run() {
    for (Index f = 0; f < mesh_.face_count(); ++f)
      if (net_.full[f]) push_free_sides(f);
    while (!queue_.empty()) {
      const Index e = queue_.top().second;
      queue_.pop();
      const Index f = full_face(mesh_.edges()[e]);
      if (f == kNone) continue;
      net_.edges[e] = 0;
      net_.full[f] = 0;
      for (const Index side : mesh_.face_edges()[f]) {
        const Index across = full_face(mesh_.edges()[side]);
        if (across != kNone) push(side);
      }
    }
    return std::move(net_);
  }

 private:
  bool is_full(Index f) const { return f != kNone && net_.full[f]; }
  /// The full face of a free edge: its other face is there, and is not full. kNone: not free.
  Index full_face(const kernel::Edge& e) const {
    if (e.f0 == kNone || e.f1 == kNone || is_full(e.f0) == is_full(e.f1)) return kNone;
    return is_full(e.f0) ? e.f0 : e.f1;
  }
  void push_free_sides(Index f) {
    for (const Index side : mesh_.face_edges()[f])
      if (full_face(mesh_.edges()[side]) != kNone) push(side);
  }
  void push(Index e) {
    const double key = flatness(mesh_, mesh_.edges()[e]);
    queue_.push({std::isnan(key) ? -2 : key, e});
  }

  const TriangleMesh& mesh_;
  Network net_;
  std::priority_queue<std::pair<double, Index>> queue_;
};

class Tracer {
 public:
  Tracer(const TriangleMesh& mesh, const Network& net, const Incidence& incidence,
         const Marks& node, const std::vector<Index>& node_of, FeatureGraph& graph)
      : mesh_(mesh),
        net_(net),
        incidence_(incidence),
        node_(node),
        node_of_(node_of),
        graph_(graph),
        traced_(mesh.edge_count(), 0) {}

  /// Requires: a line between two vertices of one node is an edge of `graph.node_edges`.
  void trace_all() {
    for (Index e = 0; e < mesh_.edge_count(); ++e) traced_[e] = inside_node(e);
    for (Index v = 0; v < mesh_.vertex_count(); ++v)
      if (node_[v]) trace_from(v);
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      if (!net_.vertices[v] || node_[v]) continue;
      if (incidence_.degree(v) == 0) trace_point(v);
      if (incidence_.degree(v) == 1) trace_from(v);
    }
    for (Index v = 0; v < mesh_.vertex_count(); ++v)
      if (!node_[v]) trace_from(v);
  }

 private:
  bool inside_node(Index e) const {
    const kernel::Edge& edge = mesh_.edges()[e];
    return node_[edge.v0] && node_[edge.v1] && node_of_[edge.v0] == node_of_[edge.v1];
  }

  /// A line's end holds the complement's sides apart only on the boundary.
  EndKind end_without_node(Index v) const {
    if (!mesh_.on_boundary(v)) return EndKind::open;
    if (incidence_.degree(v) == 0) return EndKind::boundary;
    const kernel::Edge& e = mesh_.edges()[incidence_.at(v)[0].edge];
    return e.f0 != kNone && e.f1 != kNone ? EndKind::boundary : EndKind::open;
  }
  void set_end(FeatureLine& line, std::size_t which, Index v) const {
    line.ends[which] = node_[v] ? EndKind::node : end_without_node(v);
    if (node_[v]) line.nodes[which] = node_of_[v];
  }

  void trace_point(Index v) {
    FeatureLine line;
    line.vertices = {v};
    set_end(line, 0, v);
    set_end(line, 1, v);
    finish(std::move(line));
  }

  /// Every line that starts at v and is not traced; v is an end, or on a loop.
  void trace_from(Index start) {
    for (const auto& first : incidence_.at(start)) {
      if (traced_[first.edge]) continue;
      FeatureLine line;
      line.vertices.push_back(start);
      auto at = first;
      for (;;) {
        traced_[at.edge] = 1;
        line.vertices.push_back(at.vertex);
        if (node_[at.vertex] || incidence_.degree(at.vertex) == 1 || at.vertex == start) break;
        const auto sides = incidence_.at(at.vertex);
        at = sides[sides[0].edge == at.edge ? 1 : 0];
      }
      if (at.vertex == start && !node_[start]) {
        line.vertices.pop_back();  // a loop
      } else {
        set_end(line, 0, start);
        set_end(line, 1, at.vertex);
      }
      finish(std::move(line));
    }
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
  const Network& net_;
  const Incidence& incidence_;
  const Marks& node_;
  const std::vector<Index>& node_of_;
  FeatureGraph& graph_;
  Marks traced_;  ///< E
};

/// Fills the patches.
void add_patches(const TriangleMesh& mesh, const Network& net, FeatureGraph& graph) {
  kernel::DisjointSets sets(mesh.face_count());
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const auto& [v0, v1, f0, f1] = mesh.edges()[e];
    if (!net.edges[e] && f0 != kNone && f1 != kNone) sets.unite(f0, f1);
  }
  graph.face_patch.assign(mesh.face_count(), kNone);
  Index patches = 0;
  for (Index f = 0; f < mesh.face_count(); ++f)
    if (!net.full[f])
      graph.face_patch[f] = sets.find(f) == f ? patches++ : graph.face_patch[sets.find(f)];
  graph.patch_sizes.assign(patches, 0);
  graph.patch_of.assign(mesh.vertex_count(), kNone);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (net.vertices[v]) continue;
    graph.patch_of[v] = graph.face_patch[mesh.fan(v)[0]];
    ++graph.patch_sizes[graph.patch_of[v]];
  }
}

/// Fills the nodes, clusters along feature edges if asked for; returns the number of each vertex's.
std::vector<Index> add_nodes(const TriangleMesh& mesh, const Network& net, const Marks& node,
                             bool clusters, FeatureGraph& graph) {
  kernel::DisjointSets sets(mesh.vertex_count());
  for (Index e = 0; clusters && e < mesh.edge_count(); ++e) {
    const auto& edge = mesh.edges()[e];
    if (!net.edges[e] || !node[edge.v0] || !node[edge.v1]) continue;
    sets.unite(edge.v0, edge.v1);
    graph.node_edges.push_back({edge.v0, edge.v1});
  }
  std::vector<Index> node_of(mesh.vertex_count(), kNone);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (!node[v]) continue;
    const Index first = sets.find(v);
    if (first == v) {
      node_of[v] = static_cast<Index>(graph.nodes.size());
      graph.nodes.emplace_back();
    }
    node_of[v] = node_of[first];
    graph.nodes[node_of[v]].push_back(v);
    graph.labels[v] = Label::node;
  }
  return node_of;
}

FeatureGraph graph_of(const TriangleMesh& mesh, const Network& net, bool clusters) {
  const Incidence incidence(mesh, net.edges);
  FeatureGraph graph;
  graph.labels.assign(mesh.vertex_count(), Label::patch);
  Marks node(mesh.vertex_count(), 0);
  for (Index v = 0; v < mesh.vertex_count(); ++v) node[v] = incidence.degree(v) >= 3;
  for (Index f = 0; f < mesh.face_count(); ++f)
    if (net.full[f])
      for (const Index v : mesh.faces()[f]) node[v] = 1;
  const std::vector<Index> node_of = add_nodes(mesh, net, node, clusters, graph);
  Tracer(mesh, net, incidence, node, node_of, graph).trace_all();
  add_patches(mesh, net, graph);
  return graph;
}

}  // namespace

Index FeatureGraph::count(LineKind kind) const {
  return static_cast<Index>(std::count_if(
      lines.begin(), lines.end(), [&](const FeatureLine& line) { return line.kind == kind; }));
}

FeatureGraph build_feature_graph(const TriangleMesh& mesh, const Marks& marks) {
  return graph_of(mesh, Collapse(mesh, marks).run(), true);
}

FeatureGraph build_edge_graph(const TriangleMesh& mesh, const Marks& edges) {
  Network net{Marks(mesh.vertex_count(), 0), edges, Marks(mesh.face_count(), 0)};
  for (Index e = 0; e < mesh.edge_count(); ++e)
    if (edges[e]) net.vertices[mesh.edges()[e].v0] = net.vertices[mesh.edges()[e].v1] = 1;
  return graph_of(mesh, net, false);
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
