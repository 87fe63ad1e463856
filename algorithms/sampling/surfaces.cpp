// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/sampling/surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace crest::sampling {
namespace {

using std::exp;
using std::sqrt;
using Parameters = std::vector<double>;
using Umbilics = KnownFacts::Umbilics;

struct Entry {
  const char* name;
  const char* parameters;  ///< names with defaults, for list_surfaces
  const char* summary;
  Parameters defaults;
  void (*build)(Surface&, const Parameters&);
};

void require(bool holds, const std::string& what) {
  if (!holds) throw std::invalid_argument(what);
}

void star(Surface& s, Point centre, Point reach) {
  s.shape = Surface::Shape::star;
  s.known.euler_characteristic = 2;
  s.centre = centre;
  s.reach = reach;
  s.ray_origin = [centre](const Point&) { return centre; };
}

void ellipsoid(Surface& s, const Parameters& p) {
  require(p[0] > 0 && p[1] > 0 && p[2] > 0, "ellipsoid: semi-axes must be positive");
  const Real a = 1 / square(Real(p[0])), b = 1 / square(Real(p[1])), c = 1 / square(Real(p[2]));
  s.implicit = implicit([a, b, c](const auto& x, const auto& y, const auto& z) {
    return a * square(x) + b * square(y) + c * square(z) - Real(1);
  });
  star(s, {}, {p[0], p[1], p[2]});
  if (p[0] != p[1] && p[1] != p[2] && p[0] != p[2]) s.known.umbilics = Umbilics{4, 0};
}

// Paper 002, section 9, with the signs that give a closed surface.
void blend(Surface& s, const Parameters&) {
  s.implicit = implicit([](const auto& x, const auto& y, const auto& z) {
    const auto term = [](const auto& u, Real r) { return square((1 / r) * u); };
    const auto q1 = term(x, 0.15L) + term(y, 0.25L) + term(z, 0.35L);
    const auto q2 =
        term(x - Real(0.25L), 0.1L) + term(y - Real(0.1L), 0.2L) + term(z - Real(0.1L), 0.3L);
    return Real(1) - exponential(Real(-0.7L) * (q1 - Real(1))) -
           exponential(Real(-0.7L) * (q2 - Real(1)));
  });
  star(s, {0.15L, 0.06L, 0.05L}, {0.25L, 0.25L, 0.4L});
  s.known.umbilics = Umbilics{6, 2};
}

void quartic_sphere(Surface& s, const Parameters& p) {
  require(p[0] > 0 && std::abs(p[1]) <= 0.5, "quartic-sphere: needs S > 0 and |EPS| <= 0.5");
  const Real a = p[0], e = p[1];
  s.implicit = implicit([a, e](const auto& x, const auto& y, const auto& z) {
    const auto xx = square(x), yy = square(y), zz = square(z);
    const auto cubic = x * yy + Real(0.7L) * (y * zz) - Real(0.4L) * (z * xx) +
                       Real(0.3L) * (x * (y * z)) + Real(0.2L) * (x * xx);
    return square(xx) + square(yy) + square(zz) + a * (xx + yy + zz) + e * cubic - (1 + a);
  });
  star(s, {}, {1, 1, 1});
}

void sphere(Surface& s, const Parameters& p) {
  require(p[0] > 0, "sphere: the radius must be positive");
  const Real r = p[0];
  s.implicit = implicit([r](const auto& x, const auto& y, const auto& z) {
    return square(x) + square(y) + square(z) - r * r;
  });
  star(s, {}, {r, r, r});
  s.exact = [radius = p[0]](const Point&, kernel::MongeForm& m) {
    m.k1 = m.k2 = -1 / radius;
    m.b0 = m.b1 = m.b2 = m.b3 = m.c1 = m.c3 = 0;
    m.c0 = m.c4 = 3 * m.k1 * m.k1 * m.k1;
    m.c2 = m.k1 * m.k1 * m.k1;
  };
}

void torus_shape(Surface& s, Real radius, Real tube) {
  require(tube > 0 && radius > tube, "torus: needs R > r > 0");
  s.shape = Surface::Shape::torus;
  s.known.euler_characteristic = 0;
  s.size = radius;
  s.tube = tube;
  s.ray_origin = [radius](const Point& p) {
    const Real rho = sqrt(p[0] * p[0] + p[1] * p[1]);
    return Point{radius / rho * p[0], radius / rho * p[1], 0};
  };
}

void torus(Surface& s, const Parameters& p) {
  torus_shape(s, p[0], p[1]);
  s.known.umbilics = Umbilics{0, 0};
  const Real big = p[0], small = p[1];
  s.implicit = implicit([big, small](const auto& x, const auto& y, const auto& z) {
    return square(root(square(x) + square(y)) - big) + square(z) - small * small;
  });
  // Reflection in the meridian plane kills the odd terms; the tube is a circle.
  s.exact = [tube = p[1]](const Point&, kernel::MongeForm& m) {
    m.k2 = -1 / tube;
    m.b0 = m.b2 = m.b3 = m.c1 = m.c3 = 0;
    m.c4 = 3 * m.k2 * m.k2 * m.k2;
  };
}

// The stretched tube is flatter at the outer equator than the parallel there, so k1 and k2 change
// places around it and the perturbation leaves isolated umbilics.
void perturbed_torus(Surface& s, const Parameters& p) {
  torus_shape(s, p[0], p[1]);
  require(std::abs(p[2]) <= 0.5, "perturbed-torus: needs |EPS| <= 0.5");
  require(p[3] > 0, "perturbed-torus: needs STRETCH > 0");
  const Real big = p[0], small = p[1], e = p[2], stretch = p[3];
  s.tube = small * (1 + stretch) / 2;
  s.implicit = implicit([big, small, e, stretch](const auto& x, const auto& y, const auto& z) {
    const auto u = (1 / big) * x, v = (1 / big) * y, w = (1 / (stretch * small)) * z;
    const auto g = Real(0.6L) * (u * v) + Real(0.4L) * (u * w) + Real(0.3L) * v -
                   Real(0.25L) * (v * w) + Real(0.2L) * (square(u) * w);
    return square(root(square(x) + square(y)) - big) +
           small * small * (square(w) - e * g - Real(1));
  });
}

void patch_shape(Surface& s, std::function<Point(Real, Real)> chart) {
  s.shape = Surface::Shape::patch;
  s.known.euler_characteristic = 1;
  s.known.boundary_loops = 1;
  s.chart = std::move(chart);
  s.ray_origin = [](const Point& p) { return Point{p[0], p[1], p[2] - 1}; };
}

void plane(Surface& s, const Parameters& p) {
  require(p[0] > 0, "plane: the half side must be positive");
  s.implicit = implicit([](const auto&, const auto&, const auto& z) { return z; });
  patch_shape(s, [a = Real(p[0])](Real u, Real v) { return Point{a * u, a * v, 0}; });
}

void cylinder(Surface& s, const Parameters& p) {
  require(p[0] > 0, "cylinder: the radius must be positive");
  const Real r = p[0];
  s.implicit = implicit(
      [r](const auto& x, const auto& y, const auto&) { return square(x) + square(y) - r * r; });
  patch_shape(s, [r](Real u, Real v) { return Point{r * std::cos(u), r * std::sin(u), r * v}; });
  s.ray_origin = [](const Point& q) { return Point{0, 0, q[2]}; };
  s.exact = [radius = p[0]](const Point&, kernel::MongeForm& m) {
    m.d1 = {0, 0, 1};
    m.n[2] = 0;
    m.k1 = 0;
    m.k2 = -1 / radius;
    m.b0 = m.b1 = m.b2 = m.b3 = m.c0 = m.c1 = m.c2 = m.c3 = 0;
    m.c4 = 3 * m.k2 * m.k2 * m.k2;
  };
}

// z = k (x^2 + y^2) / 2 + cubic / 6 + quartic / 24: an umbilic at the origin with a given cubic.
void umbilic_patch(Surface& s, const Parameters& p) {
  const Real k = p[0], b0 = p[1], b1 = p[2], b2 = p[3], b3 = p[4], half = p[5];
  require(half > 0, "umbilic-patch: HALF must be positive");
  const auto h = [=](const auto& x, const auto& y) {
    const auto xx = square(x), yy = square(y);
    return k / 2 * (xx + yy) +
           Real(1) / 6 * (b0 * (xx * x) + 3 * b1 * (xx * y) + 3 * b2 * (x * yy) + b3 * (yy * y)) +
           Real(1) / 24 *
               (Real(0.3L) * square(xx) + Real(0.8L) * (xx * (x * y)) - Real(0.6L) * (xx * yy) +
                Real(1.0L) * (x * (yy * y)) + Real(0.4L) * square(yy));
  };
  s.implicit = implicit([h](const auto& x, const auto& y, const auto& z) { return z - h(x, y); });
  patch_shape(s, [half, h](Real u, Real v) {
    return Point{half * u, half * v, h(half * u, half * v)};
  });
  // The deviator's linear part ((b0 - b2) x + (b1 - b3) y, 2 b1 x + 2 b2 y) winds once, with the
  // sign of its determinant; larger patches may hold further umbilics.
  const Real turn = (b0 - b2) * b2 - (b1 - b3) * b1;
  if (turn != 0 && half <= 0.5L) s.known.umbilics = turn > 0 ? Umbilics{1, 0} : Umbilics{0, 1};
}

const std::vector<Entry>& entries() {
  static const std::vector<Entry> list = {
      {"ellipsoid", "A=1 B=1.5 C=2", "semi-axes along x, y, z", {1, 1.5, 2}, ellipsoid},
      {"blend", "", "blend of two ellipsoids (paper 002, section 9)", {}, blend},
      {"torus", "R=2 r=1", "not generic: b0 and b3 are zero everywhere", {2, 1}, torus},
      {"perturbed-torus",
       "R=1 r=0.4 EPS=0.3 STRETCH=2",
       "a generic torus with umbilics",
       {1, 0.4, 0.3, 2},
       perturbed_torus},
      {"quartic-sphere",
       "S=1 EPS=0.3",
       "x^4 + y^4 + z^4 + S r^2 + EPS cubic = 1 + S",
       {1, 0.3},
       quartic_sphere},
      {"sphere", "R=1", "degenerate: umbilic everywhere", {1}, sphere},
      {"plane", "HALF=1", "degenerate patch: flat", {1}, plane},
      {"cylinder", "R=1", "degenerate patch: b0 and b3 zero", {1}, cylinder},
      {"umbilic-patch",
       "K=0.5 B0=1 B1=0 B2=-1 B3=0 HALF=0.35",
       "height field with an umbilic (3-ridge by default)",
       {0.5, 1, 0, -1, 0, 0.35},
       umbilic_patch}};
  return list;
}

}  // namespace

Point operator*(const Surface::Rotation& r, const Point& p) {
  return {dot(r[0], p), dot(r[1], p), dot(r[2], p)};
}

Surface::Rotation generic_rotation(int which) {
  // Unit quaternions after normalising.
  constexpr Real table[3][4] = {
      {0.83L, 0.31L, -0.42L, 0.17L}, {0.61L, -0.53L, 0.29L, 0.47L}, {0.37L, 0.71L, 0.23L, -0.59L}};
  require(which >= 0 && which < 3, "generic_rotation: 0, 1 or 2");
  const Real* q = table[which];
  const Real norm = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  const Real w = q[0] / norm, x = q[1] / norm, y = q[2] / norm, z = q[3] / norm;
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
           {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
           {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}}};
}

Point Surface::to_world(const Point& body) const {
  return rotation * body;
}
Point Surface::to_body(const Point& world) const {
  return world[0] * rotation[0] + world[1] * rotation[1] + world[2] * rotation[2];
}

ValueAndGradient Surface::gradient(const Point& world) const {
  ValueAndGradient g = sampling::gradient(*implicit, to_body(world));
  g.gradient = to_world(g.gradient);
  return g;
}

Point Surface::project(const Point& world) const {
  const Point body = to_body(world), origin = ray_origin(body);
  return to_world(project_along_ray(*implicit, origin, body - origin));
}

kernel::MongeForm Surface::monge_form(const Vec3& world) const {
  const Point body = to_body(to_point(world));
  kernel::MongeForm m = sampling::monge_form(*implicit, body);
  if (exact) exact(body, m);
  m.d1 = to_vec3(to_world(to_point(m.d1)));
  m.n = to_vec3(to_world(to_point(m.n)));
  return m;
}

Surface make_surface(const std::string& name, const std::vector<double>& parameters, bool rotate) {
  const auto& list = entries();
  const auto entry =
      std::find_if(list.begin(), list.end(), [&](const Entry& e) { return name == e.name; });
  if (entry == list.end()) throw std::invalid_argument("unknown surface '" + name + "'");
  Parameters values = entry->defaults;
  require(parameters.size() <= values.size(),
          name + ": takes at most " + std::to_string(values.size()) + " parameters");
  std::copy(parameters.begin(), parameters.end(), values.begin());
  for (double v : values) require(std::isfinite(v), name + ": parameters must be finite");
  Surface s;
  s.name = name;
  entry->build(s, values);
  if (rotate) s.rotation = generic_rotation(0);
  return s;
}

std::vector<std::string> list_surfaces() {
  std::vector<std::string> lines;
  for (const Entry& e : entries()) {
    const std::string gap = *e.parameters ? " " : "";
    lines.push_back(std::string(e.name) + gap + e.parameters + ": " + e.summary);
  }
  lines.push_back("handles genus=2: a rounded bar with that many holes (a double torus)");
  return lines;
}

}  // namespace crest::sampling
