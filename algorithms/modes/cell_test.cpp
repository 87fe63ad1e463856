// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/cell_test.hpp"

#include <algorithm>
#include <optional>

#include "algorithms/modes/forms.hpp"
#include "algorithms/modes/half_space.hpp"
#include "kernel/polynomial/hull_sign.hpp"

namespace crest::modes {
namespace {

using kernel::Hull;
using kernel::Sign;

/// H4: the form is positive on the closed simplex because no coefficient is negative and every
/// face of it carries a positive one.
template <class B>
bool strictly_positive(const kernel::Form<Integer, B>& f) {
  std::array<bool, 1U << B::corners> carries{};
  for (std::size_t i = 0; i < B::count; ++i) {
    if (f.s[i] < 0) return false;
    if (f.s[i].is_zero()) continue;
    unsigned mask = 0;
    for (std::size_t k = 0; k < B::corners; ++k) mask |= (B::indices[i][k] > 0 ? 1U : 0U) << k;
    carries[mask] = true;
  }
  for (unsigned face = 1; face < carries.size(); ++face) {
    bool found = false;
    for (unsigned part = face; part != 0 && !found; part = (part - 1) & face) found = carries[part];
    if (!found) return false;
  }
  return true;
}

/// The forms of one simplex, the exact ones when they are needed.
template <int D>
class Forms {
 public:
  Forms(const std::array<Tensor, D + 1>& corners, const ExactCorners<D>& exact, const Level& level)
      : level_(level), supply_(exact), real_(real_forms<D>(corners)) {}

  template <class N>
  auto f() {
    return level_form(get<N>(), level_);
  }
  template <class N>
  auto growth(std::size_t k) {
    return growth_form(get<N>(), level_, k);
  }
  template <class N>
  auto neutral_growth(std::size_t k) {
    return neutral_growth_form(get<N>(), k);
  }
  template <class N>
  TensorForms<N, D>& get() {
    if constexpr (std::is_same_v<N, Real>) {
      return real_;
    } else {
      if (!exact_) exact_ = integer_forms<D>(supply_());
      return *exact_;
    }
  }
  bool used_integers() const { return exact_.has_value(); }

 private:
  const Level& level_;
  const ExactCorners<D>& supply_;
  TensorForms<Real, D> real_;
  std::optional<TensorForms<Integer, D>> exact_;
};

struct General {
  static constexpr int degree = 6;
  template <class N, int D>
  static auto f(Forms<D>& forms) {
    return forms.template f<N>();
  }
  template <class N, int D>
  static auto growth(Forms<D>& forms, std::size_t k) {
    return forms.template growth<N>(k);
  }
};
struct Neutral {
  static constexpr int degree = 3;
  template <class N, int D>
  static auto f(Forms<D>& forms) {
    return forms.template get<N>().c;
  }
  template <class N, int D>
  static auto growth(Forms<D>& forms, std::size_t k) {
    return forms.template neutral_growth<N>(k);
  }
};

template <int D, class Kind>
class Test {
  using Basis = kernel::SimplexBasis<D, Kind::degree>;
  using RealForm = kernel::Form<Real, Basis>;

 public:
  explicit Test(Forms<D>& forms) : forms_(forms), f_(Kind::template f<Real>(forms)) {}

  Finding sign() {
    const auto certain = kernel::certain_hull(f_);
    if (certain == Hull::positive) return Finding::positive;
    if (certain == Hull::negative) return Finding::negative;
    if (certain == Hull::mixed) return Finding::none;
    auto exact = Kind::template f<Integer>(forms_);
    bool negative = false, positive = false;
    for (const Integer& x : exact.s) {
      negative = negative || x < 0;
      positive = positive || x > 0;
    }
    if (negative && positive) return Finding::none;
    if (!negative) return positive ? Finding::positive : Finding::uniform;
    for (Integer& x : exact.s) x = -x;
    return strictly_positive(exact) ? Finding::negative : Finding::none;
  }

  std::optional<Witness<D>> witness() {
    for (std::size_t k = 0; k < D; ++k) growth_[k] = Kind::template growth<Real>(forms_, k);
    const auto direction = search();
    if (!direction) return std::nullopt;
    auto w = rounded(*direction);
    if (!w) return std::nullopt;
    if (holds(*w)) return w;
    w->lambda = 0;
    if (holds(*w)) return w;
    return std::nullopt;
  }

 private:
  using Vector = std::array<double, D + 1>;

  std::optional<Vector> search() {
    Vector scale;
    for (std::size_t k = 0; k <= D; ++k) {
      const RealForm& form = k < D ? growth_[k] : f_;
      double largest = 0;
      for (std::size_t i = 0; i < Basis::count; ++i)
        largest = std::max(largest, std::fabs(form.s[i] / Basis::weights[i]));
      scale[k] = largest > 0 ? 1 / largest : 0;
    }
    std::array<Vector, Basis::count> vectors;
    std::size_t count = 0;
    for (std::size_t i = 0; i < Basis::count; ++i) {
      Vector& v = vectors[count];
      double norm = 0;
      for (std::size_t k = 0; k <= D; ++k) {
        const RealForm& form = k < D ? growth_[k] : f_;
        v[k] = form.s[i] / Basis::weights[i] * scale[k];
        norm += v[k] * v[k];
      }
      if (norm < 1e-24) continue;  // a zero of integers, which strictly_positive judges
      norm = 1 / std::sqrt(norm);
      for (double& x : v) x *= norm;
      ++count;
    }
    auto y = HalfSpace<D + 1>::search({vectors.data(), count});
    if (y)
      for (std::size_t k = 0; k <= D; ++k) (*y)[k] *= scale[k];
    return y;
  }

  static std::optional<Witness<D>> rounded(const Vector& y) {
    double sum = 0, largest = 0;
    for (std::size_t k = 0; k <= D; ++k) largest = std::fmax(largest, std::fabs(y[k]));
    for (std::size_t k = 0; k < D; ++k) sum += y[k];
    largest = std::fmax(largest, std::fabs(sum));
    if (!(largest > 0)) return std::nullopt;
    const double unit = 32000 / largest;
    Witness<D> r;
    int rest = 0;
    for (std::size_t k = 0; k < D; ++k) {
      r.w[k + 1] = static_cast<std::int16_t>(std::lround(unit * y[k]));
      rest -= r.w[k + 1];
    }
    r.w[0] = static_cast<std::int16_t>(rest);
    // A multiple of 3: the certificate's lambda is a third of it (certificate.cpp).
    r.lambda = static_cast<std::int16_t>(3 * std::lround(unit / 3 * y[D]));
    return r;
  }

  bool holds(const Witness<D>& y) {
    RealForm p = Real(static_cast<double>(y.lambda)) * f_;
    for (std::size_t k = 0; k < D; ++k)
      if (y.w[k + 1] != 0) p = p + Real(static_cast<double>(y.w[k + 1])) * growth_[k];
    const auto certain = kernel::certain_hull(p);
    if (certain) return certain == Hull::positive;
    for (std::size_t i = 0; i < Basis::count; ++i)
      if (p.s[i] < -Basis::weights[i] * p.error) return false;
    // The integers are the tensors times a power of two that is not known here, and the two terms
    // have different degrees.
    if (y.lambda != 0 && Kind::degree == 6) return false;
    auto exact = Integer(y.lambda) * Kind::template f<Integer>(forms_);
    for (std::size_t k = 0; k < D; ++k)
      if (y.w[k + 1] != 0)
        exact = exact + Integer(y.w[k + 1]) * Kind::template growth<Integer>(forms_, k);
    return strictly_positive(exact);
  }

  Forms<D>& forms_;
  RealForm f_;
  std::array<RealForm, D> growth_;
};

template <int D, class Kind>
CellResult<D> run(Forms<D>& forms) {
  CellResult<D> r;
  Test<D, Kind> test(forms);
  r.finding = test.sign();
  if (r.finding == Finding::none) {
    if (const auto w = test.witness()) {
      r.finding = Finding::graph;
      r.witness = *w;
    }
  }
  r.exact = forms.used_integers();
  return r;
}

}  // namespace

template <int D>
CellResult<D> test_cell(const std::array<Tensor, D + 1>& corners, const ExactCorners<D>& exact,
                        const Level& level) {
  Forms<D> forms(corners, exact, level);
  return level.neutral() ? run<D, Neutral>(forms) : run<D, General>(forms);
}

std::optional<Finding> certain_cell_sign(const std::array<Tensor, 4>& corners, const Level& level,
                                         bool& bound) {
  const auto forms = real_forms<3>(corners);
  using C = kernel::SimplexBasis<3, 3>;
  using N = kernel::SimplexBasis<3, 2>;
  // Ranges of the nets of c and n; the factor covers the divisions' roundings.
  double c_low = HUGE_VAL, c_high = -HUGE_VAL, n_low = HUGE_VAL, n_high = 0;
  for (std::size_t i = 0; i < C::count; ++i) {
    const double c = forms.c.s[i] / C::weights[i];
    c_low = std::min(c_low, c);
    c_high = std::max(c_high, c);
  }
  for (std::size_t i = 0; i < N::count; ++i) {
    const double n = forms.n.s[i] / N::weights[i];
    n_low = std::min(n_low, n);
    n_high = std::max(n_high, n);
  }
  const double ce = 1.01 * forms.c.error + 0x1p-50 * std::fmax(std::fabs(c_low), std::fabs(c_high)),
               ne = 1.01 * forms.n.error + 0x1p-50 * n_high;
  bound = true;
  if (level.neutral()) {
    if (c_low > ce) return Finding::positive;
    if (c_high < -ce) return Finding::negative;
  } else {
    constexpr double slack = 1 + 0x1p-40;  // for the roundings below
    const double q = 3.0 * static_cast<double>(level.q) * static_cast<double>(level.q),
                 p = 2.0 * static_cast<double>(level.p) * static_cast<double>(level.p);
    const auto cube = [](double x) { return x * x * x; };
    const double most = std::fmax(std::fabs(c_low), std::fabs(c_high)) + ce;
    const double least = std::fmax(c_low, -c_high) - ce;
    if (n_low > ne && q * most * most * slack < p * cube(n_low - ne)) return Finding::negative;
    if (least > 0 && n_low > ne && q * least * least > p * cube(n_high + ne) * slack)
      return Finding::positive;
  }
  bound = false;
  const auto hull = level.neutral() ? kernel::certain_hull(forms.c)
                                    : kernel::certain_hull(level_form(forms, level));
  if (!hull) return std::nullopt;
  return *hull == Hull::positive   ? Finding::positive
         : *hull == Hull::negative ? Finding::negative
                                   : Finding::none;
}

Finding cell_sign(const std::array<Tensor, 4>& corners, const ExactCorners<3>& exact,
                  const Level& level) {
  Forms<3> forms(corners, exact, level);
  return level.neutral() ? Test<3, Neutral>(forms).sign() : Test<3, General>(forms).sign();
}

template CellResult<2> test_cell<2>(const std::array<Tensor, 3>&, const ExactCorners<2>&,
                                    const Level&);
template CellResult<3> test_cell<3>(const std::array<Tensor, 4>&, const ExactCorners<3>&,
                                    const Level&);

}  // namespace crest::modes
