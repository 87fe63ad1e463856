// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/lineart/decode.hpp"

#include "certify/container/plain_numbers.hpp"

namespace crest::certify {
namespace {

using u32 = std::uint32_t;

template <std::size_t n>
void read_plain(ByteReader& reader, std::array<double, n>& numbers, const char* what) {
  std::vector<std::array<double, n>> row;
  reader.rows(row, 1);
  require_plain_rows(row, what);
  numbers = row.front();
}

void read_data(ByteReader reader, LineArtCertificate& c) {
  const u32 vertices = reader.integer<u32>(), faces = reader.integer<u32>(),
            creases = reader.integer<u32>(), hatches = reader.integer<u32>();
  const u32 parallel = reader.integer<u32>();
  if (parallel > 1) throw Malformed("data section: neither a parallel view nor one in perspective");
  c.parallel = parallel == 1;
  read_plain(reader, c.eye, "eye");
  for (auto& axis : c.view.axes) read_plain(reader, axis, "view");
  read_plain(reader, c.view.origin, "view");
  read_plain(reader, c.view.scale, "view");
  if (faces < 1 || vertices < 3) throw Malformed("data section: no faces");
  if (faces > 0x3fffffffU || vertices > 0x3fffffffU)
    throw Malformed("data section: more faces or vertices than the format numbers");
  reader.rows(c.faces, faces);
  reader.rows(c.creases, creases);
  reader.rows(c.points, vertices);
  require_plain_rows(c.points, "points");
  for (u32 h = 0; h < hatches; ++h) {
    auto& hatch = c.hatches.emplace_back();
    reader.rows(hatch, reader.integer<u32>());
    require_plain_rows(hatch, "hatches");
  }
  if (reader.left() != 0) throw Malformed("data section: bytes left over");
}

LineEvent read_event(ByteReader& reader) {
  LineEvent event;
  const auto kind = reader.integer<std::uint8_t>();
  if (kind > LineEvent::kPiercing) throw Malformed("claim section: an event of no kind");
  event.kind = static_cast<LineEvent::Kind>(kind);
  event.first = reader.integer<u32>();
  event.second = reader.integer<u32>();
  return event;
}

void read_claims(ByteReader reader, LineArtCertificate& c) {
  const u32 edges = reader.integer<u32>();
  for (u32 e = 0; e < edges; ++e) {
    LineEdge& edge = c.edges.emplace_back();
    edge.low = reader.integer<u32>();
    edge.high = reader.integer<u32>();
    const u32 pieces = reader.integer<u32>();
    for (u32 i = 0; i < pieces; ++i) {
      LinePiece& piece = edge.pieces.emplace_back();
      piece.front = reader.integer<u32>();
      piece.hiding = reader.integer<u32>();
      if (i + 1 == pieces) break;
      auto& events = edge.breaks.emplace_back();
      for (u32 left = reader.integer<u32>(); left > 0; --left) events.push_back(read_event(reader));
    }
  }
  reader.words(c.hatch_faces, c.hatches.size());
  if (reader.left() != 0) throw Malformed("claim section: bytes left over");
}

}  // namespace

LineArtCertificate decode_line_art(std::span<const std::uint8_t> data,
                                   std::span<const std::uint8_t> claims) {
  LineArtCertificate c;
  read_data(ByteReader(data), c);
  read_claims(ByteReader(claims), c);
  return c;
}

}  // namespace crest::certify
