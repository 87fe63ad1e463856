// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/components.hpp"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <map>

#include "kernel/geometry/disjoint_sets.hpp"

namespace crest::extremal {
namespace {

/// A side of a polygon, or a segment.
struct Border {
  Index low, high, polygon;
  bool upward;
  friend auto operator<=>(const Border&, const Border&) = default;
};

/// Polygons with their turn against the first of their set.
class TurnedSets {
 public:
  explicit TurnedSets(std::size_t n) : parent_(n), turned_(n, 0) {
    for (std::size_t i = 0; i < n; ++i) parent_[i] = static_cast<Index>(i);
  }
  /// False if they are in one set already with the other turn.
  bool unite(Index a, Index b, int turned) {
    const auto [ra, ta] = root(a);
    const auto [rb, tb] = root(b);
    const int turn = ta ^ tb ^ turned;
    if (ra == rb) return turn == 0;
    const Index low = std::min(ra, rb), high = std::max(ra, rb);
    parent_[high] = low;
    turned_[high] = static_cast<std::uint8_t>(turn);
    return true;
  }
  int turned(Index a) { return root(a).second; }

 private:
  std::pair<Index, int> root(Index x) {
    Index r = x;
    int turn = 0;
    while (parent_[r] != r) {
      turn ^= turned_[r];
      r = parent_[r];
    }
    // The way up, shortened.
    int rest = turn;
    while (parent_[x] != r && x != r) {
      const Index up = parent_[x];
      const int own = turned_[x];
      parent_[x] = r;
      turned_[x] = static_cast<std::uint8_t>(rest);
      rest ^= own;
      x = up;
    }
    return {r, turn};
  }
  std::vector<Index> parent_;
  std::vector<std::uint8_t> turned_;
};

class Meter {
 public:
  Meter(const Grid& grid, const SheetMesh& mesh, TrimmedMesh& trimmed)
      : grid_(grid),
        mesh_(mesh),
        trimmed_(trimmed),
        plane_(mesh.dimension == 2),
        points_(static_cast<Index>(trimmed.points.size())) {}

  Measured run() {
    collect_borders();
    number_components();
    count_vertices();
    count_borders();
    orient();
    borders_ = {};
    for (Index p = 0; p < count(); ++p) measure_polygon(p);
    return std::move(r_);
  }

 private:
  Index count() const { return static_cast<Index>(trimmed_.source.size()); }
  Component& of(Index polygon) { return r_.components[r_.component_of[polygon]]; }

  void collect_borders() {
    borders_.reserve(trimmed_.corners.size());
    for (Index p = 0; p < count(); ++p) {
      const Index begin = trimmed_.first[p], end = trimmed_.first[p + 1];
      for (Index i = begin; i < end; ++i) {
        const Index a = trimmed_.corners[i];
        const Index b = trimmed_.corners[i + 1 < end ? i + 1 : begin];
        points_.unite(a, b);
        borders_.push_back({std::min(a, b), std::max(a, b), p, a < b});
        if (plane_) break;
      }
    }
    tbb::parallel_sort(borders_.begin(), borders_.end());
  }

  /// By their lowest polygon of the sheet mesh, then by its lowest vertex there.
  void number_components() {
    const auto own = static_cast<Index>(mesh_.vertices.size());
    std::map<Index, std::array<Index, 3>> keys;  // By root: polygon, vertex, root.
    for (Index p = 0; p < count(); ++p) {
      const Index root = points_.find(trimmed_.corners[trimmed_.first[p]]);
      auto& key =
          keys.try_emplace(root, std::array<Index, 3>{trimmed_.source[p], own, root}).first->second;
      if (key[0] != trimmed_.source[p]) continue;
      for (Index i = trimmed_.first[p]; i < trimmed_.first[p + 1]; ++i)
        key[1] = std::min(key[1], trimmed_.corners[i]);
    }
    std::vector<std::array<Index, 3>> order;
    for (const auto& [root, key] : keys) order.push_back(key);
    std::sort(order.begin(), order.end());
    std::map<Index, Index> number;
    for (std::size_t i = 0; i < order.size(); ++i) number[order[i][2]] = static_cast<Index>(i);
    r_.components.resize(order.size());
    r_.proofs.resize(order.size());
    last_source_.assign(order.size(), kernel::kNone);
    for (Index p = 0; p < count(); ++p)
      r_.component_of.push_back(number[points_.find(trimmed_.corners[trimmed_.first[p]])]);
  }

  void count_vertices() {
    component_of_point_.assign(trimmed_.points.size(), kernel::kNone);
    for (Index p = 0; p < count(); ++p)
      for (Index i = trimmed_.first[p]; i < trimmed_.first[p + 1]; ++i)
        component_of_point_[trimmed_.corners[i]] = r_.component_of[p];
    for (const Index c : component_of_point_)
      if (c != kernel::kNone) {
        ++r_.components[c].vertices;
        ++r_.components[c].euler_characteristic;
      }
  }

  void count_borders() {
    if (plane_) {
      std::vector<int> valence(trimmed_.points.size(), 0);
      for (const Border& b : borders_) {
        --of(b.polygon).euler_characteristic;
        ++valence[b.low];
        ++valence[b.high];
      }
      for (std::size_t v = 0; v < valence.size(); ++v)
        if (valence[v] == 1) ++r_.components[component_of_point_[v]].ends;
      return;
    }
    kernel::DisjointSets rim(static_cast<Index>(trimmed_.points.size()));
    std::vector<Index> on_rim;
    for (std::size_t i = 0, end; i < borders_.size(); i = end) {
      for (end = i; end < borders_.size() && same(i, end);) ++end;
      --of(borders_[i].polygon).euler_characteristic;
      if (end - i != 1) continue;
      rim.unite(borders_[i].low, borders_[i].high);
      on_rim.push_back(borders_[i].low);
      on_rim.push_back(borders_[i].high);
    }
    std::sort(on_rim.begin(), on_rim.end());
    on_rim.erase(std::unique(on_rim.begin(), on_rim.end()), on_rim.end());
    for (const Index v : on_rim)
      if (rim.find(v) == v) ++r_.components[component_of_point_[v]].boundary_loops;
  }
  bool same(std::size_t i, std::size_t k) const {
    return borders_[i].low == borders_[k].low && borders_[i].high == borders_[k].high;
  }

  void orient() {
    if (plane_) return;
    TurnedSets sets(count());
    for (std::size_t i = 0, end; i < borders_.size(); i = end) {
      for (end = i; end < borders_.size() && same(i, end);) ++end;
      if (end - i != 2) continue;
      const Border &a = borders_[i], &b = borders_[i + 1];
      if (!sets.unite(a.polygon, b.polygon, a.upward == b.upward ? 1 : 0))
        of(a.polygon).orientable = false;
    }
    for (Index p = 0; p < count(); ++p)
      if (sets.turned(p) != 0)
        std::reverse(trimmed_.corners.begin() + trimmed_.first[p] + 1,
                     trimmed_.corners.begin() + trimmed_.first[p + 1]);
  }

  void measure_polygon(Index p) {
    Component& c = of(p);
    ComponentProof& proof = r_.proofs[r_.component_of[p]];
    ++c.polygons;
    ++c.euler_characteristic;
    const Index source = trimmed_.source[p];
    if (last_source_[r_.component_of[p]] != source) ++proof.polygons;
    last_source_[r_.component_of[p]] = source;
    proof.cut = proof.cut || trimmed_.partly[source];
    if (!mesh_.polygons[source].extremal) c.critical_type = 0;
    const auto at = [&](Index i) { return grid_.position(trimmed_.points[trimmed_.corners[i]]); };
    const Index begin = trimmed_.first[p], end = trimmed_.first[p + 1];
    if (plane_) {
      --c.euler_characteristic;  // Segments are edges, counted above.
      c.area += kernel::distance(at(begin), at(begin + 1));
      return;
    }
    for (Index i = begin + 2; i < end; ++i)
      c.area += 0.5 * kernel::norm(kernel::cross(at(i - 1) - at(begin), at(i) - at(begin)));
  }

  const Grid& grid_;
  const SheetMesh& mesh_;
  TrimmedMesh& trimmed_;
  bool plane_;
  kernel::DisjointSets points_;
  std::vector<Border> borders_;
  std::vector<Index> component_of_point_, last_source_;
  Measured r_;
};

}  // namespace

void decide_isotopy(const SheetMesh& mesh, const TrimmedMesh& trimmed, const Clusters& clusters,
                    Measured& m) {
  for (std::size_t i = 0; i < m.components.size(); ++i) {
    Component& c = m.components[i];
    c.isotopic = c.boundary_loops == 0 && c.ends == 0 && !m.proofs[i].cut;
    m.proofs[i].extremal = *c.isotopic;
  }
  for (std::size_t p = 0; p < trimmed.source.size(); ++p)
    for (Index i = trimmed.first[p]; i < trimmed.first[p + 1]; ++i) {
      const Index v = trimmed.corners[i], c = m.component_of[p];
      if (v >= mesh.vertices.size() || !*m.components[c].isotopic) continue;
      const std::size_t cell = mesh.vertices[v].cell;
      if (!clusters.proven(cell)) m.components[c].isotopic = m.proofs[c].extremal = false;
      if (!clusters.extremal(cell)) m.proofs[c].extremal = false;
    }
}

Measured measure(const Grid& grid, const SheetMesh& mesh, TrimmedMesh& trimmed) {
  return Meter(grid, mesh, trimmed).run();
}

}  // namespace crest::extremal
