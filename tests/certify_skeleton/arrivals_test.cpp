// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 10: the order of lines by how they have come is the one of the points where they cross.
#include "certify/compression/arrivals.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <iostream>
#include <map>

#include "certify/skeleton/encode.hpp"
#include "certify/verify.hpp"
#include "tests/certify_skeleton/reference_skeleton.hpp"

using namespace crest::certify;
using namespace crest::certify::compression;
using namespace crest::tests;

namespace {

using Weights = std::array<double, 3>;  ///< barycentric

/// Follows lines in plain double, triangle by triangle as their turns say.
class Tracer {
 public:
  explicit Tracer(const Proof& proof) : field_(proof.field) {}

  /// Weights' derivatives in a triangle: the field in barycentric coordinates.
  Weights flow(u32 t, const Weights& x, bool backward) const {
    double v[2] = {0, 0};
    for (u32 k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 2; ++i) v[i] += x[k] * field_.vector(3 * t + k)[i];
    Weights w{};
    double area = 0;
    for (u32 k = 0; k < 3; ++k) {
      const Pair &p = field_.position(3 * t + (k + 1) % 3),
                 &q = field_.position(3 * t + (k + 2) % 3);
      w[k] = (backward ? -1 : 1) * ((q[0] - p[0]) * v[1] - (q[1] - p[1]) * v[0]);
      const Pair& o = field_.position(3 * t + k);
      area = (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]);
    }
    for (double& a : w) a /= area;
    return w;
  }

  /// From x to the exit: the distance from its tail, or NaN.
  double cross(u32 exit, Weights x, bool backward) const {
    const u32 t = exit / 3, out = previous_corner(exit) % 3;
    const auto moved = [](const Weights& a, double h, const Weights& b) {
      return Weights{a[0] + h * b[0], a[1] + h * b[1], a[2] + h * b[2]};
    };
    for (int step = 0; step < 100000; ++step) {
      const Weights k1 = flow(t, x, backward);
      double speed = 0;
      for (const double s : k1) speed = std::max(speed, std::fabs(s));
      const double h = std::min(0.01 / speed, 1e3);
      const Weights k2 = flow(t, moved(x, h / 2, k1), backward),
                    k3 = flow(t, moved(x, h / 2, k2), backward),
                    k4 = flow(t, moved(x, h, k3), backward);
      Weights y = x;
      for (std::size_t k = 0; k < 3; ++k) y[k] += h / 6 * (k1[k] + 2 * k2[k] + 2 * k3[k] + k4[k]);
      if (y[out] <= 0 && (x[out] > 0 || k1[out] < 0)) {
        const double s = x[out] / (x[out] - y[out]);
        const u32 head = next_corner(exit) % 3;
        return x[head] + s * (y[head] - x[head]);
      }
      x = y;
    }
    return std::nan("");
  }

 private:
  const Field& field_;
};

double sum(const std::vector<double>& list, std::size_t from, std::size_t to) {
  double x = 0;
  for (std::size_t i = from; i < to; ++i) x += list[i];
  return x;
}
double tail_distance(double t) {
  return t > 0 ? t : 1 + t;
}

/// Where a line crosses the exit of each cell, as distances from its tail.
std::vector<double> crossings(const Proof& proof, const Path& path, const SkeletonLeg& leg) {
  const Tracer tracer(proof);
  std::vector<double> result;
  double at = 0;
  for (std::size_t i = 0; i < path.cells.size() && path.cells[i].exit != kNone; ++i) {
    const Cell& cell = path.cells[i];
    Weights x{};
    if (i == 0 && leg.kind == LegKind::ray) {
      at = (tail_distance(leg.first[0]) + tail_distance(leg.second[0])) / 2;
      result.push_back(at);
      continue;
    }
    if (i == 0 && leg.kind == LegKind::along) {
      // Between q on the side and the point inside.
      const std::size_t n = leg.second.size() / 2;
      const double q = tail_distance(sum(leg.first, 0, leg.first.size())),
                   a = (sum(leg.second, 0, n) + q) / 2, b = sum(leg.second, n, 2 * n) / 2;
      x[leg.corner % 3] = 1 - a - b;
      x[next_corner(leg.corner) % 3] = a;
      x[previous_corner(leg.corner) % 3] = b;
    } else if (cell.entry == Entry::vertex) {
      x[cell.name % 3] = 1;
    } else {
      // The twin runs the other way.
      x[cell.name % 3] = at;
      x[next_corner(cell.name) % 3] = 1 - at;
    }
    at = tracer.cross(cell.exit, x, path.backward);
    result.push_back(at);
  }
  return result;
}

struct Tally {
  std::size_t pairs = 0, near = 0, starts = 0;
};

void compare_all(const PlaneField& field, Tally& tally) {
  const SkeletonCertificate c = reference_skeleton(field);
  Proof proof(c);
  SignLadder sign(Arithmetic::doubles);
  Verdict verdict;
  prove_surface(proof, sign, verdict);
  prove_skeleton(proof, sign, Arithmetic::doubles, verdict);
  Comparison comparison(proof, sign);
  std::vector<Path> paths;
  for (u32 i = 0; i < c.separatrices.size(); ++i) paths.push_back(path_of(proof, i));
  struct Crossing {
    u32 line;
    std::size_t cell;
    double at;
  };
  std::map<std::pair<u32, bool>, std::vector<Crossing>> by_side;
  for (u32 i = 0; i < paths.size(); ++i) {
    if (c.separatrices[i].legs.size() != 1 || c.separatrices[i].legs[0].kind == LegKind::straight)
      continue;
    const auto at = crossings(proof, paths[i], c.separatrices[i].legs[0]);
    for (std::size_t k = 0; k < at.size(); ++k)
      by_side[{paths[i].cells[k].exit, paths[i].backward}].push_back({i, k, at[k]});
  }
  for (const auto& [side, list] : by_side)
    for (const Crossing& a : list)
      for (const Crossing& b : list) {
        if (&a == &b) continue;
        // Numbers are good to some digits only.
        if (!(std::fabs(a.at - b.at) > 1e-4)) {
          ++tally.near;
          continue;
        }
        ++tally.pairs;
        tally.starts += a.cell == 0 || b.cell == 0;
        const Order order = comparison.compare(paths[a.line], a.cell, paths[b.line], b.cell);
        INFO("side " << side.first << ": lines " << a.line << " at " << a.at << ", " << b.line
                     << " at " << b.at);
        CHECK(order == (a.at > b.at ? Order::left : Order::right));
      }
}

}  // namespace

TEST_CASE("compression: lines that cross a side are in the order of their points") {
  Tally tally;
  for (const std::uint64_t seed : {1U, 2U, 4U}) {
    compare_all(lattice_field(seed, 5 + static_cast<u32>(seed), 24, false), tally);
    compare_all(lattice_field(seed, 5 + static_cast<u32>(seed), 24, true), tally);
  }
  std::cout << "arrivals: " << tally.pairs << " pairs of crossings, " << tally.starts
            << " at a start, " << tally.near << " too near to compare\n";
  CHECK(tally.pairs > 1000);
  CHECK(tally.starts > 20);
}
