// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "algorithms/modes/degenerate_face.hpp"
#include "kernel/polynomial/real_roots.hpp"

namespace crest::modes {

namespace {

using kernel::AlgebraicNumber;
using kernel::IntegerPolynomial;
using kernel::RealRoots;
using kernel::Sign;

/// A polynomial in t as the forms' number type.
struct Poly {
  std::vector<Rational> c;

  Poly(Rational x) : c{std::move(x)} {}  // NOLINT: numbers convert
  explicit Poly(std::vector<Rational> x) : c(std::move(x)) {}
  friend Poly operator+(const Poly& a, const Poly& b) {
    Poly s = a.c.size() < b.c.size() ? b : a;
    const Poly& less = a.c.size() < b.c.size() ? a : b;
    for (std::size_t k = 0; k < less.c.size(); ++k) s.c[k] += less.c[k];
    return s;
  }
  friend Poly operator*(const Poly& a, const Poly& b) {
    Poly p(std::vector<Rational>(a.c.size() + b.c.size() - 1));
    for (std::size_t i = 0; i < a.c.size(); ++i)
      for (std::size_t j = 0; j < b.c.size(); ++j) p.c[i + j] += a.c[i] * b.c[j];
    return p;
  }
  IntegerPolynomial integer() const { return IntegerPolynomial::from(c); }
};

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

Conic<Rational> seen(const Conic<Rational>& p, const View& view) {
  std::array<kernel::Vector3<Rational>, 3> e, image;
  for (std::size_t k = 0; k < 3; ++k) {
    e[k] = {view[k][0], view[k][1], view[k][2]};
    image[k] = p.times(e[k]);
  }
  const auto at = [&](std::size_t i, std::size_t j) { return kernel::dot(e[i], image[j]); };
  return {{at(0, 0), at(1, 1), at(2, 2), at(0, 1), at(1, 2), at(0, 2)}};
}

/// The common points seen in one view.
struct Seen {
  PencilQuartic<Rational> pencil;
  View view;

  /// v over the numbers N that hold t, with y = 1.
  template <class N>
  kernel::Vector3<N> point(const N& t) const {
    const auto number = [](const Rational& x) { return N(x); };
    const N line = number(pencil.l[0]) + number(pencil.l[1]) * t;
    const N conic = number(pencil.q[0]) + (number(pencil.q[1]) + number(pencil.q[2]) * t) * t;
    const N two = line + line;
    const kernel::Vector3<N> w{two * t, two, N(Rational(-1)) * conic};
    kernel::Vector3<N> v{N(Rational(0)), N(Rational(0)), N(Rational(0))};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i) v[i] = v[i] + N(Rational(view[k][i])) * w[k];
    return v;
  }
};

std::optional<Seen> see(const SimplexForms<Rational, 3>& forms, int number) {
  const View v = view(number);
  Conic<Rational> p = seen(forms.vanishing[0], v), q = seen(forms.vanishing[1], v);
  if (p.c[2].is_zero()) std::swap(p, q);
  if (p.c[2].is_zero()) return std::nullopt;  // the view point is common to both
  return Seen{PencilQuartic<Rational>(p, q), v};
}

/// v at the root, to about 60 digits, then doubles that hold it.
kernel::Vector3<Ball> enclose(const Seen& seen, AlgebraicNumber t) {
  Rational low, high;
  if (!t.rational()) t.refine(240);
  if (t.rational()) {
    low = high = *t.rational();
  } else {
    low = t.low().value();
    high = t.high().value();
  }
  const Rational middle = (low + high) / 2, reach = (high - low) / 2;
  const kernel::Vector3<Rational> v = seen.point<Rational>(middle);
  const Poly free(std::vector<Rational>{0, 1});
  const kernel::Vector3<Poly> curve = seen.point<Poly>(free);
  Rational largest = 0;
  for (const Rational& x : v) largest = std::max<Rational>(largest, abs(x));
  if (largest.is_zero()) largest = 1;
  const Rational size = abs(middle) + reach + 1;
  kernel::Vector3<Ball> result;
  for (std::size_t i = 0; i < 3; ++i) {
    Rational slope = 0, power = 1;  // |v'| <= sum k |c_k| size^(k-1)
    for (std::size_t k = 1; k < curve[i].c.size(); ++k) {
      slope += abs(curve[i].c[k]) * static_cast<int>(k) * power;
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
  RootPlace(const Seen& seen, const SimplexForms<Rational, 3>& forms) : seen_(&seen) {
    const kernel::Vector3<Poly> v = seen.point<Poly>(Poly(std::vector<Rational>{0, 1}));
    for (std::size_t k = 0; k < 3; ++k) {
      Conic<Poly> form{{forms.coordinates[k].c[0], forms.coordinates[k].c[1],
                        forms.coordinates[k].c[2], forms.coordinates[k].c[3],
                        forms.coordinates[k].c[4], forms.coordinates[k].c[5]}};
      b_[k] = form.at(v).integer();
      forms_[k] = forms.coordinates[k];
    }
  }

  void add(const kernel::RealRoot& root, FaceRoots& result) const {
    int up = 0, down = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Sign s = kernel::sign_at(b_[k], root.value).sign;
      up += s == Sign::positive;
      down += s == Sign::negative;
    }
    if (up && down) return;  // outside
    if (root.multiplicity > 1) {
      result.special = SpecialReason::multiple_point;
      return;
    }
    if (up + down < 3) {
      if (!result.special) result.special = SpecialReason::on_rim;
      return;
    }
    FaceRoot r{
        up ? DegenerateType::linear : DegenerateType::planar, enclose(*seen_, root.value), {}};
    kernel::Vector3<Rational> v;
    for (std::size_t i = 0; i < 3; ++i) v[i] = r.v[i].mid;
    std::array<Rational, 3> b;
    for (std::size_t k = 0; k < 3; ++k) b[k] = forms_[k].at(v);
    const Rational sum = b[0] + b[1] + b[2];
    for (std::size_t k = 0; k < 3; ++k)
      r.weights[k] = sum.is_zero() ? 1.0 / 3 : static_cast<double>(Rational(b[k] / sum));
    result.root[result.count++] = r;
  }

 private:
  const Seen* seen_;
  std::array<IntegerPolynomial, 3> b_;
  std::array<Conic<Rational>, 3> forms_;
};

}  // namespace

FaceRoots exact_face_roots(const std::array<const Tensor*, 3>& corners) {
  FaceRoots result;
  const auto forms = simplex_forms<Rational, 3>(corners);
  if (!forms) {
    const bool zero = std::any_of(corners.begin(), corners.end(), [](const Tensor* t) {
      return (*t)[0] == (*t)[1] && (*t)[1] == (*t)[2] && (*t)[3] == 0 && (*t)[4] == 0 &&
             (*t)[5] == 0;
    });
    result.special = zero ? SpecialReason::zero_tensor : SpecialReason::dependent;
    return result;
  }
  // A view in which all roots are simple, or the one with the fewest multiple roots.
  std::optional<Seen> best;
  RealRoots roots;
  int fewest = 5;
  for (int number = 0; number < kViews && fewest > 0; ++number) {
    const auto seen = see(*forms, number);
    if (!seen) continue;
    const IntegerPolynomial f = IntegerPolynomial::from(seen->pencil.f);
    if (f.degree() < 4) continue;
    RealRoots found = kernel::real_roots(f);
    int multiple = 0;
    for (const auto& r : found.roots) multiple += r.multiplicity > 1;
    if (multiple < fewest) fewest = multiple, best = seen, roots = std::move(found);
  }
  if (!best) {
    result.special = SpecialReason::zero_quartic;
    return result;
  }
  const RootPlace place(*best, *forms);
  for (const auto& root : roots.roots) place.add(root, result);
  return result;
}

}  // namespace crest::modes
