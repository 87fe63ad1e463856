// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "certify/container/reject.hpp"
#include "certify/reeb/grid.hpp"
#include "certify/reeb/quadratic.hpp"
#include "certify/surface/union_find.hpp"

namespace crest::certify::reeb {
namespace {

using kernel::Interval;
using kernel::MaybeSign;
using kernel::MpInterval;
using kernel::Rational;
using kernel::Sign;

/// A node's value as p / q.
template <class Number>
struct Fraction {
  Number p, q;
};

/// Compares the values of nodes of a quadratic function.
class NodeValues {
 public:
  NodeValues(const ReebContents& c, const Gluing& mesh, const Tiling& tiling, Arithmetic arithmetic,
             SignCounts& counts)
      : c_(c), mesh_(mesh), tiling_(tiling), arithmetic_(arithmetic), counts_(counts) {
    if (arithmetic == Arithmetic::mpfr) return;
    enclose();
    grid_ = find_grid(c);
  }

  /// The sign of value(y) - value(x).
  Sign difference(u32 x, u32 y) {
    ++counts_.calls;
    // Two doubles: nothing is rounded.
    if (x < c_.values.size() && y < c_.values.size())
      return sign_of_difference(c_.values[x], c_.values[y]);
    if (arithmetic_ == Arithmetic::mpfr) {
      ++counts_.interval;
      if (const MaybeSign sign = by_mpfr(x, y)) return *sign;
      return by_rationals(x, y);
    }
    const Range a = range_[x], b = range_[y];
    if (b.low > a.high) return Sign::positive;
    if (b.high < a.low) return Sign::negative;
    if (std::max(a.high, b.high) - std::min(a.low, b.low) < grid_.separation) return Sign::zero;
    if (same_function(x, y)) return Sign::zero;
    ++counts_.interval;
    if (const MaybeSign sign = by_interval(x, y)) return *sign;
    if (!grid_.fits) return by_rationals(x, y);
    ++counts_.exact;
    return *quotient_sign(
        x, y, grid_.scale, [](double v) { return static_cast<Wide>(v); },
        [](Wide i) {
          return MaybeSign(i > 0 ? Sign::positive : i < 0 ? Sign::negative : Sign::zero);
        });
  }
  void fetch(u32 node) const {
    if (!range_.empty()) __builtin_prefetch(&range_[node]);
  }

 private:
  struct Range {
    double low, high;
  };

  static Sign sign_of_difference(double a, double b) {
    return b > a ? Sign::positive : b < a ? Sign::negative : Sign::zero;
  }
  u32 first_line() const { return static_cast<u32>(c_.values.size()); }
  u32 first_face() const { return first_line() + static_cast<u32>(tiling_.line_edges.size()); }
  EdgeValues on_edge(u32 node) const {
    return values_on_edge(c_, mesh_, tiling_.line_edges[node - first_line()]);
  }
  FaceValues in_face(u32 node) const {
    return values_in_face(c_, mesh_, tiling_.critical_faces[node - first_face()]);
  }

  /// Of the data times `scale`, which must be exact.
  template <class Lift>
  auto fraction(const Lift& lift, u32 node, double scale) const {
    using Number = decltype(lift(0.0));
    if (node < first_line()) return Fraction<Number>{lift(c_.values[node] * scale), lift(1)};
    if (node < first_face()) {
      EdgeValues e = on_edge(node);
      e.a *= scale, e.b *= scale, e.m *= scale;
      const Number d = start_slope(lift, e), q = lift(2) * (d - end_slope(lift, e));
      return Fraction<Number>{lift(e.a) * q + d * d, q};
    }
    FaceValues v = in_face(node);
    for (std::size_t i = 0; i < 3; ++i) v.f[i] *= scale, v.m[i] *= scale;
    const auto form = quadratic(lift, v);
    const Number q = lift(2) * form.hessian();
    return Fraction<Number>{lift(v.f[0]) * q + form.g * form.weight1() + form.h * form.weight2(),
                            q};
  }

  /// The sign of py / qy - px / qx, if all three signs it is made of are certain.
  template <class Lift, class Certain>
  MaybeSign quotient_sign(u32 x, u32 y, double scale, const Lift& lift,
                          const Certain& certain) const {
    const auto a = fraction(lift, x, scale), b = fraction(lift, y, scale);
    const MaybeSign over = certain(b.p * a.q - a.p * b.q), qa = certain(a.q), qb = certain(b.q);
    if (!over || !qa || !qb) return std::nullopt;
    return *over * *qa * *qb;
  }
  MaybeSign by_interval(u32 x, u32 y) const {
    const kernel::RoundUpward guard;
    return quotient_sign(
        x, y, 1, [](double v) { return Interval(v); },
        [](const Interval& i) { return kernel::certain_sign(i); });
  }
  MaybeSign by_mpfr(u32 x, u32 y) const {
    return quotient_sign(
        x, y, 1, [](double v) { return MpInterval(v, 128); },
        [](const MpInterval& i) { return certain_sign(i); });
  }
  Sign by_rationals(u32 x, u32 y) const {
    ++counts_.exact;
    return *quotient_sign(
        x, y, 1, [](double v) { return Rational(v); },
        [](const Rational& r) { return MaybeSign(kernel::sign_of(r)); });
  }

  /// Is one node's function the other's, up to a symmetry of the edge or face?
  bool same_function(u32 x, u32 y) const {
    if (x < first_line() || y < first_line() || (x < first_face()) != (y < first_face()))
      return false;
    if (x < first_face()) {
      const EdgeValues e = on_edge(x), f = on_edge(y);
      return e.m == f.m && ((e.a == f.a && e.b == f.b) || (e.a == f.b && e.b == f.a));
    }
    // A corner's value beside that in the middle of the opposite side, corners in any order.
    const auto key = [&](u32 node) {
      const FaceValues v = in_face(node);
      std::array<std::array<double, 2>, 3> pairs;
      for (std::size_t i = 0; i < 3; ++i) pairs[i] = {v.f[i], v.m[(i + 1) % 3]};
      std::sort(pairs.begin(), pairs.end());
      return pairs;
    };
    return key(x) == key(y);
  }

  void enclose() {
    const auto vertices = first_line();
    const std::size_t nodes = first_face() + tiling_.critical_faces.size();
    range_.resize(nodes);
    for (u32 v = 0; v < vertices; ++v) range_[v] = {c_.values[v], c_.values[v]};
    const kernel::RoundUpward guard;
    for (u32 node = vertices; node < nodes; ++node) {
      const auto [p, q] = fraction([](double v) { return Interval(v); }, node, 1);
      const Interval value = p / q;  // the whole line if q may be zero
      range_[node] = {value.inf(), value.sup()};
    }
  }

  const ReebContents& c_;
  const Gluing& mesh_;
  const Tiling& tiling_;
  Arithmetic arithmetic_;
  SignCounts& counts_;
  Grid grid_;
  Buffer<Range> range_;
};

Buffer<u32> ranks(const Buffer<u32>& order) {
  Buffer<u32> rank(order.size(), kNone);
  for (u32 i = 0; i < order.size(); ++i) {
    require(order[i] < order.size(), "order: no node {}", order[i]);
    require(rank[order[i]] == kNone, "order: node {} twice", order[i]);
    rank[order[i]] = i;
  }
  return rank;
}

}  // namespace

NodeOrder check_order(const ReebContents& c, const Gluing& mesh, const Tiling& tiling,
                      Arithmetic arithmetic, SignCounts& counts) {
  NodeOrder order{ranks(c.order), Buffer<std::uint8_t>(c.order.size(), 0)};
  if (c.edge_values.empty()) {
    counts.calls += c.order.size() - 1;
    for (std::size_t i = 1; i < c.order.size(); ++i) {
      const u32 x = c.order[i - 1], y = c.order[i];
      require(c.values[x] < c.values[y] || (c.values[x] == c.values[y] && x < y),
              "order: node {} is not above node {}", y, x);
      order.tied[i] = c.values[x] == c.values[y];
    }
    return order;
  }
  NodeValues values(c, mesh, tiling, arithmetic, counts);
  constexpr std::size_t kAhead = 16;
  for (std::size_t i = 1; i < c.order.size(); ++i) {
    if (i + kAhead < c.order.size()) values.fetch(c.order[i + kAhead]);
    const u32 x = c.order[i - 1], y = c.order[i];
    const Sign sign = values.difference(x, y);
    require(sign == Sign::positive || (sign == Sign::zero && x < y),
            "order: node {} is not above node {}", y, x);
    order.tied[i] = sign == Sign::zero;
  }
  return order;
}

Contraction count_ties(const ReebContents& c, const NodeOrder& order) {
  const std::size_t nodes = c.critical_nodes.size();
  Buffer<u32> value(nodes, 0);
  for (u32 i = 0, rank = 0; i < nodes; ++i) {
    // The value of the critical node before iff all between them are tied.
    bool equal = i > 0;
    for (; rank < order.rank[c.critical_nodes[i]]; ++rank)
      equal = equal && order.tied[rank + 1] != 0;
    value[i] = i == 0 ? 0 : value[i - 1] + (equal ? 0 : 1);
  }
  UnionFind classes(nodes);
  Contraction found{0, static_cast<u32>(nodes), 0};
  for (const ArcRecord& arc : c.arcs) {
    if (value[arc.lower] != value[arc.upper]) continue;
    ++found.tied_arcs;
    found.nodes -= classes.join(arc.lower, arc.upper) ? 1U : 0U;
  }
  Buffer<u32> below(nodes, 0), above(nodes, 0);
  for (const ArcRecord& arc : c.arcs) {
    if (value[arc.lower] == value[arc.upper]) continue;
    ++above[classes.find(arc.lower)];
    ++below[classes.find(arc.upper)];
  }
  for (u32 i = 0; i < nodes; ++i) found.passed += below[i] == 1 && above[i] == 1;
  return found;
}

}  // namespace crest::certify::reeb
