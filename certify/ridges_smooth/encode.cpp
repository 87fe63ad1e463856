// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/ridges_smooth/encode.hpp"

#include "certify/container/compose.hpp"

namespace crest::certify {
namespace {

void write_surface(ByteWriter& out, const SmoothSurfaceData& s) {
  if (s.kind > 1 || s.texts.size() != (s.kind == 0 ? 1 : 7))
    throw std::invalid_argument("certificate: kind 0 has one text, kind 1 seven");
  out.integer(s.kind);
  for (const std::string& text : s.texts) {
    if (text.size() > kLongestText)
      throw std::invalid_argument("certificate: an expression is too long");
    out.count(text.size());
    for (const char c : text) out.integer(static_cast<std::uint8_t>(c));
  }
  if (s.kind == 0)
    for (const double x : s.box) out.number(x);
  else
    out.integer(s.periodic);
}

void write_witness(ByteWriter& out, const Bytes& witness) {
  if (witness.size() < 255) {
    out.integer(static_cast<std::uint8_t>(witness.size()));
  } else {
    out.integer(std::uint8_t{255});
    out.count(witness.size());
  }
  out.bytes(witness);
}

void write_face(ByteWriter& out, const SmoothFaceRecord& f, bool implicit) {
  if (f.in_patch) return out.integer(std::uint8_t{3});
  const unsigned flags = (f.type[0] & 3U) << 2 | (f.type[1] & 3U) << 4 | (f.purple ? 64U : 0U);
  out.integer(static_cast<std::uint8_t>(flags));
  if (implicit)
    for (const auto n : f.frame) out.integer(n);
  out.integer(f.w);
  for (const auto verdict : f.verdict) out.integer(verdict);
}

void write_patch(ByteWriter& out, const SmoothPatchRecord& p, bool implicit) {
  out.integer(p.axis);
  out.integer(p.twice_index);
  for (const auto n : p.branches) out.integer(n);
  for (const double x : {p.centre[0], p.centre[1], p.rho, p.radius}) out.number(x);
  if (implicit)
    for (const double x : p.height) out.number(x);
  out.count(p.faces.size());
  out.numbers(p.faces);
  out.integer(p.order);
  for (const double x : p.krawczyk) out.number(x);
  if (implicit) {
    for (const double x : p.graph) out.number(x);
    out.integer(p.reach);
  }
  write_witness(out, p.witness);
}

void write_sheet(ByteWriter& out, const OneSheetRecord& sheet) {
  out.integer(sheet.face);
  for (const double x : sheet.matrix) out.number(x);
  write_witness(out, sheet.witness);
  out.count(sheet.near.size());
  for (const auto& near : sheet.near) {
    out.integer(near.face);
    write_witness(out, near.witness);
  }
}

void write_counts(ByteWriter& out, const RidgesSmoothCertificate& c) {
  out.integer(c.euler_characteristic);
  out.integer(c.boundary_loops);
  out.integer(c.components);
  for (const auto n : c.umbilics) out.integer(n);
  for (const auto n : c.counts) out.integer(n);
  for (const auto n : c.turning_points) out.integer(n);
  out.integer(c.purple_points);
  if (c.surface.kind == 0)
    out.integer(c.reach);
  else
    out.integer(c.loose_corners);
}

void write_claims(ByteWriter& out, const RidgesSmoothCertificate& c) {
  const bool implicit = c.surface.kind == 0;
  write_counts(out, c);
  out.count(c.vertices.size());
  out.count(c.faces.size());
  for (const auto& v : c.vertices)
    for (std::size_t i = 0; i < (implicit ? 6 : 2); ++i) out.number(v[i]);
  for (const auto& f : c.faces)
    for (const auto v : f) out.integer(v);
  if (!implicit && c.surface.periodic != 0) out.bytes(c.lifts);
  for (const auto& f : c.face_records) write_face(out, f, implicit);
  for (const auto& f : c.face_records) write_witness(out, f.witness);
  out.count(c.patches.size());
  for (const auto& p : c.patches) write_patch(out, p, implicit);
  if (!implicit) return;
  for (const auto& sheet : c.one_sheet) write_sheet(out, sheet);
  out.count(c.graph_boxes.size());
  for (const auto& g : c.graph_boxes) {
    for (const double x : g.box) out.number(x);
    out.integer(g.axis);
    out.integer(g.vertex);
    write_witness(out, g.witness);
  }
  out.count(c.tree.size());
  out.bytes(c.tree);
}

}  // namespace

Bytes encode(const RidgesSmoothCertificate& c) {
  const bool lifted = c.surface.kind == 1 && c.surface.periodic != 0;
  if (c.face_records.size() != c.faces.size() || (lifted && c.lifts.size() != c.faces.size()))
    throw std::invalid_argument("certificate: as many records and lifts as faces are needed");
  if (c.surface.kind == 0 && c.one_sheet.size() != c.components)
    throw std::invalid_argument("certificate: a named face of each component is needed");
  ByteWriter data;
  write_surface(data, c.surface);
  return compose(
      {kRidgesSmooth, kRidgesSmoothVersion}, data.size(),
      [&](ByteWriter& out) { out.bytes(data.result()); },
      [&](ByteWriter& out) { write_claims(out, c); });
}

}  // namespace crest::certify
