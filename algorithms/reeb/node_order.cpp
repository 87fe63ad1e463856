// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/reeb/node_order.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "algorithms/reeb/exact_order.hpp"
#include "kernel/predicates/critical_value_grid.hpp"
#include "kernel/predicates/critical_value_order.hpp"

namespace crest::reeb {
namespace {

using kernel::CriticalValue;
using kernel::Decision;
using kernel::FaceValues;
using kernel::QuadraticMesh;
using kernel::Sign;
using kernel::Stage;
using kernel::StageCounts;
using kernel::ValueKind;
using kernel::ValueRange;

/// bits: the key on the grid, or the enclosure's lower end, ascending as doubles are; width: at
/// least the enclosure's length.
struct Key {
  std::uint64_t bits;
  Index node;
  float width;
};

constexpr std::uint64_t kSignBit = std::uint64_t{1} << 63;

// +0 and -0 are one value.
std::uint64_t ascending_bits(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x + 0.0);
  return bits & kSignBit ? ~bits : bits | kSignBit;
}

Key key_of(const ValueRange& range, Index node) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const double width = range.high - range.low;
  return {ascending_bits(range.low), node,
          width == 0 ? 0.0f : std::nextafter(static_cast<float>(width), kInfinity)};
}

double low_end(const Key& key) {
  return std::bit_cast<double>(key.bits & kSignBit ? key.bits ^ kSignBit : ~key.bits);
}
// Twice the next double: for the rounding of the width and of this sum.
double high_end(const Key& key) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double low = low_end(key);
  if (key.width == 0) return low;
  return std::nextafter(std::nextafter(low + static_cast<double>(key.width), kInfinity), kInfinity);
}

// Stable, so equal keys stay in the nodes' order.
void radix_sort(std::vector<Key>& keys) {
  constexpr unsigned kDigit = 11, kDigits = 6;
  constexpr std::size_t kSize = std::size_t{1} << kDigit;
  std::vector<std::array<Index, kSize>> counts(kDigits);
  for (auto& c : counts) c.fill(0);
  for (const Key& k : keys)
    for (unsigned d = 0; d < kDigits; ++d) ++counts[d][(k.bits >> (d * kDigit)) % kSize];
  std::vector<Key> other(keys.size());
  for (unsigned d = 0; d < kDigits; ++d) {
    auto& c = counts[d];
    if (std::find(c.begin(), c.end(), keys.size()) != c.end()) continue;  // one digit for all
    Index sum = 0;
    for (Index& n : c) sum += std::exchange(n, sum);
    for (const Key& k : keys) other[c[(k.bits >> (d * kDigit)) % kSize]++] = k;
    keys.swap(other);
  }
}

/// Nodes with enclosures of their values.
class Values {
 public:
  Values(const QuadraticMesh& mesh, const TileComplex& tiles, const std::vector<Sign>& signs,
         bool guarded)
      : mesh_(mesh), tiles_(tiles), signs_(signs) {
    ranges_.reserve(signs.size());
    for (Index i = 0; i < signs.size(); ++i) {
      const CriticalValue v = value(tiles.vertex_count + i);
      ranges_.push_back(guarded ? kernel::value_range(v) : plain(v));
    }
  }

  Index size() const { return tiles_.vertex_count + static_cast<Index>(ranges_.size()); }
  bool is_vertex(Index node) const { return node < tiles_.vertex_count; }
  ValueRange range(Index node) const {
    if (!is_vertex(node)) return ranges_[node - tiles_.vertex_count];
    return {mesh_.values()[node], mesh_.values()[node]};
  }
  CriticalValue value(Index node) const { return node_value(mesh_, tiles_, signs_, node); }

 private:
  static ValueRange plain(const CriticalValue& v) {
    const FaceValues& f = v.f;
    const auto at = [&](const auto& q) { return f.corner[0] + q.numerator / q.denominator; };
    const double x = v.kind == ValueKind::edge
                         ? at(kernel::ValueFraction<double, ValueKind::edge>(f))
                         : at(kernel::ValueFraction<double, ValueKind::face>(f));
    return {x, x};
  }

  const QuadraticMesh& mesh_;
  const TileComplex& tiles_;
  const std::vector<Sign>& signs_;
  std::vector<ValueRange> ranges_;
};

// Longer runs by exact values, each once.
void sort_long_run(const Values& values, std::span<Index> nodes, std::span<std::uint8_t> tied,
                   StageCounts& counts) {
  std::vector<ValuedNode> items;
  items.reserve(nodes.size());
  for (Index node : nodes) {
    const ValueRange r = values.range(node);
    items.push_back({r.low == r.high ? CriticalValue::vertex(r.low) : values.value(node), r, node});
  }
  sort_exactly(items, nodes, tied, counts);
}

// A pair is the common run and mostly decided by a filter.
void sort_run(const Values& values, std::span<Index> nodes, std::span<std::uint8_t> tied,
              StageCounts& counts) {
  if (nodes.size() > 2) return sort_long_run(values, nodes, tied, counts);
  const CriticalValue x = values.value(nodes[0]), y = values.value(nodes[1]);
  const Decision d = kernel::critical_value_order(x, nodes[0], y, nodes[1]);
  tied[1] = d.stage == Stage::symbolic;
  if (d.sign == Sign::positive) std::swap(nodes[0], nodes[1]);
  counts.add(d.stage);
}

void take_order(const std::vector<Key>& keys, TileComplex& tiles) {
  tiles.order.resize(keys.size());
  for (std::size_t r = 0; r < keys.size(); ++r) tiles.order[r] = keys[r].node;
  tiles.tied.assign(keys.size(), 0);
}

// Both set order and tied, and count who decided between successive nodes.
void sort_by_grid(const QuadraticMesh& mesh, const std::vector<Sign>& signs,
                  const kernel::ValueGrid& grid, TileComplex& tiles, StageCounts& counts) {
  std::vector<Key> keys(tiles.vertex_count + signs.size());
  for (Index i = 0; i < keys.size(); ++i)
    keys[i] = {grid.key(node_value(mesh, tiles, signs, i)), i, 0};
  radix_sort(keys);
  take_order(keys, tiles);
  for (std::size_t r = 1; r < keys.size(); ++r) {
    tiles.tied[r] = keys[r].bits == keys[r - 1].bits;
    counts.add(tiles.tied[r] ? Stage::symbolic : Stage::integer);
  }
}

void sort_by_ranges(const Values& values, TileComplex& tiles, StageCounts& counts) {
  const Index n = values.size();
  std::vector<Key> keys(n);
  for (Index i = 0; i < n; ++i) keys[i] = key_of(values.range(i), i);
  radix_sort(keys);
  take_order(keys, tiles);
  // Runs of enclosures that overlap one another: only there the lower ends may mislead.
  for (Index begin = 0, end = 0; begin < n; begin = end) {
    if (begin > 0) counts.add(Stage::triage);
    double reach = high_end(keys[begin]);
    for (end = begin + 1; end < n && low_end(keys[end]) <= reach; ++end)
      reach = std::max(reach, high_end(keys[end]));
    if (end == begin + 1) continue;
    const std::span<Index> nodes(tiles.order.data() + begin, end - begin);
    const std::span<std::uint8_t> tied(tiles.tied.data() + begin, end - begin);
    if (reach != low_end(keys[begin])) {
      sort_run(values, nodes, tied, counts);
      continue;
    }
    // Equal points, already by number.
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      tied[i] = 1;
      counts.add(Stage::symbolic);
    }
  }
}

}  // namespace

FaceValues face_values(const QuadraticMesh& mesh, Index face) {
  FaceValues f;
  for (std::size_t k = 0; k < 3; ++k) {
    f.corner[k] = mesh.values()[mesh.faces()[face][k]];
    f.side[k] = mesh.edge_values()[mesh.face_edges()[face][k]];
  }
  return f;
}

CriticalValue node_value(const QuadraticMesh& mesh, const TileComplex& tiles,
                         const std::vector<Sign>& signs, Index node) {
  if (node < tiles.vertex_count) return CriticalValue::vertex(mesh.values()[node]);
  const std::size_t i = node - tiles.vertex_count;
  const Sign sign = signs.empty() ? Sign::zero : signs[i];
  if (i < tiles.critical_edges.size()) {
    const Index edge = tiles.critical_edges[i];
    const kernel::Edge& e = mesh.edges()[edge];
    return CriticalValue::edge({mesh.values()[e.v0], mesh.values()[e.v1], mesh.edge_values()[edge]},
                               sign);
  }
  const Index face = tiles.critical_faces[i - tiles.critical_edges.size()];
  const Triangle& t = mesh.faces()[face];
  const auto least = static_cast<std::size_t>(std::min_element(t.begin(), t.end()) - t.begin());
  FaceValues f = face_values(mesh, face).rotated(least);
  // Corners 0, 2, 1 in place of 0, 1, 2.
  if (t[(least + 1) % 3] > t[(least + 2) % 3]) f = f.rotated(1).mirrored().rotated(2);
  return CriticalValue::face(f, sign);
}

void order_nodes(const QuadraticMesh& mesh, const std::vector<Sign>& signs, bool guarded,
                 TileComplex& tiles, StageCounts& counts) {
  std::optional<kernel::ValueGrid> grid;
  if (guarded) grid = kernel::ValueGrid::find(mesh.values(), mesh.edge_values());
  if (grid)
    sort_by_grid(mesh, signs, *grid, tiles, counts);
  else
    sort_by_ranges(Values(mesh, tiles, signs, guarded), tiles, counts);
  tiles.rank.resize(tiles.order.size());
  for (Index r = 0; r < tiles.order.size(); ++r) tiles.rank[tiles.order[r]] = r;
}

}  // namespace crest::reeb
