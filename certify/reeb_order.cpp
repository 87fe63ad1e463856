// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/quadratic.hpp"
#include "certify/reject.hpp"

namespace crest::certify::reeb {
namespace {

using u32 = std::uint32_t;
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
  NodeValues(const ReebCertificate& c, const Gluing& mesh, const Tiling& tiling,
             Arithmetic arithmetic, SignCounts& counts)
      : c_(c), mesh_(mesh), tiling_(tiling), arithmetic_(arithmetic), counts_(counts) {
    if (arithmetic == Arithmetic::doubles) enclose();
  }

  /// The sign of value(y) - value(x).
  Sign difference(u32 x, u32 y) {
    ++counts_.calls;
    // Two doubles: nothing is rounded.
    if (x < c_.values.size() && y < c_.values.size()) {
      const double a = c_.values[x], b = c_.values[y];
      return b > a ? Sign::positive : b < a ? Sign::negative : Sign::zero;
    }
    if (arithmetic_ == Arithmetic::doubles) {
      if (low_[y] > high_[x]) return Sign::positive;
      if (high_[y] < low_[x]) return Sign::negative;
    }
    ++counts_.interval;
    if (const MaybeSign sign =
            arithmetic_ == Arithmetic::doubles ? by_interval(x, y) : by_mpfr(x, y))
      return *sign;
    ++counts_.exact;
    return *quotient_sign(
        x, y, [](double v) { return Rational(v); },
        [](const Rational& r) { return MaybeSign(kernel::sign_of(r)); });
  }

 private:
  template <class Lift>
  auto fraction(const Lift& lift, u32 node) const {
    using Number = decltype(lift(0.0));
    const std::size_t vertices = c_.values.size(), lines = tiling_.line_edges.size();
    if (node < vertices) return Fraction<Number>{lift(c_.values[node]), lift(1)};
    if (node < vertices + lines) {
      const EdgeValues e = values_on_edge(c_, mesh_, tiling_.line_edges[node - vertices]);
      const Number d = start_slope(lift, e), q = lift(2) * (d - end_slope(lift, e));
      return Fraction<Number>{lift(e.a) * q + d * d, q};
    }
    const FaceValues v = values_in_face(c_, mesh_, tiling_.critical_faces[node - vertices - lines]);
    const auto form = quadratic(lift, v);
    const Number q = lift(2) * form.hessian();
    return Fraction<Number>{lift(v.f[0]) * q + form.g * form.weight1() + form.h * form.weight2(),
                            q};
  }

  /// The sign of py / qy - px / qx, if all three signs it is made of are certain.
  template <class Lift, class Certain>
  MaybeSign quotient_sign(u32 x, u32 y, const Lift& lift, const Certain& certain) const {
    const auto a = fraction(lift, x), b = fraction(lift, y);
    const MaybeSign over = certain(b.p * a.q - a.p * b.q), qa = certain(a.q), qb = certain(b.q);
    if (!over || !qa || !qb) return std::nullopt;
    return *over * *qa * *qb;
  }
  MaybeSign by_interval(u32 x, u32 y) const {
    const kernel::RoundUpward guard;
    return quotient_sign(
        x, y, [](double v) { return Interval(v); },
        [](const Interval& i) { return kernel::certain_sign(i); });
  }
  MaybeSign by_mpfr(u32 x, u32 y) const {
    return quotient_sign(
        x, y, [](double v) { return MpInterval(v, 128); },
        [](const MpInterval& i) { return certain_sign(i); });
  }

  void enclose() {
    const std::size_t nodes =
        c_.values.size() + tiling_.line_edges.size() + tiling_.critical_faces.size();
    low_ = high_ = c_.values;
    low_.resize(nodes);
    high_.resize(nodes);
    const kernel::RoundUpward guard;
    for (auto node = static_cast<u32>(c_.values.size()); node < nodes; ++node) {
      const auto [p, q] = fraction([](double v) { return Interval(v); }, node);
      const Interval value = p / q;  // the whole line if q may be zero
      low_[node] = value.inf();
      high_[node] = value.sup();
    }
  }

  const ReebCertificate& c_;
  const Gluing& mesh_;
  const Tiling& tiling_;
  Arithmetic arithmetic_;
  SignCounts& counts_;
  std::vector<double> low_, high_;
};

std::vector<u32> ranks(const std::vector<u32>& order) {
  std::vector<u32> rank(order.size(), kNone);
  for (u32 i = 0; i < order.size(); ++i) {
    require(order[i] < order.size(), "order: no node {}", order[i]);
    require(rank[order[i]] == kNone, "order: node {} twice", order[i]);
    rank[order[i]] = i;
  }
  return rank;
}

}  // namespace

std::vector<u32> check_order(const ReebCertificate& c, const Gluing& mesh, const Tiling& tiling,
                             Arithmetic arithmetic, SignCounts& counts) {
  std::vector<u32> rank = ranks(c.order);
  if (c.edge_values.empty()) {
    counts.calls += c.order.size() - 1;
    for (std::size_t i = 1; i < c.order.size(); ++i) {
      const u32 x = c.order[i - 1], y = c.order[i];
      require(c.values[x] < c.values[y] || (c.values[x] == c.values[y] && x < y),
              "order: node {} is not above node {}", y, x);
    }
    return rank;
  }
  NodeValues values(c, mesh, tiling, arithmetic, counts);
  for (std::size_t i = 1; i < c.order.size(); ++i) {
    const u32 x = c.order[i - 1], y = c.order[i];
    const Sign sign = values.difference(x, y);
    require(sign == Sign::positive || (sign == Sign::zero && x < y),
            "order: node {} is not above node {}", y, x);
  }
  return rank;
}

}  // namespace crest::certify::reeb
