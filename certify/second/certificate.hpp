// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// certify/SPEC.md, "Container", and SPEC.md, "Data section", "Claim section", "Witnesses"
// (strings): the bytes as structs. Numbers and lengths are checked here, indices and statements by
// their users.
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "certify/second/ball.hpp"

namespace crest::recheck {

using Bytes = std::basic_string<unsigned char>;

/// Reads a section or a witness string; throws Rejected where it ends too early.
class Reader {
 public:
  Reader(const unsigned char* begin, std::size_t size, std::string name)
      : at_(begin), end_(begin + size), name_(std::move(name)) {}
  std::uint8_t u8() { return number<std::uint8_t>(); }
  std::int8_t i8() { return number<std::int8_t>(); }
  std::int16_t i16() { return number<std::int16_t>(); }
  std::uint32_t u32() { return number<std::uint32_t>(); }
  std::int32_t i32() { return number<std::int32_t>(); }
  std::uint64_t u64() { return number<std::uint64_t>(); }
  double f64() { return real<double>(); }
  double f32() { return static_cast<double>(real<float>()); }
  Bytes bytes(std::size_t n);
  /// u8 n, or 255 and u32 n; then n bytes.
  Bytes string();
  /// A number of records of at least `size` bytes each, all of which are there.
  std::uint32_t count(std::size_t size);
  std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }
  void finish() const;
  [[noreturn]] void fail(const std::string& what) const { throw Rejected(name_ + ": " + what); }

 private:
  template <class T>
  T number() {  // little-endian, as the machines this runs on
    if (left() < sizeof(T)) fail("ends too early");
    T x;
    std::memcpy(&x, at_, sizeof(T));
    at_ += sizeof(T);
    return x;
  }
  template <class T>
  T real();

  const unsigned char *at_, *end_;
  std::string name_;
};

using Corners = std::array<std::uint32_t, 3>;

struct FaceRecord {
  bool in_patch = false;
  std::array<int, 2> type{};  ///< by colour: blue, red
  bool purple = false;
  std::array<int, 4> frame{};  ///< kind 0
  int w = 0;
  std::array<int, 2> verdict{};
};

struct PatchRecord {
  int axis, twice_index;
  std::array<int, 2> branches;
  std::array<double, 2> z;
  double rho, r;
  std::array<double, 2> m{};  ///< kind 0: m0, m1
  std::vector<std::uint32_t> faces;
  int order;
  std::array<double, 4> y;
  std::array<double, 6> g{};  ///< kind 0
  int c = 0;                  ///< kind 0: of its h
  Bytes witness;
};

struct SheetRecord {
  std::uint32_t face;
  std::array<double, 4> matrix;
  Bytes division;
  struct Other {
    std::uint32_t face;
    Bytes division;
  };
  std::vector<Other> others;
};

struct GraphBox {
  std::array<double, 6> bounds;
  int axis;
  std::uint32_t vertex;
  Bytes witness;
};

struct Certificate {
  std::string digest;  ///< of the data section, in hexadecimal
  bool implicit;
  std::vector<std::string> texts;  ///< F, or x, y, z and the domain
  std::array<double, 6> box{};     ///< kind 0
  std::array<bool, 2> periodic{};  ///< kind 1

  int euler;
  std::uint32_t boundary_loops, components;
  std::array<std::uint32_t, 4> umbilics;               ///< index +1/2, -1/2; one blue branch, three
  std::array<std::array<std::uint32_t, 2>, 2> curves;  ///< by colour: loops, paths
  std::array<std::uint32_t, 2> turning;
  std::uint32_t purple;
  int k0 = 0;                                   ///< kind 0
  unsigned loose = 0;                           ///< kind 1
  std::vector<std::array<double, 6>> vertices;  ///< x_i, N_i; or U, V
  std::vector<Corners> faces;
  std::vector<unsigned> lifts;  ///< kind 1, 0 without a period
  std::vector<FaceRecord> records;
  std::vector<Bytes> strings;
  std::vector<PatchRecord> patches;
  std::vector<SheetRecord> sheets;
  std::vector<GraphBox> graph_boxes;
  Bytes tree;
};

/// Throws: Rejected for anything but one well-formed certificate of claim 4, version 2, with its
/// seal.
Certificate decode(const Bytes& file);

}  // namespace crest::recheck
