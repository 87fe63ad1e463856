// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/lineart/encode.hpp"

#include "certify/container/compose.hpp"
#include "certify/container/container.hpp"

namespace crest::certify {
namespace {

void write_data(ByteWriter& out, const LineArtCertificate& c) {
  out.count(c.points.size());
  out.count(c.faces.size());
  out.count(c.creases.size());
  out.count(c.hatches.size());
  out.integer(static_cast<std::uint32_t>(c.parallel));
  out.numbers(c.eye);
  for (const auto& axis : c.view.axes) out.numbers(axis);
  out.numbers(c.view.origin);
  out.numbers(c.view.scale);
  out.rows(c.faces);
  for (const auto& [low, high] : c.creases) {
    out.integer(low);
    out.integer(high);
  }
  out.rows(c.points);
  for (const auto& hatch : c.hatches) {
    out.count(hatch.size());
    out.rows(hatch);
  }
}

void write_claims(ByteWriter& out, const LineArtCertificate& c) {
  out.count(c.edges.size());
  for (const LineEdge& edge : c.edges) {
    out.integer(edge.low);
    out.integer(edge.high);
    out.count(edge.pieces.size());
    for (std::size_t i = 0; i < edge.pieces.size(); ++i) {
      out.integer(edge.pieces[i].front);
      out.integer(edge.pieces[i].hiding);
      if (i == edge.breaks.size()) break;
      out.count(edge.breaks[i].size());
      for (const LineEvent& event : edge.breaks[i]) {
        out.integer(static_cast<std::uint8_t>(event.kind));
        out.integer(event.first);
        out.integer(event.second);
      }
    }
  }
  out.numbers(std::span<const std::uint32_t>(c.hatch_faces));
}

}  // namespace

Bytes encode(const LineArtCertificate& certificate) {
  std::size_t size = 20 + 16 * sizeof(double) + certificate.faces.size() * kFaceSize +
                     certificate.creases.size() * 8 + certificate.points.size() * 24;
  for (const auto& hatch : certificate.hatches) size += 4 + 16 * hatch.size();
  return compose(
      {kLineArt, kLineArtVersion}, size, [&](ByteWriter& out) { write_data(out, certificate); },
      [&](ByteWriter& out) { write_claims(out, certificate); });
}

}  // namespace crest::certify
