// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/second/patches.hpp"

#include <algorithm>

#include "certify/second/rays.hpp"
#include "certify/second/vectors.hpp"

namespace crest::recheck {
namespace {

constexpr int kRayDepth = 16;

/// [D^k] over a triangle, and its direction.
struct Sector {
  int w = 0;
  Coefficients over;
};

class PatchProof {
 public:
  PatchProof(const Problem& problem, const PatchRecord& patch)
      : problem_(problem),
        patch_(patch),
        in_(patch.witness.data(), patch.witness.size(),
            "patch of face " + std::to_string(patch.faces[0])) {}

  /// Guarantees: a box around the umbilic: U0 and the heights over it, or U0.
  Box check() {
    const Scope scope;
    context.order = patch_.order;
    const Interval room = Interval(patch_.r) - Interval(2 * patch_.rho);
    if (room.sign() <= 0) in_.fail("2 rho is not less than R");
    if (problem_.surface.implicit())
      height_over_square();
    else
      immersion_over_square();
    const Box around = umbilic();
    rays();
    in_.finish();
    for (std::size_t j = 0; j < 2; ++j) {
      const int branches = branches_of(j);
      if (branches != patch_.branches[j] || (branches != 1 && branches != 3))
        in_.fail("it has " + std::to_string(branches) + (j == 0 ? " blue" : " red") + " branches");
    }
    return around;
  }

 private:
  Index axis(Index k) const { return (static_cast<Index>(patch_.axis) + 1 + k) % 3; }
  Ball r1() const { return Ball(patch_.r) - Ball(patch_.rho); }
  Interval side_of_square(std::size_t d) const {
    return Interval(patch_.z[d]) + Interval(-patch_.r, patch_.r);
  }

  /// Kind 0: S is a graph over Q.
  void height_over_square();

  /// Kind 1: Q is in the domain, and X an immersion of it.
  void immersion_over_square() const;

  /// The forms over a set of the plane; kind 0: and the heights.
  Forms<Model> forms(const Model& p, const Model& q, Interval* height = nullptr) const {
    if (!problem_.surface.implicit()) return problem_.surface.forms(p, q);
    const Model a = p - Model(patch_.z[0]), b = q - Model(patch_.z[1]);
    const auto& g = patch_.g;
    Fibre<Model> fibre;
    fibre.base[axis(0)] = p;
    fibre.base[axis(1)] = q;
    fibre.base[axis(2)] = Model(g[0]) + Model(g[1]) * a + Model(g[2]) * b + Model(g[3]) * a * a +
                          Model(g[4]) * a * b + Model(g[5]) * b * b;
    fibre.along[axis(2)] = Model(sign_);
    fibre.h = problem_.h(patch_.c);
    const auto foot = problem_.surface.foot(fibre, 1);
    const Interval m = foot.x[axis(2)].range();
    require(m.inside(patch_.m[0], patch_.m[1]), "patch: the heights lie between m0 and m1");
    if (height != nullptr) *height = m;
    const Jet3<Model> f =
        problem_.surface.expand(foot.x, frame_of_axis(axis(2), sign_), jet_degree());
    return problem_.surface.forms(f, sign_);
  }

  /// Conditions 2 and 5; D at z* for the rays.
  Box umbilic();

  /// Condition 4: reads all intervals and shows what is said of them.
  void rays() {
    for (int side = 0; side < 4; ++side)
      for (int k = 0; k < 4; ++k) interval({side, -1 + k / 2.0, -0.5 + k / 2.0}, nullptr, {}, 0);
  }
  void interval(const Arc& arc, const Sector* above, std::array<bool, 2> said, int depth);

  /// Enclosures over the triangle z, z + R1 e(t0), z + R1 e(t1), its points moved by at most rho.
  Sector read_sector(const Arc& arc) {
    const int w = in_.u8();
    if (w > 127) in_.fail("a direction w is not below 128");
    const Scope scope(3);
    const auto from = ray_at(arc.side, arc.t0), to = ray_at(arc.side, arc.t1);
    std::array<Model, 2> at;
    for (std::size_t d = 0; d < 2; ++d) {
      const Ball z = patch_.z[d];
      at[d] = Model::linear(z, r1() * from[d], r1() * to[d]) + Model(Ball::radius(patch_.rho));
    }
    return {w, coefficients(forms(at[0], at[1]))};
  }

  void state(Statement& s, const Sector* sector) {
    if (sector == nullptr) in_.fail("an interval has no sector");
    s.w = sector->w;
    const auto signs = rays_.show(s, sector->over);
    for (std::size_t j = 0; j < 2; ++j)
      if (s.kind[j] == Kind::free || s.kind[j] == Kind::running)
        around_[j].push_back({s.arc, s.w, {s.kind[j] == Kind::free, signs[j], 1}});
  }

  struct Placed {
    Arc arc;
    int w;
    RayInterval interval;
  };
  int branches_of(std::size_t colour) const {
    const auto& around = around_[colour];
    std::vector<RayInterval> intervals;
    for (Index k = 0; k < around.size(); ++k) {
      intervals.push_back(around[k].interval);
      intervals.back().change =
          rays_.change_of_frame(around[k].arc, around[k].w, around[(k + 1) % around.size()].w);
    }
    return count_branches(intervals);
  }

  const Problem& problem_;
  const PatchRecord& patch_;
  Reader in_;
  int sign_ = 1;  ///< kind 0: of F along the axis
  Rays rays_;
  std::array<std::vector<Placed>, 2> around_;
};

void PatchProof::height_over_square() {
  Box box;
  for (Index d = 0; d < 2; ++d) box.side[axis(d)] = side_of_square(d);
  if (patch_.m[0] > patch_.m[1]) in_.fail("m0 is not less than m1");
  const Index m = axis(2);
  std::array<int, 2> sign;
  for (Index k = 0; k < 2; ++k) {
    box.side[m] = Interval(patch_.m[k]);
    sign[k] = divided_sign(in_, box, [&](const Box& b) { return value_sign(problem_.surface, b); });
  }
  box.side[m] = {patch_.m[0], patch_.m[1]};
  Plain d{};
  d[m] = 1;
  sign_ = divided_sign(in_, box, [&](const Box& b) { return slope_sign(problem_.surface, b, d); });
  if (sign[0] == sign[1]) in_.fail("F has one sign at m0 and m1");
}

void PatchProof::immersion_over_square() const {
  for (std::size_t d = 0; d < 2; ++d) {
    const Interval q = side_of_square(d);
    if (problem_.certificate.periodic[d] ? patch_.r >= 0.5 : q.lower() < 0 || 1 < q.upper())
      in_.fail("its square Q is not in the domain");
  }
  Rectangle square;
  for (std::size_t d = 0; d < 2; ++d) {
    square.low[d] = Ball(patch_.z[d]) - Ball(patch_.r);
    square.high[d] = Ball(patch_.z[d]) + Ball(patch_.r);
  }
  shown<Rectangle>(square, kFurther, [&](const Rectangle& part) {
    for (const bool second : {false, true}) {
      const Scope scope(0);
      const auto uv = part.triangle(second);
      const Form<Model> i = problem_.surface.forms(uv[0], uv[1]).i;
      require((scaled(i[0][0] * i[2][0], 4) - i[1][0] * i[1][0]).sign() > 0,
              "patch: det I has no zero on Q");
    }
  });
}

Box PatchProof::umbilic() {
  const Ball rho = Ball::radius(patch_.rho);
  Interval height;
  const Scope scope(3);
  const Forms<Model> f =
      forms(Model(Ball(patch_.z[0]) + rho), Model(Ball(patch_.z[1]) + rho), &height);
  const Coefficients c = coefficients(f);
  const Balls &a = c.a[1][0], &b = c.a[1][1];
  rays_ = Rays(c, r1());
  {
    const Scope values(0);
    const Operator<Model> o = operator_of(forms(Model(patch_.z[0]), Model(patch_.z[1])));
    const std::array<Ball, 2> value = {o.a11[0].range().ball(), o.a12[0].range().ball()};
    for (Index i = 0; i < 2; ++i) {
      const Ball y0 = patch_.y[2 * i], y1 = patch_.y[2 * i + 1];
      Ball k = -(y0 * value[0] + y1 * value[1]);
      for (Index j = 0; j < 2; ++j)
        k = k + (Ball(i == j ? 1.0 : 0.0) - (y0 * a[j] + y1 * b[j])) * rho;
      require(Interval(k).inside(-patch_.rho, patch_.rho), "patch, 2: K(U0) lies inside U0");
    }
  }
  const int index = (a[0] * b[1] - a[1] * b[0]).sign();
  require(index != 0, "patch, 5: det D(a, b) has one sign");
  if (index != patch_.twice_index) in_.fail("its index is " + std::to_string(index) + "/2");
  Box box;
  for (std::size_t d = 0; d < 2; ++d)
    box.side[problem_.surface.implicit() ? axis(d) : d] =
        Interval(patch_.z[d]) + Interval(-patch_.rho, patch_.rho);
  if (problem_.surface.implicit()) box.side[axis(2)] = height;
  return box;
}

void PatchProof::interval(const Arc& arc, const Sector* above, std::array<bool, 2> said,
                          int depth) {
  const unsigned byte = in_.u8();
  if (byte > 31) in_.fail("an interval has unknown bits");
  Sector own;
  if ((byte & 1) != 0) {
    own = read_sector(arc);
    above = &own;
  }
  Statement s = {arc, {}, {}, 0};
  bool open = false, any = false;
  for (std::size_t j = 0; j < 2; ++j) {
    s.kind[j] = static_cast<Kind>(byte >> (1 + 2 * j) & 3);
    if ((s.kind[j] == Kind::said) != said[j]) in_.fail("an interval is said of twice, or never");
    open = open || s.kind[j] == Kind::open;
    any = any || s.kind[j] == Kind::free || s.kind[j] == Kind::running;
    said[j] = s.kind[j] != Kind::open;
  }
  if (s.kind[0] == Kind::running || s.kind[1] == Kind::running)
    s.combination = {in_.f32(), in_.f32()};
  if (any) state(s, above);
  if (!open) return;
  if (depth == kRayDepth) in_.fail("intervals are deeper than 16");
  const double middle = (arc.t0 + arc.t1) / 2;
  interval({arc.side, arc.t0, middle}, above, said, depth + 1);
  interval({arc.side, middle, arc.t1}, above, said, depth + 1);
}

/// Condition 3, by a sweep along the first coordinate.
void check_disjoint(const Problem& problem, std::vector<Box> boxes) {
  const bool implicit = problem.surface.implicit();
  const auto lower = [](const Box& a, const Box& b) {
    return a.side[0].lower() < b.side[0].lower();
  };
  if (!implicit) {  // modulo 1: copies of those near the sides
    const Index n = boxes.size();
    for (Index k = 0; k < n; ++k)
      for (const int du : {0, 1})
        for (const int dv : {0, 1, -1}) {
          if ((du == 0 && dv == 0) || (du != 0 && !problem.certificate.periodic[0]) ||
              (dv != 0 && !problem.certificate.periodic[1]))
            continue;
          Box copy = boxes[k];
          copy.side[0] = copy.side[0] + Interval(du);
          copy.side[1] = copy.side[1] + Interval(dv);
          boxes.push_back(copy);
        }
  }
  std::sort(boxes.begin(), boxes.end(), lower);
  for (Index i = 0; i < boxes.size(); ++i)
    for (Index j = i + 1; j < boxes.size() && boxes[j].side[0].lower() <= boxes[i].side[0].upper();
         ++j) {
      bool apart = false;
      for (Index k = 1; k < (implicit ? 3U : 2U); ++k)
        apart = apart || disjoint(boxes[i].side[k], boxes[j].side[k]);
      if (!apart) throw Rejected("patch, 3: two squares U0 meet");
    }
}

}  // namespace

void check_patches(const Problem& problem) {
  const auto& patches = problem.certificate.patches;
  std::vector<Box> boxes(patches.size());
  in_parallel(patches.size(), [&](Index i) { boxes[i] = PatchProof(problem, patches[i]).check(); });
  check_disjoint(problem, boxes);
}

}  // namespace crest::recheck
