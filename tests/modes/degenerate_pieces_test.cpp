// SPDX-License-Identifier: GPL-3.0-or-later
// Degenerate curves of fields cut into pieces: joined, they are those of the whole, byte for byte.
#include <catch2/catch.hpp>
#include <tuple>

#include "algorithms/modes/curves_certificate.hpp"
#include "algorithms/modes/degenerate_curves.hpp"
#include "algorithms/modes/degenerate_faces.hpp"
#include "certify/modes_curves/encode.hpp"
#include "tests/modes/samples.hpp"
#include "tests/support/random.hpp"

using namespace crest;
using namespace crest::tests;
using kernel::Index;

TEST_CASE("mode pieces: degenerate curves have the bytes of the whole, special faces, too") {
  std::size_t points = 0, special = 0;
  Random random(8);
  const auto real = [&] { return static_cast<double>(random() % 1000) / 999 - 0.5; };
  for (const auto& field : {random_integers(4, 6), random_integers(5, 7), random_box(6, real)}) {
    const auto curves_of = [&](const modes::FaceWorkers* workers) {
      return modes::degenerate_curves(field.mesh.points(), field.mesh.tets(), field.tensors,
                                      workers);
    };
    const auto bytes_of = [&](const modes::DegenerateCurves& curves) {
      return certify::encode(
          modes::curves_certificate(field.mesh.points(), field.mesh.tets(), field.tensors, curves));
    };
    const modes::DegenerateCurves whole = curves_of(nullptr);
    points += whole.points.size();
    special += whole.special_faces.size();
    const auto counts = [](const modes::DegenerateCurves& c) {
      return std::tie(c.counts.rejected_tets, c.counts.rejected_faces, c.counts.triage_faces,
                      c.counts.exact_faces, c.undecided, c.degenerate_edges, c.multiple_faces);
    };
    for (const std::size_t pieces : {std::size_t{2}, std::size_t{7}, field.mesh.tets().size()}) {
      const modes::FaceWorkers workers = modes::face_workers_here(static_cast<Index>(pieces));
      const modes::DegenerateCurves joined = curves_of(&workers);
      CHECK(bytes_of(joined) == bytes_of(whole));
      CHECK(counts(joined) == counts(whole));
      REQUIRE(joined.curves.size() == whole.curves.size());
      for (std::size_t k = 0; k < whole.curves.size(); ++k)
        CHECK(joined.curves[k].polyline == whole.curves[k].polyline);
    }
  }
  CHECK(points > 100);
  CHECK(special > 10);
}
