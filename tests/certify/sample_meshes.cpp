// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/certify/sample_meshes.hpp"

#include <cmath>
#include <map>

#include "tests/support/environment.hpp"

namespace crest::tests {
namespace {

using certify::MeshData;
using u32 = std::uint32_t;
using V3 = std::array<double, 3>;

void normalize(V3& v) {
  const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  for (double& x : v) x /= length;
}
V3 cross(const V3& a, const V3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const V3& a, const V3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void add_monge(MeshData& data) {
  data.monge.assign(data.positions.size(), {1, 0, 0, 0, 0, 1});
}

u32 middle(MeshData& data, std::map<std::pair<u32, u32>, u32>& known, u32 a, u32 b) {
  const auto [entry, fresh] =
      known.emplace(std::pair(std::min(a, b), std::max(a, b)), data.positions.size());
  if (fresh) {
    V3 p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = data.positions[a][i] + data.positions[b][i];
    normalize(p);
    data.positions.push_back(p);
  }
  return entry->second;
}

/// b_i as derivatives of smooth functions along d1 and d2 = n x d1: odd in the frame, as they
/// must be. The amplitude of c mixes the types.
void smooth_extremalities(MeshData& data) {
  for (std::size_t v = 0; v < data.monge.size(); ++v) {
    auto& m = data.monge[v];
    const auto& p = data.positions[v];
    const V3 d1 = {m[0], m[1], m[2]}, n = {m[3], m[4], m[5]}, d2 = cross(n, d1);
    const V3 g = {p[1] * p[2] + 0.3, p[0] * p[0] - p[2], p[0] - 2 * p[1] * p[1]};
    const V3 h = {p[0], -p[1] * p[2], p[1] + p[2]};
    m[8] = dot(g, d1), m[9] = dot(h, d1), m[10] = dot(g, d2), m[11] = dot(h, d2);
    m[12] = p[0] - p[1], m[13] = p[2] + 0.5 * p[0];
  }
}

/// Two disjoint copies, the second moved away.
MeshData two_of(const MeshData& one) {
  MeshData out = one;
  const auto shift = static_cast<u32>(one.positions.size());
  for (auto f : one.faces) out.faces.push_back({f[0] + shift, f[1] + shift, f[2] + shift});
  for (auto p : one.positions) out.positions.push_back({p[0] + 5, p[1], p[2]});
  out.monge.insert(out.monge.end(), one.monge.begin(), one.monge.end());
  return out;
}

/// Frames along the coordinate axes: many products are exactly zero.
void axis_frames(MeshData& data, Random& random) {
  for (auto& m : data.monge) {
    const std::size_t axis = random() % 3;
    for (std::size_t i = 0; i < 3; ++i) m[i] = i == axis ? (random() % 2 ? 1 : -1) : 0;
    for (std::size_t i = 8; i < 14; ++i) m[i] = static_cast<double>(random() % 3) - 1;
  }
}

/// On a plane: d1 is (1, 0, 1) or (-1, 0, 2) at random. Products are positive, projections
/// opposite: rotations are exactly half turns.
void tie_frames(MeshData& data, Random& random) {
  for (auto& m : data.monge) {
    const bool back = random() % 2;
    m[0] = back ? -1 : 1, m[1] = 0, m[2] = back ? 2 : 1;
    m[3] = 0, m[4] = 0, m[5] = 1;
  }
}

}  // namespace

double uniform(Random& random) {
  return std::ldexp(static_cast<double>(static_cast<std::int64_t>(random())), -63);
}

MeshData icosphere(int level) {
  MeshData data;
  const double g = (1 + std::sqrt(5.0)) / 2;
  for (int i = 0; i < 3; ++i)
    for (const double s : {-1.0, 1.0})
      for (const double t : {-g, g}) {
        V3 p{};
        p[static_cast<std::size_t>(i)] = 0;
        p[static_cast<std::size_t>((i + 1) % 3)] = s;
        p[static_cast<std::size_t>((i + 2) % 3)] = t;
        normalize(p);
        data.positions.push_back(p);
      }
  // Faces: triples of mutual neighbours, oriented outward.
  const auto near = [&](u32 a, u32 b) { return dot(data.positions[a], data.positions[b]) > 0.4; };
  for (u32 a = 0; a < 12; ++a)
    for (u32 b = a + 1; b < 12; ++b)
      for (u32 c = b + 1; c < 12; ++c) {
        if (!near(a, b) || !near(b, c) || !near(a, c)) continue;
        const bool out = dot(data.positions[a], cross(data.positions[b], data.positions[c])) > 0;
        data.faces.push_back({a, out ? b : c, out ? c : b});
      }
  for (int l = 0; l < level; ++l) {
    std::map<std::pair<u32, u32>, u32> known;
    std::vector<std::array<u32, 3>> faces;
    for (const auto f : data.faces) {
      const u32 m[3] = {middle(data, known, f[0], f[1]), middle(data, known, f[1], f[2]),
                        middle(data, known, f[2], f[0])};
      faces.insert(
          faces.end(),
          {{f[0], m[0], m[2]}, {f[1], m[1], m[0]}, {f[2], m[2], m[1]}, {m[0], m[1], m[2]}});
    }
    data.faces = faces;
  }
  add_monge(data);
  return data;
}

MeshData torus(u32 m, u32 n) {
  MeshData data;
  for (u32 i = 0; i < m; ++i)
    for (u32 j = 0; j < n; ++j) {
      const double s = 2 * M_PI * i / m, t = 2 * M_PI * j / n, r = 2 + std::cos(t);
      data.positions.push_back({r * std::cos(s), r * std::sin(s), std::sin(t)});
      const u32 a = i * n + j, b = (i + 1) % m * n + j, c = (i + 1) % m * n + (j + 1) % n,
                d = i * n + (j + 1) % n;
      data.faces.push_back({a, b, c});
      data.faces.push_back({a, c, d});
      data.monge.push_back({-std::sin(t) * std::cos(s), -std::sin(t) * std::sin(s), std::cos(t),
                            std::cos(t) * std::cos(s), std::cos(t) * std::sin(s), std::sin(t), 1,
                            std::cos(t) / r});
    }
  return data;
}

MeshData grid(u32 m, u32 n, bool hole) {
  MeshData data;
  for (u32 i = 0; i <= m; ++i)
    for (u32 j = 0; j <= n; ++j)
      data.positions.push_back({static_cast<double>(i), static_cast<double>(j), 0});
  for (u32 i = 0; i < m; ++i)
    for (u32 j = 0; j < n; ++j) {
      if (hole && i == m / 2 && j == n / 2) continue;
      const u32 a = i * (n + 1) + j, b = a + n + 1;
      data.faces.push_back({a, b, b + 1});
      data.faces.push_back({a, b + 1, a + 1});
    }
  add_monge(data);
  return data;
}

MeshData ellipsoid(int level, double a, double b, double c) {
  MeshData data = icosphere(level);
  const V3 q = {2 / (a * a), 2 / (b * b), 2 / (c * c)};
  for (std::size_t v = 0; v < data.positions.size(); ++v) {
    auto& p = data.positions[v];
    // A turn about a generic axis keeps vertices off the planes of symmetry.
    const V3 turned = {0.36 * p[0] + 0.48 * p[1] - 0.8 * p[2], -0.8 * p[0] + 0.6 * p[1],
                       0.48 * p[0] + 0.64 * p[1] + 0.6 * p[2]};
    p = {a * turned[0], b * turned[1], c * turned[2]};
    const V3 gradient = {q[0] * p[0], q[1] * p[1], q[2] * p[2]};
    V3 n = gradient;
    normalize(n);
    V3 s = std::fabs(n[0]) < 0.7 ? cross(n, {1, 0, 0}) : cross(n, {0, 1, 0});
    normalize(s);
    const V3 t = cross(n, s);
    const auto second = [&](const V3& x, const V3& y) {
      return -(q[0] * x[0] * y[0] + q[1] * x[1] * y[1] + q[2] * x[2] * y[2]) /
             std::sqrt(dot(gradient, gradient));
    };
    const double e = second(s, s), f = second(s, t), g = second(t, t);
    const double angle = 0.5 * std::atan2(2 * f, e - g), gap = std::hypot((e - g) / 2, f);
    auto& m = data.monge[v];
    for (std::size_t i = 0; i < 3; ++i) {
      m[i] = std::cos(angle) * s[i] + std::sin(angle) * t[i];
      m[3 + i] = n[i];
    }
    m[6] = (e + g) / 2 + gap, m[7] = (e + g) / 2 - gap;
  }
  smooth_extremalities(data);
  return data;
}

void randomize_monge(MeshData& data, Random& random) {
  for (auto& m : data.monge) {
    for (double& x : m) x = uniform(random);
    if (m[6] < m[7]) std::swap(m[6], m[7]);
  }
}

void scale_positions(MeshData& data, double factor) {
  for (auto& p : data.positions)
    for (double& x : p) x *= factor;
}

std::vector<Sample> all_samples() {
  Random random(kSeed);
  std::vector<Sample> out;
  const auto add = [&](const std::string& name, MeshData data) {
    out.push_back({name, std::move(data)});
  };
  add("ellipsoid, 42 vertices", ellipsoid(1, 1, 1.5, 2));
  add("ellipsoid, 162 vertices", ellipsoid(2, 1, 1.5, 2));
  MeshData random_sphere = icosphere(1);
  randomize_monge(random_sphere, random);
  add("random sphere", random_sphere);
  add("two random spheres", two_of(random_sphere));
  add("torus, b = 0", torus(5, 4));
  MeshData random_torus = torus(4, 4);
  randomize_monge(random_torus, random);
  add("random torus", random_torus);
  MeshData annulus = grid(5, 5, true);
  smooth_extremalities(annulus);
  add("annulus", annulus);
  randomize_monge(annulus, random);
  add("random annulus", annulus);
  MeshData triangle;
  triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.faces = {{0, 1, 2}};
  add_monge(triangle);
  randomize_monge(triangle, random);
  add("one triangle", triangle);
  MeshData axes = icosphere(1);
  axis_frames(axes, random);
  add("axis frames", axes);
  MeshData plane = grid(4, 4);
  axis_frames(plane, random);
  add("axis frames in a plane", plane);
  tie_frames(plane, random);
  add("half-turn ties", plane);
  for (const double factor : {0x1p-500, 0x1p-150, 0x1p150, 0x1p400}) {
    MeshData scaled = random_sphere;
    scale_positions(scaled, factor);
    add("random sphere times " + std::to_string(std::ilogb(factor)) + " bits", scaled);
  }
  MeshData tilted = random_sphere;
  for (std::size_t v = 0; v < tilted.monge.size(); v += 2)
    for (std::size_t i = 0; i < 3; ++i) tilted.monge[v][i] = tilted.monge[v][3 + i];
  add("d1 parallel to n", tilted);
  MeshData steep = random_sphere;
  for (std::size_t v = 0; v < steep.monge.size(); ++v)
    for (std::size_t i = 0; i < 3; ++i)
      steep.monge[v][i] = steep.monge[v][3 + i] + 1e-14 * uniform(random);
  add("d1 nearly parallel to n", steep);
  return out;
}

}  // namespace crest::tests
