// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/spline_rays/encode.hpp"

#include <algorithm>

#include "certify/container/compose.hpp"

namespace crest::certify {

Bytes encode(const SplineRaysCertificate& c) {
  require_fit(c.volume);
  if (c.meets.size() != c.rays.size() ||
      static_cast<std::size_t>(std::ranges::count(c.meets, 1)) != c.hits.size())
    throw std::invalid_argument("certificate: rays and hits that do not fit");
  const auto write_data = [&](ByteWriter& out) {
    write_volume(out, c.volume);
    out.count(c.rays.size());
    out.rows(c.rays);
  };
  const auto write_claims = [&](ByteWriter& out) {
    out.bytes(c.meets);
    for (const SplineHit& hit : c.hits) {
      out.integer(hit.cube);
      out.integer(hit.tetrahedron);
      out.number(hit.low);
      out.number(hit.high);
    }
  };
  return compose({kSplineRays, kSplineRaysVersion}, encoded_size(c.volume) + 4 + 48 * c.rays.size(),
                 write_data, write_claims);
}

}  // namespace crest::certify
