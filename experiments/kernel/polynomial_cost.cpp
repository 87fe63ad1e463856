// SPDX-License-Identifier: GPL-3.0-or-later
// What exact work on polynomials costs: hull rejection on tetrahedra, root isolation, algebraic
// numbers. Microseconds an operation, one thread.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <random>
#include <vector>

#include "kernel/polynomial/descartes.hpp"
#include "kernel/polynomial/hull_sign.hpp"
#include "kernel/polynomial/real_roots.hpp"
#include "kernel/polynomial/simplex_net.hpp"
#include "kernel/predicates/quadratic_root_order.hpp"

namespace crest {
namespace {

using namespace kernel;

std::mt19937_64 engine(1);
double uniform() {
  return static_cast<double>(engine() >> 11) * 0x1p-52 - 1;
}
volatile double keep;

/// Microseconds of operation(i), i < count: the median of five passes.
template <class Operation>
double microseconds(std::size_t count, Operation&& operation) {
  std::vector<double> passes;
  for (int pass = 0; pass < 5; ++pass) {
    const auto start = std::chrono::steady_clock::now();
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += operation(i);
    const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - start;
    keep = sum;
    passes.push_back(time.count() / static_cast<double>(count));
  }
  std::sort(passes.begin(), passes.end());
  return passes[2];
}

/// Nets of one sign (1 plus noise): what a rejection must read to the end.
template <int Degree>
std::vector<SimplexNet<double, 3, Degree>> one_sign(std::size_t count) {
  std::vector<SimplexNet<double, 3, Degree>> r(count);
  for (auto& net : r)
    for (double& x : net.c) x = 1 + 0.5 * uniform();
  return r;
}
template <int Degree>
std::vector<SimplexNet<Lanes, 3, Degree>> in_lanes(
    const std::vector<SimplexNet<double, 3, Degree>>& nets) {
  std::vector<SimplexNet<Lanes, 3, Degree>> r(nets.size() / Lanes::count);
  for (std::size_t i = 0; i < r.size(); ++i)
    for (std::size_t k = 0; k < r[i].c.size(); ++k)
      for (std::size_t lane = 0; lane < Lanes::count; ++lane)
        r[i].c[k].x[lane] = nets[i * Lanes::count + lane].c[k];
  return r;
}

template <int Degree>
void print_hull() {
  const auto nets = one_sign<Degree>(4096);
  const auto lanes = in_lanes(nets);
  const double one = microseconds(nets.size(), [&](std::size_t i) {
    return *certain_hull(SimplexForm<Bounded<double>, 3, Degree>(nets[i])) == Hull::positive;
  });
  const double eight = microseconds(lanes.size(), [&](std::size_t i) {
    return certain_signs(SimplexForm<Bounded<Lanes>, 3, Degree>(lanes[i])).positive;
  });
  fmt::print("| hull sign from given coefficients, tetrahedron, degree {} | {:.3f} | {:.3f} |\n",
             Degree, one, eight / Lanes::count);
}

/// 54 d^2 - m q^3 with its error bound, and its hull sign: degree 6.
void print_sextic() {
  const auto d = one_sign<3>(2048);
  const auto q = one_sign<2>(2048);
  const auto dl = in_lanes(d);
  const auto ql = in_lanes(q);
  const auto sextic = []<class T>(const auto& a, const auto& b, T) {
    return T(54.0) * (a * a) - T(0.25) * (b * b * b);
  };
  using One = Bounded<double>;
  using Eight = Bounded<Lanes>;
  const double one = microseconds(d.size(), [&](std::size_t i) {
    return certain_hull(sextic(lifted<One>(d[i]), lifted<One>(q[i]), One(0.0))) == Hull::positive;
  });
  const double eight = microseconds(dl.size(), [&](std::size_t i) {
    return certain_signs(sextic(lifted<Eight>(dl[i]), lifted<Eight>(ql[i]), Eight(0.0))).positive;
  });
  fmt::print(
      "| 54 d^2 - m q^3 of a cubic d, a quadratic q: products, bound, hull sign | {:.3f} | {:.3f} "
      "|\n",
      one, eight / Lanes::count);
}

void print_roots(std::size_t degree) {
  std::vector<std::vector<double>> b(400);
  std::vector<std::vector<Integer>> exact;
  std::vector<IntegerPolynomial> p;
  for (auto& c : b) {
    for (std::size_t k = 0; k <= degree; ++k) c.push_back(uniform());
    exact.push_back(*integers(c));
    p.push_back(IntegerPolynomial::from_bernstein(exact.back()));
  }
  const double triage = microseconds(b.size(), [&](std::size_t i) {
    const auto places = triage_unit_places(b[i], 0);
    return places ? static_cast<double>(places->size()) : 0.0;
  });
  const double unit = microseconds(
      b.size(), [&](std::size_t i) { return static_cast<double>(unit_roots(b[i])->roots.size()); });
  const double integers_only = microseconds(b.size(), [&](std::size_t i) {
    return static_cast<double>(exact_unit_places(exact[i]).size());
  });
  const double line = microseconds(
      b.size(), [&](std::size_t i) { return static_cast<double>(real_roots(p[i]).roots.size()); });
  fmt::print("| {} | {:.2f} | {:.2f} | {:.1f} | {:.1f} |\n", degree, triage, unit, integers_only,
             line);
}

void print_numbers() {
  std::vector<AlgebraicNumber> numbers;
  std::vector<IntegerPolynomial> q;
  while (numbers.size() < 400) {
    std::vector<double> b, c;
    for (int k = 0; k <= 6; ++k) b.push_back(uniform());
    for (int k = 0; k <= 6; ++k) c.push_back(uniform());
    const auto found = unit_roots(b);
    for (const RealRoot& r : found->roots) {
      numbers.push_back(r.value);
      q.push_back(*IntegerPolynomial::from(c));
    }
  }
  const std::size_t count = numbers.size() - 1;
  const auto row = [&](const char* name, auto&& operation) {
    fmt::print("| {} | {:.2f} |\n", name, microseconds(count, operation));
  };
  row("sign of a sextic at a root of another",
      [&](std::size_t i) { return static_cast<double>(sign_at(q[i], numbers[i]).sign); });
  row("the same where it is zero (a common factor)", [&](std::size_t i) {
    return static_cast<double>(sign_at(numbers[i].polynomial() * q[i], numbers[i]).sign);
  });
  row("order of two roots of two sextics",
      [&](std::size_t i) { return static_cast<double>(compare(numbers[i], numbers[i + 1])); });
  row("a root of a sextic between neighbouring doubles",
      [&](std::size_t i) { return numbers[i].bracket().low; });
  std::vector<Quadratic> p;
  while (p.size() <= count) p.push_back({uniform(), uniform(), uniform()});
  row("sign of a quadratic at a root of another, no square root", [&](std::size_t i) {
    const auto s = sign_at_root(p[i], QuadraticRoot::larger, p[i + 1]);
    return s ? static_cast<double>(s->sign) : 0.0;
  });
}

}  // namespace
}  // namespace crest

int main() {
  fmt::print(
      "| rejection, triage | one at a time, us | eight at a time, us each |\n|---|---|---|\n");
  crest::print_hull<3>();
  crest::print_hull<4>();
  crest::print_hull<5>();
  crest::print_hull<6>();
  crest::print_sextic();
  fmt::print(
      "\n| degree | unit interval, triage alone, us | to algebraic numbers, us | integers alone, "
      "us | "
      "the line, us |\n|---|---|---|---|---|\n");
  for (const std::size_t degree : {3, 4, 5, 6, 8, 10, 12}) crest::print_roots(degree);
  fmt::print("\n| operation | us |\n|---|---|\n");
  crest::print_numbers();
  return 0;
}
