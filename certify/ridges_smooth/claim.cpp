// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 4, ridges-smooth: ridges and umbilics of a surface that expressions define (SPEC.md). The
// surface stands in the certificate itself: `--input` is refused.
#include "certify/container/checker.hpp"
#include "certify/container/prove.hpp"
#include "certify/container/reject.hpp"
#include "certify/ridges_smooth/decode.hpp"
#include "certify/ridges_smooth/patches.hpp"
#include "certify/ridges_smooth/sheet.hpp"

namespace crest::certify {
namespace {

using smooth::Claim;

void describe_surface(const RidgesSmoothCertificate& c, Verdict& verdict) {
  const auto& s = c.surface;
  if (s.kind == 0)
    prove(verdict, "data: the surface {} = 0 in [{}, {}] x [{}, {}] x [{}, {}]; digests match",
          s.texts[0], s.box[0], s.box[1], s.box[2], s.box[3], s.box[4], s.box[5]);
  else
    prove(verdict,
          "data: the surface ({}; {}; {}), u in [{}, {}]{}, v in [{}, {}]{}; digests match",
          s.texts[0], s.texts[1], s.texts[2], s.texts[3], s.texts[4],
          (s.periodic & 1U) != 0 ? " periodic" : "", s.texts[5], s.texts[6],
          (s.periodic & 2U) != 0 ? " periodic" : "");
}

/// Step 2.
smooth::Mesh prove_topology(const RidgesSmoothCertificate& c, Verdict& verdict) {
  smooth::Mesh mesh = smooth::check_mesh(c);
  require_equal(c.euler_characteristic, mesh.topology.euler_characteristic, "Euler characteristic");
  require_equal(c.boundary_loops, mesh.topology.boundary_loops, "boundary loops");
  require_equal(c.components, mesh.components, "components");
  prove(verdict, "topology: {} faces, Euler characteristic {}, {} boundary loops, {} components",
        c.faces.size(), c.euler_characteristic, c.boundary_loops, c.components);
  return mesh;
}

void prove_graph(const RidgesSmoothCertificate& c, Verdict& verdict) {
  const auto& [plus, minus, one, three] = c.umbilics;
  prove(
      verdict,
      "ridges-smooth: {} umbilics ({} of +1/2, {} of -1/2; {} with one blue branch, {} with "
      "three), blue {} loops {} paths {} turning points, red {} loops {} paths {} turning points, "
      "{} purple points{}",
      c.patches.size(), plus, minus, one, three, c.counts[0], c.counts[1], c.turning_points[0],
      c.counts[2], c.counts[3], c.turning_points[1], c.purple_points,
      c.boundary_loops == 0 ? "; indices sum to the Euler characteristic" : "");
}

/// On all cores.
void verify_ridges_smooth(std::span<const std::uint8_t> data, std::span<const std::uint8_t> claims,
                          const VerifyOptions& options, Verdict& verdict) {
  const RidgesSmoothCertificate c = decode_ridges_smooth(data, claims);
  if (options.input)
    throw TieUnavailable(options.input->name +
                         ": --input compares meshes; this surface is given by expressions, which "
                         "stand in the certificate");
  const smooth::Surface surface = smooth::parse_surface(c.surface);
  describe_surface(c, verdict);
  const smooth::Mesh mesh = prove_topology(c, verdict);
  const Claim claim{surface, c, mesh, options.arithmetic};
  if (!surface.implicit) {
    SignLadder sign(options.arithmetic);
    smooth::check_unit_square(c, mesh, sign);
    verdict.signs = sign.counts();
  }
  const auto faces = smooth::check_faces(claim);
  const auto crossed = smooth::check_edges(claim, faces);
  if (surface.implicit) {
    smooth::check_one_sheet(claim, faces);
    const std::size_t leaves = smooth::check_completeness(claim);
    prove(verdict, "chart: the triangulation is the surface, all of it in the box ({} cells)",
          leaves);
  } else {
    prove(verdict, "chart: the triangulation is the domain");
  }
  prove(verdict, "faces: no umbilic outside {} patches, at most one arc of a colour in a face",
        c.patches.size());
  smooth::check_patches(claim);
  smooth::check_graph(claim, crossed);
  prove(verdict, "patches: one umbilic each, as many arcs as branches");
  prove_graph(c, verdict);
}

}  // namespace

extern const ClaimChecker ridges_smooth_claim;
const ClaimChecker ridges_smooth_claim = {kRidgesSmooth, kRidgesSmoothVersion, "ridges-smooth",
                                          verify_ridges_smooth};

}  // namespace crest::certify
