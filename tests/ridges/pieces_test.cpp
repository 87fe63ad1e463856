// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes cut into pieces: joined, fits, graph and certificate are those of the whole, byte for
// byte.
#include "algorithms/ridges/pieces.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "algorithms/ridges/auto_scale.hpp"
#include "algorithms/ridges/certificate.hpp"
#include "tests/ridges/ridge_cases.hpp"
#include "tests/support/ragged_mesh.hpp"

using namespace crest;
using kernel::Index;
using kernel::TriangleMesh;

namespace {

/// No numbers: what has none is nowhere the same.
template <class T, class Fields>
std::vector<double> numbers(const std::vector<T>& items, const Fields& fields) {
  std::vector<double> r;
  for (const T& x : items)
    for (const double value : fields(x)) r.push_back(value);
  return r;
}

/// Bit by bit: 0 is not -0.
bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

std::vector<double> forms_of(const ridges::FitResult& fit) {
  return numbers(fit.forms, [](const kernel::MongeForm& m) {
    return std::array{m.d1[0], m.d1[1], m.d1[2], m.n[0], m.n[1], m.n[2], m.k1, m.k2, m.b0,
                      m.b1,    m.b2,    m.b3,    m.c0,   m.c1,   m.c2,   m.c3, m.c4};
  });
}
std::vector<double> quality_of(const ridges::FitResult& fit) {
  return numbers(fit.quality, [](const ridges::FitQuality& q) {
    return std::array{q.condition, double(q.points), double(q.degree)};
  });
}
std::vector<double> errors_of(const ridges::FitResult& fit) {
  return numbers(fit.errors, [](const ridges::CurvatureError& e) {
    return std::array{e.k1, e.k2, e.gap, e.wide_k1, e.wide_k2, e.radius};
  });
}

/// With a rim, folded above 40 degrees along a line of 40 edges.
TriangleMesh folded() {
  std::vector<kernel::Vec3> points;
  for (unsigned i = 0; i <= 40; ++i)
    for (unsigned j = 0; j <= 20; ++j) {
      const double y = double(j) - 10, bend = 0.02 * double(i) * double(i % 7);
      points.push_back({double(i), y, (j > 10 ? 1.1 * y : 0.05 * y * y) + 0.01 * bend});
    }
  std::vector<kernel::Triangle> faces;
  for (unsigned i = 0; i < 40; ++i)
    for (unsigned j = 0; j < 20; ++j) {
      const unsigned a = i * 21 + j, b = a + 21;
      faces.push_back({a, b, b + 1});
      faces.push_back({a, b + 1, a + 1});
    }
  return {std::move(points), std::move(faces)};
}

/// Numbered without regard to places, so that pieces have numbers from everywhere.
TriangleMesh shuffled(const std::string& name, const std::vector<double>& parameters, int vertices,
                      double noise) {
  sampling::SurfaceSample s = sampling::sample(name, parameters, vertices, true);
  const double edge = sampling::mean_edge_length(s.points, s.faces);
  if (noise > 0) sampling::add_normal_noise(s.points, sampling::normals(s), noise * edge, 5);
  const auto n = static_cast<Index>(s.points.size());
  const auto number = [n](Index v) { return (v * 7919ULL + 13) % n; };
  std::vector<kernel::Vec3> points(n);
  for (Index v = 0; v < n; ++v) points[number(v)] = s.points[v];
  for (kernel::Triangle& f : s.faces)
    for (Index& v : f) v = static_cast<Index>(number(v));
  std::reverse(s.faces.begin(), s.faces.end());
  return {std::move(points), std::move(s.faces)};
}

void check_alike(const TriangleMesh& mesh, const ridges::FitOptions& options,
                 std::initializer_list<Index> counts_of_pieces = {2, 7, 64}) {
  const ridges::FitResult whole = ridges::fit_monge_forms(mesh, options);
  ridges::PredicateReport report;
  const auto graph = ridges::extract_certified(mesh, whole.forms, {}, &report);
  for (const Index pieces : counts_of_pieces) {
    INFO(mesh.vertex_count() << " vertices, " << pieces << " pieces");
    const ridges::Workers workers = ridges::workers_here(pieces);
    const ridges::FitResult fit = ridges::fit_monge_forms(mesh, options, &workers);
    CHECK(same_bits(forms_of(fit), forms_of(whole)));
    CHECK(same_bits(quality_of(fit), quality_of(whole)));
    CHECK(same_bits(errors_of(fit), errors_of(whole)));
    CHECK(fit.creases == whole.creases);
    ridges::PredicateReport counts;
    const auto joined = ridges::extract_certified(mesh, fit.forms, {}, &counts, &workers);
    CHECK(joined.certificate == graph.certificate);
    REQUIRE(counts.size() == report.size());
    for (std::size_t i = 0; i < counts.size(); ++i) {
      INFO(counts[i].first);
      const auto& [a, b] = std::tie(counts[i].second, report[i].second);
      CHECK(std::tie(a.calls, a.interval, a.integer, a.exact, a.symbolic) ==
            std::tie(b.calls, b.interval, b.integer, b.exact, b.symbolic));
    }
  }
}

}  // namespace

TEST_CASE("ridge pieces: 2, 7 and 64 pieces have the bytes of the whole") {
  ridges::FitOptions options;
  SECTION("closed") {
    check_alike(shuffled("ellipsoid", {1, 1.5, 2}, 2400, 0), options);
  }
  SECTION("with a rim, noise and errors of the fit") {
    options.errors = true;
    check_alike(shuffled("umbilic-patch", {}, 1500, 0.1), options);
  }
  SECTION("supports of the smallest size at a crease, smoothed") {
    options.errors = true;
    options.smooth = 3;
    options.min_points = 60;
    const TriangleMesh mesh = folded();
    const auto fit = ridges::fit_monge_forms(mesh, options);
    REQUIRE(std::count(fit.creases.begin(), fit.creases.end(), 1) > 30);
    check_alike(mesh, options);
  }
  SECTION("by rings") {
    options.rings = 2;
    check_alike(shuffled("handles", {2}, 1500, 0), options);
  }
  SECTION("by a radius that needs more rings than are guessed") {
    options.errors = true;
    options.scale = 0.5;
    check_alike(shuffled("torus", {}, 1200, 0.05), options);
  }
}

TEST_CASE("ridge pieces: the support that is chosen does not depend on pieces") {
  const TriangleMesh mesh = shuffled("ellipsoid", {1, 1.5, 2}, 900, 0.1);
  const ridges::Workers workers = ridges::workers_here(5);
  const auto whole = ridges::choose_support(mesh, {});
  const auto joined = ridges::choose_support(mesh, {}, {}, {}, &workers);
  CHECK(joined.points == whole.points);
  const auto trial = [](const ridges::SupportTrial& t) {
    return std::array{double(t.points), t.length, t.salient_length, t.significant_length, t.j};
  };
  CHECK(same_bits(numbers(joined.trials, trial), numbers(whole.trials, trial)));
}

TEST_CASE("ridge pieces: forms without any meaning, exact zeros among them") {
  const TriangleMesh mesh = shuffled("sphere", {}, 400, 0);
  for (const tests::Family family : {tests::Family::small_integers, tests::Family::tiny}) {
    const auto forms = tests::random_forms(mesh.vertex_count(), family, 11);
    const auto whole = ridges::extract_certified(mesh, forms);
    const ridges::Workers workers = ridges::workers_here(7);
    CHECK(ridges::extract_certified(mesh, forms, {}, nullptr, &workers).certificate ==
          whole.certificate);
  }
}

TEST_CASE("ridge pieces: a support that the rim cuts short is left, not fitted to what there is") {
  const TriangleMesh mesh = shuffled("sphere", {}, 2000, 0);
  const ridges::FitResult whole = ridges::fit_monge_forms(mesh, {});
  const auto owned = kernel::cut_points(mesh.points(), 8)[3];
  std::size_t left = owned.size();
  for (const Index rings : {1U, 2U, 5U}) {
    const auto r = ridges::work_on(ridges::FitJob{kernel::mesh_part(mesh, owned, rings), {}, {}});
    CHECK(r.left.size() < left);
    left = r.left.size();
    ridges::FitResult expected;
    for (Index i = 0; i < owned.size(); ++i)
      if (!std::binary_search(r.left.begin(), r.left.end(), i))
        expected.forms.push_back(whole.forms[owned[i]]);
    ridges::FitResult found;
    found.forms = r.forms;
    CHECK(same_bits(forms_of(found), forms_of(expected)));
    if (rings < 5) CHECK(left > 0);
  }
  CHECK(left == 0);
}

TEST_CASE("ridge pieces: a vertex each, of ragged parts without inner vertices") {
  tests::Random random(42);
  for (const Index n : {1U, 4U, 12U}) {
    const TriangleMesh mesh = tests::ragged_mesh(n, random);
    ridges::FitOptions options;
    check_alike(mesh, options, {3, 2 * mesh.vertex_count()});
    options.errors = true;
    options.scale = 1.5;
    check_alike(mesh, options, {mesh.vertex_count()});
  }
}
