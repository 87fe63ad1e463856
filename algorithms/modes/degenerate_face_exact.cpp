// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "algorithms/modes/degenerate_exact.hpp"
#include "algorithms/modes/degenerate_face.hpp"
#include "kernel/polynomial/real_roots.hpp"

namespace crest::modes {

namespace {

using kernel::AlgebraicNumber;
using kernel::IntegerPolynomial;
using kernel::Rational;
using kernel::RealRoots;
using kernel::Sign;

/// A polynomial in t as the forms' number type.
struct Poly {
  std::vector<Integer> c;

  Poly(Integer x = 0) : c{std::move(x)} {}  // NOLINT: numbers convert
  Poly(int x) : c{Integer(x)} {}            // NOLINT
  static Poly of(std::vector<Integer> x) {
    Poly p;
    p.c = std::move(x);
    return p;
  }
  friend Poly operator+(const Poly& a, const Poly& b) {
    Poly s = a.c.size() < b.c.size() ? b : a;
    const Poly& less = a.c.size() < b.c.size() ? a : b;
    for (std::size_t k = 0; k < less.c.size(); ++k) s.c[k] += less.c[k];
    return s;
  }
  friend Poly operator-(const Poly& a, const Poly& b) { return a + Poly(-1) * b; }
  friend Poly operator*(const Poly& a, const Poly& b) {
    Poly p = of(std::vector<Integer>(a.c.size() + b.c.size() - 1));
    for (std::size_t i = 0; i < a.c.size(); ++i)
      for (std::size_t j = 0; j < b.c.size(); ++j) p.c[i + j] += a.c[i] * b.c[j];
    return p;
  }
  IntegerPolynomial integer() const { return IntegerPolynomial(c); }
  Rational at(const Rational& t) const {
    Rational sum = 0;
    for (std::size_t k = c.size(); k-- > 0;) sum = sum * t + Rational(c[k]);
    return sum;
  }
};
using Curve = kernel::Vector3<Poly>;

Conic<Poly> lifted(const Conic<Integer>& a) {
  Conic<Poly> p;
  for (std::size_t k = 0; k < 6; ++k) p.c[k] = a.c[k];
  return p;
}

/// The view point of a pencil and two directions across, as columns. The first three are the axes;
/// the others lie on a conic, no three on a line: of the lines that join two of four common points
/// there are six, each meets the conic in two points at most, so one of 13 is on none.
using View = std::array<std::array<int, 3>, 3>;
View view(int number) {
  if (number < 3) {
    View v{};
    for (std::size_t k = 0; k < 3; ++k) v[k][(static_cast<std::size_t>(number) + 1 + k) % 3] = 1;
    return v;
  }
  const int k = number - 2;
  return {{{0, 1, 0}, {0, 0, 1}, {1, k, k * k}}};
}
constexpr int kViews = 16;
/// How many are tried where some common point is multiple, which no view makes simple.
constexpr int kViewsOfMultiple = 7;

Conic<Integer> seen(const Conic<Integer>& p, const View& view) {
  std::array<kernel::Vector3<Integer>, 3> e, image;
  for (std::size_t k = 0; k < 3; ++k) {
    e[k] = {view[k][0], view[k][1], view[k][2]};
    image[k] = p.times(e[k]);
  }
  const auto at = [&](std::size_t i, std::size_t j) { return kernel::dot(e[i], image[j]); };
  return {{at(0, 0), at(1, 1), at(2, 2), at(0, 1), at(1, 2), at(0, 2)}};
}

/// Whether the pencil has four different common points, complex ones counted: the discriminant of
/// det(x P + Q) is not zero.
bool all_simple(const Conic<Integer>& p, const Conic<Integer>& q) {
  const auto at = [&](int x) {
    Conic<Integer> sum;
    for (std::size_t k = 0; k < 6; ++k) sum.c[k] = x * p.c[k] + q.c[k];
    return sum.det();
  };
  // d + c x + b x^2 + a x^3, twice.
  const Integer d = 2 * q.det(), a = 2 * p.det(), up = at(1), down = at(-1);
  const Integer b = up + down - d, c = up - down - a;
  return b * b * c * c - 4 * a * c * c * c - 4 * b * b * b * d - 27 * a * a * d * d +
             18 * a * b * c * d !=
         0;
}

/// The common points seen in one view.
struct SeenPoints {
  PencilQuartic<Integer> pencil;
  View view;

  Curve world(const Curve& w) const {
    Curve v;
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i) v[i] = v[i] + Poly(view[k][i]) * w[k];
    return v;
  }
  Poly line(const std::array<Integer, 2>& a) const { return Poly::of({a[0], a[1]}); }
  Poly conic(const std::array<Integer, 3>& a) const { return Poly::of({a[0], a[1], a[2]}); }
  /// v at t = x / y; zero where a line of the pencil passes the view point.
  Curve points() const {
    const Poly two = Poly(2) * line(pencil.l);
    return world({two * Poly::of({0, 1}), two, Poly(-1) * conic(pencil.q)});
  }
  /// Where it does and meets P in one point, that point.
  Curve touching() const {
    return world({Poly::of({0, pencil.p}), Poly(pencil.p), Poly(-1) * line(pencil.m)});
  }
  /// Its sign at t: how the ray from the view point meets P.
  Poly meeting() const {
    const Poly m = line(pencil.m);
    return m * m - Poly(pencil.p) * conic(pencil.n);
  }
};

std::optional<SeenPoints> see(const SimplexForms<Integer, 3>& forms, int number) {
  const View v = view(number);
  Conic<Integer> p = seen(forms.vanishing[0], v), q = seen(forms.vanishing[1], v);
  if (p.c[2].is_zero()) std::swap(p, q);
  if (p.c[2].is_zero()) return std::nullopt;  // the view point is common to both
  return SeenPoints{PencilQuartic<Integer>(p, q), v};
}

/// Three polynomials at the root, to about 60 digits, then doubles that hold them, times a positive
/// number.
kernel::Vector3<Ball> enclose(const Curve& curve, AlgebraicNumber t) {
  Rational low, high;
  if (!t.rational()) t.refine(240);
  if (t.rational()) {
    low = high = *t.rational();
  } else {
    low = t.low().value();
    high = t.high().value();
  }
  const Rational middle = (low + high) / 2, reach = (high - low) / 2,
                 size = abs(middle) + reach + 1;
  kernel::Vector3<Rational> v;
  Rational largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    v[i] = curve[i].at(middle);
    largest = std::max<Rational>(largest, abs(v[i]));
  }
  if (largest.is_zero()) largest = 1;
  kernel::Vector3<Ball> result;
  for (std::size_t i = 0; i < 3; ++i) {
    Rational slope = 0, power = 1;  // |v'| <= sum k |c_k| size^(k-1)
    for (std::size_t k = 1; k < curve[i].c.size(); ++k) {
      slope += abs(Rational(curve[i].c[k])) * static_cast<int>(k) * power;
      power *= size;
    }
    const double mid = static_cast<double>(Rational(v[i] / largest));
    const double error = static_cast<double>(Rational(slope * reach / largest));
    result[i] = {mid, (error + 0x1p-51 * std::fabs(mid)) * Ball::kSlack + Ball::kTiny};
  }
  return result;
}

/// Signs of the three coordinates at a root decide where it lies.
class RootPlace {
 public:
  RootPlace(const SeenPoints& seen, const SimplexForms<Integer, 3>& forms)
      : seen_(seen), forms_(forms), curve_(seen.points()), b_(along(curve_)) {}

  void add(const kernel::RealRoot& root, FaceRoots& result, std::vector<ExactPoint>& points) const {
    const auto [up, down] = signs(b_, root);
    if (up && down) return;  // outside
    if (root.multiplicity > 1) {
      if (up + down > 0 || touching_place(root)) result.special = SpecialReason::multiple_point;
      return;
    }
    if (up + down < 3) {
      if (!result.special) result.special = SpecialReason::on_rim;
      return;
    }
    FaceRoot r{
        up ? DegenerateType::linear : DegenerateType::planar, enclose(curve_, root.value), {}};
    points.push_back(
        {r.v, {curve_[0].integer(), curve_[1].integer(), curve_[2].integer()}, root.value});
    const kernel::Vector3<Ball> b = enclose(coordinates(curve_), root.value);
    const Ball sum = b[0] + b[1] + b[2];
    for (std::size_t k = 0; k < 3; ++k) r.weights[k] = b[k] / sum;
    result.root[result.count++] = r;
  }

 private:
  using Signs = std::array<IntegerPolynomial, 3>;
  Curve coordinates(const Curve& v) const {
    return {lifted(forms_.coordinates[0]).at(v), lifted(forms_.coordinates[1]).at(v),
            lifted(forms_.coordinates[2]).at(v)};
  }
  Signs along(const Curve& v) const {
    const Curve b = coordinates(v);
    return {b[0].integer(), b[1].integer(), b[2].integer()};
  }
  static std::pair<int, int> signs(const Signs& b, const kernel::RealRoot& root) {
    int up = 0, down = 0;
    for (const IntegerPolynomial& form : b) {
      const Sign s = kernel::sign_at(form, root.value).sign;
      up += s == Sign::positive;
      down += s == Sign::negative;
    }
    return {up, down};
  }
  /// Where v = 0: false proves that no common point on that ray is in the face.
  bool touching_place(const kernel::RealRoot& root) const {
    const Sign s = kernel::sign_at(seen_.meeting().integer(), root.value).sign;
    if (s != Sign::zero) return s == Sign::positive;
    const auto [up, down] = signs(along(seen_.touching()), root);
    return !(up && down);
  }

  const SeenPoints& seen_;
  const SimplexForms<Integer, 3>& forms_;
  Curve curve_;
  Signs b_;
};

FaceRoots solve(const std::array<const Tensor*, 3>& corners, std::vector<ExactPoint>& points) {
  FaceRoots result;
  const auto forms = exact_forms<3>(corners);
  if (!forms) {
    const bool zero = std::any_of(corners.begin(), corners.end(), [](const Tensor* t) {
      return (*t)[0] == (*t)[1] && (*t)[1] == (*t)[2] && (*t)[3] == 0 && (*t)[4] == 0 &&
             (*t)[5] == 0;
    });
    result.special = zero ? SpecialReason::zero_tensor : SpecialReason::dependent;
    return result;
  }
  // A view in which all roots are simple, or the one with the fewest multiple roots.
  const bool simple = all_simple(forms->vanishing[0], forms->vanishing[1]);
  result.multiple = !simple;
  std::optional<SeenPoints> best;
  RealRoots roots;
  int fewest = 5;
  bool vanishes = true;
  for (int number = 0; number < (simple ? kViews : kViewsOfMultiple) && fewest > 0; ++number) {
    const auto seen = see(*forms, number);
    if (!seen) continue;
    const IntegerPolynomial f = IntegerPolynomial({seen->pencil.f.begin(), seen->pencil.f.end()});
    vanishes = vanishes && f.is_zero();
    if (f.degree() < 4) continue;
    RealRoots found = kernel::real_roots(f);
    int multiple = 0;
    for (const auto& r : found.roots) multiple += r.multiplicity > 1;
    if (multiple < fewest) fewest = multiple, best.emplace(*seen), roots = std::move(found);
  }
  if (!best) {
    result.special = vanishes ? SpecialReason::zero_quartic : SpecialReason::multiple_point;
    return result;
  }
  const RootPlace place(*best, *forms);
  for (const auto& root : roots.roots) place.add(root, result, points);
  return result;
}

}  // namespace

FaceRoots exact_face_roots(const std::array<const Tensor*, 3>& corners) {
  std::vector<ExactPoint> points;
  return solve(corners, points);
}

std::vector<ExactPoint> exact_face_points(const std::array<const Tensor*, 3>& corners) {
  std::vector<ExactPoint> points;
  solve(corners, points);
  return points;
}

}  // namespace crest::modes
