// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/second/patches.hpp"

#include <algorithm>

#include "certify/second/vectors.hpp"

namespace crest::recheck {
namespace {

constexpr int kRayDepth = 16, kRayFurther = 2;

using Balls = std::vector<Ball>;

/// The coefficients of degree k of jets, as numbers that enclose them on all of the set.
std::vector<Balls> enclosed(const Form& jets, int k) {
  std::vector<Balls> all;
  const auto& count = Monomials<2>::get().count;
  for (const Jet2& jet : jets) {
    all.emplace_back();
    for (Index i = count[static_cast<Index>(k)]; i < count[static_cast<Index>(k) + 1]; ++i)
      all.back().push_back(jet[i].range().ball());
  }
  return all;
}

/// Taylor coefficients by degree of I (3), the entries of A (3), the coefficients of E (6).
struct Coefficients {
  std::vector<Balls> i[3], a[4], e[3];
};

Coefficients coefficients(const Forms& f, const Operator& a) {
  Coefficients c;
  const Scope scope(2);
  const Form e = quintic(f), entries = {a.a11, a.a12, a.a21};
  for (int k = 0; k <= 3; ++k) {
    c.a[k] = enclosed(entries, k);
    if (k == 3) continue;
    c.i[k] = enclosed(f.i, k);
    c.e[k] = enclosed(e, k);
  }
  return c;
}

/// [low, high] in two coordinates, as two triangles.
struct Rectangle {
  std::array<Ball, 2> low, high;
  std::vector<Rectangle> children() const {
    std::vector<Rectangle> all;
    const std::array<Ball, 2> middle = {scaled(low[0] + high[0], 1, 2),
                                        scaled(low[1] + high[1], 1, 2)};
    for (const bool i : {false, true})
      for (const bool j : {false, true})
        all.push_back({{i ? middle[0] : low[0], j ? middle[1] : low[1]},
                       {i ? high[0] : middle[0], j ? high[1] : middle[1]}});
    return all;
  }
  /// (low, low), then (high, low) or (low, high), then (high, high).
  std::array<Model, 2> triangle(bool second) const {
    return {Model::linear(low[0], second ? low[0] : high[0], high[0]),
            Model::linear(low[1], second ? high[1] : low[1], high[1])};
  }
};

/// A sector: [D^2 I], [D^3 A], [D^2 E] over its triangle, and its direction.
struct Sector {
  int w;
  Coefficients over;
};

/// What holds at an interval of t, before signs are compared.
struct Statement {
  int side;
  double t0, t1;
  std::array<int, 2> kind{};  ///< by colour: kFree, kRunning, or nothing here
  std::array<double, 2> combination{};
};
constexpr int kOpen = 0, kFree = 1, kRunning = 2, kSaid = 3;

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
    return Interval(patch_.z[d]) + Interval(Float(-patch_.r), Float(patch_.r));
  }

  /// Kind 0: S is a graph over Q.
  void height_over_square() {
    Box box;
    for (Index d = 0; d < 2; ++d) box.side[axis(d)] = side_of_square(d);
    if (patch_.m[0] > patch_.m[1]) in_.fail("m0 is not less than m1");
    const Index m = axis(2);
    std::array<int, 2> sign;
    for (Index k = 0; k < 2; ++k) {
      box.side[m] = Interval(patch_.m[k]);
      sign[k] =
          divided_sign(in_, box, [&](const Box& b) { return value_sign(problem_.surface, b); });
    }
    box.side[m] = {patch_.m[0], patch_.m[1]};
    Plain d{};
    d[m] = 1;
    sign_ =
        divided_sign(in_, box, [&](const Box& b) { return slope_sign(problem_.surface, b, d); });
    if (sign[0] == sign[1]) in_.fail("F has one sign at m0 and m1");
  }

  /// Kind 1: Q is in the domain, and X an immersion of it.
  void immersion_over_square() const {
    for (std::size_t d = 0; d < 2; ++d) {
      const Interval q = side_of_square(d);
      if (problem_.certificate.periodic[d] ? patch_.r >= 0.5
                                           : q.lower().sign() < 0 || Float(1) < q.upper())
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
        const Form i = problem_.surface.forms(uv[0], uv[1]).i;
        require(scaled(i[0][0] * i[2][0], 4).range().sign() > 0 &&
                    (scaled(i[0][0] * i[2][0], 4) - i[1][0] * i[1][0]).sign() > 0,
                "patch: det I has no zero on Q");
      }
    });
  }

  /// The forms over a set of the plane; kind 0: and the heights.
  Forms forms(const Model& p, const Model& q, Interval* height = nullptr) const {
    if (!problem_.surface.implicit()) return problem_.surface.forms(p, q);
    const Model a = p - Model(patch_.z[0]), b = q - Model(patch_.z[1]);
    const auto& g = patch_.g;
    Fibre fibre;
    fibre.base[axis(0)] = p;
    fibre.base[axis(1)] = q;
    fibre.base[axis(2)] = Model(g[0]) + Model(g[1]) * a + Model(g[2]) * b + Model(g[3]) * a * a +
                          Model(g[4]) * a * b + Model(g[5]) * b * b;
    fibre.along[axis(2)] = Model(sign_);
    fibre.h = problem_.h(patch_.c);
    const Foot foot = problem_.surface.foot(fibre, 1);
    const Interval m = foot.x[axis(2)].range();
    require(m.inside(patch_.m[0], patch_.m[1]), "patch: the heights lie between m0 and m1");
    if (height != nullptr) *height = m;
    const Jet3 f = problem_.surface.expand(foot.x, frame_of_axis(axis(2), sign_), jet_degree());
    return problem_.surface.forms(f, sign_);
  }

  /// Conditions 2 and 5; D at z* for the rays.
  Box umbilic() {
    const Ball rho = Ball::radius(patch_.rho);
    Interval height;
    const Scope scope(3);
    const Forms f = forms(Model(Ball(patch_.z[0]) + rho), Model(Ball(patch_.z[1]) + rho), &height);
    at_umbilic_ = coefficients(f, operator_of(f));
    const Balls &a = at_umbilic_.a[1][0], &b = at_umbilic_.a[1][1];
    {
      const Scope values(0);
      const Operator o = operator_of(forms(Model(patch_.z[0]), Model(patch_.z[1])));
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
          Interval(patch_.z[d]) + Interval(Float(-patch_.rho), Float(patch_.rho));
    if (problem_.surface.implicit()) box.side[axis(2)] = height;
    return box;
  }

  /// e(t) of a side as jets in (r, t).
  static Direction ray(int side, const Jet2& t) {
    const Jet2 one(1.0);
    switch (side) {
      case 0:
        return {one, t};
      case 1:
        return {-t, one};
      case 2:
        return {-one, -t};
      default:
        return {t, -one};
    }
  }
  static std::array<double, 2> derivative_of_ray(int side) {
    switch (side) {
      case 0:
        return {0, 1};
      case 1:
        return {-1, 0};
      case 2:
        return {0, -1};
      default:
        return {1, 0};
    }
  }

  /// Condition 4: reads all intervals and shows what is said of them.
  void rays() {
    for (int side = 0; side < 4; ++side)
      for (int k = 0; k < 4; ++k) interval(side, -1 + k / 2.0, -0.5 + k / 2.0, nullptr, {}, 0);
  }
  void interval(int side, double t0, double t1, const Sector* above, std::array<bool, 2> said,
                int depth) {
    const unsigned byte = in_.u8();
    if (byte > 31) in_.fail("an interval has unknown bits");
    Sector own;
    if ((byte & 1) != 0) {
      own.w = in_.u8();
      if (own.w > 127) in_.fail("a direction w is not below 128");
      read_sector(own, side, t0, t1);
      above = &own;
    }
    Statement s = {side, t0, t1, {}, {}};
    bool open = false, any = false;
    for (std::size_t j = 0; j < 2; ++j) {
      const int kind = static_cast<int>(byte >> (1 + 2 * j) & 3);
      if ((kind == kSaid) != said[j]) in_.fail("an interval is said of twice, or never");
      s.kind[j] = kind;
      open = open || kind == kOpen;
      any = any || kind == kFree || kind == kRunning;
      said[j] = kind != kOpen;
    }
    if (s.kind[0] == kRunning || s.kind[1] == kRunning) s.combination = {in_.f32(), in_.f32()};
    if (any && above == nullptr) in_.fail("an interval has no sector");
    if (any) show(s, *above);
    if (!open) return;
    if (depth == kRayDepth) in_.fail("intervals are deeper than 16");
    const double middle = (t0 + t1) / 2;
    interval(side, t0, middle, above, said, depth + 1);
    interval(side, middle, t1, above, said, depth + 1);
  }

  void read_sector(Sector& sector, int side, double t0, double t1) const {
    const Scope scope(3);
    const Ball rho = Ball::radius(patch_.rho);
    std::array<Model, 2> at;
    const auto from = ray(side, Jet2(t0)), to = ray(side, Jet2(t1));
    for (std::size_t d = 0; d < 2; ++d) {
      const Ball z = patch_.z[d];
      at[d] = Model::linear(z, z + r1() * from[d][0].range().ball(),
                            z + r1() * to[d][0].range().ball()) +
              Model(rho);
    }
    const Forms f = forms(at[0], at[1]);
    sector.over = coefficients(f, operator_of(f));
  }

  static Form constants(const Balls& balls) {
    Form f;
    for (const Ball& b : balls) f.emplace_back(Model(b));
    return f;
  }
  /// f along the ray from its value and derivatives; P for A.
  static Jet2 along(const Balls& value, const Balls& first, const Balls& second, const Jet2& r,
                    const Direction& e) {
    const Jet2 rest = evaluate(constants(first), e) + r * evaluate(constants(second), e);
    return value.empty() ? rest : Jet2(Model(value[0])) + r * rest;
  }
  static Jet2 blown_up(const Balls& first, const Balls& second, const Balls& third, const Jet2& r,
                       const Direction& e) {
    return evaluate(constants(first), e) +
           r * (evaluate(constants(second), e) + r * evaluate(constants(third), e));
  }
  Operator operator_along(const Sector& sector, const Jet2& r, const Direction& e) const {
    std::array<Jet2, 3> p;
    for (Index k = 0; k < 3; ++k)
      p[k] = blown_up(at_umbilic_.a[1][k], at_umbilic_.a[2][k], sector.over.a[3][k], r, e);
    return {p[0], p[1], p[2]};
  }
  Form form_along(const std::vector<Balls> (&at)[3], const std::vector<Balls> (&over)[3],
                  const Jet2& r, const Direction& e) const {
    Form f;
    for (Index k = 0; k < at[0].size(); ++k)
      f.push_back(along(at[0][k], at[1][k], over[2][k], r, e));
    return f;
  }

  void show(const Statement& s, const Sector& sector) {
    std::array<int, 2> signs{};
    const Rectangle whole = {{Ball(0.0), Ball(s.t0)}, {r1(), Ball(s.t1)}};
    shown<Rectangle>(whole, kRayFurther, [&](const Rectangle& part) {
      for (const bool second : {false, true}) show_on(s, sector, part.triangle(second), signs);
    });
    for (std::size_t j = 0; j < 2; ++j)
      if (s.kind[j] == kFree || s.kind[j] == kRunning)
        around_[j].push_back({s.side, s.t1, sector.w, {s.kind[j] == kFree, signs[j], 1}});
  }
  void show_on(const Statement& s, const Sector& sector, const std::array<Model, 2>& at,
               std::array<int, 2>& signs) const {
    const bool runs = s.kind[0] == kRunning || s.kind[1] == kRunning;
    const Scope scope(runs ? 1 : 0);
    const Jet2 r(at[0], {Model(1.0), Model()}), t(at[1], {Model(), Model(1.0)});
    const Direction e = ray(s.side, t);
    const Form i = form_along(at_umbilic_.i, sector.over.i, r, e),
               form = form_along(at_umbilic_.e, sector.over.e, r, e);
    const Operator p = operator_along(sector, r, e);
    require(definite({i, {}, {}, {}}, p, direction(sector.w)).sign() > 0,
            "patch, 4: I(w, P w) > 0");
    const auto v = directions(i, p, direction(sector.w));
    std::array<Jet2, 2> value;
    for (std::size_t j = 0; j < 2; ++j)
      if (runs || s.kind[j] == kFree) value[j] = evaluate(form, v[j]);
    const auto note = [&](std::size_t j, const Model& x) {
      const int sign = x.sign();
      require(sign != 0 && sign != -signs[j], "patch, 4: E_j, or its derivative, has no zero");
      signs[j] = sign;
    };
    for (std::size_t j = 0; j < 2; ++j) {
      if (s.kind[j] == kFree) note(j, value[j][0]);
      if (s.kind[j] != kRunning) continue;
      note(j, value[j][2]);
      const auto e1 = derivative_of_ray(s.side);
      const Model &v0 = v[j][0][0], &v1 = v[j][1][0];
      const Model in_e = v0 * Model(e1[1]) - v1 * Model(e1[0]);
      const Model in_t = e[0][0] * v1 - e[1][0] * v0;
      require((r[0] * in_e * value[j][1] + in_t * value[j][2]).sign() != 0,
              "patch, 4: G_j has no zero");
    }
    if (runs)
      require(
          (Model(s.combination[0]) * value[0][0] + Model(s.combination[1]) * value[1][0]).sign() !=
              0,
          "patch, 4: a combination has no zero");
  }

  struct Placed {
    int side;
    double end;
    int w;
    RayInterval interval;
  };
  /// Of the frame, at the end of an interval, to the direction of the next one.
  int change_of_frame(const Placed& from, int w) const {
    if (from.w == w) return 1;
    const Scope scope(0);
    const Direction e = ray(from.side, Jet2(from.end));
    Form i;
    for (const Balls& value : at_umbilic_.i[0]) i.emplace_back(Model(value[0]));
    std::array<Jet2, 3> p;
    for (Index k = 0; k < 3; ++k) p[k] = evaluate(constants(at_umbilic_.a[1][k]), e);
    const Direction v = directions(i, {p[0], p[1], p[2]}, direction(from.w))[0];
    const auto next = direction(w);
    const Jet2 i12 = scaled(i[1], 1, 2);
    const int sign = (scaled(i[0] * v[0] + i12 * v[1], next[0], 1) +
                      scaled(i12 * v[0] + i[2] * v[1], next[1], 1))[0]
                         .sign();
    require(sign != 0, "patch, 4: the change of frame");
    return sign;
  }
  int branches_of(std::size_t colour) {
    auto& around = around_[colour];
    std::vector<RayInterval> intervals;
    for (Index k = 0; k < around.size(); ++k) {
      around[k].interval.change = change_of_frame(around[k], around[(k + 1) % around.size()].w);
      intervals.push_back(around[k].interval);
    }
    return count_branches(intervals);
  }

  const Problem& problem_;
  const PatchRecord& patch_;
  Reader in_;
  int sign_ = 1;  ///< kind 0: of F along the axis
  Coefficients at_umbilic_;
  std::array<std::vector<Placed>, 2> around_;
};

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

int count_branches(const std::vector<RayInterval>& around) {
  const auto fail = [] { throw Rejected("patch, 4: the signs around an umbilic do not fit"); };
  const Index n = around.size();
  Index first = 0;
  int total = 1;
  for (const RayInterval& i : around) total *= i.change;
  while (first < n && !around[first].free) ++first;
  if (first == n || total != -1) fail();
  int frame = 1, before = around[first].sign, run = 0, branches = 0;
  for (Index k = 1; k <= n; ++k) {
    frame *= around[(first + k - 1) % n].change;
    const RayInterval& now = around[(first + k) % n];
    const int sign = frame * now.sign;
    if (!now.free) {
      if (run == -sign) fail();
      run = sign;
      continue;
    }
    if (sign != before) {
      if (run != sign) fail();
      ++branches;
    }
    before = sign;
    run = 0;
  }
  return branches;
}

void check_patches(const Problem& problem) {
  const auto& patches = problem.certificate.patches;
  std::vector<Box> boxes(patches.size());
  in_parallel(patches.size(), [&](Index i) { boxes[i] = PatchProof(problem, patches[i]).check(); });
  check_disjoint(problem, boxes);
}

}  // namespace crest::recheck
