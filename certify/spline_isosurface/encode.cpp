// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/spline_isosurface/encode.hpp"

#include "certify/container/compose.hpp"

namespace crest::certify {

Bytes encode(const SplineIsosurfaceCertificate& c) {
  require_fit(c.volume);
  const auto write_claims = [&](ByteWriter& out) {
    out.count(c.bisected.size());
    out.numbers(c.bisected);
    out.count(c.trees.size());
    out.bytes(c.trees);
    out.count(c.brackets.size());
    out.rows(c.brackets);
    out.count(c.triangles.size());
    out.rows(c.triangles);
    out.integer(c.euler_characteristic);
    out.integer(c.components);
    out.integer(c.boundary_loops);
  };
  return compose(
      {kSplineIsosurface, kSplineIsosurfaceVersion}, encoded_size(c.volume),
      [&](ByteWriter& out) { write_volume(out, c.volume); }, write_claims);
}

}  // namespace crest::certify
