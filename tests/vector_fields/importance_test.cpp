// SPDX-License-Identifier: GPL-3.0-or-later
// Weights of zeros and separatrices: partners, the rules, ties.
#include "algorithms/vector_fields/importance.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "algorithms/sampling/planar_fields.hpp"
#include "algorithms/vector_fields/vector_fields.hpp"
#include "tests/vector_fields/counts.hpp"

using namespace crest;
using namespace crest::tests;
using namespace crest::vector_fields;

namespace {

int index_of(const CriticalPoint& c) {
  return c.index.value_or(0);
}

/// Partners are mutual and of opposite index, the three rules hold, the indices of what is kept
/// have one sum at all thresholds.
void check_importance(const Skeleton& s, const Importance& w) {
  REQUIRE(w.zeros.size() == s.critical_points.size());
  REQUIRE(w.separatrices.size() == s.separatrices.size());
  std::set<double> thresholds = {0, 1};
  for (Index z = 0; z < w.zeros.size(); ++z) {
    const ZeroWeight& a = w.zeros[z];
    CHECK(a.weight >= a.first);
    CHECK(a.weight <= 1);
    thresholds.insert(a.weight);
    if (a.end != PathEnd::partner) {
      CHECK(a.weight == 1);
      continue;
    }
    REQUIRE(a.partner < w.zeros.size());
    const ZeroWeight& b = w.zeros[a.partner];
    CHECK(b.partner == z);
    CHECK(a.first == b.first);
    CHECK(a.weight == b.weight);
    CHECK(index_of(s.critical_points[z]) == -index_of(s.critical_points[a.partner]));
  }
  for (std::size_t i = 0; i < w.separatrices.size(); ++i) {
    const Separatrix& l = s.separatrices[i];
    CHECK(w.separatrices[i] == (l.from_switch_point ? 1 : w.zeros[l.origin].weight));
    if (l.end == EndKind::critical_point) CHECK(w.zeros[l.target].weight >= w.separatrices[i]);
  }
  for (const double least : thresholds) {
    int sum = 0;
    for (Index z = 0; z < w.zeros.size(); ++z)
      if (w.zeros[z].weight >= least) sum += index_of(s.critical_points[z]);
    CHECK(sum == s.index_sum);
  }
}

Importance weights(const PlanarField& field, Skeleton& skeleton,
                   Laplacian laplacian = Laplacian::uniform) {
  skeleton = extract_skeleton(field);
  return weigh(field, smoothed(field, laplacian), skeleton);
}

}  // namespace

TEST_CASE("Weights: pairs of lattice fields and of the twins") {
  struct Row {
    sampling::PlanarSample sample;
    std::size_t pairs, staying;
  };
  const Row rows[] = {{sampling::lattice_field(3, 48, false, 12), 25, 7},
                      {sampling::twin_bodden(), 33, 6},
                      {sampling::twin_skin(), 168, 2}};
  for (const Row& row : rows) {
    const PlanarField field = field_of(row.sample);
    Skeleton skeleton;
    const Importance w = weights(field, skeleton);
    CHECK(w.pairs == row.pairs);
    CHECK(w.staying == row.staying);
    CHECK(w.open == 0);
    check_importance(skeleton, w);
  }
}

TEST_CASE("Weights: the field on its way to the smoothed one loses the pairs that weigh less") {
  const PlanarField field = field_of(sampling::lattice_field(5, 40));
  const Skeleton skeleton = extract_skeleton(field);
  const auto smooth = smoothed(field);
  const Importance w = weigh(field, smooth, skeleton);
  for (const double t : {0.25, 0.5, 0.75}) {
    std::size_t left = 0;
    for (const ZeroWeight& z : w.zeros) left += z.first >= t ? 1 : 0;
    const Skeleton at = extract_skeleton(blended(field, smooth, t));
    // Pairs may be born on the way: they belong to nobody.
    CHECK(at.critical_points.size() >= left);
    CHECK((at.critical_points.size() - left) % 2 == 0);
    CHECK(at.index_sum == skeleton.index_sum);
  }
}

TEST_CASE("Weights: smoothing keeps the boundary and averages the rest") {
  const PlanarField field = field_of(sampling::lattice_field(2, 24, true));
  for (const Laplacian laplacian : {Laplacian::uniform, Laplacian::cotan}) {
    const auto smooth = smoothed(field, laplacian);
    std::size_t same = 0;
    for (std::size_t v = 0; v < smooth.size(); ++v) same += smooth[v] == field.vectors[v] ? 1 : 0;
    CHECK(same == 4 * 24 + 4 * 6);
    Skeleton skeleton;
    check_importance(skeleton, weights(field, skeleton, laplacian));
    // No component beyond those of the boundary: means have no extrema inside.
    for (std::size_t k = 0; k < 2; ++k) {
      double most = -HUGE_VAL, most_smooth = -HUGE_VAL;
      for (std::size_t v = 0; v < smooth.size(); ++v) {
        most_smooth = std::max(most_smooth, smooth[v][k]);
        if (smooth[v] == field.vectors[v]) most = std::max(most, smooth[v][k]);
      }
      CHECK(most_smooth <= most * (1 + 1e-12));
    }
  }
}

TEST_CASE("Weights: what meets a tie is left open and weighs 1") {
  Random random(7);
  std::size_t open = 0;
  for (int i = 0; i < 2; ++i) {
    PlanarField field = field_of(sampling::lattice_field(1, 6));
    for (auto& v : field.vectors)
      v = {static_cast<double>(random() % 5) - 2, static_cast<double>(random() % 5) - 2};
    Skeleton skeleton;
    const Importance w = weights(field, skeleton);
    for (std::size_t z = 0; z < w.zeros.size(); ++z) {
      if (skeleton.critical_points[z].where != ZeroPlace::triangle)
        CHECK(w.zeros[z].end == PathEnd::open);
      if (w.zeros[z].end == PathEnd::open) CHECK(w.zeros[z].weight == 1);
    }
    check_importance(skeleton, w);
    open += w.open;
  }
  CHECK(open > 0);
}

TEST_CASE("Weights: the important part names its own zeros") {
  const PlanarField field = field_of(sampling::twin_bodden());
  Skeleton skeleton;
  const Importance w = weights(field, skeleton);
  const Skeleton part = important_part(skeleton, w, 0.5);
  CHECK(part.critical_points.size() < skeleton.critical_points.size());
  CHECK(part.separatrices.size() < skeleton.separatrices.size());
  for (const Separatrix& s : part.separatrices)
    if (s.end == EndKind::critical_point)
      CHECK(part.critical_points.at(s.target).kind != ZeroKind::saddle);
  CHECK(important_part(skeleton, w, 0).separatrices.size() == skeleton.separatrices.size());
}
