// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Taylor coefficients by D variables of a function at all points of a set: jets over models of a
// piece or over intervals of a box.
#include <algorithm>
#include <array>
#include <vector>

#include "certify/second/series.hpp"

namespace crest::recheck {

/// The monomials of degree <= 5 in D variables by degrees, and their products.
template <int D>
struct Monomials {
  static constexpr int kDegree = 5;
  std::vector<std::array<int, D>> exponents;
  std::vector<int> degree;
  std::array<std::size_t, kDegree + 2> count{};  ///< of those of lower degree
  std::vector<std::vector<std::size_t>> product;
  static const Monomials& get() {
    static const Monomials all;
    return all;
  }
  std::size_t find(const std::array<int, D>& e) const {
    return static_cast<std::size_t>(std::find(exponents.begin(), exponents.end(), e) -
                                    exponents.begin());
  }
  /// That of x_a, and of x_a x_b.
  static std::size_t unit(std::size_t a) { return a + 1; }

 private:
  Monomials() {
    for (int d = 0; d <= kDegree; ++d) {
      count[static_cast<std::size_t>(d)] = exponents.size();
      std::array<int, D> e{};
      add(e, 0, d);
    }
    count[kDegree + 1] = exponents.size();
    product.resize(exponents.size());
    for (std::size_t a = 0; a < exponents.size(); ++a)
      for (std::size_t b = 0; b < exponents.size() && degree[a] + degree[b] <= kDegree; ++b) {
        std::array<int, D> e = exponents[a];
        for (std::size_t i = 0; i < D; ++i) e[i] += exponents[b][i];
        product[a].push_back(find(e));
      }
  }
  void add(std::array<int, D>& e, std::size_t i, int left) {
    if (i + 1 == D) {
      e[i] = left;
      exponents.push_back(e);
      degree.push_back(0);
      for (const int k : e) degree.back() += k;
      return;
    }
    for (e[i] = left; e[i] >= 0; --e[i]) add(e, i + 1, left - e[i]);
    e[i] = 0;
  }
};

/// Operations keep degree context.jet_order.
template <class T, int D>
class Jet {
 public:
  using Table = Monomials<D>;
  Jet() : c_(1) {}
  Jet(double x) : c_{T(x)} {}
  template <class Value>
  explicit Jet(Value x) : c_{T(std::move(x))} {}
  /// x plus a multiple of each variable.
  Jet(T x, const std::array<T, D>& slopes) : c_{std::move(x)} {
    if (context.jet_order == 0) return;
    degree_ = 1;
    for (const T& s : slopes) c_.push_back(s);
  }

  int degree() const { return degree_; }
  std::size_t size() const { return c_.size(); }
  const T& operator[](std::size_t k) const {
    static const T zero;
    return k < c_.size() ? c_[k] : zero;
  }
  /// For writing.
  T& at(std::size_t k) {
    grow(Table::get().degree[k]);
    return c_[k];
  }
  /// The coefficients of degree up to context.jet_order.
  Jet cut() const {
    Jet r = *this;
    if (degree_ > context.jet_order) {
      r.degree_ = context.jet_order;
      r.c_.resize(Table::get().count[static_cast<std::size_t>(r.degree_) + 1]);
    }
    return r;
  }
  /// By variable i, of degree up to context.jet_order.
  Jet derivative(std::size_t i) const {
    const Table& table = Table::get();
    Jet r;
    for (std::size_t k = 0; k < c_.size(); ++k) {
      std::array<int, D> e = table.exponents[k];
      if (e[i] == 0 || table.degree[k] > context.jet_order + 1) continue;
      const int factor = e[i]--;
      r.at(table.find(e)) = scaled(c_[k], factor);
    }
    return r;
  }

  Jet& operator+=(const Jet& b) {
    grow(b.degree_);
    for (std::size_t k = 0; k < b.c_.size(); ++k) c_[k] = c_[k] + b.c_[k];
    return *this;
  }
  friend Jet operator+(Jet a, const Jet& b) { return a += b; }
  friend Jet operator-(const Jet& a, const Jet& b) { return a + -b; }
  Jet operator-() const {
    Jet r = *this;
    for (T& x : r.c_) x = -x;
    return r;
  }
  friend Jet operator*(const Jet& a, const Jet& b) {
    const Table& table = Table::get();
    Jet r;
    r.grow(std::min(context.jet_order, a.degree_ + b.degree_));
    for (std::size_t k = 0; k < a.c_.size(); ++k) {
      if (a.c_[k].is_zero()) continue;
      const std::size_t end = std::min(b.c_.size(), r.beyond(table.degree[k]));
      for (std::size_t l = 0; l < end; ++l)
        if (!b.c_[l].is_zero()) r.c_[table.product[k][l]].add_product(a.c_[k], b.c_[l]);
    }
    return r;
  }
  friend Jet scaled(const Jet& x, slong n, slong d) {
    Jet r = x;
    for (T& c : r.c_) c = scaled(c, n, d);
    return r;
  }
  /// f of it: from f(g) g = 1 or f(g)^2 = g degree by degree, else by f's Taylor series at the
  /// value.
  friend Jet applied(const Function& f, const Jet& g) {
    if (g.degree_ == 0 || context.jet_order == 0) return Jet(value_of(f, g.c_[0]));
    if (f.kind == Function::Kind::inverse || f.kind == Function::Kind::sqrt) return solved(f, g);
    const std::vector<T> t = series(f, g.c_[0], context.jet_order);
    Jet delta = g;
    delta.c_[0] = T();
    Jet r(t.back());
    for (std::size_t k = t.size() - 1; k-- > 0;) {  // delta begins with degree 1
      const Scope scope(context.jet_order - static_cast<int>(k));
      r = r * delta + Jet(t[k]);
    }
    return r;
  }

 private:
  static Jet solved(const Function& f, const Jet& g) {
    const bool root = f.kind == Function::Kind::sqrt;
    const Table& table = Table::get();
    const auto begin = [&](int d) { return table.count[static_cast<std::size_t>(d)]; };
    Jet r(value_of(f, g.c_[0])), rest;
    r.grow(context.jet_order);
    rest.grow(context.jet_order);
    const T step = root ? inverse(scaled(r.c_[0], 2, 1)) : -r.c_[0];
    for (int d = 1; d <= context.jet_order; ++d) {
      for (std::size_t a = 1; a < begin(root ? d : d + 1); ++a) {
        const int left = d - table.degree[a];
        for (std::size_t b = begin(left); b < begin(left + 1); ++b)
          rest.c_[table.product[a][b]].add_product(root ? r.c_[a] : g[a], r.c_[b]);
      }
      for (std::size_t k = begin(d); k < begin(d + 1); ++k)
        r.c_[k] = step * (root ? g[k] - rest.c_[k] : rest.c_[k]);
    }
    return r;
  }
  void grow(int degree) {
    if (degree <= degree_) return;
    degree_ = degree;
    c_.resize(Table::get().count[static_cast<std::size_t>(degree) + 1]);
  }
  /// How many monomials times one of degree d are kept.
  std::size_t beyond(int d) const {
    return d > degree_ ? 0 : Table::get().count[static_cast<std::size_t>(degree_ - d) + 1];
  }

  int degree_ = 0;
  std::vector<T> c_;
};

template <class T, int D>
Jet<T, D> sqrt(const Jet<T, D>& x) {
  return applied({Function::Kind::sqrt}, x);
}
template <class T, int D>
Jet<T, D> inverse(const Jet<T, D>& x) {
  return applied({Function::Kind::inverse}, x);
}

}  // namespace crest::recheck
