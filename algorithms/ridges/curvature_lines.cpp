// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/curvature_lines.hpp"

#include <limits>

namespace crest::ridges {
namespace {

using kernel::dot;
using kernel::operator+;
using kernel::operator-;
using kernel::operator*;

int sign_of(double x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}

double component(const CurvatureLines::Velocity& v, std::size_t corner) {
  return corner == 0 ? -v[0] - v[1] : v[corner - 1];
}

/// A face's plane, spanned by its sides from corner 0.
class Plane {
 public:
  Plane(const kernel::TriangleMesh& mesh, Index f) {
    const auto [a, b, c] = mesh.faces()[f];
    u_ = mesh.points()[b] - mesh.points()[a];
    v_ = mesh.points()[c] - mesh.points()[a];
    uu_ = dot(u_, u_);
    uv_ = dot(u_, v_);
    vv_ = dot(v_, v_);
    det_ = uu_ * vv_ - uv_ * uv_;
  }
  CurvatureLines::Velocity velocity(const Vec3& direction) const {
    const double du = dot(direction, u_), dv = dot(direction, v_);
    return {(vv_ * du - uv_ * dv) / det_, (uu_ * dv - uv_ * du) / det_};
  }

 private:
  Vec3 u_, v_;
  double uu_, uv_, vv_, det_;
};

}  // namespace

CurvatureLines::Field CurvatureLines::field(Index f, Colour c) const {
  const kernel::Triangle& t = mesh_.faces()[f];
  const std::array<Vec3, 3> d = {principal(t[0], c), principal(t[1], c), principal(t[2], c)};
  const int first = sign_of(dot(d[0], d[1])), last = sign_of(dot(d[0], d[2]));
  Field field;
  if (first * sign_of(dot(d[1], d[2])) * last <= 0) return field;
  field.sign = {1, static_cast<std::int8_t>(first), static_cast<std::int8_t>(last)};
  const Plane plane(mesh_, f);
  for (std::size_t k = 0; k < 3; ++k) {
    field.corner[k] = plane.velocity(d[k]);
    for (double& x : field.corner[k]) x *= field.sign[k];
  }
  return field;
}

CurvatureLines::Velocity CurvatureLines::velocity(Index f, const Vec3& direction) const {
  return Plane(mesh_, f).velocity(direction);
}

Vec3 CurvatureLines::direction(Index f, const Velocity& v) const {
  const auto [a, b, c] = mesh_.faces()[f];
  const auto& p = mesh_.points();
  return v[0] * (p[b] - p[a]) + v[1] * (p[c] - p[a]);
}

Vec3 CurvatureLines::direction_on(Index edge, double weight, Colour c) const {
  const kernel::Edge& e = mesh_.edges()[edge];
  const Vec3 p = principal(e.v0, c), q = principal(e.v1, c);
  const int sign = sign_of(dot(p, q));
  return sign == 0 ? Vec3{} : (1 - weight) * p + sign * weight * q;
}

LineWalk::LineWalk(const CurvatureLines& lines, Index edge, double weight, Colour colour,
                   bool forward, double straight)
    : lines_(lines), colour_(colour), straight_(straight), weight_(weight) {
  const kernel::Edge& e = lines.mesh().edges()[edge];
  const auto& points = lines.mesh().points();
  ends_ = {e.v0, e.v1};
  point_ = (1 - weight) * points[e.v0] + weight * points[e.v1];
  direction_ = lines.direction_on(edge, weight, colour);
  if (!forward) direction_ = -1.0 * direction_;
  // Of the two faces the one into which the direction leads more steeply, or back less.
  double best = -std::numeric_limits<double>::infinity();
  for (const Index f : {e.f0, e.f1}) {
    if (f == kernel::kNone) continue;
    const kernel::Triangle& t = lines.mesh().faces()[f];
    std::size_t opposite = 0;
    while (t[opposite] == e.v0 || t[opposite] == e.v1) ++opposite;
    const double rate = component(lines.velocity(f, direction_), opposite);
    if (rate > best) {
      best = rate;
      enter(f, e.v0, e.v1);
    }
  }
}

void LineWalk::enter(Index face, Index p, Index q) {
  face_ = face;
  known_ = false;
  const kernel::Triangle& t = lines_.mesh().faces()[face];
  for (std::size_t k = 0; k < 3; ++k) {
    at_[k] = t[k] == p ? 1 - weight_ : t[k] == q ? weight_ : 0;
    if (t[k] != p && t[k] != q) from_ = k;
  }
}

// At a vertex: the face of its fan into which its own principal direction leads.
void LineWalk::enter_at(Index vertex) {
  ends_ = {vertex, vertex};
  weight_ = 0;
  sign_ = carried_ = 0;
  known_ = false;
  Vec3 d = lines_.principal(vertex, colour_);
  if (dot(d, direction_) < 0) d = -1.0 * d;
  face_ = kernel::kNone;
  double best = -std::numeric_limits<double>::infinity();
  for (const Index f : lines_.mesh().fan(vertex)) {
    const kernel::Triangle& t = lines_.mesh().faces()[f];
    const std::size_t k = t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2;
    const Velocity v = lines_.velocity(f, d);
    const double i = component(v, (k + 1) % 3), j = component(v, (k + 2) % 3);
    if (!(std::fmin(i, j) > best)) continue;
    best = std::fmin(i, j);
    face_ = f;
    at_ = {};
    at_[k] = 1;
    from_ = i > j ? (k + 1) % 3 : (k + 2) % 3;
  }
}

// The field's sign is carried over by the vector at the first end of the side of entry.
void LineWalk::look() {
  field_ = lines_.field(face_, colour_);
  known_ = true;
  if (carried_ == 0) return;
  const kernel::Triangle& t = lines_.mesh().faces()[face_];
  sign_ = carried_ * field_.sign[t[0] == ends_[0] ? 0 : t[1] == ends_[0] ? 1 : 2];
}

// The line's velocity at at_, into the triangle if it can.
LineWalk::Lead LineWalk::velocity_here(Velocity& v) {
  if (!known_) look();
  if (field_.coherent()) {
    for (std::size_t i = 0; i < 2; ++i) {
      v[i] = at_[0] * field_.corner[0][i] + at_[1] * field_.corner[1][i] +
             at_[2] * field_.corner[2][i];
    }
    if (sign_ == 0) sign_ = dot(lines_.direction(face_, v), direction_) < 0 ? -1 : 1;
    for (double& x : v) x *= sign_;
    return component(v, from_) > 0 ? Lead::in : Lead::back;
  }
  sign_ = 0;
  if (!(length_ < straight_)) return Lead::nowhere;
  v = lines_.velocity(face_, direction_);
  return component(v, from_) > 0 ? Lead::in : Lead::back;
}

// Along the side of entry to the end that lies ahead.
bool LineWalk::slide() {
  const auto& points = lines_.mesh().points();
  const double ahead = dot(direction_, points[ends_[1]] - points[ends_[0]]);
  if (ahead == 0) return false;
  const Index vertex = ends_[ahead > 0 ? 1 : 0];
  go_to(points[vertex]);
  enter_at(vertex);
  return true;
}

void LineWalk::go_to(const Vec3& next) {
  const Vec3 way = next - point_;
  const double length = kernel::norm(way);
  if (length > 0) direction_ = way;
  length_ += length;
  point_ = next;
}

LineWalk::Exit LineWalk::exit(const Velocity& v) const {
  Exit exit{from_, std::numeric_limits<double>::infinity()};
  for (std::size_t k = 0; k < 3; ++k) {
    const double rate = component(v, k);
    if (k == from_ || !(rate < 0)) continue;
    const double time = at_[k] / -rate;
    if (time < exit.time) exit = {k, time};
  }
  return exit;
}

bool LineWalk::step() {
  constexpr int kSteps = 10000;  // turning on the spot about a vertex takes no length
  if (face_ == kernel::kNone || ++steps_ > kSteps) return false;
  Velocity v;
  const Lead lead = velocity_here(v);
  if (lead != Lead::in) return lead == Lead::back && slide();
  Exit out = exit(v);
  if (sign_ != 0) {
    const std::array<double, 3> start = at_;
    for (std::size_t k = 0; k < 3; ++k) at_[k] += out.time / 2 * component(v, k);
    Velocity middle{};
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t k = 0; k < 3; ++k) middle[i] += sign_ * at_[k] * field_.corner[k][i];
    at_ = start;
    if (component(middle, from_) > 0) {
      v = middle;
      out = exit(v);
    }
  }
  if (out.corner == from_) return false;  // not a number
  move(v, out);
  return true;
}

void LineWalk::move(const Velocity& v, const Exit& out) {
  for (std::size_t k = 0; k < 3; ++k) at_[k] = std::fmax(0.0, at_[k] + out.time * component(v, k));
  const std::size_t i = (out.corner + 1) % 3, j = (out.corner + 2) % 3;
  const kernel::Triangle& t = lines_.mesh().faces()[face_];
  const auto& points = lines_.mesh().points();
  ends_ = {t[i], t[j]};
  const double sum = at_[i] + at_[j];
  weight_ = sum > 0 ? at_[j] / sum : 0.5;
  go_to((1 - weight_) * points[t[i]] + weight_ * points[t[j]]);

  carried_ = sign_ * field_.sign[i];
  sign_ = 0;
  face_ = lines_.mesh().neighbour(face_, static_cast<int>(i));
  if (face_ != kernel::kNone) enter(face_, ends_[0], ends_[1]);
}

}  // namespace crest::ridges
