// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/arithmetic/taylor_lanes.hpp"

#include "kernel/arithmetic/wide_clones.hpp"

namespace crest::kernel {
namespace taylor {
namespace {

/// Calls f(constant k) for k < n, without a loop: the loop over lanes is to be the innermost.
template <std::size_t n, class F>
inline void unrolled(const F& f) {
  [&]<std::size_t... k>(std::index_sequence<k...>) {
    (f(std::integral_constant<std::size_t, k>{}), ...);
  }
  (std::make_index_sequence<n>{});
}

/// The coefficients of one lane.
struct Column {
  const double* first;
  double operator[](std::size_t k) const { return first[Lanes::count * k]; }
};

template <int Order>
struct Loops {
  using K = Kernels<Order>;
  static constexpr std::size_t kCount = K::kCount, kRadius = kCount;
  using Rows = LaneRows<Order>;

  static Column column(const Rows& a, std::size_t l) { return {a[0].x.data() + l}; }

  /// Kernels::size in its order of summation.
  template <class List>
  static double size(const List& a) {
    double sum[4] = {0, 0, 0, 0};
    unrolled<kCount / 4 * 4>([&](auto m) { sum[m % 4] += std::fabs(a[m]); });
    unrolled<kCount % 4>([&](auto m) { sum[0] += std::fabs(a[kCount / 4 * 4 + m]); });
    return (sum[0] + sum[2]) + (sum[1] + sum[3]);
  }

  template <std::size_t D>
  static double of_degree(const Column& a) {
    constexpr std::size_t kFirst = D * (D + 1) / 2;
    return [&]<std::size_t... I>(std::index_sequence<I...>) {
      return ((std::fabs(a[kFirst + I]) * K::kWeights.of[kFirst + I]) + ...);
    }
    (std::make_index_sequence<D + 1>{});
  }
  /// Kernels::left_out.
  static double left_out(const Column& a, double a_radius, const Column& b, double b_radius) {
    constexpr double kSpread = 1 << (Order / 2);
    constexpr double kRounding = 1.02 * kSpread * kSpread * K::kTerms * K::kUnit;
    double of_a[Order], of_b[Order], from_a[Order], from_b[Order];
    unrolled<Order>([&](auto d) {
      of_a[d] = of_degree<d + 1>(a);
      of_b[d] = of_degree<d + 1>(b);
    });
    from_a[Order - 1] = of_a[Order - 1];
    from_b[Order - 1] = of_b[Order - 1];
    unrolled<Order - 1>([&](auto d) {
      from_a[Order - 2 - d] = of_a[Order - 2 - d] + from_a[Order - 1 - d];
      from_b[Order - 2 - d] = of_b[Order - 2 - d] + from_b[Order - 1 - d];
    });
    const double beyond = [&]<std::size_t... D>(std::index_sequence<D...>) {
      return ((of_a[D] * from_b[Order - 1 - D]) + ...);
    }
    (std::make_index_sequence<Order>{});
    const double all_a = std::fabs(a[0]) + from_a[0], all_b = std::fabs(b[0]) + from_b[0];
    return beyond + kRounding * all_a * all_b + all_a * b_radius + all_b * a_radius +
           a_radius * b_radius + K::kLost * (all_a + all_b);
  }

  static bool may_be_flat(const Rows& a, const Rows& b) {
    const auto zero = [](double x) { return static_cast<int>(x == 0); };
    int any = 0;
    for (std::size_t l = 0; l < Lanes::count; ++l)
      any |= (zero(a[1].x[l]) & zero(a[2].x[l])) | (zero(b[1].x[l]) & zero(b[2].x[l]));
    return any != 0;
  }
};

/// r's rows by those of a and b, its radius by their radii.
template <int Order, class Term, class Radius>
inline void by_rows(const LaneRows<Order>& a, const LaneRows<Order>& b, LaneRows<Order>& result,
                    const Term& term, const Radius& radius) {
  using L = Loops<Order>;
  double* __restrict const r = result[0].x.data();
#pragma GCC ivdep
  for (std::size_t l = 0; l < Lanes::count; ++l) {
    const Column x = L::column(a, l), y = L::column(b, l);
    double c[L::kCount];
    unrolled<L::kCount>([&](auto m) { c[m] = r[Lanes::count * m + l] = term(x[m], y[m]); });
    r[Lanes::count * L::kRadius + l] =
        grow(radius(x[L::kRadius], y[L::kRadius]) + L::K::kUnit * L::size(c));
  }
}

/// The same by a number a lane.
template <int Order, class Term, class Radius>
inline void scale_lanes(const LaneRows<Order>& a, const Lanes& s, LaneRows<Order>& result,
                        const Term& term, const Radius& radius) {
  using L = Loops<Order>;
  const double* const factors = s.x.data();
  double* __restrict const r = result[0].x.data();
#pragma GCC ivdep
  for (std::size_t l = 0; l < Lanes::count; ++l) {
    const Column x = L::column(a, l);
    const double factor = factors[l];
    double c[L::kCount];
    unrolled<L::kCount>([&](auto m) { c[m] = r[Lanes::count * m + l] = term(x[m], factor); });
    r[Lanes::count * L::kRadius + l] =
        grow(radius(x[L::kRadius], factor) + L::K::kUnit * L::size(c));
  }
}

template <int Order, bool Add>
inline bool multiply_lanes(const LaneRows<Order>& a, const LaneRows<Order>& b,
                           LaneRows<Order>& result) {
  using L = Loops<Order>;
  if (L::may_be_flat(a, b)) return false;
  double* __restrict const r = result[0].x.data();
#pragma GCC ivdep
  for (std::size_t l = 0; l < Lanes::count; ++l) {
    const Column x = L::column(a, l), y = L::column(b, l);
    const double radius = L::left_out(x, x[L::kRadius], y, y[L::kRadius]);
    double c[L::kCount];
    unrolled<L::kCount>([&](auto m) {
      c[m] = L::K::template coefficient<m>(x, y);
      if constexpr (Add) c[m] = r[Lanes::count * m + l] + c[m];
      r[Lanes::count * m + l] = c[m];
    });
    if constexpr (Add) {
      r[Lanes::count * L::kRadius + l] =
          grow(r[Lanes::count * L::kRadius + l] + radius + L::K::kUnit * L::size(c));
    } else {
      r[Lanes::count * L::kRadius + l] = grow(radius);
    }
  }
  return true;
}

template <int Order>
inline void times_flat_lanes(const LaneRows<Order>& a, const LaneRows<Order>& flat,
                             LaneRows<Order>& result) {
  using L = Loops<Order>;
  double* __restrict const r = result[0].x.data();
#pragma GCC ivdep
  for (std::size_t l = 0; l < Lanes::count; ++l) {
    const Column x = L::column(a, l), y = L::column(flat, l);
    const double factor = y[0], size_of_a = L::size(x);
    double c[L::kCount];
    unrolled<L::kCount>([&](auto m) { c[m] = r[Lanes::count * m + l] = x[m] * factor; });
    r[Lanes::count * L::kRadius + l] =
        grow(std::fabs(factor) * x[L::kRadius] + y[L::kRadius] * (size_of_a + x[L::kRadius]) +
             L::K::kUnit * L::size(c));
  }
}

template <int Order>
inline void times_two_flat_lanes(const LaneRows<Order>& a, const LaneRows<Order>& flat,
                                 LaneRows<Order>& r) {
  constexpr std::size_t kRadius = Loops<Order>::kRadius;
  for (std::size_t m = 1; m < kRadius; ++m) r[m] = 0;
#pragma GCC ivdep
  for (std::size_t l = 0; l < Lanes::count; ++l) {
    const double constant = a[0].x[l], radius = a[kRadius].x[l], factor = flat[0].x[l];
    const double product = constant * factor;
    r[0].x[l] = product;
    r[kRadius].x[l] = grow(Kernels<Order>::kUnit * std::fabs(product) + std::fabs(factor) * radius +
                           flat[kRadius].x[l] * (std::fabs(constant) + radius));
  }
}

template <int Order>
inline LaneMask flat_lanes_of(const LaneRows<Order>& a) {
  LaneMask flat = 0;
#pragma GCC ivdep
  for (std::size_t l = 0; l < Lanes::count; ++l) {
    std::uint64_t bits = 0;
    for (std::size_t m = 1; m < Loops<Order>::kCount; ++m)
      bits |= std::bit_cast<std::uint64_t>(a[m].x[l]);
    flat |= LaneMask{bits << 1 == 0} << l;
  }
  return flat;
}

template <int Order>
inline bool all_lanes_defined(const LaneRows<Order>& a) {
  using L = Loops<Order>;
  int all = 1;
#pragma GCC ivdep
  for (std::size_t l = 0; l < Lanes::count; ++l) {
    const Column x = L::column(a, l);
    all &= L::size(x) + x[L::kRadius] < HUGE_VAL;
  }
  return all != 0;
}

/// range_of_rows of taylor_model.cpp: the even rows and the odd ones, then both.
template <int Order>
inline void range_of_lanes(const LaneRows<Order>& a, LaneRanges& result) {
  using L = Loops<Order>;
  static constexpr BernsteinTable<Order> kBernstein{};
  double* __restrict const lows = result.low.x.data();
  double* __restrict const highs = result.high.x.data();
#pragma GCC ivdep
  for (std::size_t l = 0; l < Lanes::count; ++l) {
    const Column x = L::column(a, l);
    double low[2], high[2];
    unrolled<L::kCount + L::kCount % 2>([&](auto row) {
      constexpr std::size_t kRow = row < L::kCount ? row : L::kCount - 1;
      double value = x[0];
      unrolled<L::kCount - 1>([&](auto m) { value += x[m + 1] * kBernstein.of[kRow][m + 1]; });
      double &least = low[row % 2], &most = high[row % 2];
      least = row < 2 ? value : value < least ? value : least;
      most = row < 2 ? value : value > most ? value : most;
    });
    const double least = low[0] < low[1] ? low[0] : low[1];
    const double most = high[0] > high[1] ? high[0] : high[1];
    const double size = L::size(x);
    const double slack = grow(x[L::kRadius] + (L::kCount + 6) * L::K::kUnit * size);
    const bool finite = size + slack < HUGE_VAL;
    lows[l] = finite ? least - slack - std::fabs(least) * 0x1p-52 : -HUGE_VAL;
    highs[l] = finite ? most + slack + std::fabs(most) * 0x1p-52 : HUGE_VAL;
  }
}

template <int Order>
inline void sizes_of_lanes(const LaneRows<Order>& a, Lanes& sizes) {
  double* __restrict const r = sizes.x.data();
#pragma GCC ivdep
  for (std::size_t l = 0; l < Lanes::count; ++l)
    r[l] = Loops<Order>::size(Loops<Order>::column(a, l));
}

/// inverse_series() of taylor_series.hpp.
template <int Order>
inline void inverse_series_lanes(const Lanes& centre, const Lanes& radius,
                                 LaneSeries<Order>& series) {
  const double *const c = centre.x.data(), *const rho = radius.x.data();
  double* __restrict const t = series.t[0].x.data();
  double* __restrict const error = series.error[0].x.data();
  double* __restrict const rest = series.rest.x.data();
#pragma GCC ivdep
  for (std::size_t l = 0; l < Lanes::count; ++l) {
    const double size = std::fabs(c[l]), nearest = shrink(size - rho[l]);
    const bool analytic = (nearest > 0) & (size < HUGE_VAL);
    const double first = 1 / c[l];
    double term = first, power = 1;
    unrolled<Order + 1>([&](auto k) {
      if constexpr (k > 0) term = -term * first;
      const double bound = grow((2 + 2.0 * k) * Kernels<Order>::kUnit * std::fabs(term));
      t[Lanes::count * k + l] = analytic ? term : 0;
      error[Lanes::count * k + l] = analytic ? bound : 0;
      power *= size;
    });
    const double below = power * nearest, quotient = 1 / below;
    rest[l] = (analytic & (below > 0x1p-960)) ? grow(quotient) : HUGE_VAL;
  }
}

template <int Order>
inline void add_scaled_lanes(const LaneRows<Order>& a, const Lanes& w, LaneRows<Order>& sum) {
  using L = Loops<Order>;
  const double* const weights = w.x.data();
  double* __restrict const r = sum[0].x.data();
#pragma GCC ivdep
  for (std::size_t l = 0; l < Lanes::count; ++l) {
    const Column x = L::column(a, l);
    unrolled<L::kCount>([&](auto m) { r[Lanes::count * m + l] += weights[l] * x[m]; });
  }
}

template <int Order>
inline void centred_lanes(const LaneRows<Order>& a, const Lanes& centre, LaneRows<Order>& h) {
  constexpr std::size_t kRadius = Loops<Order>::kRadius;
  h = a;
#pragma GCC ivdep
  for (std::size_t l = 0; l < Lanes::count; ++l) {
    h[0].x[l] = a[0].x[l] - centre.x[l];
    h[kRadius].x[l] = grow(a[kRadius].x[l] + Kernels<Order>::kUnit * std::fabs(h[0].x[l]));
  }
}

}  // namespace

#define CREST_LANE_LOOPS(Order)                                                                 \
  CREST_WIDE_CLONES void add(const LaneRows<Order>& a, const LaneRows<Order>& b,                \
                             LaneRows<Order>& r) {                                              \
    const auto sum = [](double x, double y) { return x + y; };                                  \
    by_rows<Order>(a, b, r, sum, sum);                                                          \
  }                                                                                             \
  CREST_WIDE_CLONES void subtract(const LaneRows<Order>& a, const LaneRows<Order>& b,           \
                                  LaneRows<Order>& r) {                                         \
    by_rows<Order>(                                                                             \
        a, b, r, [](double x, double y) { return x - y; },                                      \
        [](double x, double y) { return x + y; });                                              \
  }                                                                                             \
  CREST_WIDE_CLONES void scale(const LaneRows<Order>& a, const Lanes& s, LaneRows<Order>& r) {  \
    scale_lanes<Order>(                                                                         \
        a, s, r, [](double x, double y) { return x * y; },                                      \
        [](double x, double y) { return std::fabs(y) * x; });                                   \
  }                                                                                             \
  CREST_WIDE_CLONES void divide(const LaneRows<Order>& a, const Lanes& s, LaneRows<Order>& r) { \
    scale_lanes<Order>(                                                                         \
        a, s, r, [](double x, double y) { return x / y; },                                      \
        [](double x, double y) { return x / std::fabs(y) + 0 * y; });                           \
  }                                                                                             \
  CREST_WIDE_CLONES bool multiply(const LaneRows<Order>& a, const LaneRows<Order>& b,           \
                                  LaneRows<Order>& r) {                                         \
    return multiply_lanes<Order, false>(a, b, r);                                               \
  }                                                                                             \
  CREST_WIDE_CLONES bool multiply_and_add(const LaneRows<Order>& a, const LaneRows<Order>& b,   \
                                          LaneRows<Order>& sum) {                               \
    return multiply_lanes<Order, true>(a, b, sum);                                              \
  }                                                                                             \
  CREST_WIDE_CLONES void times_flat(const LaneRows<Order>& a, const LaneRows<Order>& flat,      \
                                    LaneRows<Order>& r) {                                       \
    times_flat_lanes<Order>(a, flat, r);                                                        \
  }                                                                                             \
  CREST_WIDE_CLONES void times_two_flat(const LaneRows<Order>& a, const LaneRows<Order>& flat,  \
                                        LaneRows<Order>& r) {                                   \
    times_two_flat_lanes<Order>(a, flat, r);                                                    \
  }                                                                                             \
  CREST_WIDE_CLONES LaneMask flat_lanes(const LaneRows<Order>& a) {                             \
    return flat_lanes_of<Order>(a);                                                             \
  }                                                                                             \
  CREST_WIDE_CLONES bool all_defined(const LaneRows<Order>& a) {                                \
    return all_lanes_defined<Order>(a);                                                         \
  }                                                                                             \
  CREST_WIDE_CLONES void range_of(const LaneRows<Order>& a, LaneRanges& r) {                    \
    range_of_lanes<Order>(a, r);                                                                \
  }                                                                                             \
  CREST_WIDE_CLONES void sizes_of(const LaneRows<Order>& a, Lanes& sizes) {                     \
    sizes_of_lanes<Order>(a, sizes);                                                            \
  }                                                                                             \
  CREST_WIDE_CLONES void series_of_inverse(const Lanes& centre, const Lanes& rho,               \
                                           LaneSeries<Order>& s) {                              \
    inverse_series_lanes<Order>(centre, rho, s);                                                \
  }                                                                                             \
  CREST_WIDE_CLONES void add_scaled(const LaneRows<Order>& a, const Lanes& w,                   \
                                    LaneRows<Order>& sum) {                                     \
    add_scaled_lanes<Order>(a, w, sum);                                                         \
  }                                                                                             \
  CREST_WIDE_CLONES void centred(const LaneRows<Order>& a, const Lanes& centre,                 \
                                 LaneRows<Order>& h) {                                          \
    centred_lanes<Order>(a, centre, h);                                                         \
  }
CREST_LANE_LOOPS(3)
CREST_LANE_LOOPS(4)
CREST_LANE_LOOPS(5)
#undef CREST_LANE_LOOPS

}  // namespace taylor

template <int Order>
TaylorLanes<Order> TaylorLanes<Order>::linear(const Lanes& at0, const Lanes& at1,
                                              const Lanes& at2) {
  TaylorLanes r;
  for (std::size_t l = 0; l < kLanes; ++l)
    r.set_lane(l, Model::linear(at0.x[l], at1.x[l], at2.x[l]));
  return r;
}

template <int Order>
void TaylorLanes<Order>::set_product(const TaylorLanes& a, const TaylorLanes& b) {
  const LaneMask flat_a = taylor::flat_lanes(a.rows), flat_b = taylor::flat_lanes(b.rows);
  const auto uniform = [](LaneMask m) { return m == 0 || m == kAllLanes; };
  if (uniform(flat_a) && uniform(flat_b) && (flat_a | flat_b) != 0) {
    // As TaylorModel: the first flat one is the factor of the other.
    const TaylorLanes &factor = flat_a != 0 ? a : b, &other = flat_a != 0 ? b : a;
    if (flat_a != 0 && flat_b != 0)
      taylor::times_two_flat(other.rows, factor.rows, rows);
    else
      taylor::times_flat(other.rows, factor.rows, rows);
    return;
  }
  for (std::size_t l = 0; l < kLanes; ++l) set_lane(l, a.lane(l) * b.lane(l));
}

template <int Order>
void TaylorLanes<Order>::add_slowly(const TaylorLanes& a, const TaylorLanes& b) {
  const LaneMask flat = taylor::flat_lanes(a.rows) | taylor::flat_lanes(b.rows);
  if (flat == kAllLanes) {
    *this = *this + a * b;
    return;
  }
  for (std::size_t l = 0; l < kLanes; ++l) {
    Model sum = lane(l);
    add_product(sum, a.lane(l), b.lane(l));
    set_lane(l, sum);
  }
}

template <int Order>
TaylorLanes<Order> TaylorLanes<Order>::compose(taylor::Series (*make_series)(double, double, int),
                                               Model (*alone)(const Model&)) const {
  if (taylor::flat_lanes(rows) != 0) {
    TaylorLanes r(Unset{});
    for (std::size_t l = 0; l < kLanes; ++l) r.set_lane(l, alone(lane(l)));
    return r;
  }
  const LaneRanges all = range();
  Lanes centre, power;
  for (std::size_t l = 0; l < kLanes; ++l) centre.x[l] = 0.5 * (all.low.x[l] + all.high.x[l]);
  TaylorLanes h(Unset{});
  taylor::centred(rows, centre, h.rows);
  const LaneRanges off = h.range();
  taylor::LaneSeries<Order> all_series;
  auto& [t, error, rest] = all_series;
  Lanes rho;
  for (std::size_t l = 0; l < kLanes; ++l) {
    rho.x[l] = std::fmax(-off.low.x[l], off.high.x[l]);
    power.x[l] = 1;
    for (int k = 0; k <= Order; ++k) power.x[l] *= rho.x[l];
  }
  if (make_series == taylor::inverse_series)
    taylor::series_of_inverse(centre, rho, all_series);
  else
    for (std::size_t l = 0; l < kLanes; ++l) {
      const taylor::Series s = make_series(centre.x[l], rho.x[l], Order);
      for (std::size_t k = 0; k <= Order; ++k) t[k].x[l] = s.t[k], error[k].x[l] = s.error[k];
      rest.x[l] = s.rest;
    }
  TaylorLanes r = around(t[Order], error[Order]);
  for (std::size_t k = Order; k-- > 0;) r = r * h + around(t[k], error[k]);
  for (std::size_t l = 0; l < kLanes; ++l) {
    double& radius = r.radius().x[l];
    radius = grow(radius + rest.x[l] * (power.x[l] + 0x1p-1000));  // power may underflow
  }
  return r;
}

template class TaylorLanes<3>;
template class TaylorLanes<4>;
template class TaylorLanes<5>;

}  // namespace crest::kernel
