// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/reeb/node_order.hpp"

#include <algorithm>
#include <bit>
#include <span>
#include <utility>

#include "kernel/arithmetic/rational.hpp"
#include "kernel/predicates/critical_value_order.hpp"

namespace crest::reeb {
namespace {

using kernel::CriticalValue;
using kernel::Decision;
using kernel::FaceValues;
using kernel::QuadraticMesh;
using kernel::Rational;
using kernel::Sign;
using kernel::Stage;
using kernel::ValueKind;
using kernel::ValueRange;

struct Key {
  std::uint64_t bits;
  Index node;
};

// Ascending as the doubles are; +0 and -0 are one value.
std::uint64_t ascending_bits(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x + 0.0);
  return bits >> 63 ? ~bits : bits | (std::uint64_t{1} << 63);
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
  bool all_vertices() const { return ranges_.empty(); }
  bool is_vertex(Index node) const { return node < tiles_.vertex_count; }
  ValueRange range(Index node) const {
    if (!is_vertex(node)) return ranges_[node - tiles_.vertex_count];
    return {mesh_.values()[node], mesh_.values()[node]};
  }
  CriticalValue value(Index node) const { return node_value(mesh_, tiles_, signs_, node); }

  /// The order of two nodes with different numbers.
  Decision order(Index x, Index y) const {
    const ValueRange a = range(x), b = range(y);
    if (a.high < b.low) return {Sign::negative, Stage::triage};
    if (b.high < a.low) return {Sign::positive, Stage::triage};
    // Points whose ranges meet are equal.
    if (a.low == a.high && b.low == b.high)
      return {kernel::symbolic_critical_value_order(x, y), Stage::symbolic};
    return kernel::critical_value_order(value(x), x, value(y), y);
  }

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

Rational exact_value(const CriticalValue& v) {
  const Rational base = v.f.corner[0];
  if (v.kind == ValueKind::vertex) return base;
  const auto at = [&](const auto& q) { return Rational(base + q.numerator / q.denominator); };
  return v.kind == ValueKind::edge ? at(kernel::ValueFraction<Rational, ValueKind::edge>(v.f))
                                   : at(kernel::ValueFraction<Rational, ValueKind::face>(v.f));
}

// A long run: the exact values once a node rather than once a comparison.
void sort_exactly(const Values& values, std::span<Index> nodes, std::span<std::uint8_t> tied) {
  struct Item {
    Rational value;
    Index node;
  };
  std::vector<Item> items;
  items.reserve(nodes.size());
  for (Index node : nodes) items.push_back({exact_value(values.value(node)), node});
  const auto before = [&](const Item& x, const Item& y) {
    const ValueRange a = values.range(x.node), b = values.range(y.node);
    if (a.high < b.low || b.high < a.low) return a.high < b.low;
    const int c = x.value.compare(y.value);
    return c != 0 ? c < 0 : x.node < y.node;
  };
  std::sort(items.begin(), items.end(), before);
  for (std::size_t i = 0; i < items.size(); ++i) {
    nodes[i] = items[i].node;
    tied[i] = i > 0 && items[i].value == items[i - 1].value;
  }
}

void sort_run(const Values& values, std::span<Index> nodes, std::span<std::uint8_t> tied) {
  constexpr std::size_t kShort = 8;
  if (nodes.size() > kShort) return sort_exactly(values, nodes, tied);
  std::sort(nodes.begin(), nodes.end(),
            [&](Index x, Index y) { return x != y && values.order(x, y).sign == Sign::negative; });
}

// Sets `order`, and `tied` where it is found on the way.
void sort_nodes(const Values& values, std::vector<Index>& order, std::vector<std::uint8_t>& tied) {
  {
    std::vector<Key> keys(values.size());
    for (Index i = 0; i < values.size(); ++i) keys[i] = {ascending_bits(values.range(i).low), i};
    radix_sort(keys);
    order.resize(values.size());
    for (Index r = 0; r < values.size(); ++r) order[r] = keys[r].node;
  }
  tied.assign(values.size(), 0);
  // Points in ascending order, equal ones by number: nothing is left to do.
  if (values.all_vertices()) return;
  // Runs of enclosures that overlap one another: only there the lower bounds may mislead.
  for (Index begin = 0; begin < order.size();) {
    double reach = values.range(order[begin]).high;
    bool all_vertices = values.is_vertex(order[begin]);
    Index end = begin + 1;
    for (; end < order.size() && values.range(order[end]).low <= reach; ++end) {
      reach = std::max(reach, values.range(order[end]).high);
      all_vertices = all_vertices && values.is_vertex(order[end]);
    }
    const std::size_t n = end - begin;
    if (!all_vertices && n > 1)
      sort_run(values, std::span(order).subspan(begin, n), std::span(tied).subspan(begin, n));
    begin = end;
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
                 TileComplex& tiles, kernel::StageCounts& counts) {
  const Values values(mesh, tiles, signs, guarded);
  sort_nodes(values, tiles.order, tiles.tied);
  const Index n = values.size();
  tiles.rank.resize(n);
  for (Index r = 0; r < n; ++r) tiles.rank[tiles.order[r]] = r;
  for (Index r = 1; r < n; ++r) {
    const Stage stage =
        tiles.tied[r] ? Stage::symbolic : values.order(tiles.order[r - 1], tiles.order[r]).stage;
    counts.add(stage);
    tiles.tied[r] = stage == Stage::symbolic;
  }
}

}  // namespace crest::reeb
