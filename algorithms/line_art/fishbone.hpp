// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Approach 2: backbones along the minimum curvature, ribs along the maximum, most of them blended
// from few key ribs. Segments are what the fishbones claim.
#include "algorithms/line_art/line_art_result.hpp"
#include "algorithms/line_art/streamlines.hpp"

namespace crest::line_art {

/// One side of a rib: [E0, {alpha}] with edges of one length h; `angle` is E0's.
struct RibSide {
  double angle = 0;
  std::vector<double> turns;
};

/// t = 0: a, t = 1: b. The shorter list borrows the longer's tail; E0 is the edge at the blended
/// angle, which keeps its length.
RibSide blend(const RibSide& a, const RibSide& b, double t);

/// p_k = p_0 + h sum over i < k of the unit vectors at angle + the first i turns.
std::vector<Vec2> rib_points(const Vec2& start, const RibSide& side, double h);
/// The side of a line of edges h; what is left of a shorter last edge goes.
RibSide side_of(const std::vector<Vec2>& points, double h);

struct Fishbones {
  std::vector<Segment> segments;
  std::vector<Hatch> ribs;  ///< kind rib, with segment and rank
  std::size_t key_ribs = 0, blended = 0;
};

/// The given segments; without any, until no free disc of 0.6 spacings is left on what is darker
/// than `brightest`.
Fishbones make_fishbones(const Tracer& tracer, double brightest,
                         const std::vector<Segment>& given = {});

}  // namespace crest::line_art
