// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <tuple>

#include "algorithms/feature_lines/feature_graph.hpp"

namespace crest::feature_lines {
namespace {

struct OpenEnd {
  Index vertex, line;
};

std::vector<OpenEnd> open_ends(const FeatureGraph& graph) {
  std::vector<OpenEnd> ends;
  for (Index i = 0; i < graph.lines.size(); ++i) {
    const FeatureLine& line = graph.lines[i];
    if (line.vertices.size() < 2) continue;
    if (line.ends[0] == EndKind::open) ends.push_back({line.vertices.front(), i});
    if (line.ends[1] == EndKind::open) ends.push_back({line.vertices.back(), i});
  }
  std::sort(ends.begin(), ends.end(),
            [](const OpenEnd& a, const OpenEnd& b) { return a.vertex < b.vertex; });
  return ends;
}

/// Breadth first from an open end through unmarked vertices; marked ones are met, not passed.
class GapSearch {
 public:
  GapSearch(const kernel::TriangleMesh& mesh, const Marks& marks)
      : mesh_(mesh), marks_(marks), from_(mesh.vertex_count()), seen_(mesh.vertex_count(), 0) {}

  /// Calls meet(w, edges) for every marked vertex met after `shortest` to `longest` edges.
  template <class Meet>
  void run(Index start, Gap gap, Meet&& meet) {
    ++search_;
    seen_[start] = search_;
    front_.assign(1, start);
    for (Index edges = 1; edges <= gap.longest && !front_.empty(); ++edges) {
      next_.clear();
      for (const Index v : front_) {
        for (const Index w : mesh_.ring(v)) {
          if (seen_[w] == search_) continue;
          if (marks_[w] && edges < gap.shortest) continue;
          seen_[w] = search_;
          from_[w] = v;
          if (marks_[w])
            meet(w, edges);
          else
            next_.push_back(w);
        }
      }
      front_.swap(next_);
    }
  }
  Index from(Index v) const { return from_[v]; }

 private:
  const kernel::TriangleMesh& mesh_;
  const Marks& marks_;
  std::vector<Index> from_, seen_, front_, next_;
  Index search_ = 0;
};

struct Pair {
  Index edges, a, b;  ///< vertices, a < b
  bool operator<(const Pair& o) const {
    return std::tie(edges, a, b) < std::tie(o.edges, o.a, o.b);
  }
};

}  // namespace

std::vector<std::vector<Index>> joining_paths(const kernel::TriangleMesh& mesh,
                                              const FeatureGraph& graph, Gap gap) {
  std::vector<std::vector<Index>> paths;
  if (gap.longest < gap.shortest) return paths;
  Marks marks(mesh.vertex_count());
  for (Index v = 0; v < mesh.vertex_count(); ++v) marks[v] = graph.labels[v] != Label::patch;
  const std::vector<OpenEnd> ends = open_ends(graph);
  std::vector<Index> line_of(mesh.vertex_count(), kNone);
  for (const OpenEnd& end : ends) line_of[end.vertex] = end.line;
  GapSearch search(mesh, marks);
  std::vector<Pair> pairs;
  for (const OpenEnd& end : ends) {
    search.run(end.vertex, gap, [&](Index w, Index edges) {
      if (line_of[w] == kNone || w < end.vertex) return;
      const bool curl =
          line_of[w] == end.line && graph.lines[end.line].vertices.size() <= 2 * edges;
      if (!curl) pairs.push_back({edges, end.vertex, w});
    });
  }
  std::sort(pairs.begin(), pairs.end());
  for (const Pair& pair : pairs) {
    if (line_of[pair.a] == kNone || line_of[pair.b] == kNone) continue;
    // Earlier joins may lie in the way: search again in the marks as they are now.
    bool reached = false;
    search.run(pair.a, gap, [&](Index w, Index) { reached = reached || w == pair.b; });
    if (!reached) continue;
    auto& path = paths.emplace_back(std::vector<Index>{pair.b});
    for (Index v = search.from(pair.b); v != pair.a; v = search.from(v)) {
      marks[v] = 1;
      path.push_back(v);
    }
    path.push_back(pair.a);
    line_of[pair.a] = line_of[pair.b] = kNone;
  }
  return paths;
}

}  // namespace crest::feature_lines
