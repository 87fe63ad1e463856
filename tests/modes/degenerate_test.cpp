// SPDX-License-Identifier: GPL-3.0-or-later
#include <tbb/global_control.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <set>

#include "algorithms/modes/curves_certificate.hpp"
#include "algorithms/modes/degenerate_arcs.hpp"
#include "algorithms/modes/degenerate_curves.hpp"
#include "algorithms/modes/degenerate_face.hpp"
#include "certify/modes_curves/encode.hpp"
#include "certify/verify.hpp"
#include "tests/modes/reference_fields.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/random.hpp"

namespace {

using namespace crest;
using namespace crest::tests;
using namespace crest::modes;

struct Expected {
  int linear;
  double linear_length;
  int planar;
  double planar_length;
};
constexpr std::array<Expected, 6> kExpected{{{1, 4.703, 2, 5.6333},
                                             {2, 7.7326, 1, 2.7268},
                                             {2, 5.8757, 1, 5.4998},
                                             {1, 5.5836, 2, 8.8955},
                                             {1, 4.620, 1, 6.504},
                                             {2, 7.7648, 2, 9.3469}}};

DegenerateCurves curves_of(const SampledField& s) {
  return degenerate_curves(s.points, s.tets, s.tensors);
}

struct Summary {
  std::array<int, 2> pieces{};
  std::array<double, 2> length{};
  int closed = 0;
  explicit Summary(const DegenerateCurves& r) {
    for (const auto& c : r.curves) {
      const auto t = static_cast<std::size_t>(c.type);
      ++pieces[t];
      length[t] += c.length;
      closed += c.closed;
    }
  }
};

std::array<double, 3> middles(const std::array<kernel::Ball, 3>& b) {
  return {b[0].mid, b[1].mid, b[2].mid};
}

Tensor random_tensor(Random& random) {
  std::normal_distribution<double> normal;
  Tensor t;
  for (double& x : t) x = normal(random);
  return t;
}

}  // namespace

TEST_CASE("degenerate curves of the reference fields: pieces, types, lengths") {
  for (std::size_t f = 0; f < 6; ++f)
    for (const auto& [n, mirrored] : {std::pair{3u, false}, {5u, false}, {3u, true}, {8u, false}}) {
      INFO("field " << f + 1 << ", " << n << " cubes a side, mirrored " << mirrored);
      const DegenerateCurves r = curves_of(sampled(reference_fields()[f], n, 2, mirrored));
      CHECK(r.undecided.empty());
      CHECK(r.special_tets.size() <= 8);
      // On the finest grid curves pass edges exactly; what is named is missing there.
      if (!r.special_faces.empty()) {
        CHECK(n == 8);
        for (const auto& s : r.special_faces) CHECK(s.reason == SpecialReason::on_rim);
        continue;
      }
      const Summary s(r);
      CHECK(s.pieces[0] == kExpected[f].linear);
      CHECK(s.pieces[1] == kExpected[f].planar);
      CHECK(s.closed == 0);
      CHECK(s.length[0] == Approx(kExpected[f].linear_length).epsilon(1e-3));
      CHECK(s.length[1] == Approx(kExpected[f].planar_length).epsilon(1e-3));
      for (const auto& c : r.curves)
        for (const std::uint32_t end : {c.face_points.front(), c.face_points.back()}) {
          const kernel::Vec3& x = r.points[end].point;
          CHECK(std::max({std::fabs(x[0]), std::fabs(x[1]), std::fabs(x[2])}) == Approx(2));
        }
      // Points and polylines are where the field is degenerate.
      for (const auto& c : r.curves)
        for (const kernel::Vec3& x : c.polyline)
          CHECK(mode_of(tensor_at(reference_fields()[f], x)) ==
                Approx(c.type == DegenerateType::linear ? 1 : -1).margin(1e-11));
    }
}

TEST_CASE("degenerate points of random faces: at most four, the stages agree") {
  Random random(kSeed + 41);
  std::array<int, 5> found{};
  int undecided = 0;
  for (int i = 0; i < 60 * multiplier(); ++i) {
    std::array<Tensor, 3> t;
    const double spread = i % 3 == 0 ? 1 : i % 3 == 1 ? 0.1 : 0.001;
    const Tensor common = random_tensor(random);
    for (auto& x : t) {
      x = random_tensor(random);
      for (std::size_t k = 0; k < 6; ++k) x[k] = (spread == 1 ? 0 : common[k]) + spread * x[k];
    }
    const std::array<const Tensor*, 3> corners{&t[0], &t[1], &t[2]};
    const FaceRoots exact = exact_face_roots(corners);
    REQUIRE(!exact.special);
    ++found[exact.count];
    const std::array<Direction, 3> u{direction(t[0]), direction(t[1]), direction(t[2])};
    if (cones_exclude(u, 6)) CHECK(exact.count == 0);
    const auto triage = triage_face_roots(corners);
    undecided += !triage;
    if (!triage) continue;
    REQUIRE(triage->count == exact.count);
    for (std::size_t k = 0; k < exact.count; ++k) {
      bool matched = false;
      for (std::size_t j = 0; j < exact.count; ++j) {
        const FaceRoot &a = exact.root[k], &b = triage->root[j];
        matched =
            matched || (a.type == b.type && std::fabs(a.weights[0].mid - b.weights[0].mid) < 1e-7 &&
                        std::fabs(a.weights[1].mid - b.weights[1].mid) < 1e-7);
      }
      CHECK(matched);
      CHECK(mode_of(blend(t, middles(exact.root[k].weights))) ==
            Approx(exact.root[k].type == DegenerateType::linear ? 1 : -1).margin(1e-9));
    }
  }
  CHECK(found[0] > 0);
  CHECK(found[1] > 0);
  CHECK(undecided <= 2 * multiplier());
}

TEST_CASE("degenerate arcs of random tets: every point ends one, none is closed") {
  Random random(kSeed + 42);
  const std::vector<kernel::Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<TetCorners> tet{{0, 1, 2, 3}};
  std::map<std::size_t, int> sizes;
  for (int i = 0; i < 3000 * multiplier(); ++i) {
    std::vector<Tensor> t;
    for (int k = 0; k < 4; ++k) t.push_back(random_tensor(random));
    const DegenerateCurves r = degenerate_curves(points, tet, t);
    CHECK(r.special_faces.empty());
    REQUIRE(r.undecided.empty());
    ++sizes[r.points.size()];
    CHECK(2 * r.arcs.size() == r.points.size());
    for (const auto& c : r.curves) {
      CHECK(!c.closed);
      CHECK(c.face_points.size() == 2);
      CHECK(r.points[c.face_points[0]].type == r.points[c.face_points[1]].type);
      // Inside the tet and degenerate between the ends, too.
      for (const kernel::Vec3& x : c.polyline) {
        const std::array<double, 4> w{1 - x[0] - x[1] - x[2], x[0], x[1], x[2]};
        for (const double b : w) CHECK(b > -1e-9);
        CHECK(std::fabs(mode_of(blend<4>({t[0], t[1], t[2], t[3]}, w))) > 1 - 1e-9);
      }
    }
  }
  CHECK(sizes[2] > 100);
  CHECK(sizes[4] > 10);
}

TEST_CASE("degenerate curves of -T: linear and planar exchanged") {
  SampledField s = sampled(reference_fields()[2], 3, 2);
  const Summary a(curves_of(s));
  for (auto& t : s.tensors)
    for (double& x : t) x = -x;
  const Summary b(curves_of(s));
  CHECK(a.pieces[0] == b.pieces[1]);
  CHECK(a.pieces[1] == b.pieces[0]);
  CHECK(a.length[0] == Approx(b.length[1]));
}

TEST_CASE("degenerate curves are the same for one thread") {
  const SampledField s = sampled(reference_fields()[3], 5, 2);
  const DegenerateCurves many = curves_of(s);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  const DegenerateCurves one = curves_of(s);
  REQUIRE(many.curves.size() == one.curves.size());
  for (std::size_t i = 0; i < one.curves.size(); ++i)
    CHECK(many.curves[i].polyline == one.curves[i].polyline);
}

namespace {

/// A load symmetric about z = 0: shears odd in z, the rest even.
SampledField mirrored_load() {
  SampledField s = box_mesh(4, 2, true);
  for (const kernel::Vec3& x : s.points) {
    const auto a = tensor_at(reference_fields()[4], {x[0], x[1], std::fabs(x[2])});
    s.tensors.push_back({a[0], a[1], a[2], a[3], x[2] * a[4], x[2] * a[5]});
  }
  return s;
}

/// On the z axis xx = yy and no shears: mode +-1 along its edges.
SampledField fourfold_load() {
  SampledField s = box_mesh(4, 2, true);
  for (const kernel::Vec3& x : s.points)
    s.tensors.push_back({x[0] * x[0] - 1 - x[2], x[1] * x[1] - 1 - x[2], 3 + x[2], x[0] * x[1],
                         x[1] * (x[2] + 2), x[0] * (x[2] + 2)});
  return s;
}

}  // namespace

TEST_CASE("degenerate curves on a symmetry plane: its faces are named") {
  const SampledField s = mirrored_load();
  const DegenerateCurves r = curves_of(s);
  CHECK(r.undecided.empty());
  int in_plane = 0;
  for (const auto& f : r.special_faces) {
    const bool flat =
        s.points[f.face[0]][2] == 0 && s.points[f.face[1]][2] == 0 && s.points[f.face[2]][2] == 0;
    in_plane += flat && f.reason == SpecialReason::zero_quartic;
  }
  CHECK(in_plane > 0);
  // A plane face that is not named holds no degenerate tensor: dense samples.
  std::map<FaceCorners, bool> named;
  for (const auto& f : r.special_faces) named[f.face] = true;
  for (const auto& tet : s.tets)
    for (std::size_t k = 0; k < 4; ++k) {
      FaceCorners f{tet[(k + 1) % 4], tet[(k + 2) % 4], tet[(k + 3) % 4]};
      std::sort(f.begin(), f.end());
      if (s.points[f[0]][2] != 0 || s.points[f[1]][2] != 0 || s.points[f[2]][2] != 0 || named[f])
        continue;
      for (int i = 0; i <= 12; ++i)
        for (int j = 0; i + j <= 12; ++j)
          CHECK(std::fabs(mode_of(blend<3>({s.tensors[f[0]], s.tensors[f[1]], s.tensors[f[2]]},
                                           {i / 12.0, j / 12.0, 1 - (i + j) / 12.0}))) < 1 - 1e-12);
    }
}

TEST_CASE("degenerate curves on a fourfold axis: the faces around its edges are named") {
  const SampledField s = fourfold_load();
  const DegenerateCurves r = curves_of(s);
  CHECK(r.undecided.empty());
  std::map<FaceCorners, bool> named;
  for (const auto& f : r.special_faces) named[f.face] = true;
  int around = 0;
  for (const auto& tet : s.tets)
    for (std::size_t k = 0; k < 4; ++k) {
      FaceCorners f{tet[(k + 1) % 4], tet[(k + 2) % 4], tet[(k + 3) % 4]};
      std::sort(f.begin(), f.end());
      int on_axis = 0;
      for (const std::uint32_t c : f) on_axis += s.points[c][0] == 0 && s.points[c][1] == 0;
      if (on_axis < 2) continue;
      ++around;
      CHECK(named[f]);
    }
  CHECK(around > 0);
  // Three of the axis: the deviator is zero at z = -2, where it is that of v v^T, v = (x, y, 0), so
  // that edges along v are degenerate, too.
  int on_axis = 0;
  for (const auto& [a, b] : r.degenerate_edges) {
    const auto &p = s.points[a], &q = s.points[b];
    CHECK(p[0] * q[1] == p[1] * q[0]);
    CHECK(std::hypot(p[0], p[1], p[2] + 2) * std::hypot(q[0], q[1], q[2] + 2) > 0);
    const bool axis = p[0] == 0 && p[1] == 0 && q[0] == 0 && q[1] == 0;
    on_axis += axis ? 1 : 0;
    CHECK((axis || (p[2] == -2 && q[2] == -2)));
  }
  CHECK(on_axis == 3);
  const auto c = curves_certificate(s.points, s.tets, s.tensors, r);
  CHECK(c.degenerate_edges == r.degenerate_edges);
  const auto verdict = certify::verify(certify::encode(c));
  INFO(verdict.reason);
  CHECK(verdict.accepted);
}

TEST_CASE("degenerate curves of degenerate data: zero, constant and dependent tensors are named") {
  SampledField s = sampled(reference_fields()[0], 3, 2);
  const std::size_t centre = 1 + 4 * (1 + 4 * 1);
  s.tensors[centre] = {5, 5, 5, 0, 0, 0};  // a zero deviator
  const DegenerateCurves zero = curves_of(s);
  std::size_t named = 0;
  for (const auto& f : zero.special_faces) named += f.reason == SpecialReason::zero_tensor;
  CHECK(named > 0);
  // Constant: nothing where the tensor is not degenerate, every face where it is.
  for (auto& t : s.tensors) t = {3, 1, -4, 0, 0, 0};
  const DegenerateCurves plain = curves_of(s);
  CHECK(plain.special_faces.empty());
  CHECK(plain.counts.rejected_tets == s.tets.size());
  for (auto& t : s.tensors) t = {2, -1, -1, 0, 0, 0};
  const DegenerateCurves uniform = curves_of(s);
  CHECK(uniform.special_faces.size() > 2 * s.tets.size());
  for (const auto& f : uniform.special_faces) CHECK(f.reason == SpecialReason::dependent);
  CHECK(uniform.curves.empty());
  std::set<std::array<std::uint32_t, 2>> edges;
  for (const auto& t : s.tets)
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = 0; k < i; ++k)
        edges.insert({std::min(t[i], t[k]), std::max(t[i], t[k])});
  CHECK(uniform.degenerate_edges.size() == edges.size());
}

TEST_CASE("degenerate points: large and small numbers, isotropic parts") {
  const SampledField s = sampled(reference_fields()[1], 3, 2);
  const Summary expected(curves_of(s));
  for (const double scale : {0x1p-600, 0x1p+300}) {
    SampledField scaled = s;
    for (auto& t : scaled.tensors)
      for (double& x : t) x *= scale;
    const Summary found(curves_of(scaled));
    CHECK(found.pieces == expected.pieces);
    CHECK(found.length[0] == Approx(expected.length[0]));
  }
  SampledField pressed = s;  // integers and halves: sums are exact
  for (auto& t : pressed.tensors)
    for (std::size_t k = 0; k < 3; ++k) t[k] += 0x1p+40;
  CHECK(Summary(curves_of(pressed)).pieces == expected.pieces);
}

TEST_CASE(
    "degenerate curves as records: boxes hold their points, counts, what touches special places") {
  const SampledField s = sampled(reference_fields()[1], 3, 2);
  const DegenerateCurves r = curves_of(s);
  const auto c = curves_certificate(s.points, s.tets, s.tensors, r);
  REQUIRE(c.face_points.size() == r.points.size());
  for (std::size_t i = 0; i < r.points.size(); ++i)
    for (std::size_t k = 0; k < 2; ++k) {
      const auto& p = c.face_points[i];
      CHECK(p.low[k] <= r.points[i].weights[k]);
      CHECK(p.high[k] >= r.points[i].weights[k]);
      CHECK(p.low[k] >= 0);
      CHECK(p.high[k] <= 1);
      CHECK(p.high[k] - p.low[k] < 1e-8);
    }
  CHECK(std::is_sorted(c.faces.begin(), c.faces.end()));
  CHECK(c.arcs.size() == r.arcs.size());
  CHECK(c.linear.open == 2);
  CHECK(c.planar.open == 1);
  CHECK(c.linear.touched + c.planar.touched + c.linear.closed + c.planar.closed == 0);
  // A zero tensor on a curve's way: its pieces end there.
  SampledField broken = s;
  const TetCorners& tet = s.tets[r.arcs[r.arcs.size() / 2].tet];
  broken.tensors[tet[0]] = {1, 1, 1, 0, 0, 0};
  const DegenerateCurves b = curves_of(broken);
  const auto d = curves_certificate(broken.points, broken.tets, broken.tensors, b);
  CHECK(d.special_faces.size() == b.special_faces.size());
  CHECK(d.special_tets.size() >= d.special_faces.size() / 4);
  CHECK(std::is_sorted(d.special_tets.begin(), d.special_tets.end()));
  CHECK(d.special_tets.size() > 0);
}
