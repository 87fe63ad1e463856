// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The certificate of claim 4, ridges-smooth, as plain structs (SPEC.md).
#include "certify/certificate.hpp"

namespace crest::certify {

inline constexpr std::uint32_t kRidgesSmooth = 4, kRidgesSmoothVersion = 2;
/// Bytes of an expression, and its numbers, names and operators.
inline constexpr std::size_t kLongestText = 65535, kMostWords = 8192;

/// What expressions define a smooth surface: claim ridges-smooth.
struct SmoothSurfaceData {
  std::uint8_t kind = 0;           ///< 0 implicit, 1 parametric
  std::vector<std::string> texts;  ///< kind 0: F; kind 1: x, y, z, u0, u1, v0, v1
  std::array<double, 6> box{};     ///< kind 0: x0, x1, y0, y1, z0, z1
  std::uint8_t periodic = 0;       ///< kind 1: bit 0 in u, bit 1 in v
};

/// A face of claim ridges-smooth. Directions: SPEC.md, Forms; witnesses: SPEC.md, Witnesses.
struct SmoothFaceRecord {
  static constexpr std::uint8_t kNoZero = 255;
  bool in_patch = false;               ///< then nothing else is written
  std::array<std::int8_t, 4> frame{};  ///< kind 0
  std::array<std::uint8_t, 2> type{};  ///< blue, red: 0 none, 1 elliptic, 2 hyperbolic, 3 turning
  bool purple = false;
  std::uint8_t w = 0;
  std::array<std::uint8_t, 2> verdict{};  ///< blue, red: kNoZero, or the direction c
  Bytes witness;
};

struct SmoothPatchRecord {
  std::uint8_t axis = 0;
  std::int8_t twice_index = 0;
  std::array<std::uint8_t, 2> branches{};  ///< blue, red
  std::array<double, 2> centre{};
  double rho = 0, radius = 0;
  std::array<double, 2> height{};    ///< kind 0: m0, m1
  std::vector<std::uint32_t> faces;  ///< ascending
  std::uint8_t order = 3;            ///< of models
  std::array<double, 4> krawczyk{};  ///< Y by rows
  std::array<double, 6> graph{};     ///< kind 0: g
  std::uint8_t reach = 0;            ///< kind 0: c, the fibres' length
  Bytes witness;
};

/// Kind 0: a face with a point that no other face covers.
struct OneSheetRecord {
  struct Near {
    std::uint32_t face = 0;
    Bytes witness;
  };
  std::uint32_t face = 0;
  std::array<double, 4> matrix{};  ///< C by rows
  Bytes witness;
  std::vector<Near> near;  ///< by ascending face
};

struct GraphBoxRecord {
  std::array<double, 6> box{};  ///< x0, x1, y0, y1, z0, z1
  std::uint8_t axis = 0;
  std::uint32_t vertex = 0;
  Bytes witness;
};

/// Claim ridges-smooth: ridges and umbilics of a smooth surface given by expressions.
struct RidgesSmoothCertificate {
  SmoothSurfaceData surface;
  std::int32_t euler_characteristic = 0;
  std::uint32_t boundary_loops = 0, components = 0;
  std::array<std::uint32_t, 4> umbilics{};  ///< index +1/2, -1/2; 1-ridge, 3-ridge
  std::array<std::uint32_t, 4> counts{};    ///< blue loops, blue paths, red loops, red paths
  std::array<std::uint32_t, 2> turning_points{};
  std::uint32_t purple_points = 0;
  std::int16_t reach = 0;                           ///< kind 0: k0, of the fibres' lengths
  std::uint8_t loose_corners = 0;                   ///< kind 1
  std::vector<std::array<double, 6>> vertices;      ///< kind 0: x, N; kind 1: U, V, then zeros
  std::vector<std::array<std::uint32_t, 3>> faces;  ///< F
  std::vector<std::uint8_t> lifts;                  ///< F if periodic, else none
  std::vector<SmoothFaceRecord> face_records;       ///< F
  std::vector<SmoothPatchRecord> patches;           ///< by ascending first face
  std::vector<OneSheetRecord> one_sheet;            ///< kind 0, by ascending face
  std::vector<GraphBoxRecord> graph_boxes;          ///< kind 0
  Bytes tree;                                       ///< kind 0: codes 0-6, 6 followed by u32
};

}  // namespace crest::certify
