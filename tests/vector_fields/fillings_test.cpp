// SPDX-License-Identifier: GPL-3.0-or-later
// Holes that vertices leave: all their triangulations, and vertices taken out and put back.
#include "algorithms/vector_fields/fillings.hpp"

#include <catch2/catch.hpp>
#include <set>

#include "algorithms/vector_fields/certificate.hpp"
#include "certify/verify.hpp"
#include "kernel/predicates/planar_field.hpp"
#include "tests/vector_fields/counts.hpp"

using namespace crest;
using namespace crest::tests;
using namespace crest::vector_fields;

namespace {

constexpr std::size_t kAll = 1'000'000;

/// The first filling of the hole in which all triangles are positive.
std::optional<Fillings::Triangles> filling_of(const CollapseMesh& mesh,
                                              const std::vector<Index>& corners) {
  const auto positive = [&](std::size_t first, std::size_t apex, std::size_t last) {
    return kernel::orientation(mesh.point(corners[first]), mesh.point(corners[apex]),
                               mesh.point(corners[last])) == kernel::Sign::positive;
  };
  std::optional<Fillings::Triangles> found;
  Fillings(corners, positive).any(kAll, [&](const Fillings::Triangles& filling) {
    found = filling;
    return true;
  });
  return found;
}

/// All fans are whole, and every side but the boundary's has a twin that runs the other way.
void check_mesh(const CollapseMesh& mesh) {
  std::vector<HalfEdge> fan;
  for (HalfEdge h = 0; h < 3 * mesh.triangle_count(); ++h) {
    if (!mesh.alive(h / 3)) continue;
    mesh.fan(mesh.from(h), fan);
    CHECK(std::find(fan.begin(), fan.end(), h) != fan.end());
    const HalfEdge g = mesh.twin(h);
    if (g == kNone) {
      const Index ordinal = mesh.boundary_edge(h).ordinal;
      CHECK(mesh.edge_of_ordinal(ordinal) == h);
      continue;
    }
    CHECK(mesh.twin(g) == h);
    CHECK(mesh.from(g) == mesh.to(h));
    CHECK(mesh.to(g) == mesh.from(h));
  }
}

}  // namespace

TEST_CASE("Fillings: all triangulations of a hole, each once") {
  const auto all = [](std::size_t, std::size_t, std::size_t) { return true; };
  std::vector<Index> corners = {7, 3};
  for (const std::size_t catalan : {1, 2, 5, 14, 42, 132}) {
    corners.push_back(static_cast<Index>(10 + corners.size()));
    std::set<Fillings::Triangles> seen;
    std::size_t count = 0;
    Fillings fillings(corners, all);
    const auto note = [&](Fillings::Triangles t) {
      CHECK(t.size() == corners.size() - 2);
      std::sort(t.begin(), t.end());
      seen.insert(t);
      ++count;
      return false;
    };
    CHECK_FALSE(fillings.any(kAll, note));
    CHECK(count == catalan);
    CHECK(seen.size() == catalan);
    // So many at most, and none after one that will do.
    count = 0;
    CHECK_FALSE(fillings.any(1, note));
    CHECK(count == 1);
    count = 0;
    CHECK(fillings.any(kAll, [&](const Fillings::Triangles&) { return ++count == catalan; }));
    CHECK(count == catalan);
  }
  // A pentagon without the triangles at its corner 0 but one.
  corners.resize(5);
  std::size_t count = 0;
  Fillings some(corners, [](std::size_t first, std::size_t apex, std::size_t last) {
    return first != 0 || (apex == 2 && last == 4) || (apex == 1 && last == 2);
  });
  some.any(kAll, [&](const Fillings::Triangles& t) {
    ++count;
    CHECK(t.size() == 3);
    return false;
  });
  CHECK(count == 1);
}

TEST_CASE("Vertices taken out are put back to the last bit") {
  const PlanarField field = field_of(sampling::lattice_field(2, 12, true));
  const Domain domain(field);
  const Boundary boundary = examine_boundary(domain);
  CollapseMesh mesh(domain, boundary);
  std::vector<Index> vertex_of, corners;
  Collapse plan;
  std::size_t inner = 0, outer = 0, none = 0;
  for (Index v = 0; v < field.points.size(); ++v) {
    if (mesh.stays(v) || mesh.from(mesh.leaving(v)) != v || !mesh.alive(mesh.leaving(v) / 3))
      continue;
    const Index live = mesh.live_triangles();
    if (!mesh.plan_hole(v, corners, plan)) {
      ++none;
      continue;
    }
    const auto filling = filling_of(mesh, corners);
    if (!filling) continue;
    plan.filling = *filling;
    const bool open = plan.gone[0] == plan.gone[1];
    const auto before = mesh.field(vertex_of).triangles;
    std::vector<kernel::FieldOnTriangle> after;
    for (std::size_t k = 0; k < filling->size(); ++k)
      after.push_back(mesh.data_after(plan, plan.star[k]));
    mesh.apply(plan);
    CHECK(mesh.live_triangles() == live - (open ? 1 : 2));
    for (std::size_t k = 0; k < filling->size(); ++k) {
      CHECK(mesh.data(plan.star[k]).p == after[k].p);
      CHECK(mesh.data(plan.star[k]).v == after[k].v);
    }
    CHECK(Domain(mesh.field(vertex_of)).euler_characteristic() == domain.euler_characteristic());
    CHECK(std::find(vertex_of.begin(), vertex_of.end(), v) == vertex_of.end());
    check_mesh(mesh);
    mesh.undo();
    CHECK(mesh.field(vertex_of).triangles == before);
    check_mesh(mesh);
    ++(open ? outer : inner);
    if (v % 3 != 0) mesh.apply(plan);
  }
  CHECK(inner > 0);
  CHECK(outer > 0);
  CHECK(none > 0);
}

TEST_CASE("Compression: holes filled otherwise save more, and the skeleton stays") {
  const PlanarField field = field_of(sampling::lattice_field(6, 40, true));
  for (const Equivalence e : {Equivalence::original, Equivalence::relaxed}) {
    CompressionOptions options;
    options.equivalence = e;
    certify::CompressionCertificate record;
    const Compression c = compress(field, options, record);
    INFO(c.difference);
    REQUIRE(c.same_skeleton);
    CHECK(c.counts.filled > 0);
    CHECK(c.counts.collapses >= c.counts.filled);
    const auto verdict = certify::verify(certify::encode(record));
    INFO(verdict.reason);
    CHECK(verdict.accepted);
    options.flips = false;
    CHECK(compress(field, options).counts.filled == 0);
  }
}

TEST_CASE("Compression: a hole of hundreds of corners is left alone") {
  constexpr Index spikes = 600;  // no corner sees all others: nothing collapses
  PlanarField field;
  field.points.push_back({0, 0});
  for (Index i = 0; i < spikes; ++i) {
    const double a = 2 * 3.14159265358979 * i / spikes, r = i % 2 == 0 ? 1 : 0.5;
    field.points.push_back({r * std::cos(a), r * std::sin(a)});
    field.triangles.push_back({0, 1 + i, 1 + (i + 1) % spikes});
  }
  field.vectors.assign(field.points.size(), {1, 0.25});
  const Compression c = compress(field, {});
  CHECK(c.counts.filled == 0);
  CHECK(c.same_skeleton);
}
