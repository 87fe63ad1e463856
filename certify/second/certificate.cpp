// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/second/certificate.hpp"

#include <openssl/sha.h>

#include <bit>
#include <cmath>

namespace crest::recheck {

static_assert(std::endian::native == std::endian::little);

template <class T>
T Reader::real() {
  const T x = number<T>();
  if (!std::isfinite(x) || (x == 0 && std::signbit(x))) fail("a number is not finite, or -0");
  return x;
}

template double Reader::real<double>();
template float Reader::real<float>();

Bytes Reader::bytes(std::size_t n) {
  if (left() < n) fail("ends too early");
  Bytes b(at_, n);
  at_ += n;
  return b;
}
Bytes Reader::string() {
  const std::uint32_t n = u8();
  if (n < 255) return bytes(n);
  const std::uint32_t longer = u32();
  if (longer < 255) fail("a witness string has a long form without need");
  return bytes(longer);
}
std::uint32_t Reader::count(std::size_t size) {
  const std::uint32_t n = u32();
  if (n > left() / size) fail("a number of records is larger than the rest of the file");
  return n;
}
void Reader::finish() const {
  if (left() != 0) fail("has " + std::to_string(left()) + " bytes too many");
}

namespace {

Bytes sha256(const std::vector<Bytes>& parts) {
  Bytes all;
  for (const Bytes& p : parts) all += p;
  Bytes digest(SHA256_DIGEST_LENGTH, 0);
  SHA256(all.data(), all.size(), digest.data());
  return digest;
}

std::string hexadecimal(const Bytes& bytes) {
  std::string s;
  for (const unsigned char b : bytes)
    for (const int digit : {b >> 4, b & 15}) s += "0123456789abcdef"[digit];
  return s;
}

template <std::size_t N>
std::array<double, N> reals(Reader& in) {
  std::array<double, N> a;
  for (double& x : a) x = in.f64();
  return a;
}

void read_data(Reader in, Certificate& c) {
  const unsigned kind = in.u8();
  if (kind > 1) in.fail("the kind is neither 0 nor 1");
  c.implicit = kind == 0;
  for (int k = 0; k < (c.implicit ? 1 : 7); ++k) {
    const std::uint32_t n = in.u32();
    if (n > 65535) in.fail("a text is longer than 65535 bytes");
    const Bytes text = in.bytes(n);
    for (const unsigned char byte : text)
      if (byte < 32 || byte > 126) in.fail("a text is not printable ASCII");
    c.texts.emplace_back(text.begin(), text.end());
  }
  if (c.implicit) {
    c.box = reals<6>(in);
    for (Index i = 0; i < 6; i += 2)
      if (c.box[i] >= c.box[i + 1]) in.fail("the box is empty");
  } else {
    const unsigned bits = in.u8();
    if (bits > 3) in.fail("unknown bits of the periods");
    c.periodic = {(bits & 1) != 0, (bits & 2) != 0};
  }
  in.finish();
}

FaceRecord read_face(Reader& in, bool implicit) {
  FaceRecord f;
  const unsigned bits = in.u8();
  f.in_patch = (bits & 3) == 3;
  if ((f.in_patch && bits != 3) || (!f.in_patch && (bits & 3) != 0) || bits > 127)
    in.fail("a face record has unknown bits");
  if (f.in_patch) return f;
  f.type = {static_cast<int>(bits >> 2 & 3), static_cast<int>(bits >> 4 & 3)};
  f.purple = (bits >> 6 & 1) != 0;
  if (implicit) {
    bool any = false;
    for (int& e : f.frame) any |= (e = in.i8()) != 0;
    if (!any) in.fail("a frame is zero");
  }
  f.w = in.u8();
  if (f.w > 127) in.fail("a direction w is not below 128");
  for (int& verdict : f.verdict) {
    verdict = in.u8();
    if (verdict > 127 && verdict != 255) in.fail("a verdict is neither a direction nor 255");
  }
  return f;
}

PatchRecord read_patch(Reader& in, bool implicit) {
  PatchRecord p;
  p.axis = in.u8();
  if (p.axis > (implicit ? 2 : 0)) in.fail("a patch's axis is unknown");
  p.twice_index = in.i8();
  p.branches = {in.u8(), 0};
  p.branches[1] = in.u8();
  p.z = reals<2>(in);
  p.rho = in.f64();
  p.r = in.f64();
  if (implicit) p.m = reals<2>(in);
  p.faces.resize(in.count(4));
  for (std::uint32_t& f : p.faces) f = in.u32();
  p.order = in.u8();
  if (p.order != 3 && p.order != 5) in.fail("a patch's order is neither 3 nor 5");
  p.y = reals<4>(in);
  if (implicit) {
    p.g = reals<6>(in);
    p.c = in.u8();
  }
  p.witness = in.string();
  return p;
}

void read_triangulation(Reader& in, Certificate& c) {
  const std::uint32_t vertices = in.u32(), faces = in.u32();
  if (vertices > in.left() / (c.implicit ? 48 : 16) || faces > in.left() / 13)
    in.fail("there are more vertices or faces than bytes");
  for (std::uint32_t i = 0; i < vertices; ++i)
    if (c.implicit) {
      c.vertices.push_back(reals<6>(in));
    } else {
      const auto uv = reals<2>(in);
      c.vertices.push_back({uv[0], uv[1]});
    }
  c.faces.resize(faces);
  for (Corners& f : c.faces)
    for (std::uint32_t& v : f)
      if ((v = in.u32()) >= vertices) in.fail("a face has an unknown vertex");
  c.lifts.resize(faces);
  if (c.periodic[0] || c.periodic[1])
    for (unsigned& bits : c.lifts) bits = in.u8();
  for (std::uint32_t i = 0; i < faces; ++i) c.records.push_back(read_face(in, c.implicit));
  for (std::uint32_t i = 0; i < faces; ++i) c.strings.push_back(in.string());
}

void read_completeness(Reader& in, Certificate& c) {
  if (c.components > in.left() / 41) in.fail("there are more components than bytes");
  for (std::uint32_t i = 0; i < c.components; ++i) {
    SheetRecord s;
    s.face = in.u32();
    s.matrix = reals<4>(in);
    s.division = in.string();
    for (std::uint32_t n = in.count(5); n > 0; --n) {
      const std::uint32_t face = in.u32();
      s.others.push_back({face, in.string()});
    }
    c.sheets.push_back(std::move(s));
  }
  for (std::uint32_t n = in.count(54); n > 0; --n) {
    GraphBox b;
    b.bounds = reals<6>(in);
    b.axis = in.u8();
    b.vertex = in.u32();
    b.witness = in.string();
    if (b.axis > 2 || b.vertex >= c.vertices.size())
      in.fail("a graph box has no such axis or vertex");
    c.graph_boxes.push_back(std::move(b));
  }
  c.tree = in.bytes(in.count(1));
}

void read_claim(Reader in, Certificate& c) {
  c.euler = in.i32();
  c.boundary_loops = in.u32();
  c.components = in.u32();
  for (std::uint32_t& n : c.umbilics) n = in.u32();
  for (auto& colour : c.curves)
    for (std::uint32_t& n : colour) n = in.u32();
  for (std::uint32_t& n : c.turning) n = in.u32();
  c.purple = in.u32();
  if (c.implicit)
    c.k0 = in.i16();
  else
    c.loose = in.u8();
  read_triangulation(in, c);
  for (std::uint32_t n = in.count(55); n > 0; --n) c.patches.push_back(read_patch(in, c.implicit));
  if (c.implicit) read_completeness(in, c);
  in.finish();
}

}  // namespace

Certificate decode(const Bytes& file) {
  Reader in(file.data(), file.size(), "certificate");
  const Bytes magic = in.bytes(8);
  if (std::memcmp(magic.data(), "CRESTCRT", 8) != 0) in.fail("does not begin with CRESTCRT");
  const std::uint32_t version = in.u32(), claim = in.u32();
  if (claim != 4) in.fail("is of claim " + std::to_string(claim) + ", this program knows claim 4");
  if (version != 2) in.fail("has version " + std::to_string(version) + ", this program knows 2");
  const Bytes digest = in.bytes(32);
  const std::uint64_t data_size = in.u64(), claim_size = in.u64();
  if (in.left() < 32 || data_size > in.left() - 32 || claim_size != in.left() - 32 - data_size)
    in.fail("the lengths of its sections are not that of the file");
  const Bytes data = in.bytes(data_size), body = in.bytes(claim_size), seal = in.bytes(32);
  if (sha256({data}) != digest) in.fail("the data digest is that of other data");
  if (sha256({file.substr(0, 64), body}) != seal) in.fail("the seal is broken");
  Certificate c;
  c.digest = hexadecimal(digest);
  read_data(Reader(data.data(), data.size(), "data section"), c);
  read_claim(Reader(body.data(), body.size(), "claim section"), c);
  return c;
}

}  // namespace crest::recheck
