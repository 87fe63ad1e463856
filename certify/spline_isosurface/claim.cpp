// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 13, spline-isosurface: the topology of a level set of a quadratic spline (SPEC.md).
#include "certify/container/checker.hpp"
#include "certify/container/prove.hpp"
#include "certify/container/reject.hpp"
#include "certify/spline_isosurface/decode.hpp"
#include "certify/spline_isosurface/mesh.hpp"
#include "certify/surface/mesh_checks.hpp"
#include "certify/surface/union_find.hpp"

namespace crest::certify {
namespace {

using namespace spline_isosurface;

std::size_t count_components(const Mesh& mesh) {
  UnionFind classes(mesh.vertices.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    classes.join(a, b);
    classes.join(a, c);
  }
  std::size_t count = 0;
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) count += classes.find(v) == v;
  return count;
}

/// Cost: n log n.
void verify_spline_isosurface(std::span<const std::uint8_t> data,
                              std::span<const std::uint8_t> claims, const VerifyOptions& options,
                              Verdict& verdict) {
  const SplineIsosurfaceCertificate c = decode_spline_isosurface(data, claims);
  if (options.input)
    throw TieUnavailable(options.input->name +
                         ": --input cannot compare samples; compare the data digest with the one "
                         "in the output");
  const kernel::Sign direct = orientation(c.volume);
  const auto& n = c.volume.nodes;
  prove(verdict, "data: {} x {} x {} samples{}, level {}; digests match", n[0], n[1], n[2],
        c.volume.extended ? " and an extended layer" : "", c.volume.level);
  const QuadraticSpline spline(c.volume);
  const Forest forest(c, spline);
  forest.check_conforming();
  prove(verdict, "leaves: {} tetrahedra bisected into {}, {} deep at most; all leaves conform",
        forest.bisected(), forest.leaves(), forest.deepest());
  const Leaves leaves = check_leaves(c.volume, spline, forest);
  prove(verdict, "{} leaves are simple, all others empty", leaves.simple);
  const Mesh mesh = build_mesh(leaves, direct);
  require_equal(static_cast<std::int64_t>(c.brackets.size()), mesh.vertices.size(), "vertices");
  require(c.triangles == mesh.triangles, "the triangles are not those of the signs");
  check_brackets(c, spline, forest, leaves, mesh);
  const Topology topology = build_topology(c.triangles, c.brackets.size());
  require_equal(c.euler_characteristic, topology.euler_characteristic, "Euler characteristic");
  require_equal(std::int64_t{c.boundary_loops}, topology.boundary_loops, "boundary loops");
  require_equal(std::int64_t{c.components}, count_components(mesh), "components");
  prove(verdict,
        "mesh: {} vertices, {} triangles, {} components, Euler characteristic {}, {} boundary "
        "loops; isotopic to the level set just below",
        c.brackets.size(), c.triangles.size(), c.components, c.euler_characteristic,
        c.boundary_loops);
}

}  // namespace

extern const ClaimChecker spline_isosurface_claim;
const ClaimChecker spline_isosurface_claim = {kSplineIsosurface, kSplineIsosurfaceVersion,
                                              "spline-isosurface", verify_spline_isosurface};

}  // namespace crest::certify
