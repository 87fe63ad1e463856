// SPDX-License-Identifier: GPL-3.0-or-later
// Single tets with loops inside a face, several sheets, one annulus or two disks: their counts are
// those of the same field on the tet in eight; nothing is closed inside a tet.
#include <catch2/catch.hpp>
#include <random>

#include "algorithms/modes/certificate.hpp"
#include "algorithms/modes/face_critical_points.hpp"
#include "certify/verify.hpp"
#include "tests/modes/samples.hpp"
#include "tests/support/random.hpp"

using namespace crest;
using namespace crest::tests;
using kernel::Index;
using modes::Level;

namespace {

/// One tet with small even integers: halves of their sums are exact.
modes::ModeField random_tet(Random& random) {
  modes::ModeField field{
      kernel::TetMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}), {}};
  for (int i = 0; i < 4; ++i) {
    std::array<double, 5> r;
    for (double& x : r) x = 2 * (static_cast<double>(random() % 2001) - 1000);
    field.tensors.push_back(tensor_of(r));
  }
  return field;
}

/// The same, with the middles of the edges: four tets at the corners, four in the octahedron.
modes::ModeField in_eight(const modes::ModeField& one) {
  std::vector<kernel::Vec3> points = one.mesh.points();
  std::vector<std::array<double, 6>> tensors = one.tensors;
  Index middle[4][4];
  for (Index i = 0; i < 4; ++i)
    for (Index j = 0; j < i; ++j) {
      middle[i][j] = middle[j][i] = static_cast<Index>(points.size());
      auto& p = points.emplace_back();
      auto& t = tensors.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) p[k] = (points[i][k] + points[j][k]) / 2;
      for (std::size_t k = 0; k < 6; ++k) t[k] = (tensors[i][k] + tensors[j][k]) / 2;
    }
  const auto& m = middle;
  const Index a = m[0][1], b = m[2][3];  // ends of the octahedron's diagonal
  std::vector<kernel::TetMesh::Tet> tets = {
      {0, m[0][1], m[0][2], m[0][3]}, {m[0][1], 1, m[1][2], m[1][3]},
      {m[0][2], m[1][2], 2, m[2][3]}, {m[0][3], m[1][3], m[2][3], 3},
      {a, b, m[0][2], m[0][3]},       {a, b, m[0][3], m[1][3]},
      {a, b, m[1][3], m[1][2]},       {a, b, m[1][2], m[0][2]}};
  return {kernel::TetMesh(std::move(points), std::move(tets)), std::move(tensors)};
}

/// Whether the mode has an extremum inside a face, of those in its plane.
bool has_extremum_in_face(const modes::ModeField& field) {
  for (std::size_t out = 0; out < 4; ++out) {
    std::array<std::array<double, 6>, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = field.tensors[(out + 1 + k) % 4];
    for (const auto& p : modes::face_critical_points(corners))
      if (p.extremum && p.weights[0] > 0 && p.weights[1] > 0 && p.weights[2] > 0) return true;
  }
  return false;
}

certify::Verdict verdict_of(modes::ModeField field, const Level& level) {
  const modes::ZeroSet zeros = modes::insert_zeros(field);
  std::vector<certify::ModeLevel> records(1);
  modes::extract(field, level, {}, records[0]);
  return certify::verify(certify::encode(modes::make_certificate(field, zeros, records)));
}

struct Seen {
  int face_loops = 0, sheets = 0, annuli = 0, pairs_of_disks = 0;
  void add(const modes::ModeSurface& s) {
    face_loops += s.face_loops > 0;
    sheets += s.components.size() > 1;
    int disks = 0;
    for (const auto& c : s.components) {
      annuli += c.boundary_loops == 2 && c.euler_characteristic == 0;
      disks += c.boundary_loops == 1 && c.euler_characteristic == 1;
    }
    pairs_of_disks += disks == 2 && s.components.size() == 2;
  }
};

}  // namespace

TEST_CASE("loops inside faces, several sheets, annuli and pairs of disks in one tet") {
  Random random(kSeed + 90);
  Seen seen;
  for (std::uint64_t i = 0; i < scaled(150); ++i) {
    const auto field = random_tet(random);
    const auto fine = in_eight(field);
    for (const Level& level : {Level{0, 1}, Level{1, 2}, Level{9, 10}, Level{97, 100}}) {
      INFO("tet " << i << ", mode " << level.value());
      const auto r = modes::extract(field, level), again = modes::extract(fine, level);
      REQUIRE(r.undecided.empty());
      REQUIRE(again.undecided.empty());
      for (std::size_t k = 0; k < r.surfaces.size(); ++k) {
        const auto& s = r.surfaces[k];
        seen.add(s);
        CHECK(counts_of(s) == counts_of(again.surfaces[k]));
        CHECK(s.watertight);
        for (const auto& c : s.components) CHECK(c.boundary_loops > 0);
        if (s.face_loops > 0) CHECK(has_extremum_in_face(field));
      }
      if (i < 20) CHECK(verdict_of(field, level).accepted);
    }
  }
  CAPTURE(seen.face_loops, seen.sheets, seen.annuli, seen.pairs_of_disks);
  CHECK(seen.face_loops > 10);
  CHECK(seen.sheets > 10);
  CHECK(seen.annuli > 10);
  CHECK(seen.pairs_of_disks > 10);
}
