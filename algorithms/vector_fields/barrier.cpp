// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/vector_fields/barrier.hpp"

#include <algorithm>

#include "algorithms/vector_fields/reals.hpp"

namespace crest::vector_fields {

namespace {

constexpr int kFewPieces = 512, kMostPieces = 4000;
constexpr int kMostNewton = 100, kQuickNewton = 20;

template <class Real>
Real largest(const Real& x, const Real& y) {
  using std::fabs;
  const Real a = fabs(x), b = fabs(y);
  return a > b ? a : b;
}

/// x rounded to a multiple of the unit in the last place of 1/2.
double on_grid(double x) {
  return (x + 1) - 1;
}
template <class Real>
Real on_grid(const Real& x) {
  return (x + 1) - 1;
}

/// What the arithmetic is good for.
template <class Real>
Real unit_roundoff(const BarrierSetting& setting) {
  using std::ldexp;
  const bool pairs = std::is_same_v<Real, DoubleDouble>;
  return ldexp(Real(1), -(pairs ? 102 : setting.bits));
}

}  // namespace

/// x0 + sum c_k s^k, s from 0 to 1.
template <class Real>
struct BarrierMaker<Real>::Piece {
  int origin;
  Real x, y;             ///< x0
  Real h, m;             ///< step in time; |w| at the start
  Real norm;             ///< of A'
  Real error;            ///< of w
  Real least{}, most{};  ///< bounds of |w| on the piece
};

template <class Real>
BarrierMaker<Real>::BarrierMaker(const Domain& domain, const BarrierSetting& setting)
    : domain_(domain), setting_(setting), unit_(unit_roundoff<Real>(setting)) {
  set(setting.angle, setting.shrink);
  Real binomial = 1;
  for (int k = 0; k <= setting.degree; ++k) {
    inverse_binomial_.push_back(1 / binomial);
    binomial = binomial * (setting.degree - k) / (k + 1);
  }
  c_.resize(static_cast<std::size_t>(setting.degree) + 1);
  points_.resize(c_.size());
  doubles_.resize(c_.size());
}

template <class Real>
void BarrierMaker<Real>::set(int angle, int shrink) {
  using std::ldexp;
  setting_.angle = angle;
  setting_.shrink = shrink;
  theta_ = ldexp(Real(1), -angle);
}

/// What rounding changes of x'.
template <class Real>
Real BarrierMaker<Real>::rounding(const Piece& p) const {
  return 8 * setting_.degree * unit_ * (largest(p.x, p.y) + 2 * p.h * p.m);
}

/// one_way() in doubles, which do for a filter: what they leave open is looked at again.
template <class Real>
bool BarrierMaker<Real>::surely_one_way(Piece& p) const {
  const auto in_double = [](const Real& x) { return static_cast<double>(x); };
  double change = 0;
  for (std::size_t k = 0; k < c_.size(); ++k) {
    doubles_[k] = {in_double(c_[k][0]), in_double(c_[k][1])};
    if (k > 1) change += static_cast<double>(k) * largest(doubles_[k][0], doubles_[k][1]);
  }
  const double h = in_double(p.h), m = in_double(p.m), error = in_double(p.error);
  const double tail = in_double(p.norm) * largest(doubles_.back()[0], doubles_.back()[1]);
  change = (change / h + tail) * 1.001;
  const double least = (m - change) * 0.999, most = (m + change) * 1.001;
  p.least = least;
  p.most = most;
  const double rest = h * tail + in_double(rounding(p));
  const double left = in_double(theta_) * h * least * least;
  return least > 0 && left > 1e-280 && left > 1.01 * (2 * least * rest + 2.5 * h * most * error);
}

/// Sets the bounds of |w|.
template <class Real>
bool BarrierMaker<Real>::one_way(Piece& p) const {
  if (!std::is_same_v<Real, double> && surely_one_way(p)) return true;
  // w(x(s)) - w(x(0)) is what x' changes by, over h, but for the last term.
  Real change = 0;
  for (int k = 2; k <= setting_.degree; ++k) {
    const auto& c = c_[static_cast<std::size_t>(k)];
    change += k * largest(c[0], c[1]);
  }
  const auto& last = c_.back();
  const Real tail = p.norm * largest(last[0], last[1]);
  change = (change / p.h + tail) * 1.001;
  p.least = (p.m - change) * 0.999;
  p.most = (p.m + change) * 1.001;
  if (!(p.least > 0)) return false;
  const Real rest = p.h * tail + rounding(p);
  return theta_ * p.h * p.least * p.least > 2 * p.least * rest + 2.5 * p.h * p.most * p.error;
}

template <class Real>
Real BarrierMaker<Real>::coefficient(const Piece& p, int corner, int k) const {
  const auto& c = c_[static_cast<std::size_t>(k)];
  const int axis = (corner - p.origin + 3) % 3;
  if (axis == 1) return k == 0 ? p.x : c[0];
  if (axis == 2) return k == 0 ? p.y : c[1];
  return k == 0 ? Real(1 - p.x - p.y) : Real(-(c[0] + c[1]));
}

/// Where Newton's iteration starts: in doubles at the end, else at the root in doubles.
template <class Real>
double near_root(const std::vector<Real>& e) {
  if constexpr (std::is_same_v<Real, double>) return 1;
  std::vector<double> q;
  for (const Real& x : e) q.push_back(static_cast<double>(x));
  double s = 1;
  for (int i = 0; i < kQuickNewton; ++i) {
    double value = 0, slope = 0;
    for (std::size_t k = q.size(); k-- > 0;) {
      slope = slope * s + value;
      value = value * s + q[k];
    }
    const double next = s - value / slope;
    if (!(next > 0 && next <= 1)) return 1;
    if (std::fabs(next - s) < 1e-14 * s) return next;
    s = next;
  }
  return 1;
}

/// The root in (0, 1] of a corner's coordinate, which falls from a positive value to one that is
/// not; `divided`: by s, for the coordinate that is 0 at the start.
template <class Real>
Real BarrierMaker<Real>::root(const Piece& p, int corner, bool divided) const {
  const int d = setting_.degree, first = divided ? 1 : 0;
  std::vector<Real> e;
  for (int k = first; k <= d; ++k) e.push_back(coefficient(p, corner, k));
  Real low = 0, high = 1, s = near_root(e);
  for (int i = 0; i < kMostNewton; ++i) {
    Real value = 0, slope = 0;
    for (std::size_t k = e.size(); k-- > 0;) {
      slope = slope * s + value;
      value = value * s + e[k];
    }
    if (value == 0) return s;
    (value > 0 ? low : high) = s;
    Real next = slope < 0 ? Real(s - value / slope) : Real((low + high) / 2);
    if (!(next > low && next < high)) next = (low + high) / 2;
    using std::fabs;
    if (fabs(next - s) <= 2 * unit_ * s || !(low < next && next < high)) return next;
    s = next;
  }
  return s;
}

/// inside() in doubles, where that is clear.
template <class Real>
bool BarrierMaker<Real>::surely_inside(const Piece& p, int entry, int exit) const {
  const std::size_t d = c_.size() - 1;
  auto& b = doubles_;
  double size = 0;
  for (std::size_t k = 1; k <= d; ++k)
    for (std::size_t i = 0; i < 2; ++i) {
      b[k][i] = static_cast<double>(c_[k][i]);
      size += std::fabs(b[k][i]);
      b[k][i] *= static_cast<double>(inverse_binomial_[k]);
    }
  const double x = static_cast<double>(p.x), y = static_cast<double>(p.y);
  const double margin = 0x1p-42 * (size + std::fabs(x) + std::fabs(y));
  b[0] = {0, 0};
  for (std::size_t r = 1; r <= d; ++r)
    for (std::size_t j = d; j >= r; --j) {
      b[j][0] += b[j - 1][0];
      b[j][1] += b[j - 1][1];
    }
  const int axis_in = entry < 0 || entry > 2 ? entry : (entry - p.origin + 3) % 3;
  const int axis_out = exit < 0 ? -1 : (exit - p.origin + 3) % 3;
  for (std::size_t j = 0; j <= d; ++j) {
    const double u = b[j][0] + x, v = b[j][1] + y;
    const double least[3] = {1 - u - v, u, v};
    for (int axis = 0; axis < 3; ++axis) {
      const bool start = j == 0 && (axis == axis_in || (entry == 3 && axis != 0));
      if (!(least[axis] > margin) && !start && !(j == d && axis == axis_out)) return false;
    }
  }
  return true;
}

/// Control points, all strictly inside but for the start on the entry and the end on the exit.
template <class Real>
bool BarrierMaker<Real>::inside(const Piece& p, int entry, int exit) {
  const std::size_t last = c_.size() - 1;
  if (!std::is_same_v<Real, double> && surely_inside(p, entry, exit)) {
    points_[last] = {p.x, p.y};
    for (std::size_t k = 1; k <= last; ++k) {
      points_[last][0] += c_[k][0];
      points_[last][1] += c_[k][1];
    }
    return true;
  }
  const std::size_t d = c_.size() - 1;
  for (std::size_t k = 1; k <= d; ++k)
    points_[k] = {c_[k][0] * inverse_binomial_[k], c_[k][1] * inverse_binomial_[k]};
  points_[0] = {Real(0), Real(0)};
  for (std::size_t r = 1; r <= d; ++r)
    for (std::size_t j = d; j >= r; --j) {
      points_[j][0] += points_[j - 1][0];
      points_[j][1] += points_[j - 1][1];
    }
  for (auto& b : points_) {
    b[0] += p.x;
    b[1] += p.y;
  }
  const int axis_in = entry < 0 || entry > 2 ? entry : (entry - p.origin + 3) % 3;
  const int axis_out = exit < 0 ? -1 : (exit - p.origin + 3) % 3;
  for (std::size_t j = 0; j <= d; ++j) {
    const auto& b = points_[j];
    const bool inside[3] = {b[0] + b[1]<1 - 4 * unit_, b[0]> 0, b[1] > 0};
    for (int axis = 0; axis < 3; ++axis) {
      if (inside[axis]) continue;
      const bool start = j == 0 && (axis == axis_in || (entry == 3 && axis != 0));
      if (!start && !(j == d && axis == axis_out)) return false;
    }
  }
  return true;
}

/// Taylor coefficients of a piece from its velocity; returns its end.
template <class Real>
std::array<Real, 2> BarrierMaker<Real>::series(const Piece& piece, const Real& u, const Real& v,
                                               const std::array<Real, 2>& p,
                                               const std::array<Real, 2>& q) {
  c_[1] = {piece.h * u, piece.h * v};
  std::array<Real, 2> end = {piece.x + c_[1][0], piece.y + c_[1][1]};
  for (int k = 1; k < setting_.degree; ++k) {
    const auto& c = c_[static_cast<std::size_t>(k)];
    const Real f = piece.h / (k + 1);
    auto& next = c_[static_cast<std::size_t>(k) + 1];
    next = {f * (p[0] * c[0] + q[0] * c[1]), f * (p[1] * c[0] + q[1] * c[1])};
    end[0] += next[0];
    end[1] += next[1];
  }
  return end;
}

/// The corner whose coordinate falls to zero first, and where; -1: none does.
template <class Real>
std::pair<int, Real> BarrierMaker<Real>::exit_of(const Piece& piece, const std::array<Real, 2>& end,
                                                 int entry) const {
  int exit = -1;
  Real s = 2;
  const bool outside[3] = {end[0] + end[1] >= 1, end[0] <= 0, end[1] <= 0};
  for (int axis = 0; axis < 3; ++axis) {
    if (!outside[axis]) continue;
    const int corner = (piece.origin + axis) % 3;
    const bool from_zero = corner == entry || (entry == 3 && axis != 0);
    const Real r = root(piece, corner, from_zero);
    if (r < s) {
      s = r;
      exit = corner;
    }
  }
  return {exit, s};
}

template <class Real>
std::optional<ArcEnd<Real>> BarrierMaker<Real>::leave(const TriangleFrame<Real>& frame,
                                                      const Real& x, const Real& y,
                                                      int exit) const {
  const int o = frame.origin, axis = (exit - o + 3) % 3;
  ArcEnd<Real> end;
  end.side = (exit + 1) % 3;
  Real a = axis == 1 ? Real(0) : x, b = axis == 2 ? Real(0) : y;
  if (axis == 0) {
    a = on_grid(a);
    b = 1 - a;
    end.t = b <= 0.5 ? b : Real(-a);
  } else if (axis == 1) {
    end.t = b < 0.5 ? Real(-b) : Real(1 - b);
  } else {
    end.t = a <= 0.5 ? a : Real(a - 1);
  }
  if (end.t == 0) return std::nullopt;
  const auto w = frame.value(a, b);
  const Real out = axis == 0 ? Real(w[0] + w[1]) : axis == 1 ? Real(-w[0]) : Real(-w[1]);
  if (!(out > 4 * frame.error)) return std::nullopt;
  return end;
}

template <class Real>
std::optional<ArcEnd<Real>> BarrierMaker<Real>::arc(const TriangleFrame<Real>& frame, const Real& x,
                                                    const Real& y, bool left, int entry,
                                                    const TrapShape* trap) {
  using std::fabs;
  const Real turn = left ? theta_ : Real(-theta_);
  const auto turned = [&](const Real& u, const Real& v) {
    return std::array<Real, 2>{u - turn * v, v + turn * u};
  };
  const auto w = turned(frame.w[0], frame.w[1]);
  const auto p = turned(frame.a[0][0], frame.a[1][0]), q = turned(frame.a[0][1], frame.a[1][1]);
  using std::ldexp;
  const Real shrink = ldexp(Real(1), -setting_.shrink);
  Piece piece{frame.origin, x, y, Real(0), Real(0), Real(0), frame.error};
  piece.norm = std::max<Real>(fabs(p[0]) + fabs(q[0]), fabs(p[1]) + fabs(q[1]));
  const int d = setting_.degree;
  exhausted_ = false;
  const int share = std::max(1, setting_.bits / 60);  // pieces of many bits are dear
  const int most = std::max(
      16, (!quick_ && (trap || setting_.shrink < 0) ? kMostPieces : kFewPieces) / share / share);
  for (int pieces = 0; pieces < most; ++pieces) {
    const Real u = w[0] + p[0] * piece.x + q[0] * piece.y;
    const Real v = w[1] + p[1] * piece.x + q[1] * piece.y;
    piece.m = largest(u, v);
    if (!(piece.m > 0)) return std::nullopt;
    piece.h = shrink / (2 * piece.norm + piece.m / 2);
    const auto at_end = series(piece, u, v, p, q);
    if (!one_way(piece)) return std::nullopt;
    const auto [exit, s] = exit_of(piece, at_end, pieces == 0 ? entry : -1);
    if (exit >= 0) {
      Real power = s;
      for (int k = 1; k <= d; ++k, power *= s) {
        c_[static_cast<std::size_t>(k)][0] *= power;
        c_[static_cast<std::size_t>(k)][1] *= power;
      }
    }
    if (!inside(piece, pieces == 0 ? entry : -1, exit)) return std::nullopt;
    const auto& end = points_.back();
    if (exit >= 0) {
      // What rounding changes must be little against the shorter piece, too.
      if (!(theta_ * piece.h * s * piece.least > 2 * rounding(piece))) return std::nullopt;
      return leave(frame, end[0], end[1], exit);
    }
    piece.x = end[0];
    piece.y = end[1];
    if (trap) {
      const int axis1 = (1 - frame.origin + 3) % 3, axis2 = (2 - frame.origin + 3) % 3;
      const auto coordinate = [&](int axis) -> Real {
        return axis == 0 ? Real(1 - piece.x - piece.y) : axis == 1 ? piece.x : piece.y;
      };
      if (trap->holds(coordinate(axis1), coordinate(axis2))) return ArcEnd<Real>{};
    }
  }
  exhausted_ = true;
  return std::nullopt;
}

template class BarrierMaker<double>;
template class BarrierMaker<DoubleDouble>;
template class BarrierMaker<Real133>;
template class BarrierMaker<Real332>;
template class BarrierMaker<Real1000>;

}  // namespace crest::vector_fields
