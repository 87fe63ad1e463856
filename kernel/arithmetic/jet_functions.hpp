// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The recurrences of jet.hpp. A coefficient is final when the loop reaches it (monomials ascend by
// degree); it is then spread to the sums of higher degree.
#include "kernel/arithmetic/jet.hpp"

namespace crest::kernel {

template <class T, int Variables, int Order>
void Jet<T, Variables, Order>::undefine(T value) {
  value = undefined_of(std::move(value));
  for (std::size_t i = 0; i < kCount; ++i) c_.put(i, value);
}

template <class T, int Variables, int Order>
Jet<T, Variables, Order> Jet<T, Variables, Order>::plus(const Jet& b, bool negative) const {
  Jet r;
  for_each_bit(mask() | b.mask(), [&](std::size_t i) {
    if (!b.c_.has(i))
      r.c_.put(i, c_[i]);
    else if (!c_.has(i))
      r.c_.make(i, [&] { return negative ? T(-b.c_[i]) : b.c_[i]; });
    else
      r.c_.make(i, [&] { return negative ? T(c_[i] - b.c_[i]) : T(c_[i] + b.c_[i]); });
  });
  r.settle();
  return r;
}

template <class T, int Variables, int Order>
void Jet<T, Variables, Order>::spread(Coefficients& sums, std::size_t i, const T& x,
                                      const Coefficients& f, std::uint64_t which) {
  const std::size_t left = Order - std::size_t{kTables.degree[i]};
  for_each_bit(which & kTables.up_to[left], [&](std::size_t j) {
    const std::size_t k = kTables.product[i][j];
    if (sums.has(k))
      add_product(sums.place(k), x, f[j]);
    else
      sums.make(k, [&] { return T(x * f[j]); });
  });
}

template <class T, int Variables, int Order>
void Jet<T, Variables, Order>::spread_square(Coefficients& sums, std::size_t i,
                                             const Coefficients& f) {
  const std::uint64_t self = std::uint64_t{1} << i, before = f.mask() & (self - 1);
  if (before != 0) spread(sums, i, T(f[i] * 2.0), f, before);
  if (2 * kTables.degree[i] <= Order) spread(sums, i, f[i], f, self);
}

template <class T, int Variables, int Order>
auto Jet<T, Variables, Order>::euler() const -> Coefficients {
  Coefficients r;
  for_each_bit(mask() & ~std::uint64_t{1}, [&](std::size_t i) {
    if (kTables.degree[i] == 1)
      r.put(i, c_[i]);
    else
      r.put(i, T(c_[i] * static_cast<double>(kTables.degree[i])));
  });
  return r;
}

template <class T, int Variables, int Order>
Jet<T, Variables, Order> Jet<T, Variables, Order>::over(const Jet& f) const {
  const T factor = number_like(1, &f[0]) / f[0];
  const std::uint64_t rest = f.mask() & ~std::uint64_t{1};
  Jet q;
  if (!is_defined(factor)) {
    q.undefine(factor);
    return q;
  }
  Coefficients sums;
  for (std::size_t i = 0; i < kCount; ++i) {
    if (!c_.has(i) && !sums.has(i)) continue;
    if (!sums.has(i))
      q.c_.put(i, T(c_[i] * factor));
    else
      q.c_.put(i, T((c_.has(i) ? T(c_[i] - sums[i]) : T(-sums[i])) * factor));
    spread(sums, i, q.c_[i], f.c_, rest);
  }
  q.settle();
  return q;
}

template <class T, int Variables, int Order>
Jet<T, Variables, Order> Jet<T, Variables, Order>::square_root() const {
  // The constant is set last: its products with the others are the left side.
  using std::sqrt;
  const T root = sqrt((*this)[0]), factor = number_like(1, &root) / (root * 2.0);
  Jet s;
  Coefficients sums;
  for (std::size_t i = 1; i < kCount; ++i) {
    if (!c_.has(i) && !sums.has(i)) continue;
    if (!sums.has(i))
      s.c_.put(i, T(c_[i] * factor));
    else
      s.c_.put(i, T((c_.has(i) ? T(c_[i] - sums[i]) : T(-sums[i])) * factor));
    spread_square(sums, i, s.c_);
  }
  s.c_.put(0, root);
  s.settle();
  return s;
}

template <class T, int Variables, int Order>
Jet<T, Variables, Order> Jet<T, Variables, Order>::exponential() const {
  using std::exp;
  const Coefficients h = euler();
  Jet e = constant(exp((*this)[0]));
  Coefficients sums;
  spread(sums, 0, e.c_[0], h, h.mask());
  for (std::size_t i = 1; i < kCount; ++i) {
    if (!sums.has(i)) continue;
    e.c_.put(i, T(sums[i] / static_cast<double>(kTables.degree[i])));
    spread(sums, i, e.c_[i], h, h.mask());
  }
  e.settle();
  return e;
}

template <class T, int Variables, int Order>
Jet<T, Variables, Order> Jet<T, Variables, Order>::logarithm() const {
  using std::log;
  Jet slope;
  slope.c_ = euler();
  const Jet l = slope.over(*this);
  Jet r = constant(log((*this)[0]));
  for_each_bit(l.mask(), [&](std::size_t i) {
    r.c_.put(i, T(l.c_[i] / static_cast<double>(kTables.degree[i])));
  });
  r.settle();
  return r;
}

template <class T, int Variables, int Order>
auto Jet<T, Variables, Order>::circular() const -> std::pair<Jet, Jet> {
  using std::cos, std::sin;
  const Coefficients h = euler();
  Jet s = constant(sin((*this)[0])), c = constant(cos((*this)[0]));
  Coefficients s_sums, c_sums;  // of E sin and -E cos
  for (std::size_t i = 0; i < kCount; ++i) {
    // The two have the same places.
    if (i > 0 && !s_sums.has(i)) continue;
    if (i > 0) {
      const auto degree = static_cast<double>(kTables.degree[i]);
      s.c_.put(i, T(s_sums[i] / degree));
      c.c_.put(i, T(c_sums[i] / -degree));
    }
    spread(s_sums, i, c.c_[i], h, h.mask());
    spread(c_sums, i, s.c_[i], h, h.mask());
  }
  s.settle();
  c.settle();
  return {std::move(s), std::move(c)};
}

}  // namespace crest::kernel
