// SPDX-License-Identifier: GPL-3.0-or-later
// Compressed fields: the skeletons of both are proven equal, by the producer and by the checker.
#include <catch2/catch.hpp>
#include <cmath>

#include "algorithms/vector_fields/certificate.hpp"
#include "algorithms/vector_fields/collapse_mesh.hpp"
#include "certify/verify.hpp"
#include "tests/vector_fields/counts.hpp"

using namespace crest;
using namespace crest::tests;
using namespace crest::vector_fields;

namespace {

CompressionOptions options_for(Equivalence e, CollapseTest test = CollapseTest::retrace) {
  CompressionOptions options;
  options.equivalence = e;
  options.test = test;
  return options;
}

/// Compresses, and asks the checker.
Compression proven(const PlanarField& field, const CompressionOptions& options) {
  certify::CompressionCertificate record;
  Compression result = compress(field, options, record);
  INFO(result.difference);
  REQUIRE(result.same_skeleton);
  const auto verdict = certify::verify(certify::encode(record));
  INFO(verdict.reason);
  CHECK(verdict.accepted);
  return result;
}

/// The output's vertices are some of the input's, bit for bit.
void check_vertices(const PlanarField& field, const Compression& c) {
  REQUIRE(c.vertex_of.size() == c.field.points.size());
  CHECK(std::is_sorted(c.vertex_of.begin(), c.vertex_of.end()));
  for (std::size_t i = 0; i < c.vertex_of.size(); ++i) {
    CHECK(c.field.points[i] == field.points[c.vertex_of[i]]);
    CHECK(c.field.vectors[i] == field.vectors[c.vertex_of[i]]);
  }
}

}  // namespace

TEST_CASE("Compressed lattice fields have the same skeleton, in three notions") {
  for (const auto& [seed, hole] :
       {std::pair{1ULL, true}, {2ULL, false}, {4ULL, false}, {6ULL, true}}) {
    INFO("seed " << seed);
    const PlanarField field = field_of(sampling::lattice_field(seed, 40, hole));
    const Counts counts = counts_of(extract_skeleton(field));
    std::size_t last = field.triangles.size();
    for (const Equivalence e : {Equivalence::strong, Equivalence::original, Equivalence::relaxed}) {
      const Compression c = proven(field, options_for(e));
      check_vertices(field, c);
      Counts after = counts_of(c.after);
      if (e == Equivalence::relaxed) after.foci = counts.foci;
      CHECK(after == counts);
      // Each notion allows more than the one before.
      CHECK(c.field.triangles.size() < last);
      last = c.field.triangles.size();
    }
    CHECK(last < field.triangles.size() / 10);
  }
}

TEST_CASE("Compression: a region may have only the rest of an edge") {
  // On L(17) one lies between a switch point inside an edge and one at the edge's corner.
  const PlanarField field = field_of(sampling::lattice_field(17, 40));
  const Compression c = proven(field, options_for(Equivalence::strong));
  CHECK(c.field.triangles.size() < field.triangles.size());
}

TEST_CASE("Compression: the printed test of the thesis keeps the skeleton, too") {
  const PlanarField field = field_of(sampling::lattice_field(2, 40, true));
  const Compression c = proven(field, options_for(Equivalence::original, CollapseTest::thesis));
  CHECK(c.counts.refused.order > 0);
  CHECK(c.field.triangles.size() < field.triangles.size() / 4);
}

TEST_CASE("Compression: positions and vectors scaled by powers of two collapse alike") {
  const PlanarField field = field_of(sampling::lattice_field(3, 24));
  const Compression expected = compress(field, options_for(Equivalence::original));
  for (const auto& [place, vector] : {std::pair{-17, 0}, {10, -27}}) {
    PlanarField scaled = field;
    for (auto& p : scaled.points)
      for (double& x : p) x = std::ldexp(x, place);
    for (auto& v : scaled.vectors)
      for (double& x : v) x = std::ldexp(x, vector);
    const Compression c = compress(scaled, options_for(Equivalence::original));
    CHECK(c.vertex_of == expected.vertex_of);
    CHECK(c.field.triangles == expected.field.triangles);
  }
}

TEST_CASE("Compression: what weighs less may go, what weighs more stays") {
  const PlanarField field = field_of(sampling::lattice_field(3, 40));
  const Compression plain = compress(field, options_for(Equivalence::original));
  std::size_t last = plain.field.triangles.size();
  for (const double threshold : {0.0, 0.5, 1.0}) {
    CompressionOptions options;
    options.simplify = threshold;
    certify::CompressionCertificate record;
    const Compression c = compress(field, options, record);
    INFO("w0 = " << threshold << ": " << c.difference);
    REQUIRE(c.same_skeleton);
    check_vertices(field, c);
    const auto verdict = certify::verify(certify::encode(record.output));
    INFO(verdict.reason);
    CHECK(verdict.accepted);
    CHECK(c.after.index_sum == c.before.index_sum);
    CHECK(c.after.switch_points.size() == c.before.switch_points.size());
    // Each important zero is where it was, bit for bit.
    std::size_t important = 0;
    for (std::size_t z = 0; z < c.before.critical_points.size(); ++z) {
      if (c.importance->zeros[z].weight < threshold) continue;
      ++important;
      const CriticalPoint& old = c.before.critical_points[z];
      CHECK(std::any_of(c.after.critical_points.begin(), c.after.critical_points.end(),
                        [&](const CriticalPoint& now) {
                          return now.kind == old.kind && now.point == old.point &&
                                 now.jacobian == old.jacobian;
                        }));
    }
    CHECK(c.after.critical_points.size() == important + c.counts.left_below);
    CHECK(c.before.critical_points.size() == c.after.critical_points.size() + c.counts.cancelled);
    if (threshold == 0) {
      CHECK(c.vertex_of == plain.vertex_of);
      CHECK(c.field.triangles == plain.field.triangles);
    } else {
      CHECK(c.counts.cancelled > 0);
      CHECK(c.field.triangles.size() < last);
    }
  }
}

TEST_CASE("Compression: fields with ties keep what cannot be followed in doubles") {
  // Small integers: zeros at vertices, on edges and lines, tangent runs, straight separatrices.
  Random random(20);
  std::size_t collapses = 0;
  for (int i = 0; i < 4; ++i) {
    PlanarField field = field_of(sampling::lattice_field(1, 6));
    for (auto& v : field.vectors)
      v = {static_cast<double>(random() % 5) - 2, static_cast<double>(random() % 5) - 2};
    certify::CompressionCertificate record;
    const Compression c = compress(field, options_for(Equivalence::original), record);
    INFO("field " << i << ": " << c.difference);
    if (!c.same_skeleton) continue;  // refused: nothing is claimed
    const auto verdict = certify::verify(certify::encode(record));
    INFO(verdict.reason);
    CHECK(verdict.accepted);
    collapses += c.counts.collapses;
  }
  CHECK(collapses > 0);
}

TEST_CASE("Collapses are taken back to the last bit") {
  const PlanarField field = field_of(sampling::lattice_field(2, 12, true));
  const Domain domain(field);
  const Boundary boundary = examine_boundary(domain);
  CollapseMesh mesh(domain, boundary);
  std::vector<Index> vertex_of;
  Collapse plan;
  std::size_t applied = 0, refused = 0;
  for (HalfEdge h = 0; h < 3 * domain.triangle_count(); ++h) {
    if (!mesh.alive(h / 3)) continue;
    if (mesh.plan(mesh.from(h), mesh.to(h), plan) != CollapseRefusal::none) {
      ++refused;
      continue;
    }
    const auto before = mesh.field(vertex_of).triangles;
    const Index live = mesh.live_triangles();
    mesh.apply(plan);
    CHECK(mesh.live_triangles() < live);
    // Still a mesh of the same domain: positive triangles, each edge in two at most.
    const PlanarField smaller = mesh.field(vertex_of);
    CHECK(Domain(smaller).euler_characteristic() == domain.euler_characteristic());
    mesh.undo();
    CHECK(mesh.field(vertex_of).triangles == before);
    CHECK(mesh.live_triangles() == live);
    if (h % 3 == 0) {
      mesh.apply(plan);
      ++applied;
    }
  }
  CHECK(applied > 0);
  CHECK(refused > 0);
}

TEST_CASE("Flips are taken back to the last bit") {
  const PlanarField field = field_of(sampling::lattice_field(2, 12, true));
  const Domain domain(field);
  const Boundary boundary = examine_boundary(domain);
  CollapseMesh mesh(domain, boundary);
  std::vector<Index> vertex_of;
  Collapse plan;
  // Some collapses first: in a grid all but a few edges can be flipped.
  for (HalfEdge h = 0; h < 3 * domain.triangle_count(); h += 7)
    if (mesh.alive(h / 3) && mesh.plan(mesh.from(h), mesh.to(h), plan) == CollapseRefusal::none)
      mesh.apply(plan);
  std::size_t flipped = 0, refused = 0;
  for (HalfEdge h = 0; h < 3 * domain.triangle_count(); ++h) {
    if (!mesh.alive(h / 3)) continue;
    if (!mesh.plan_flip(h, plan)) {
      ++refused;
      continue;
    }
    const auto before = mesh.field(vertex_of).triangles;
    const auto first = mesh.data_after(plan, plan.star[0]),
               second = mesh.data_after(plan, plan.star[1]);
    mesh.apply(plan);
    const PlanarField other = mesh.field(vertex_of);
    CHECK(other.triangles.size() == before.size());
    CHECK(other.triangles != before);
    CHECK(Domain(other).euler_characteristic() == domain.euler_characteristic());
    CHECK(mesh.data(plan.star[0]).p == first.p);
    CHECK(mesh.data(plan.star[1]).v == second.v);
    mesh.undo();
    CHECK(mesh.field(vertex_of).triangles == before);
    if (h % 3 != 0) continue;
    mesh.apply(plan);
    ++flipped;
    // Fans are whole.
    std::vector<HalfEdge> fan;
    for (HalfEdge g = 3 * plan.star[0]; g < 3 * plan.star[0] + 3; ++g) {
      mesh.fan(mesh.from(g), fan);
      CHECK(std::find(fan.begin(), fan.end(), g) != fan.end());
      CHECK(mesh.from(mesh.leaving(mesh.from(g))) == mesh.from(g));
    }
  }
  CHECK(flipped > 0);
  CHECK(refused > 0);
}

TEST_CASE("Compression: flips save more, and the skeleton stays") {
  const PlanarField field = field_of(sampling::lattice_field(4, 40, true));
  for (const Equivalence e : {Equivalence::original, Equivalence::relaxed}) {
    CompressionOptions alone = options_for(e);
    alone.flips = false;
    const Compression fewer = proven(field, options_for(e)), more = proven(field, alone);
    CHECK(fewer.counts.flips > 0);
    CHECK(more.counts.flips == 0);
    CHECK(fewer.field.triangles.size() < more.field.triangles.size());
  }
  CHECK(proven(field, options_for(Equivalence::original, CollapseTest::thesis)).counts.flips == 0);
}
