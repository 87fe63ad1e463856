// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/degenerate_arcs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "algorithms/modes/degenerate_exact.hpp"
#include "algorithms/modes/degenerate_order.hpp"
#include "algorithms/modes/small_matrix.hpp"

namespace crest::modes {

namespace {

using kernel::MaybeSign;
using kernel::Sign;
using kernel::Vec3;
using kernel::operator+;
using kernel::operator-;
using kernel::operator*;

/// A point of the conic as a direction from the point inside it.
struct Seen {
  Ball x, y;
  double angle = 0;
};

/// The conic as seen from the point `eye`, where both linear forms of `across` vanish.
class Circle {
 public:
  /// det: the conic's sign; turn: of the plane in which directions are compared.
  Circle(const Conic<Ball>& conic, Sign det, double turn) : conic_(conic) {
    const auto& c = conic.c;
    const Eigensystem axes =
        eigensystem({Vec3{c[0].mid, c[3].mid, c[5].mid}, Vec3{c[3].mid, c[1].mid, c[4].mid},
                     Vec3{c[5].mid, c[4].mid, c[2].mid}});
    // The eigenvalue whose sign is alone, that of det: of the others one may be too small for its
    // sign to be seen.
    const std::size_t alone = det == Sign::positive ? 0 : 2, second = (alone + 1) % 3,
                      third = (alone + 2) % 3;
    const Vec3 &a = axes.vectors[second], &b = axes.vectors[third];
    const double stretch_a = std::sqrt(std::fabs(axes.values[second])),
                 stretch_b = std::sqrt(std::fabs(axes.values[third]));
    for (std::size_t k = 0; k < 3; ++k) {
      const double pa = a[k] * stretch_a, pb = b[k] * stretch_b;
      across_[0][k] = std::cos(turn) * pa + std::sin(turn) * pb;
      across_[1][k] = std::cos(turn) * pb - std::sin(turn) * pa;
      const double ia = a[k] / stretch_a, ib = b[k] / stretch_b;
      along_[0][k] = std::cos(turn) * ia + std::sin(turn) * ib;
      along_[1][k] = std::cos(turn) * ib - std::sin(turn) * ia;
    }
    eye_ = kernel::cross(across_[0], across_[1]);
    polar_ = conic_.times(eye_);
    defined_ = certain_sign(kernel::dot(eye_, polar_)) == det;
    if (det == Sign::positive) {
      for (Ball& x : conic_.c) x = -x;
      for (Ball& x : polar_) x = -x;
    }
  }

  bool defined() const { return defined_; }

  /// Nothing: not decided on which side of the eye's polar v lies.
  std::optional<Seen> see(const Vector3<Ball>& v) const {
    const MaybeSign side = certain_sign(kernel::dot(v, polar_));
    if (!side || *side == Sign::zero) return std::nullopt;
    Seen s{kernel::dot(across_[0], v), kernel::dot(across_[1], v)};
    if (*side == Sign::positive) s.x = -s.x, s.y = -s.y;
    s.angle = std::atan2(s.y.mid, s.x.mid);
    return s;
  }
  /// The conic's point near that angle.
  Vector3<Ball> at(double angle) const {
    Vector3<Ball> h;
    for (std::size_t k = 0; k < 3; ++k)
      h[k] = Ball(std::cos(angle)) * along_[0][k] + Ball(std::sin(angle)) * along_[1][k];
    const Ball a = kernel::dot(eye_, polar_), b = kernel::dot(h, polar_), c = conic_.at(h);
    const Ball z = (-b - sqrt(b * b - a * c)) / a;
    return {h[0] + z * eye_[0], h[1] + z * eye_[1], h[2] + z * eye_[2]};
  }

 private:
  Conic<Ball> conic_;
  std::array<Vector3<Ball>, 2> across_, along_;
  Vector3<Ball> eye_, polar_;
  bool defined_ = false;
};

/// Whether a comes before b, seen from the direction of (-1, 0) counterclockwise; nothing: not
/// decided.
bool certainly_before(const Seen& a, const Seen& b) {
  const MaybeSign ya = certain_sign(a.y), yb = certain_sign(b.y);
  if (!ya || !yb || *ya == Sign::zero || *yb == Sign::zero) return false;
  if (*ya != *yb) return *ya == Sign::negative;
  return certain_sign(a.x * b.y - a.y * b.x) == Sign::positive;
}

using Weights = std::array<double, 4>;

class TetConic {
 public:
  TetConic(const SimplexForms<Ball, 4>& forms, Sign det, const std::array<Vec3, 4>& positions,
           double turn)
      : forms_(&forms), positions_(&positions), circle_(forms.vanishing[0], det, turn) {}

  /// False: not decided.
  bool run(std::span<const TetPoint> points, std::vector<TetArc>& arcs) {
    if (!circle_.defined() || !order(points)) return false;
    const std::size_t n = points.size();
    std::vector<Seen> sequence;
    std::vector<double> middle(n);
    std::vector<bool> inside(n);
    for (std::size_t i = 0; i < n; ++i) {
      double to = seen_[order_[(i + 1) % n]].angle;
      if (i + 1 == n) to += 2 * std::numbers::pi;
      middle[i] = (seen_[order_[i]].angle + to) / 2;
      const Vector3<Ball> v = circle_.at(middle[i]);
      const auto s = circle_.see(v);
      const auto sign = common_sign(v);
      if (!s || !sign) return false;
      inside[i] = *sign;
      sequence.push_back(seen_[order_[i]]);
      sequence.push_back(*s);
    }
    // The last sample may lie beyond the direction of (-1, 0).
    if (sequence.back().angle < sequence.front().angle)
      std::rotate(sequence.begin(), sequence.end() - 1, sequence.end());
    for (std::size_t i = 0; i + 1 < sequence.size(); ++i)
      if (!certainly_before(sequence[i], sequence[i + 1])) return false;
    for (std::size_t i = 0; i < n; ++i) {
      // Each point is a simple zero of one coordinate, so arcs alternate.
      if (inside[i] == inside[(i + 1) % n] && n > 1) return false;
      if (inside[i]) arcs.push_back(arc(points, order_[i], order_[(i + 1) % n]));
    }
    return true;
  }

  /// Arcs that are known, each counterclockwise.
  std::vector<TetArc> joined(std::span<const TetPoint> points, std::span<const Join> joins) {
    const bool seen = circle_.defined() && order(points);
    std::vector<TetArc> arcs;
    for (const auto& [a, b] : joins)
      arcs.push_back(seen && nothing_between(a, b) ? arc(points, a, b)
                                                   : TetArc{{points[a].id, points[b].id}, {}});
    return arcs;
  }

 private:
  bool order(std::span<const TetPoint> points) {
    for (const TetPoint& p : points) {
      const auto s = circle_.see(p.v);
      if (!s) return false;
      order_.push_back(seen_.size());
      seen_.push_back(*s);
    }
    std::sort(order_.begin(), order_.end(),
              [&](std::size_t a, std::size_t b) { return seen_[a].angle < seen_[b].angle; });
    return !points.empty();
  }
  /// Whether all coordinates have one sign.
  std::optional<bool> common_sign(const Vector3<Ball>& v) const {
    int up = 0, down = 0;
    for (const auto& form : forms_->coordinates) {
      const MaybeSign s = certain_sign(form.at(v));
      up += s == Sign::positive;
      down += s == Sign::negative;
    }
    if (up && down) return false;
    if (up + down == 4) return true;
    return std::nullopt;
  }
  /// From seen point a.
  double turn_to(std::size_t a, std::size_t b) const {
    const double turn = seen_[b].angle - seen_[a].angle;
    return turn < 0 ? turn + 2 * std::numbers::pi : turn;
  }
  /// As doubles see it: neighbours may seem to be in the other order, the whole circle apart.
  bool nothing_between(std::size_t a, std::size_t b) const {
    for (std::size_t c = 0; c < seen_.size(); ++c)
      if (c != a && c != b && turn_to(a, c) < turn_to(a, b)) return false;
    return true;
  }
  TetArc arc(std::span<const TetPoint> points, std::size_t a, std::size_t b) const {
    TetArc result{{points[a].id, points[b].id}, {}};
    const double from = seen_[a].angle, to = from + turn_to(a, b);
    refine(from, place(weights(from)), to, place(weights(to)), 7, result.interior);
    return result;
  }
  /// Points until the chord is a hundredth of its length from the curve at most.
  void refine(double from, const Vec3& a, double to, const Vec3& b, int depth,
              std::vector<Weights>& interior) const {
    const double middle = (from + to) / 2;
    const Weights w = weights(middle);
    if (!std::isfinite(w[0] + w[1] + w[2] + w[3])) return;  // a chord will do
    const Vec3 m = place(w), chord = b - a;
    const double length = kernel::norm(chord);
    const bool flat = depth < 7 &&
                      kernel::norm(kernel::cross(m - a, chord)) < 0.005 * length * length &&
                      kernel::dot(m - a, chord) > 0 && kernel::dot(b - m, chord) > 0;
    if (depth == 0 || flat) return;
    refine(from, a, middle, m, depth - 1, interior);
    interior.push_back(w);
    refine(middle, m, to, b, depth - 1, interior);
  }
  Weights weights(double angle) const {
    const Vector3<Ball> v = circle_.at(angle);
    Weights w;
    double sum = 0;
    for (std::size_t k = 0; k < 4; ++k) sum += w[k] = forms_->coordinates[k].at(v).mid;
    for (double& x : w) x /= sum;
    return w;
  }
  Vec3 place(const Weights& w) const {
    const auto& x = *positions_;
    return w[0] * x[0] + w[1] * x[1] + w[2] * x[2] + w[3] * x[3];
  }

  const SimplexForms<Ball, 4>* forms_;
  const std::array<Vec3, 4>* positions_;
  Circle circle_;
  std::vector<Seen> seen_;
  std::vector<std::size_t> order_;
};

/// Of all points, their exact twins: of several in one face the only one that may be it.
std::optional<std::vector<ConicPoint>> exact_points(const std::array<const Tensor*, 4>& corners,
                                                    std::span<const TetPoint> points) {
  std::vector<ConicPoint> result;
  std::array<std::vector<ExactPoint>, 4> found;
  for (std::size_t k = 0; k < 4; ++k)
    if (std::any_of(points.begin(), points.end(), [&](const auto& p) { return p.opposite == k; }))
      found[k] =
          exact_face_points({corners[(k + 1) % 4], corners[(k + 2) % 4], corners[(k + 3) % 4]});
  for (const TetPoint& p : points) {
    const ExactPoint* match = nullptr;
    for (const ExactPoint& e : found[p.opposite]) {
      const Vector3<Ball> c = kernel::cross(e.near, p.v);
      if (certain_sign(c[0]) || certain_sign(c[1]) || certain_sign(c[2])) continue;  // another one
      if (match) return std::nullopt;
      match = &e;
    }
    if (!match) return std::nullopt;
    result.push_back({*match, p.type, p.opposite});
  }
  return result;
}

}  // namespace

TetArcs tet_arcs(const std::array<const Tensor*, 4>& corners, const std::array<Vec3, 4>& positions,
                 std::span<const TetPoint> points) {
  TetArcs result;
  if (points.empty()) return result;
  const auto joined = [&](const SimplexForms<Ball, 4>& forms, Sign det) {
    for (const double turn : {0.0, 0.7, 1.9, 2.6}) {
      TetConic conic(forms, det, positions, turn);
      if (conic.run(points, result.arcs)) return true;
      result.arcs.clear();
    }
    return false;
  };
  if (const auto forms = triage_forms<4>(corners)) {
    const MaybeSign s = certain_sign(forms->vanishing[0].det());
    if (s && *s != Sign::zero && joined(*forms, *s)) return result;
  }
  const auto exact = exact_forms<4>(corners);
  if (!exact) return {{}, SpecialReason::dependent};
  const Sign det = kernel::sign_of(exact->vanishing[0].det());
  if (det == Sign::zero) return {{}, SpecialReason::line_pair};
  SimplexForms<Ball, 4> forms;
  forms.vanishing[0] = ball(exact->vanishing[0], largest(exact->vanishing));
  const Integer scale = largest(exact->coordinates);
  for (std::size_t k = 0; k < 4; ++k) forms.coordinates[k] = ball(exact->coordinates[k], scale);
  if (joined(forms, det)) return result;
  // A curve that enters leaves: of an odd number one is false.
  const auto twins = points.size() % 2 == 0 ? exact_points(corners, points) : std::nullopt;
  result.decided = twins.has_value();
  if (twins)
    result.arcs =
        TetConic(forms, det, positions, 0).joined(points, joins_round_conic(*exact, *twins));
  return result;
}

}  // namespace crest::modes
