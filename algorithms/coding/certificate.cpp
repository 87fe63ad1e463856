// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/coding/certificate.hpp"

#include <bit>

namespace crest::coding {

certify::CodingCertificate make_certificate(const Encoded& encoded, std::span<const Triangle> faces,
                                            std::span<const Point> points,
                                            const EncodeOptions& options, Index dropped) {
  certify::CodingCertificate certificate;
  certificate.faces.assign(faces.begin(), faces.end());
  for (const auto& [x, y, z] : points)
    certificate.positions.push_back({std::bit_cast<std::uint64_t>(x),
                                     std::bit_cast<std::uint64_t>(y),
                                     std::bit_cast<std::uint64_t>(z)});
  certificate.dropped = dropped;
  certificate.mode = static_cast<certify::CodingMode>(options.places);
  certificate.keep_order = options.keep_order;
  certificate.tolerance = options.places == Places::rounded ? options.tolerance : 0;
  certificate.stream = encoded.stream;
  certificate.permutation = encoded.vertex_order;
  certificate.components = encoded.info.components;
  certificate.handles = encoded.info.handles;
  certificate.loops = encoded.info.loops;
  return certificate;
}

}  // namespace crest::coding
