// SPDX-License-Identifier: GPL-3.0-or-later
// What the remainder of a Taylor model costs: the same polynomial arithmetic with and without.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <random>
#include <vector>

#include "kernel/arithmetic/taylor_model.hpp"

namespace crest {
namespace {

/// The polynomial part alone.
template <int Order>
struct Plain {
  using Model = kernel::TaylorModel<Order>;
  std::array<double, Model::kCount> c{};
  friend Plain operator+(const Plain& a, const Plain& b) {
    Plain r;
    for (std::size_t i = 0; i < r.c.size(); ++i) r.c[i] = a.c[i] + b.c[i];
    return r;
  }
  friend Plain operator*(const Plain& a, const Plain& b) {
    return {Model::Kernels::product(a.c, b.c)};
  }
};

/// Nanoseconds of an operation: the median of 21 passes over 1000 pairs.
template <class T, class Operation>
double nanoseconds(const std::vector<T>& a, const std::vector<T>& b, Operation&& operation) {
  std::vector<double> passes;
  std::vector<T> r(a.size());
  for (int pass = 0; pass < 21; ++pass) {
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < a.size(); ++i) r[i] = operation(a[i], b[i]);
    const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
    volatile double keep = r[a.size() / 2].c[0];
    static_cast<void>(keep);
    passes.push_back(time.count() / static_cast<double>(a.size()));
  }
  std::sort(passes.begin(), passes.end());
  return passes[passes.size() / 2];
}

template <int Order>
void print_rows() {
  using Model = kernel::TaylorModel<Order>;
  std::mt19937_64 draw(1);
  std::vector<Model> a(1000), b(1000);
  std::vector<Plain<Order>> pa(1000), pb(1000);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < Model::kCount; ++k) {
      pa[i].c[k] = a[i].c[k] = static_cast<double>(draw() >> 11) * 0x1p-53;
      pb[i].c[k] = b[i].c[k] = static_cast<double>(draw() >> 11) * 0x1p-53;
    }
  const auto row = [](const char* name, double plain, double model) {
    fmt::print("| {} | {} | {:.1f} | {:.1f} | {:.2f} |\n", Order, name, plain, model,
               model / plain);
  };
  row("sum", nanoseconds(pa, pb, [](const auto& x, const auto& y) { return x + y; }),
      nanoseconds(a, b, [](const auto& x, const auto& y) { return x + y; }));
  row("product", nanoseconds(pa, pb, [](const auto& x, const auto& y) { return x * y; }),
      nanoseconds(a, b, [](const auto& x, const auto& y) { return x * y; }));
  row("x y + x", nanoseconds(pa, pb, [](const auto& x, const auto& y) { return x * y + x; }),
      nanoseconds(a, b, [](const auto& x, const auto& y) { return x * y + x; }));
}

}  // namespace
}  // namespace crest

int main() {
  fmt::print(
      "| order | operation | polynomial, ns | Taylor model, ns | times |\n|---|---|---|---|---|\n");
  crest::print_rows<3>();
  crest::print_rows<4>();
  crest::print_rows<5>();
  return 0;
}
