// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Eight Taylor models that go through one formula together, an instruction for several of them.
//
// Law. Lane l of a result has the bits that TaylorModel gives for the operands' lanes l, on every
// instruction set: the same operations in the same order, none contracted. So a lane encloses what
// the model would (taylor_model.hpp), and is undefined where the model would be. Operands that do
// not go one way together (one lane flat, another not) go alone, as models.
// is_defined() asks for all lanes: jets, which make all coefficients undefined if the value is, do
// so in all lanes. A lane is undefined then where its model alone might not be, never otherwise.
#include <bit>

#include "kernel/arithmetic/jet.hpp"
#include "kernel/arithmetic/lanes.hpp"
#include "kernel/arithmetic/taylor_model.hpp"

namespace crest::kernel {

struct LaneRanges {
  Lanes low, high;
  Range operator[](std::size_t l) const { return {low.x[l], high.x[l]}; }
};

/// The sign of all of them.
inline MaybeSign certain_sign(const LaneRanges& r) {
  const MaybeSign first = certain_sign(r[0]);
  for (std::size_t l = 1; l < Lanes::count; ++l)
    if (certain_sign(r[l]) != first) return std::nullopt;
  return first;
}

/// Bit l: lane l.
using LaneMask = unsigned;
inline constexpr LaneMask kAllLanes = (1U << Lanes::count) - 1;

namespace taylor {

/// Coefficients as in the model, then the radius; a row has the lanes.
template <int Order>
using LaneRows = std::array<Lanes, monomial_count(2, Order) + 1>;

/// Series by lanes.
template <int Order>
struct LaneSeries {
  std::array<Lanes, Order + 1> t, error;
  Lanes rest;
};

// The loops over the lanes, for each instruction set. Requires: the result is no operand.
#define CREST_LANE_LOOPS(Order)                                                                    \
  void add(const LaneRows<Order>& a, const LaneRows<Order>& b, LaneRows<Order>& r);                \
  void subtract(const LaneRows<Order>& a, const LaneRows<Order>& b, LaneRows<Order>& r);           \
  void scale(const LaneRows<Order>& a, const Lanes& s, LaneRows<Order>& r);                        \
  void divide(const LaneRows<Order>& a, const Lanes& s, LaneRows<Order>& r);                       \
  /* False, and nothing done, if a lane of a factor may be flat. */                                \
  bool multiply(const LaneRows<Order>& a, const LaneRows<Order>& b, LaneRows<Order>& r);           \
  bool multiply_and_add(const LaneRows<Order>& a, const LaneRows<Order>& b, LaneRows<Order>& sum); \
  /* By lanes that are flat; of lanes that are all not flat, or all flat. */                       \
  void times_flat(const LaneRows<Order>& a, const LaneRows<Order>& flat, LaneRows<Order>& r);      \
  void times_two_flat(const LaneRows<Order>& a, const LaneRows<Order>& flat, LaneRows<Order>& r);  \
  LaneMask flat_lanes(const LaneRows<Order>& a);                                                   \
  bool all_defined(const LaneRows<Order>& a);                                                      \
  void range_of(const LaneRows<Order>& a, LaneRanges& r);                                          \
  void sizes_of(const LaneRows<Order>& a, Lanes& sizes);                                           \
  void series_of_inverse(const Lanes& centre, const Lanes& rho, LaneSeries<Order>& s);             \
  /* The coefficients of w a to those of the sum. */                                               \
  void add_scaled(const LaneRows<Order>& a, const Lanes& w, LaneRows<Order>& sum);                 \
  /* a less the constant `centre`. */                                                              \
  void centred(const LaneRows<Order>& a, const Lanes& centre, LaneRows<Order>& h)
CREST_LANE_LOOPS(3);
CREST_LANE_LOOPS(4);
CREST_LANE_LOOPS(5);
#undef CREST_LANE_LOOPS

}  // namespace taylor

template <int Order>
class TaylorLanes {
 public:
  using Model = TaylorModel<Order>;
  static constexpr std::size_t kCount = Model::kCount;
  static constexpr std::size_t kLanes = Lanes::count;

  alignas(64) taylor::LaneRows<Order> rows;

  TaylorLanes() { rows.fill(0); }
  explicit TaylorLanes(double constant) : TaylorLanes() { rows[0] = constant; }
  explicit TaylorLanes(const Lanes& constants) : TaylorLanes() { rows[0] = constants; }
  /// The same in all lanes.
  explicit TaylorLanes(const Model& m) {
    for (std::size_t k = 0; k < kCount; ++k) rows[k] = m.c[k];
    rows[kCount] = m.radius;
  }
  static TaylorLanes around(const Lanes& constants, const Lanes& errors) {
    TaylorLanes r(constants);
    r.rows[kCount] = errors;
    return r;
  }
  static TaylorLanes linear(const Lanes& at0, const Lanes& at1, const Lanes& at2);

  const Lanes& radius() const { return rows[kCount]; }
  Lanes& radius() { return rows[kCount]; }

  Model lane(std::size_t l) const {
    Model m;
    for (std::size_t k = 0; k < kCount; ++k) m.c[k] = rows[k].x[l];
    m.radius = radius().x[l];
    return m;
  }
  void set_lane(std::size_t l, const Model& m) {
    for (std::size_t k = 0; k < kCount; ++k) rows[k].x[l] = m.c[k];
    radius().x[l] = m.radius;
  }

  LaneRanges range() const {
    LaneRanges r;
    taylor::range_of(rows, r);
    return r;
  }

  friend bool is_defined(const TaylorLanes& a) { return taylor::all_defined(a.rows); }

  TaylorLanes operator-() const {
    TaylorLanes r(Unset{});
    for (std::size_t k = 0; k < kCount; ++k)
      for (std::size_t l = 0; l < kLanes; ++l) r.rows[k].x[l] = -rows[k].x[l];
    r.radius() = radius();
    return r;
  }
  friend TaylorLanes operator+(const TaylorLanes& a, const TaylorLanes& b) {
    TaylorLanes r(Unset{});
    taylor::add(a.rows, b.rows, r.rows);
    return r;
  }
  friend TaylorLanes operator-(const TaylorLanes& a, const TaylorLanes& b) {
    TaylorLanes r(Unset{});
    taylor::subtract(a.rows, b.rows, r.rows);
    return r;
  }
  friend TaylorLanes operator+(const TaylorLanes& a, const Lanes& s) { return a + TaylorLanes(s); }
  friend TaylorLanes operator*(const Lanes& s, const TaylorLanes& a) { return a * s; }
  friend TaylorLanes operator*(const TaylorLanes& a, const Lanes& s) {
    TaylorLanes r(Unset{});
    taylor::scale(a.rows, s, r.rows);
    return r;
  }
  friend TaylorLanes operator/(const TaylorLanes& a, const Lanes& s) {
    TaylorLanes r(Unset{});
    taylor::divide(a.rows, s, r.rows);
    return r;
  }
  friend TaylorLanes operator*(const TaylorLanes& a, const TaylorLanes& b) {
    TaylorLanes r(Unset{});
    if (!taylor::multiply(a.rows, b.rows, r.rows)) r.set_product(a, b);
    return r;
  }
  /// sum += a b (see jet_tables.hpp).
  friend void add_product(TaylorLanes& sum, const TaylorLanes& a, const TaylorLanes& b) {
    if (&sum == &a || &sum == &b || !taylor::multiply_and_add(a.rows, b.rows, sum.rows))
      sum.add_slowly(a, b);
  }
  friend TaylorLanes operator/(const TaylorLanes& a, const TaylorLanes& b) {
    return a * inverse(b);
  }
  friend TaylorLanes inverse(const TaylorLanes& a) {
    return a.compose(taylor::inverse_series, [](const Model& m) { return inverse(m); });
  }
  friend TaylorLanes sqrt(const TaylorLanes& a) {
    return a.compose(taylor::sqrt_series, [](const Model& m) { return sqrt(m); });
  }
  friend TaylorLanes exp(const TaylorLanes& a) {
    return a.compose(taylor::exp_series, [](const Model& m) { return exp(m); });
  }
  friend TaylorLanes log(const TaylorLanes& a) {
    return a.compose(taylor::log_series, [](const Model& m) { return log(m); });
  }
  friend TaylorLanes sin(const TaylorLanes& a) {
    return a.compose(taylor::sin_series, [](const Model& m) { return sin(m); });
  }
  friend TaylorLanes cos(const TaylorLanes& a) {
    return a.compose(taylor::cos_series, [](const Model& m) { return cos(m); });
  }
  /// In all lanes (defined.hpp).
  friend TaylorLanes undefined_of(TaylorLanes a) {
    a.radius() = HUGE_VAL;
    return a;
  }
  /// Constants of a jet's operations (jet_tables.hpp).
  friend TaylorLanes number_like(const Lanes& x, const TaylorLanes* /*like*/) {
    return TaylorLanes(x);
  }

 private:
  struct Unset {};
  explicit TaylorLanes(Unset) {}  // NOLINT: all rows are written next

  void set_product(const TaylorLanes& a, const TaylorLanes& b);
  void add_slowly(const TaylorLanes& a, const TaylorLanes& b);
  TaylorLanes compose(taylor::Series (*make_series)(double, double, int),
                      Model (*alone)(const Model&)) const;
};

template <int Order>
struct ScalarOf<TaylorLanes<Order>> {
  using Type = Lanes;
};

template <int Order, int Variables, int JetOrder>
Jet<TaylorModel<Order>, Variables, JetOrder> lane_of(
    const Jet<TaylorLanes<Order>, Variables, JetOrder>& f, std::size_t l) {
  Jet<TaylorModel<Order>, Variables, JetOrder> r;
  for_each_bit(f.mask(), [&](std::size_t i) { r.set(i, f[i].lane(l)); });
  return r;
}
/// Gives lane `to` what lane `from` has.
inline void copy_lane(Lanes& x, std::size_t from, std::size_t to) {
  x.x[to] = x.x[from];
}
template <int Order>
void copy_lane(TaylorLanes<Order>& f, std::size_t from, std::size_t to) {
  for (Lanes& row : f.rows) row.x[to] = row.x[from];
}
template <int Order, int Variables, int JetOrder>
void copy_lane(Jet<TaylorLanes<Order>, Variables, JetOrder>& f, std::size_t from, std::size_t to) {
  for_each_bit(f.mask(), [&](std::size_t i) {
    auto coefficient = f[i];
    copy_lane(coefficient, from, to);
    f.set(i, coefficient);
  });
}

extern template class TaylorLanes<3>;
extern template class TaylorLanes<4>;
extern template class TaylorLanes<5>;

}  // namespace crest::kernel
