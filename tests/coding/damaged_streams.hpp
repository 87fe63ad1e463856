// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Streams of all kinds to be damaged, and how damage gets past their checksums.
#include <bit>
#include <boost/crc.hpp>
#include <vector>

#include "algorithms/coding/coding.hpp"
#include "tests/coding/meshes.hpp"

namespace crest::tests {

/// At vertices, corners, faces in turn, some with gaps.
inline std::vector<kernel::Attribute> some_attributes(const PlainMesh& mesh, int count) {
  std::vector<kernel::Attribute> list;
  for (int i = 0; i < count; ++i) {
    kernel::Attribute a{"heat", static_cast<kernel::Site>(2 * i % 3),
                        static_cast<kernel::NumberType>(9 - i), 1 + i % 4u};
    const std::size_t places = a.site == kernel::Site::vertices ? mesh.points.size()
                               : a.site == kernel::Site::faces  ? mesh.faces.size()
                                                                : 3 * mesh.faces.size();
    for (std::size_t k = 0; k < places * a.components; ++k) {
      const std::uint64_t x = k * k / 50 % 100;
      a.words.push_back(is_real(a.type) ? std::bit_cast<std::uint64_t>(static_cast<double>(x)) : x);
    }
    if (i % 2 == 1)
      for (std::size_t k = 0; k < places; ++k) a.missing.push_back(k % 7 == 3);
    for (std::size_t k = 0; k < a.words.size(); ++k)
      if (!a.has(k % places)) a.words[k] = 0;
    list.push_back(std::move(a));
  }
  return list;
}

inline std::vector<coding::Bytes> some_streams(Random& random) {
  PlainMesh mesh = joined_tori(2, 6, 7);
  flip_edges(mesh, 400, random);
  mesh = punch_holes(mesh, 2, random);
  std::vector<coding::Bytes> streams;
  for (int i = 0; i < 12; ++i) {
    coding::EncodeOptions options;
    options.method = static_cast<coding::Method>(i % 4);
    options.places = static_cast<coding::Places>(i / 4);
    options.tolerance = 0.01;
    options.keep_order = i % 3 == 0;
    const auto attributes = some_attributes(mesh, i % 2 == 0 ? i / 2 : 0);
    streams.push_back(
        coding::encode(mesh.vertices(), mesh.faces, mesh.points, options, attributes).stream);
  }
  const PlainMesh stacked = with_stacked_faces(torus_grid(12, 12), 90, random);
  const coding::EncodeOptions bare{.places = coding::Places::none};  // with clearance
  streams.push_back(coding::encode(stacked.vertices(), stacked.faces, {}, bare).stream);
  return streams;
}

/// Makes the checksums of all sections right.
inline void renew_checksums(coding::Bytes& stream) {
  std::size_t at = 7;
  const auto varint = [&] {
    std::size_t x = 0;
    for (int shift = 0; at < stream.size() && shift < 35; shift += 7) {
      x |= std::size_t{stream[at] & 127u} << shift;
      if (stream[at++] < 128) break;
    }
    return x;
  };
  const int flags = stream[5];
  varint();
  for (int bit = 0; bit < 3; ++bit)
    if ((flags >> bit & 1) != 0) varint();
  const int sections =
      1 + ((flags & 24) != 0 ? 1 : 0) + ((flags & 32) != 0 ? 1 : 0) + ((flags & 64) != 0 ? 1 : 0);
  for (int i = 0; i < sections; ++i) {
    const std::size_t size = varint();
    if (at + 4 + size > stream.size()) return;
    boost::crc_32_type crc;
    crc.process_bytes(stream.data() + at + 4, size);
    for (int k = 0; k < 4; ++k)
      stream[at + static_cast<std::size_t>(k)] =
          static_cast<std::uint8_t>(crc.checksum() >> (8 * k));
    at += 4 + size;
  }
}

}  // namespace crest::tests
