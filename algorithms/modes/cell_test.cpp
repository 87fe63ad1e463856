// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/cell_test.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/modes/cell_lanes.hpp"
#include "algorithms/modes/half_space.hpp"
#include "kernel/arithmetic/wide_clones.hpp"

namespace crest::modes {
namespace {

/// What a test of eight simplices starts from.
template <int D, class Kind>
struct Prepared {
  using Basis = kernel::SimplexBasis<D, Kind::degree>;
  using Form = kernel::Form<RealLanes, Basis>;
  Form f;
  std::array<Form, D> growth;  ///< if f has no sign somewhere
  HullMasks signs;
  std::array<Lanes, D + 1> scale;  ///< one over the largest coefficient; 0: there is none
  /// The coefficients of growth and f, scaled, as unit vectors; 0: only zeros of integers, which
  /// strictly_positive judges.
  std::array<std::array<Lanes, D + 1>, Basis::count> vectors;
};

template <int D, class Kind>
CREST_WIDE_CLONES void prepare(const EightTensors<D>& cells, const Level& level,
                               Prepared<D, Kind>& r) {
  using Basis = typename Prepared<D, Kind>::Basis;
  const auto forms = bounded_forms<Lanes, D>(cells.t, cells.largest, cells.error);
  r.f = Kind::f(forms, level);
  r.signs = HullMasks(r.f);
  if ((r.signs.positive | r.signs.negative) == (1U << Lanes::count) - 1) return;
  for (std::size_t k = 0; k < D; ++k) r.growth[k] = Kind::growth(forms, level, k);
  Wide zero, infinity;
  load(0, zero);
  load(HUGE_VAL, infinity);
  for (std::size_t k = 0; k <= D; ++k) {
    const auto& form = k < D ? r.growth[k] : r.f;
    Wide largest = zero, x;
    for (std::size_t i = 0; i < Basis::count; ++i) {
      load(form.s[i], x);
      x /= Basis::weights[i];
      store(x, r.vectors[i][k]);
      const Wide size = x < 0 ? -x : x;
      largest = largest < size ? size : largest;
    }
    store(1 / (largest > 0 ? largest : infinity), r.scale[k]);
  }
  for (auto& v : r.vectors) {
    Wide norm = zero, x, scale;
    for (std::size_t k = 0; k <= D; ++k) {
      load(v[k], x);
      load(r.scale[k], scale);
      x *= scale;
      store(x, v[k]);
      norm += x * x;
    }
    Lanes length;
    store(norm, length);
    for (std::size_t l = 0; l < Lanes::count; ++l) length.x[l] = std::sqrt(length.x[l]);
    load(length, norm);
    const Wide factor = 1 / (norm > 1e-12 ? norm : infinity);
    for (Lanes& y : v) {
      load(y, x);
      store(x * factor, y);
    }
  }
}

/// The signs of p for a witness in each lane.
template <int D, class Kind>
CREST_WIDE_CLONES HullMasks try_witnesses(const Prepared<D, Kind>& cells,
                                          const std::array<Lanes, D>& w, const Lanes& lambda) {
  auto p = RealLanes(lambda) * cells.f;
  for (std::size_t k = 0; k < D; ++k) p = p + RealLanes(w[k]) * cells.growth[k];
  return HullMasks(p);
}

template <std::size_t N, std::size_t Most>
CREST_WIDE_CLONES std::optional<std::array<double, N>> direction(const VectorList<N, Most>& list) {
  return HalfSpace<N, Most>::search(list);
}

template <int D, class Kind>
class Test {
  using Basis = kernel::SimplexBasis<D, Kind::degree>;

 public:
  Test(std::span<const Corners<D>> cells, const ExactCorners<D>& exact, const Level& level,
       std::span<CellResult<D>> results)
      : exact_(exact), level_(level), results_(results) {
    prepare<D, Kind>(EightTensors<D>(cells), level, cells_);
  }

  void run() {
    unsigned open = 0;
    for (std::size_t l = 0; l < results_.size(); ++l) {
      CellResult<D>& r = results_[l];
      if (const auto certain = cells_.signs.finding(l)) {
        r.finding = *certain;
      } else {
        r.exact = true;
        r.finding = exact_finding(Kind::f(integer_forms<D>(exact_(l)), level_));
      }
      if (r.finding != Finding::none || !search(l)) continue;
      open |= 1U << l;
    }
    open = keep_what_holds(open);
    for (std::size_t l = 0; l < results_.size(); ++l)
      if (open >> l & 1U) results_[l].witness.lambda = 0;
    keep_what_holds(open);
  }

 private:
  /// Tries the lanes' witnesses; the lanes whose do not hold.
  unsigned keep_what_holds(unsigned open) {
    if (open == 0) return 0;
    std::array<Lanes, D> w;
    Lanes lambda = 0;
    w.fill(0);
    for (std::size_t l = 0; l < results_.size(); ++l) {
      for (std::size_t k = 0; k < D; ++k) w[k].x[l] = results_[l].witness.w[k + 1];
      lambda.x[l] = results_[l].witness.lambda;
    }
    const HullMasks signs = try_witnesses<D, Kind>(cells_, w, lambda);
    unsigned left = 0;
    for (std::size_t l = 0; l < results_.size(); ++l) {
      const unsigned bit = 1U << l;
      if ((open & bit) == 0) continue;
      if ((signs.positive & bit) != 0 || ((signs.some_negative & bit) == 0 && holds_exactly(l)))
        results_[l].finding = Finding::graph;
      else
        left |= bit;
    }
    return left;
  }

  bool holds_exactly(std::size_t l) {
    const Witness<D>& y = results_[l].witness;
    // The integers are the tensors times a power of two that is not known here, and the two terms
    // have different degrees.
    if (y.lambda != 0 && Kind::degree == 6) return false;
    results_[l].exact = true;
    const auto forms = integer_forms<D>(exact_(l));
    auto p = Integer(y.lambda) * Kind::f(forms, level_);
    for (std::size_t k = 0; k < D; ++k)
      if (y.w[k + 1] != 0) p = p + Integer(y.w[k + 1]) * Kind::growth(forms, level_, k);
    return strictly_positive(p);
  }

  /// Finds a witness to be tried.
  bool search(std::size_t l) {
    VectorList<D + 1, Basis::count> list;
    for (const auto& v : cells_.vectors) {
      bool zero = true;
      for (std::size_t k = 0; k <= D; ++k) {
        list.component[k][list.size] = v[k].x[l];
        zero = zero && v[k].x[l] == 0;
      }
      list.size += zero ? 0 : 1;
    }
    auto y = direction(list);
    if (!y) return false;
    for (std::size_t k = 0; k <= D; ++k) (*y)[k] *= cells_.scale[k].x[l];
    return round(*y, results_[l].witness);
  }

  static bool round(const std::array<double, D + 1>& y, Witness<D>& r) {
    double sum = 0, largest = 0;
    for (std::size_t k = 0; k <= D; ++k) largest = std::fmax(largest, std::fabs(y[k]));
    for (std::size_t k = 0; k < D; ++k) sum += y[k];
    largest = std::fmax(largest, std::fabs(sum));
    if (!(largest > 0)) return false;
    const double unit = 32000 / largest;
    int rest = 0;
    for (std::size_t k = 0; k < D; ++k) {
      r.w[k + 1] = static_cast<std::int16_t>(std::lround(unit * y[k]));
      rest -= r.w[k + 1];
    }
    r.w[0] = static_cast<std::int16_t>(rest);
    // A multiple of 3: the certificate's lambda is a third of it (certificate.cpp).
    r.lambda = static_cast<std::int16_t>(3 * std::lround(unit / 3 * y[D]));
    return true;
  }

  const ExactCorners<D>& exact_;
  const Level& level_;
  std::span<CellResult<D>> results_;
  Prepared<D, Kind> cells_;
};

/// Ranges of the nets of c and n.
struct Ranges {
  Lanes c_low, c_high, n_low, n_high;
};

template <class Form>
void range(const Form& f, Lanes& low, Lanes& high) {
  using B = typename Form::Basis;
  Wide x, least, most;
  load(f.s[0], least);
  most = least /= B::weights[0];
  for (std::size_t i = 1; i < B::count; ++i) {
    load(f.s[i], x);
    x /= B::weights[i];
    least = x < least ? x : least;
    most = x > most ? x : most;
  }
  store(least, low);
  store(most, high);
}

/// By the ranges; the factors cover the divisions' roundings.
std::optional<Finding> by_bound(const TensorForms<RealLanes, 3>& forms, const Ranges& r,
                                const Level& level, std::size_t l) {
  const double c_low = r.c_low.x[l], c_high = r.c_high.x[l], n_low = r.n_low.x[l],
               n_high = std::fmax(r.n_high.x[l], 0);
  const double ce =
      1.01 * forms.c.error.x[l] + 0x1p-50 * std::fmax(std::fabs(c_low), std::fabs(c_high));
  const double ne = 1.01 * forms.n.error.x[l] + 0x1p-50 * n_high;
  if (level.neutral()) {
    if (c_low > ce) return Finding::positive;
    if (c_high < -ce) return Finding::negative;
    return std::nullopt;
  }
  constexpr double slack = 1 + 0x1p-40;  // for the roundings below
  const double q = 3.0 * static_cast<double>(level.q) * static_cast<double>(level.q),
               p = 2.0 * static_cast<double>(level.p) * static_cast<double>(level.p);
  const auto cube = [](double x) { return x * x * x; };
  const double most = std::fmax(std::fabs(c_low), std::fabs(c_high)) + ce;
  const double least = std::fmax(c_low, -c_high) - ce;
  if (n_low > ne && q * most * most * slack < p * cube(n_low - ne)) return Finding::negative;
  if (least > 0 && n_low > ne && q * least * least > p * cube(n_high + ne) * slack)
    return Finding::positive;
  return std::nullopt;
}

/// Findings by bounds, which `known` names, and by the signs of f.
CREST_WIDE_CLONES void scan(const EightTensors<3>& cells, const Level& level,
                            std::array<std::optional<Finding>, kTogether>& findings,
                            unsigned& known) {
  const auto forms = bounded_forms<Lanes, 3, false>(cells.t, cells.largest, cells.error);
  Ranges ranges;
  range(forms.c, ranges.c_low, ranges.c_high);
  range(forms.n, ranges.n_low, ranges.n_high);
  known = 0;
  for (std::size_t l = 0; l < kTogether; ++l) {
    findings[l] = by_bound(forms, ranges, level, l);
    known |= findings[l] ? 1U << l : 0;
  }
  if (known == (1U << kTogether) - 1) return;
  const HullMasks signs =
      level.neutral() ? HullMasks(forms.c) : HullMasks(level_form(forms, level));
  for (std::size_t l = 0; l < kTogether; ++l)
    if ((known >> l & 1U) == 0) findings[l] = signs.finding(l);
}

}  // namespace

template <int D>
void test_cells(std::span<const Corners<D>> cells, const ExactCorners<D>& exact, const Level& level,
                std::span<CellResult<D>> results) {
  if (level.neutral())
    Test<D, Neutral>(cells, exact, level, results).run();
  else
    Test<D, General>(cells, exact, level, results).run();
}

template void test_cells<2>(std::span<const Corners<2>>, const ExactCorners<2>&, const Level&,
                            std::span<CellResult<2>>);
template void test_cells<3>(std::span<const Corners<3>>, const ExactCorners<3>&, const Level&,
                            std::span<CellResult<3>>);

void cell_signs(std::span<const Corners<3>> cells, const ExactCorners<3>& exact, const Level& level,
                std::span<CellSign> results) {
  std::array<std::optional<Finding>, kTogether> findings;
  unsigned bounds = 0;
  scan(EightTensors<3>(cells), level, findings, bounds);
  for (std::size_t l = 0; l < cells.size(); ++l) {
    if (!findings[l]) {
      const auto forms = integer_forms<3>(exact(l));
      findings[l] =
          level.neutral() ? exact_finding(forms.c) : exact_finding(level_form(forms, level));
    }
    results[l] = {*findings[l], (bounds >> l & 1U) != 0};
  }
}

}  // namespace crest::modes
