// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How much of one set of ridges lies near another set's, by length.
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "algorithms/ridges/ridges.hpp"

namespace crest::experiments {

/// A piece of a line of one colour.
struct Dash {
  kernel::Vec3 middle;
  double length;
  ridges::Colour colour;
};

/// Adds the line from p to q in dashes no longer than the step.
inline void add_dashes(const kernel::Vec3& p, const kernel::Vec3& q, ridges::Colour colour,
                       double step, std::vector<Dash>& all) {
  const double length = kernel::distance(p, q);
  const int parts = 1 + static_cast<int>(length / step);
  for (int k = 0; k < parts; ++k) {
    const double t = (k + 0.5) / parts;
    Dash d{{}, length / parts, colour};
    for (std::size_t c = 0; c < 3; ++c) d.middle[c] = (1 - t) * p[c] + t * q[c];
    all.push_back(d);
  }
}

/// The segments between crossings of at least the given level.
inline std::vector<Dash> dashes(const ridges::RidgeGraph& graph, int level, double step = 1e300) {
  std::vector<Dash> all;
  for (const ridges::Ridge& r : graph.ridges)
    for (std::size_t i = 0; i < r.segment_count(); ++i) {
      const ridges::Crossing &a = r.crossings[i], &b = r.crossings[(i + 1) % r.crossings.size()];
      if (a.level >= level && b.level >= level) add_dashes(a.point, b.point, r.colour, step, all);
    }
  return all;
}

/// The same and, as files have them, the ends inside the umbilics' patches, of the
/// level of the crossing beside them.
inline std::vector<Dash> dashes_with_ends(const ridges::RidgeGraph& graph, int level, double step) {
  std::vector<Dash> all = dashes(graph, level, step);
  for (const ridges::Ridge& r : graph.ridges) {
    std::vector<kernel::Vec3> in = r.lead_in, out = {r.crossings.back().point};
    in.push_back(r.crossings.front().point);
    out.insert(out.end(), r.lead_out.begin(), r.lead_out.end());
    const auto add = [&](const std::vector<kernel::Vec3>& line, const ridges::Crossing& beside) {
      for (std::size_t i = 0; beside.level >= level && i + 1 < line.size(); ++i)
        add_dashes(line[i], line[i + 1], r.colour, step, all);
    };
    add(in, r.crossings.front());
    add(out, r.crossings.back());
  }
  return all;
}

inline double length_of(const std::vector<Dash>& all) {
  double sum = 0;
  for (const Dash& d : all) sum += d.length;
  return sum;
}

/// The share of a's length whose dashes have one of b of the same colour (any, if asked for) within
/// the distance; 1 if a has no length.
inline double near_share(const std::vector<Dash>& a, const std::vector<Dash>& b, double distance,
                         bool any_colour = false) {
  using Cell = std::array<std::int64_t, 3>;
  struct Hash {
    std::size_t operator()(const Cell& c) const {
      return static_cast<std::size_t>(c[0] * 73856093 ^ c[1] * 19349663 ^ c[2] * 83492791);
    }
  };
  std::unordered_map<Cell, std::vector<const Dash*>, Hash> cells;
  const auto cell_of = [&](const kernel::Vec3& p) {
    Cell c;
    for (std::size_t k = 0; k < 3; ++k) c[k] = std::llround(std::floor(p[k] / distance));
    return c;
  };
  for (const Dash& d : b) cells[cell_of(d.middle)].push_back(&d);
  const auto near = [&](const Dash& d) {
    const Cell c = cell_of(d.middle);
    for (std::int64_t x = -1; x <= 1; ++x)
      for (std::int64_t y = -1; y <= 1; ++y)
        for (std::int64_t z = -1; z <= 1; ++z) {
          const auto found = cells.find({c[0] + x, c[1] + y, c[2] + z});
          if (found == cells.end()) continue;
          for (const Dash* e : found->second)
            if ((any_colour || e->colour == d.colour) &&
                kernel::distance(d.middle, e->middle) <= distance)
              return true;
        }
    return false;
  };
  double all = 0, matched = 0;
  for (const Dash& d : a) {
    all += d.length;
    if (near(d)) matched += d.length;
  }
  return all > 0 ? matched / all : 1;
}

}  // namespace crest::experiments
