// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The order of arrivals: of lines that end at one place (SPEC.md, lemmas 15 to 17).
#include <map>

#include "certify/compression/orbits.hpp"

namespace crest::certify::compression {

/// Where lines arrive side by side.
struct Place {
  enum Kind : u8 { region, wall, zero, left_of_orbit, right_of_orbit } kind;
  u32 number;        ///< of the region, zero or orbit
  u32 loop = kNone;  ///< of a wall
  friend auto operator<=>(const Place&, const Place&) = default;
};

/// Lines in order; those that have become one stand together.
struct Arrivals {
  bool cyclic = true;
  std::vector<std::vector<u32>> lines;
};

struct ArrivalTable {
  std::vector<Path> paths;  ///< of all separatrices
  std::map<Place, Arrivals> orders;
  /// Sinks and sources inside triangles or edges, sides of orbits and whole loops of one region at
  /// which no line arrives, nor any of a vertex on the loop starts; one through an inner vertex
  /// counts if both ways end.
  std::size_t silent = 0;
};

/// Throws Reject where an order cannot be told.
ArrivalTable find_arrivals(const Proof& proof, const std::vector<Orbit>& orbits, SignLadder& sign);

}  // namespace crest::certify::compression
