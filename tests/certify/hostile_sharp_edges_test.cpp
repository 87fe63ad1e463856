// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 5 on small meshes with numbers and angles that no one would give: what is accepted says
// what SPEC.md says of its data, by a count of its own in rationals and 1000 digits.
#include <boost/multiprecision/gmp.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <iostream>
#include <map>
#include <set>

#include "certify/sharp_edges/encode.hpp"
#include "certify/verify.hpp"
#include "tests/support/degenerate_families.hpp"
#include "tests/support/failures.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

using u32 = std::uint32_t;
using Q = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                        boost::multiprecision::et_off>;
using Real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<1000>,
                                           boost::multiprecision::et_off>;
using Vector = std::array<Q, 3>;
using Faces = std::vector<std::array<u32, 3>>;
using Sides = std::map<std::array<u32, 2>, std::vector<std::array<u32, 2>>>;

Q dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// All that claim 5 says of its data, by the shortest way there is.
class Recount {
 public:
  explicit Recount(SharpEdgesCertificate data) : truth(std::move(data)) {
    for (u32 f = 0; f < truth.faces.size(); ++f)
      for (u32 k = 0; k < 3; ++k) {
        const u32 a = truth.faces[f][k], b = truth.faces[f][(k + 1) % 3];
        sides_[{std::min(a, b), std::max(a, b)}].push_back({f, a < b});
      }
    valid = !truth.faces.empty() && is_manifold() && has_area() && is_angle();
    if (valid) count();
  }
  SharpEdgesCertificate truth;
  bool valid;

 private:
  Sides sides_;

  bool is_manifold() const {
    std::set<std::set<u32>> sets;
    for (const auto& f : truth.faces) {
      const std::set<u32> set(f.begin(), f.end());
      if (set.size() != 3 || *set.rbegin() >= truth.positions.size() || !sets.insert(set).second)
        return false;
    }
    for (const auto& [edge, faces] : sides_)
      if (faces.size() > 2 || (faces.size() == 2 && faces[0][1] == faces[1][1])) return false;
    for (u32 v = 0; v < truth.positions.size(); ++v)
      if (!is_fan(v)) return false;
    return true;
  }
  /// Its faces hang together by edges at it.
  bool is_fan(u32 v) const {
    std::vector<u32> around;
    for (u32 f = 0; f < truth.faces.size(); ++f)
      if (std::count(truth.faces[f].begin(), truth.faces[f].end(), v) > 0) around.push_back(f);
    if (around.empty()) return false;
    std::set<u32> reached = {around[0]};
    for (std::size_t round = 0; round < around.size(); ++round)
      for (const auto& [edge, faces] : sides_)
        if ((edge[0] == v || edge[1] == v) && faces.size() == 2 &&
            (reached.count(faces[0][0]) > 0 || reached.count(faces[1][0]) > 0))
          reached.insert({faces[0][0], faces[1][0]});
    return reached.size() == around.size();
  }
  Vector normal(u32 f) const {
    std::array<Vector, 3> p;
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i) p[k][i] = Q(truth.positions[truth.faces[f][k]][i]);
    Vector a, b;
    for (std::size_t i = 0; i < 3; ++i) a[i] = p[1][i] - p[0][i], b[i] = p[2][i] - p[0][i];
    return cross(a, b);
  }
  bool has_area() const {
    for (u32 f = 0; f < truth.faces.size(); ++f) {
      const Vector n = normal(f);
      if (dot(n, n) == 0) return false;
    }
    return true;
  }
  bool is_angle() const {
    const std::string& a = truth.angle;
    if (a.size() > 100 || a.find_first_not_of("0123456789.") != std::string::npos) return false;
    const auto points = std::count(a.begin(), a.end(), '.');
    return points <= 1 && a.size() > static_cast<std::size_t>(points) && Real(padded()) <= 180;
  }
  std::string padded() const { return "0" + truth.angle + (truth.angle.back() == '.' ? "0" : ""); }

  /// 1: above the angle, 0: equal, as far as 900 digits tell, or the exact signs at 0, 90, 180.
  int compare(u32 f, u32 g) const {
    const Vector m = normal(f), n = normal(g), x = cross(m, n);
    const Q s = dot(m, n), xx = dot(x, x);
    const Real degrees(padded());
    if (degrees == 180) return xx == 0 && s < 0 ? 0 : -1;
    if (degrees == 90) return s < 0 ? 1 : s == 0 ? 0 : -1;
    if (degrees == 0) return xx == 0 && s > 0 ? 0 : 1;
    const Q scale = xx + s * s;  // = q
    const Real angle = atan2(sqrt(static_cast<Real>(Q(xx / scale))),
                             (s < 0 ? -1 : 1) * sqrt(static_cast<Real>(Q(s * s / scale))));
    const Real gap = angle * 180 / acos(Real(-1)) - degrees;
    return abs(gap) < pow(Real(10), -900) ? 0 : gap > 0 ? 1 : -1;
  }

  void count() {
    std::vector<u32> group(truth.faces.size()), degree(truth.positions.size());
    for (u32 f = 0; f < group.size(); ++f) group[f] = f;
    truth.sharp.clear();
    truth.ties = truth.ends = truth.nodes = 0;
    std::map<u32, u32> next;  // along the boundary
    u32 number = 0;
    for (const auto& [edge, faces] : sides_) {
      const u32 e = number++;
      if (faces.size() == 1) {
        next[edge[faces[0][1] != 0 ? 0 : 1]] = edge[faces[0][1] != 0 ? 1 : 0];
        continue;
      }
      const int side = compare(faces[0][0], faces[1][0]);
      truth.ties += side == 0;
      if (side > 0) {
        truth.sharp.push_back(e);
        ++degree[edge[0]], ++degree[edge[1]];
      } else {
        std::replace(group.begin(), group.end(), u32{group[faces[0][0]]}, u32{group[faces[1][0]]});
      }
    }
    for (const u32 d : degree) truth.ends += d == 1, truth.nodes += d >= 3;
    truth.patches = static_cast<u32>(std::set<u32>(group.begin(), group.end()).size());
    truth.boundary_loops = 0;
    while (!next.empty()) {
      ++truth.boundary_loops;
      for (u32 v = next.begin()->first; next.count(v) > 0;) {
        const u32 to = next[v];
        next.erase(v);
        v = to;
      }
    }
    truth.euler_characteristic = static_cast<std::int32_t>(truth.positions.size()) -
                                 static_cast<std::int32_t>(sides_.size()) +
                                 static_cast<std::int32_t>(truth.faces.size());
  }
};

Faces draw_faces(Random& random) {
  static const std::vector<Faces> kMeshes = {
      {},
      {{0, 1, 2}},
      {{0, 1, 2}, {1, 0, 3}},
      {{0, 1, 2}, {3, 4, 5}},
      {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 5}},
      {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}},
      {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}},
      {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 1}},
      {{0, 1, 3}, {1, 4, 3}, {1, 2, 4}, {2, 5, 4}, {2, 0, 5}, {0, 3, 5}},  // a tube
      {{0, 1, 2}, {0, 3, 4}},                                              // two fans at 0
      {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}};                                  // three at an edge
  Faces faces = kMeshes[random() % kMeshes.size()];
  if (!faces.empty() && random() % 8 == 0) {
    auto& f = faces[random() % faces.size()];
    if (random() % 2)
      std::swap(f[0], f[1]);
    else
      f[random() % 3] = static_cast<u32>(random() % 7);
  }
  return faces;
}

/// Some exactly at the angles of folds of small integers, some nearly.
std::string draw_angle(Random& random) {
  static const std::vector<std::string> kAngles = {"0",
                                                   "180",
                                                   "90",
                                                   "45",
                                                   "60",
                                                   "120",
                                                   "135",
                                                   "30",
                                                   "150",
                                                   "90.",
                                                   ".0",
                                                   "000045.000",
                                                   "45.",
                                                   "",
                                                   ".",
                                                   "1.2.3",
                                                   "-1",
                                                   "+5",
                                                   "4 5",
                                                   "1e1",
                                                   "nan",
                                                   "inf",
                                                   "0x10",
                                                   "180.1",
                                                   "179.99999",
                                                   "26.6",
                                                   "54.735610317245345684622999669981",
                                                   "54.735610317245345684622999669982",
                                                   "70.528779365509308630754000660037",
                                                   "70.528779365509308630754000660038",
                                                   "20",
                                                   "109.5"};
  if (random() % 4) return kAngles[random() % kAngles.size()];
  // Next to an exact one, by the last digit that fits.
  static const std::vector<std::string> kNear = {"0.", "45.", "90.", "180.", "44.", "89.", "179."};
  std::string a = kNear[random() % kNear.size()];
  const bool nines = random() % 2;
  a += std::string(99 - a.size() + random() % 2, nines ? '9' : '0');
  return a + (nines ? '9' : '1');
}

void draw_positions(SharpEdgesCertificate& c, Random& random) {
  static constexpr double kNumbers[] = {
      0,        1,      -1,    2,       1e308,       -1e308,      5e-324,    -5e-324,
      0x1p-537, 1e-160, 1e160, 0x1p-52, 1 + 0x1p-52, 1 - 0x1p-53, 0x1p-1022, 0x1p1023};
  const auto kind = random() % 4;
  for (auto& p : c.positions)
    for (double& x : p) {
      const double plain = static_cast<double>(random() >> 11) * 0x1p-52 - 1;
      if (kind == 0) x = static_cast<double>(random() % 3) - 1;
      if (kind == 1) x = kNumbers[random() % std::size(kNumbers)];
      if (kind == 2) x = std::ldexp(plain, static_cast<int>(random() % 240) - 120);
      if (kind == 3)  // small integers, a little moved
        x = static_cast<double>(random() % 3) - 1 + (random() % 4 ? 0 : std::ldexp(plain, -60));
    }
}

SharpEdgesCertificate draw_data(Random& random) {
  SharpEdgesCertificate c;
  c.faces = draw_faces(random);
  u32 vertices = 0;
  for (const auto& f : c.faces)
    for (const u32 v : f) vertices = std::max(vertices, v + 1);
  c.positions.resize(vertices + (random() % 16 == 0 ? 1 : 0));
  draw_positions(c, random);
  c.angle = draw_angle(random);
  return c;
}

bool accepted(const SharpEdgesCertificate& c, Arithmetic arithmetic = Arithmetic::doubles) {
  return verify(encode(c), {arithmetic, {}}).accepted;
}

/// Every number and every edge of the claim another.
std::vector<SharpEdgesCertificate> lies_about(const SharpEdgesCertificate& c) {
  std::vector<SharpEdgesCertificate> all;
  const auto add = [&](auto change) {
    all.push_back(c);
    change(all.back());
  };
  for (u32 SharpEdgesCertificate::*number :
       {&SharpEdgesCertificate::boundary_loops, &SharpEdgesCertificate::ties,
        &SharpEdgesCertificate::ends, &SharpEdgesCertificate::nodes,
        &SharpEdgesCertificate::patches})
    for (const u32 step : {1U, ~0U, 1U << 31}) add([&](auto& lie) { lie.*number += step; });
  for (const int step : {1, -1, 2}) add([&](auto& lie) { lie.euler_characteristic += step; });
  for (std::size_t k = 0; k < c.sharp.size(); ++k) {
    add([&](auto& lie) { lie.sharp.erase(lie.sharp.begin() + static_cast<long>(k)); });
    add([&](auto& lie) { lie.sharp.insert(lie.sharp.begin() + static_cast<long>(k), c.sharp[k]); });
  }
  for (u32 e = 0; e < 3 * c.faces.size(); ++e) {
    if (std::count(c.sharp.begin(), c.sharp.end(), e) > 0) continue;
    add([&](auto& lie) {
      lie.sharp.insert(std::upper_bound(lie.sharp.begin(), lie.sharp.end(), e), e);
    });
  }
  add([](auto& lie) { lie.sharp.push_back(~0U); });
  return all;
}

}  // namespace

TEST_CASE("sharp edges of degenerate meshes: accepted if and only if a count of its own agrees") {
  Random random(kSeed + 31);
  std::uint64_t valid = 0, refused = 0, lies = 0;
  for (std::uint64_t i = 0; i < scaled(1500); ++i) {
    const Recount recount(draw_data(random));
    const OnFailure shown(
        [&] { return "mesh " + std::to_string(i) + ", angle " + recount.truth.angle; });
    const bool expected = recount.valid;
    ++(expected ? valid : refused);
    CHECK(accepted(recount.truth) == expected);
    CHECK(accepted(recount.truth, Arithmetic::mpfr) == expected);
    if (!expected || i % 4 != 0) continue;
    for (const SharpEdgesCertificate& lie : lies_about(recount.truth)) {
      ++lies;
      CHECK_FALSE(accepted(lie));
    }
  }
  std::cout << "sharp edges: " << valid << " degenerate meshes accepted, " << refused
            << " refused; " << lies << " lies, none accepted\n";
  CHECK(valid > scaled(1500) / 5);
  CHECK(refused > scaled(1500) / 5);
}

TEST_CASE("sharp edges of numbers that only rationals carry cost linear time") {
  // A strip folded at every edge, coordinates of exponents far apart, an angle next to the folds'.
  const auto seconds = [](u32 quads) {
    SharpEdgesCertificate c;
    for (u32 k = 0; k <= quads; ++k)
      for (const double z : {0.0, 0x1p-1074}) {
        const double x = static_cast<double>(k);
        c.positions.push_back({k % 2 ? x : x + 0x1p-400, k % 2 ? 0x1p-1000 : 1.0, z});
      }
    for (u32 k = 0; k < quads; ++k) {
      const u32 a = 2 * k;
      c.faces.push_back({a, a + 2, a + 1});
      c.faces.push_back({a + 1, a + 2, a + 3});
    }
    c.angle = "89." + std::string(97, '9');
    const auto before = std::chrono::steady_clock::now();
    const auto verdict = verify(encode(c));
    CHECK_FALSE(verdict.accepted);  // no counts are stated
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  };
  const double small = seconds(200), large = seconds(1600);
  std::cout << "sharp edges in rationals: " << small << " s for 400 faces, " << large
            << " s for 3200\n";
  CHECK(large < 40 * small + 0.5);
}
