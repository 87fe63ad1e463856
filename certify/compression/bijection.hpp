// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The stated maps are a bijection of skeletons (SPEC.md, steps 4 to 7).
#include "certify/compression/arrivals.hpp"
#include "certify/compression/match.hpp"
#include "certify/compression/records.hpp"

namespace crest::certify::compression {

/// A stated map and its inverse.
struct Map {
  std::vector<u32> to, from;
  /// Throws Reject unless it is a permutation of `count` numbers.
  Map(const std::vector<u32>& stated, std::size_t count, const char* what);
};

struct Maps {
  Map zeros, orbits, separatrices;
};

/// Each throws Reject unless what it names corresponds.
void check_zeros(const Match& match, const Map& zeros, SkeletonNotion notion, SignLadder& sign);
void check_orbits(const std::vector<Orbit>& in, const std::vector<Orbit>& out, const Match& match,
                  const Maps& maps);
/// Starts and ends. Returns how many are undecided.
std::size_t check_separatrices(const Match& match, const ArrivalTable& in, const ArrivalTable& out,
                               const Maps& maps);
void check_arrivals(const Match& match, const ArrivalTable& in, const ArrivalTable& out,
                    const Maps& maps);
/// All lines meet the same triangles. Returns how many those are.
std::size_t check_strong(const Match& match, const ArrivalTable& in, const ArrivalTable& out,
                         const Maps& maps);

}  // namespace crest::certify::compression
