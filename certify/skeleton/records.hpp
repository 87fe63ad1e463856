// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The certificate of claim 9, skeleton, as plain structs (SPEC.md).
#include <array>
#include <cstdint>
#include <vector>

namespace crest::certify {

inline constexpr std::uint32_t kSkeleton = 9, kSkeletonVersion = 1;

// Triangle f has corners 3f, 3f + 1, 3f + 2, counter-clockwise; side c runs from corner c to the
// next one, the triangle at its left. A point in an open side is one double t: t > 0 is
// tail + t (head - tail), t < 0 is head + |t| (tail - head); 0 < |t| <= 1/2, never -1/2.

enum class ZeroPlace : std::uint8_t { triangle, edge, vertex, line, region };
enum class ZeroClass : std::uint8_t { saddle, source, sink, centre, higher_order };

inline constexpr std::int32_t kNoIndex = INT32_MIN;
inline constexpr std::uint32_t kNotStated = 0xffffffffU;

/// A component of the zero set.
struct SkeletonZero {
  std::uint32_t triangle = 0;  ///< the first that it meets
  ZeroPlace place = ZeroPlace::triangle;
  ZeroClass kind = ZeroClass::saddle;  ///< higher_order unless inside a triangle
  std::uint8_t focus = 0;              ///< 1: source or sink with complex eigenvalues
  std::int32_t index = kNoIndex;       ///< kNoIndex: line, region, or on the boundary
  std::uint32_t hyperbolic = kNotStated, elliptic = kNotStated;  ///< edge, vertex with an index
};

/// Where v.N changes its sign along a loop.
struct SkeletonSwitch {
  std::uint32_t side = 0;   ///< it lies in this side (not at its tail, perhaps at its head)
  std::uint8_t place = 0;   ///< 0: inside the side, 1: corner (no zero of v.N), 2: tangent run
  std::uint8_t inside = 0;  ///< 1: the stream line touches from inside
};

struct SkeletonLoop {
  std::uint32_t side = 0;  ///< the least
  std::uint8_t zero = 0;   ///< 1: it meets a zero, the numbers below are 0
  std::int32_t winding = 0, turning = 0;
  std::uint32_t interior = 0, exterior = 0, inflow = 0, outflow = 0;
};

/// A point of a triangle in the frame of a corner c: c + a (next - c) + b (previous - c).
struct SkeletonPoint {
  std::uint32_t corner = 0;
  double a = 0, b = 0;
};

/// Whoever enters stays and ends in the zero. Inside a triangle or a side: the ellipse
/// (x - z)^T P (x - z) < 1 in the frame of corner 0 of its first triangle. Vertex: a polygon.
struct SkeletonTrap {
  std::uint32_t zero = 0;
  std::array<double, 3> form{};     ///< P: aa, ab, bb; vertex: zeros
  std::vector<SkeletonPoint> star;  ///< counter-clockwise; not a vertex: empty
};

/// Entered through side k, left through k + 1, k + 2 or k.
enum class Turn : std::uint8_t { right, left, back };

/// How barriers are made (SPEC.md, "Barriers").
struct SkeletonBarrier {
  std::uint8_t degree = 10;
  std::uint16_t angle = 30;  ///< theta = 2^-angle
  std::uint16_t bits = 53;
  std::int8_t shrink = 0;  ///< steps are 2^-shrink times as long
};
/// A step whose barriers are others.
struct SkeletonException {
  std::uint32_t step = 0;
  SkeletonBarrier barrier;
};

enum class LegKind : std::uint8_t { ray, point, along, straight };

/// Part of a stream line, from a start on.
struct SkeletonLeg {
  LegKind kind = LegKind::ray;
  std::uint32_t corner = 0;
  std::vector<double> first, second;  ///< by kind (SPEC.md, "Legs")
  std::uint32_t elements = 0;         ///< straight: how many
  std::vector<Turn> turns;            ///< not straight: one a triangle crossed
  SkeletonBarrier barrier;
  std::vector<SkeletonException> exceptions;
};

enum class SkeletonOrigin : std::uint8_t { zero, switch_point, vertex };
enum class SkeletonEnd : std::uint8_t { zero, switch_point, boundary, orbit, undecided };
enum class OpenReason : std::uint8_t { none, saddle_connection, vertex_hit, weak_focus, budget };

/// Or a stream line through a vertex, a witness.
struct SkeletonSeparatrix {
  SkeletonOrigin origin = SkeletonOrigin::zero;
  std::uint32_t from = 0;         ///< number of the zero or switch point, or a corner
  std::uint8_t backward = 0;      ///< 1: a stream line of -v
  std::vector<SkeletonLeg> legs;  ///< none: nothing is known but that it is there
  SkeletonEnd end = SkeletonEnd::undecided;
  std::uint32_t to = 0;  ///< zero, switch point, region or orbit; 0 if undecided
  OpenReason reason = OpenReason::none;
};

/// A closed chain of cells that returns into its first segment.
struct SkeletonOrbit {
  std::uint32_t side = 0;      ///< entered through this side of its triangle
  std::uint8_t backward = 0;   ///< 1: of -v, so repelling
  double left = 0, right = 0;  ///< ends of the segment in this side
  std::vector<Turn> turns;     ///< the last leaves into `side` again
  SkeletonBarrier barrier;
  std::vector<SkeletonException> exceptions;
};

/// Claim skeleton: the topological skeleton of a planar piecewise linear vector field.
struct SkeletonCertificate {
  std::vector<std::array<double, 2>> positions;         ///< V
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< F
  std::vector<std::array<double, 2>> vectors;           ///< V
  std::vector<SkeletonZero> zeros;                      ///< ascending by triangle
  std::vector<SkeletonSwitch> switches;                 ///< by loop, then along it
  std::vector<SkeletonLoop> loops;                      ///< ascending by side
  std::vector<SkeletonTrap> traps;                      ///< ascending by zero
  std::vector<SkeletonOrbit> orbits;
  std::vector<SkeletonSeparatrix> separatrices;
  std::int32_t index_sum = 0;           ///< of the indices that are stated
  std::array<std::uint32_t, 5> ends{};  ///< separatrices by SkeletonEnd
};

}  // namespace crest::certify
