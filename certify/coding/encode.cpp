// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/coding/encode.hpp"

#include "certify/container/compose.hpp"
#include "certify/container/container.hpp"

namespace crest::certify {
namespace {

void write_data(ByteWriter& out, const CodingCertificate& c) {
  out.count(c.positions.size());
  out.count(c.faces.size());
  out.integer(c.dropped);
  out.rows(c.faces);
  for (const auto& point : c.positions)
    for (const std::uint64_t pattern : point) out.integer(pattern);
}

void write_claims(ByteWriter& out, const CodingCertificate& c) {
  out.integer(static_cast<std::uint8_t>(c.mode));
  out.integer(static_cast<std::uint8_t>(c.keep_order));
  out.number(c.tolerance);
  for (const auto number : {c.components, c.handles, c.loops}) out.integer(number);
  out.count(c.stream.size());
  out.bytes(c.stream);
  out.numbers(std::span<const std::uint32_t>(c.permutation));
}

}  // namespace

Bytes encode(const CodingCertificate& certificate) {
  const std::size_t size =
      12 + certificate.faces.size() * kFaceSize + certificate.positions.size() * 24;
  return compose(
      {kCoding, kCodingVersion}, size, [&](ByteWriter& out) { write_data(out, certificate); },
      [&](ByteWriter& out) { write_claims(out, certificate); });
}

}  // namespace crest::certify
