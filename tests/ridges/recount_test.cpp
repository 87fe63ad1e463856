// SPDX-License-Identifier: GPL-3.0-or-later
// What certificates of extracted ridges state of small meshes, counted anew from
// certify/ridges_mesh/SPEC.md.
#include <catch2/catch.hpp>
#include <cmath>

#include "algorithms/ridges/certificate.hpp"
#include "certify/verify.hpp"
#include "tests/certify/recount_ridges.hpp"
#include "tests/ridges/ridge_cases.hpp"

using namespace crest;
using namespace crest::tests;

namespace {

/// Frames that no surface has, and rotations next to half a turn (ridges_mesh/SPEC.md: 2^-200).
void spoil(std::vector<kernel::MongeForm>& forms, Draw& d) {
  for (kernel::MongeForm& m : forms) {
    const int how = d.integer(0, 7);
    const double little = std::ldexp(1, d.coin() ? -230 : -180) * (d.coin() ? 1 : 2);
    if (how == 0) m.n = m.d1;
    if (how == 1) m.k1 = m.k2;
    if (how == 2) m.b0 = m.b3 = 0;
    if (how >= 6) m.d1 = how == 6 ? kernel::Vec3{1, little, 0} : kernel::Vec3{little, 1, 0};
    if (how >= 6) m.n = {0, 0, d.coin() ? 1.0 : -1.0};
  }
}

}  // namespace

TEST_CASE("certificates of extracted ridges state what a count of its own finds") {
  const RidgeCase shapes[] = {exact_case("ellipsoid", {1, 1.5, 2}, 20, true),
                              exact_case("plane", {}, 16, false)};
  std::uint64_t salt = 7000;
  std::uint32_t frames = 0;
  for (const RidgeCase& shape : shapes)
    for (const Family family : kFamilies)
      for (std::uint64_t trial = 0; trial < scaled(2); ++trial) {
        RidgeCase c = shape;
        c.forms = random_forms(c.forms.size(), family, salt++);
        Draw d(salt++);
        spoil(c.forms, d);
        CAPTURE(name_of(family), trial);
        const auto stated =
            ridges::make_certificate(c.mesh, c.forms, ridges::extract_ridge_graph(c.mesh, c.forms));
        const certify::Verdict verdict = certify::verify(certify::encode(stated));
        CAPTURE(verdict.reason);
        CHECK(verdict.accepted);
        const RidgesRecount truth(stated.data);
        CHECK(stated.euler_characteristic == truth.euler_characteristic);
        CHECK(stated.boundary_loops == truth.boundary_loops);
        CHECK(stated.twice_index_sum == truth.twice_index_sum);
        CHECK(stated.conflict_triangles == truth.conflict_triangles);
        CHECK(stated.ambiguous_edges == truth.ambiguous_edges);
        CHECK(stated.zero_extremalities == truth.zero_extremalities);
        CHECK(stated.against_faces == truth.against_faces);
        CHECK(stated.equal_curvatures == truth.equal_curvatures);
        CHECK(stated.parallel_frames == truth.parallel_frames);
        std::vector<int> indices(stated.data.faces.size(), 0);
        for (const auto& [f, twice] : stated.face_indices) indices[f] = twice;
        CHECK(indices == truth.twice_index);
        for (const auto& patch : stated.patches)
          CHECK(patch.centre == truth.central_face(patch.faces));
        frames += truth.against_faces + truth.equal_curvatures + truth.parallel_frames;
      }
  CHECK(frames > 100);
}
