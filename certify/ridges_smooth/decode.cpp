// SPDX-License-Identifier: GPL-3.0-or-later
// No length is believed before it is compared.
#include "certify/ridges_smooth/decode.hpp"

#include "certify/container/plain_numbers.hpp"

namespace crest::certify {
namespace {

double read_number(ByteReader& reader) {
  const auto bits = reader.integer<std::uint64_t>();
  if (!is_plain(bits)) throw Malformed("a number is infinite, NaN or -0");
  return std::bit_cast<double>(bits);
}

/// A count of items that take at least `size` bytes each.
std::size_t read_count(ByteReader& reader, std::size_t size, const char* what) {
  const std::size_t count = reader.integer<std::uint32_t>();
  if (count > reader.left() / size) throw Malformed(std::string(what) + ": longer than its bytes");
  return count;
}

/// A witness string: its length in one form only.
Bytes read_witness(ByteReader& reader) {
  std::size_t count = reader.integer<std::uint8_t>();
  if (count == 255) {
    count = reader.integer<std::uint32_t>();
    if (count < 255) throw Malformed("a witness: its length in the longer form");
  }
  const auto bytes = reader.take(count);
  return {bytes.begin(), bytes.end()};
}

void read_list(ByteReader& reader, std::vector<std::uint32_t>& list, std::size_t count) {
  if (count > reader.left() / 4) throw Malformed("a list is longer than its bytes");
  reader.words(list, count);
}

SmoothSurfaceData read_surface(ByteReader& reader) {
  SmoothSurfaceData s;
  s.kind = reader.integer<std::uint8_t>();
  if (s.kind > 1) throw Malformed("data section: the kind is neither 0 nor 1");
  for (int i = 0; i < (s.kind == 0 ? 1 : 7); ++i) {
    const std::size_t length = read_count(reader, 1, "data section: a text");
    if (length > kLongestText) throw Malformed("data section: a text is too long");
    const auto text = reader.take(length);
    for (const auto byte : text)
      if (byte < 0x20 || byte > 0x7e) throw Malformed("data section: a text is not plain ASCII");
    s.texts.emplace_back(text.begin(), text.end());
  }
  if (s.kind == 0)
    for (double& x : s.box) x = read_number(reader);
  else
    s.periodic = reader.integer<std::uint8_t>();
  if (s.periodic > 3) throw Malformed("data section: unknown periodic directions");
  if (reader.left() != 0) throw Malformed("data section: bytes left over");
  return s;
}

SmoothFaceRecord read_face(ByteReader& reader, bool implicit) {
  SmoothFaceRecord f;
  const unsigned flags = reader.integer<std::uint8_t>();
  if ((flags & 3U) == 3) {
    if (flags != 3) throw Malformed("faces: a face in a patch says more");
    f.in_patch = true;
    return f;
  }
  f.type = {static_cast<std::uint8_t>(flags >> 2 & 3U), static_cast<std::uint8_t>(flags >> 4 & 3U)};
  f.purple = (flags & 64U) != 0;
  if (flags >= 128 || (flags & 3U) != 0) throw Malformed("faces: unknown flags");
  if (implicit) {
    for (auto& n : f.frame) n = reader.integer<std::int8_t>();
    if (f.frame == decltype(f.frame){}) throw Malformed("faces: a frame is zero");
  }
  f.w = reader.integer<std::uint8_t>();
  for (auto& verdict : f.verdict) {
    verdict = reader.integer<std::uint8_t>();
    if (verdict > 127 && verdict != SmoothFaceRecord::kNoZero)
      throw Malformed("faces: unknown verdict");
  }
  if (f.w > 127) throw Malformed("faces: no such direction");
  return f;
}

SmoothPatchRecord read_patch(ByteReader& reader, bool implicit) {
  SmoothPatchRecord p;
  p.axis = reader.integer<std::uint8_t>();
  if (p.axis > (implicit ? 2 : 0)) throw Malformed("patches: no such axis");
  p.twice_index = reader.integer<std::int8_t>();
  for (auto& n : p.branches) n = reader.integer<std::uint8_t>();
  for (double* x : {&p.centre[0], &p.centre[1], &p.rho, &p.radius}) *x = read_number(reader);
  if (implicit)
    for (double& x : p.height) x = read_number(reader);
  read_list(reader, p.faces, reader.integer<std::uint32_t>());
  p.order = reader.integer<std::uint8_t>();
  if (p.order != 3 && p.order != 5) throw Malformed("patches: the order is neither 3 nor 5");
  for (double& x : p.krawczyk) x = read_number(reader);
  if (implicit) {
    for (double& x : p.graph) x = read_number(reader);
    p.reach = reader.integer<std::uint8_t>();
  }
  p.witness = read_witness(reader);
  return p;
}

void read_counts(ByteReader& reader, RidgesSmoothCertificate& c) {
  c.euler_characteristic = reader.integer<std::int32_t>();
  c.boundary_loops = reader.integer<std::uint32_t>();
  c.components = reader.integer<std::uint32_t>();
  for (auto& n : c.umbilics) n = reader.integer<std::uint32_t>();
  for (auto& n : c.counts) n = reader.integer<std::uint32_t>();
  for (auto& n : c.turning_points) n = reader.integer<std::uint32_t>();
  c.purple_points = reader.integer<std::uint32_t>();
  if (c.surface.kind == 0)
    c.reach = reader.integer<std::int16_t>();
  else
    c.loose_corners = reader.integer<std::uint8_t>();
  if (c.surface.periodic != 0 && c.loose_corners != 0)
    throw Malformed("claim section: a corner of a domain without corners");
}

void read_mesh(ByteReader& reader, RidgesSmoothCertificate& c) {
  const bool implicit = c.surface.kind == 0;
  const std::size_t vertices = reader.integer<std::uint32_t>();
  const std::size_t faces = reader.integer<std::uint32_t>(), width = implicit ? 6 : 2;
  if (vertices < 3 || faces < 1) throw Malformed("claim section: no triangulation");
  if (3 * std::uint64_t{faces} > 0xfffffffeU) throw Malformed("claim section: too many faces");
  if (vertices > reader.left() / (8 * width) || faces > reader.left() / 13)
    throw Malformed("claim section: more vertices or faces than bytes");
  c.vertices.resize(vertices);
  for (auto& v : c.vertices)
    for (std::size_t i = 0; i < width; ++i) v[i] = read_number(reader);
  reader.rows(c.faces, faces);
  if (!implicit && c.surface.periodic != 0) {
    const auto lifts = reader.take(faces);
    c.lifts.assign(lifts.begin(), lifts.end());
  }
  if (faces > reader.left()) throw Malformed("claim section: more faces than bytes");
  c.face_records.reserve(faces);
  for (std::size_t f = 0; f < faces; ++f) c.face_records.push_back(read_face(reader, implicit));
  for (SmoothFaceRecord& record : c.face_records) record.witness = read_witness(reader);
}

/// What kind 0 has beside.
void read_sheets(ByteReader& reader, RidgesSmoothCertificate& c) {
  if (c.components > reader.left() / 41) throw Malformed("one sheet: longer than its bytes");
  c.one_sheet.resize(c.components);
  for (OneSheetRecord& sheet : c.one_sheet) {
    sheet.face = reader.integer<std::uint32_t>();
    for (double& x : sheet.matrix) x = read_number(reader);
    sheet.witness = read_witness(reader);
    sheet.near.resize(read_count(reader, 5, "one sheet"));
    for (auto& near : sheet.near) {
      near.face = reader.integer<std::uint32_t>();
      near.witness = read_witness(reader);
    }
  }
  c.graph_boxes.resize(read_count(reader, 54, "graph boxes"));
  for (auto& g : c.graph_boxes) {
    for (double& x : g.box) x = read_number(reader);
    g.axis = reader.integer<std::uint8_t>();
    if (g.axis > 2) throw Malformed("graph boxes: no such axis");
    g.vertex = reader.integer<std::uint32_t>();
    g.witness = read_witness(reader);
  }
  const auto tree = reader.take(read_count(reader, 1, "tree"));
  c.tree.assign(tree.begin(), tree.end());
}

}  // namespace

RidgesSmoothCertificate decode_ridges_smooth(std::span<const std::uint8_t> data,
                                             std::span<const std::uint8_t> claims) {
  RidgesSmoothCertificate c;
  ByteReader reader(data);
  c.surface = read_surface(reader);
  const bool implicit = c.surface.kind == 0;
  reader = ByteReader(claims);
  read_counts(reader, c);
  read_mesh(reader, c);
  const std::size_t patches = read_count(reader, 74, "patches");
  for (std::size_t p = 0; p < patches; ++p) c.patches.push_back(read_patch(reader, implicit));
  if (implicit) read_sheets(reader, c);
  if (reader.left() != 0) throw Malformed("claim section: bytes left over");
  return c;
}

}  // namespace crest::certify
