// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/second/rays.hpp"

namespace crest::recheck {
namespace {

constexpr int kFurtherRays = 2;

std::vector<Balls> enclosed(const Form<Model>& jets, int k) {
  std::vector<Balls> all;
  const auto& count = Monomials<2>::get().count;
  for (const Jet2<Model>& jet : jets) {
    all.emplace_back();
    for (Index i = count[static_cast<Index>(k)]; i < count[static_cast<Index>(k) + 1]; ++i)
      all.back().push_back(jet[i].range().ball());
  }
  return all;
}

/// e(t); its second coordinate's jets by (r, t) come with t.
Direction<Model> ray(int side, const Jet2<Model>& t) {
  const Jet2<Model> one(1.0);
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
std::array<double, 2> derivative_of_ray(int side) {
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

/// The homogeneous part with these Taylor coefficients, in the direction e.
Jet2<Model> part(const Balls& balls, const Direction<Model>& e) {
  Form<Model> f;
  for (const Ball& b : balls) f.emplace_back(Model(b));
  return evaluate(f, e);
}

/// f = value + r first + r^2 second along the ray; the product rule of jets gives the derivatives
/// of SPEC.md.
Form<Model> along(const std::array<std::vector<Balls>, 3>& at, const std::vector<Balls>& second,
                  const Jet2<Model>& r, const Direction<Model>& e) {
  Form<Model> f;
  for (Index k = 0; k < second.size(); ++k)
    f.push_back(Jet2<Model>(Model(at[0][k][0])) + r * (part(at[1][k], e) + r * part(second[k], e)));
  return f;
}
/// P = first + r second + r^2 third.
Operator<Model> along(const std::array<std::vector<Balls>, 4>& at, const std::vector<Balls>& third,
                      const Jet2<Model>& r, const Direction<Model>& e) {
  std::array<Jet2<Model>, 3> p;
  for (Index k = 0; k < 3; ++k)
    p[k] = part(at[1][k], e) + r * (part(at[2][k], e) + r * part(third[k], e));
  return {p[0], p[1], p[2]};
}

}  // namespace

Coefficients coefficients(const Forms<Model>& f) {
  Coefficients c;
  const Operator<Model> a = operator_of(f);
  const Scope scope(2);
  const Form<Model> e = quintic(f), entries = {a.a11, a.a12, a.a21};
  for (int k = 0; k <= 3; ++k) {
    const auto at = static_cast<Index>(k);
    c.a[at] = enclosed(entries, k);
    if (k == 3) continue;
    c.i[at] = enclosed(f.i, k);
    c.e[at] = enclosed(e, k);
  }
  return c;
}

std::vector<Rectangle> Rectangle::children() const {
  std::vector<Rectangle> all;
  const std::array<Ball, 2> middle = {scaled(low[0] + high[0], 1, 2),
                                      scaled(low[1] + high[1], 1, 2)};
  for (const bool i : {false, true})
    for (const bool j : {false, true})
      all.push_back({{i ? middle[0] : low[0], j ? middle[1] : low[1]},
                     {i ? high[0] : middle[0], j ? high[1] : middle[1]}});
  return all;
}
std::array<Model, 2> Rectangle::triangle(bool second) const {
  const Ball x = high[0] - low[0], y = high[1] - low[1], none;
  return {Model::linear(low[0], second ? none : x, x), Model::linear(low[1], second ? y : none, y)};
}

std::array<Ball, 2> ray_at(int side, double t) {
  const Direction<Model> e = ray(side, Jet2<Model>(t));
  return {e[0][0].range().ball(), e[1][0].range().ball()};
}

std::array<int, 2> Rays::show(const Statement& s, const Coefficients& sector) const {
  std::array<int, 2> signs{};
  const Rectangle whole = {{Ball(0.0), Ball(s.arc.t0)}, {length_, Ball(s.arc.t1)}};
  shown<Rectangle>(whole, kFurtherRays, [&](const Rectangle& part) {
    for (const bool second : {false, true}) show_on(s, sector, part.triangle(second), signs);
  });
  return signs;
}

void Rays::show_on(const Statement& s, const Coefficients& sector, const std::array<Model, 2>& at,
                   std::array<int, 2>& signs) const {
  const bool runs = s.kind[0] == Kind::running || s.kind[1] == Kind::running;
  const Scope scope(runs ? 1 : 0);
  const Jet2<Model> r(at[0], {Model(1.0), Model()}), t(at[1], {Model(), Model(1.0)});
  const Direction<Model> e = ray(s.arc.side, t);
  const Form<Model> i = along(at_.i, sector.i[2], r, e), form = along(at_.e, sector.e[2], r, e);
  const Operator<Model> p = along(at_.a, sector.a[3], r, e);
  const auto w = direction(s.w);
  require(definite(i, p, w).sign() > 0, "patch, 4: I(w, P w) > 0");
  const auto v = directions(i, p, w);
  std::array<Jet2<Model>, 2> value;
  for (std::size_t j = 0; j < 2; ++j)
    if (runs || s.kind[j] == Kind::free) value[j] = evaluate(form, v[j]);
  for (std::size_t j = 0; j < 2; ++j) {
    if (s.kind[j] != Kind::free && s.kind[j] != Kind::running) continue;
    const int sign = value[j][s.kind[j] == Kind::free ? 0 : 2].sign();
    require(sign != 0 && sign != -signs[j], "patch, 4: E_j, or its derivative, has no zero");
    signs[j] = sign;
    if (s.kind[j] == Kind::free) continue;
    const auto e1 = derivative_of_ray(s.arc.side);
    const Model &v0 = v[j][0][0], &v1 = v[j][1][0];
    const Model in_e = v0 * Model(e1[1]) - v1 * Model(e1[0]), in_t = e[0][0] * v1 - e[1][0] * v0;
    require((r[0] * in_e * value[j][1] + in_t * value[j][2]).sign() != 0,
            "patch, 4: G_j has no zero");
  }
  if (!runs) return;
  const Model sum = Model(s.combination[0]) * value[0][0] + Model(s.combination[1]) * value[1][0];
  require(sum.sign() != 0, "patch, 4: a combination has no zero");
}

int Rays::change_of_frame(const Arc& arc, int w, int next) const {
  if (w == next) return 1;
  const Scope scope(0);
  const Direction<Model> e = ray(arc.side, Jet2<Model>(arc.t1));
  const Form<Model> i = along(at_.i, std::vector<Balls>(3, Balls(3)), Jet2<Model>(), e);
  const Operator<Model> p = along(at_.a, std::vector<Balls>(3, Balls(4)), Jet2<Model>(), e);
  const Direction<Model> v = directions(i, p, direction(w))[0];
  const auto other = direction(next);
  const Jet2<Model> i12 = scaled(i[1], 1, 2);
  const Jet2<Model> product =
      scaled(i[0] * v[0] + i12 * v[1], other[0], 1) + scaled(i12 * v[0] + i[2] * v[1], other[1], 1);
  require(product[0].sign() != 0, "patch, 4: the change of frame");
  return product[0].sign();
}

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

}  // namespace crest::recheck
