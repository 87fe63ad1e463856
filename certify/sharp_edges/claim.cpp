// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 5, sharp-edges: exactly the edges whose faces' normals make an angle above a given one
// (SPEC.md).
#include <algorithm>

#include "certify/container/checker.hpp"
#include "certify/container/prove.hpp"
#include "certify/container/reject.hpp"
#include "certify/exact/sign_ladder.hpp"
#include "certify/exact/vector.hpp"
#include "certify/sharp_edges/decode.hpp"
#include "certify/surface/input_tie.hpp"
#include "certify/surface/mesh_checks.hpp"

namespace crest::certify {
namespace {

using u32 = std::uint32_t;
using kernel::MpInterval;
using kernel::Rational;
using kernel::Sign;

/// The angle of the data section and its cosine.
struct Angle {
  Rational degrees;
  Sign cosine = Sign::zero;
  double low = 0, high = 0;  ///< around the squared cosine; equal iff it is rational (lemma 6)
};

MpInterval squared_cosine(const Rational& degrees, mpfr_prec_t bits) {
  const MpInterval c = cos(MpInterval::pi(bits) * MpInterval::from(degrees / 180, bits));
  return c * c;
}

Angle read_angle(const std::string& text) {
  Angle angle;
  Rational unit = 1;
  bool after_point = false;
  std::size_t digits = 0;
  for (const char c : text) {
    if (c == '.') {
      require(!after_point, "angle: two points");
      after_point = true;
      continue;
    }
    require(c >= '0' && c <= '9', "angle: is no decimal");
    ++digits;
    angle.degrees = angle.degrees * 10 + (c - '0');
    if (after_point) unit *= 10;
  }
  require(digits > 0, "angle: has no digits");
  angle.degrees /= unit;
  require(angle.degrees <= 180, "angle: is above 180 degrees");
  angle.cosine = kernel::sign_of(Rational(90 - angle.degrees));
  // The nine angles of lemma 6: multiples of 30 and of 45 degrees.
  if (denominator(Rational(angle.degrees / 30)) == 1) {
    const Rational turn = angle.degrees / 30;
    angle.low = turn == 0 || turn == 6 ? 1 : turn == 1 || turn == 5 ? 0.75 : turn == 3 ? 0 : 0.25;
    angle.high = angle.low;
  } else if (denominator(Rational(angle.degrees / 45)) == 1) {
    angle.low = angle.high = 0.5;
  } else {
    const MpInterval square = squared_cosine(angle.degrees, 192);
    angle.low = std::max(0.0, square.lower());
    angle.high = std::min(1.0, square.upper());
  }
  return angle;
}

/// s = m . n and q = (m . m)(n . n) of the normals of the faces on both sides of an edge.
template <class T>
struct Products {
  T s, q;
};

class Comparison {
 public:
  Comparison(const SharpEdgesCertificate& c, const Angle& angle, SignLadder& sign)
      : c_(c), angle_(angle), sign_(sign) {}

  /// Positive: the angle at the side is above the given one; zero: equal.
  Sign operator()(u32 side, u32 twin) {
    const Sign cosine = decide([&](auto lift) { return products(side, twin, lift).s; });
    if (cosine != angle_.cosine) return cosine < angle_.cosine ? Sign::positive : Sign::negative;
    if (cosine == Sign::zero) return Sign::zero;
    const Sign gap = square_gap(side, twin);
    return cosine == Sign::positive ? gap : -gap;
  }

  void require_area(u32 face) {
    const auto square = [&](auto lift) {
      const auto n = normal(3 * face, lift);
      return dot(n, n);
    };
    require(decide(square) == Sign::positive, "face {}: its area is zero", face);
  }

 private:
  /// Coordinates have no common origin: their differences are small beside them, and the bound of
  /// doubles, which knows coordinates alone, seldom decides.
  template <class Formula>
  Sign decide(const Formula& formula) {
    return sign_.without_triage(formula);
  }

  /// Of a side's face, of twice the area's length, from the corner where the side begins.
  template <class Lift>
  auto normal(u32 side, const Lift& lift) const {
    const auto at = [&](u32 corner) {
      return lift_vector(lift, c_.positions[vertex_of(c_.faces, corner)].data());
    };
    const auto p = at(side);
    return cross(at(next_corner(side)) - p, at(previous_corner(side)) - p);
  }

  template <class Lift>
  auto products(u32 side, u32 twin, const Lift& lift) const {
    const auto m = normal(side, lift), n = normal(twin, lift);
    using T = decltype(dot(m, n));
    return Products<T>{dot(m, n), T(dot(m, m) * dot(n, n))};
  }

  /// The sign of cos^2 of the given angle - cos^2 of the one at the side.
  Sign square_gap(u32 side, u32 twin) {
    const auto against = [&](double square) {
      return decide([&](auto lift) {
        const auto p = products(side, twin, lift);
        return lift(square) * p.q - p.s * p.s;
      });
    };
    const Sign low = against(angle_.low);
    if (angle_.low == angle_.high) return low;
    if (low != Sign::negative) return Sign::positive;
    if (against(angle_.high) != Sign::positive) return Sign::negative;
    const auto p = products(side, twin, [](double x) { return Rational(x); });
    const Rational square = p.s * p.s / p.q;
    for (mpfr_prec_t bits = 256;; bits *= 2)
      if (const auto sign =
              certain_sign(squared_cosine(angle_.degrees, bits) - MpInterval::from(square, bits)))
        return *sign;
  }

  const SharpEdgesCertificate& c_;
  const Angle& angle_;
  SignLadder& sign_;
};

/// Step 3. Returns whether each edge is sharp.
std::vector<bool> check_edges(const SharpEdgesCertificate& c, const Topology& t, const Angle& angle,
                              SignLadder& sign) {
  Comparison compare(c, angle, sign);
  std::vector<bool> sharp(t.edges.size(), false);
  std::size_t stated = 0;
  u32 ties = 0;
  for (u32 e = 0; e < t.edges.size(); ++e) {
    const Edge& edge = t.edges[e];
    if (edge.forward == kNone || edge.backward == kNone) continue;
    const Sign found = compare(edge.forward, edge.backward);
    ties += found == Sign::zero;
    if (found != Sign::positive) continue;
    sharp[e] = true;
    require(stated < c.sharp.size() && c.sharp[stated] == e,
            "edge {} ({}, {}): its angle is above the given one, it is not listed there", e,
            edge.low, edge.high);
    ++stated;
  }
  require(stated == c.sharp.size(), "sharp edges: {} stated, {} found", c.sharp.size(), stated);
  require_equal(c.ties, ties, "edges of exactly the angle");
  return sharp;
}

/// Step 4.
void check_counts(const SharpEdgesCertificate& c, const Topology& t,
                  const std::vector<bool>& sharp) {
  std::vector<u32> degree(c.positions.size(), 0);
  for (u32 e = 0; e < t.edges.size(); ++e)
    if (sharp[e]) ++degree[t.edges[e].low], ++degree[t.edges[e].high];
  require_equal(c.ends, std::count(degree.begin(), degree.end(), 1U), "ends");
  require_equal(c.nodes, std::count_if(degree.begin(), degree.end(), [](u32 d) { return d >= 3; }),
                "nodes");
  u32 patches = 0;
  std::vector<bool> seen(c.faces.size(), false);
  std::vector<u32> stack;
  for (u32 seed = 0; seed < c.faces.size(); ++seed) {
    if (seen[seed]) continue;
    ++patches;
    seen[seed] = true;
    stack.assign(1, seed);
    while (!stack.empty()) {
      const u32 f = stack.back();
      stack.pop_back();
      for (u32 side = 3 * f; side < 3 * f + 3; ++side) {
        const u32 twin = t.twin[side];
        if (twin == kNone || sharp[t.edge_of[side]] || seen[twin / 3]) continue;
        seen[twin / 3] = true;
        stack.push_back(twin / 3);
      }
    }
  }
  require_equal(c.patches, patches, "patches");
}

/// Cost: linear but for the edges whose angle is the given one, or nearly: 0.1 ms each.
void verify_sharp_edges(std::span<const std::uint8_t> data, std::span<const std::uint8_t> claims,
                        const VerifyOptions& options, Verdict& verdict) {
  const SharpEdgesCertificate c = decode_sharp_edges(data, claims);
  const Topology t = build_topology(c.faces, c.positions.size());
  const Angle angle = read_angle(c.angle);
  SignLadder sign(options.arithmetic);
  Comparison areas(c, angle, sign);
  for (u32 f = 0; f < c.faces.size(); ++f) areas.require_area(f);
  prove(verdict,
        "data: an oriented manifold of {} vertices, {} faces of positive area; {} degrees; digests "
        "match",
        c.positions.size(), c.faces.size(), c.angle);
  if (options.input) {
    const std::string oriented = check_input(*options.input, c.positions, c.faces);
    prove(verdict, "input: {} holds the same positions and faces, {}", options.input->name,
          oriented);
  }
  require_equal(c.euler_characteristic, t.euler_characteristic, "Euler characteristic");
  require_equal(c.boundary_loops, t.boundary_loops, "boundary loops");
  prove(verdict, "topology: Euler characteristic {}, {} boundary loops", t.euler_characteristic,
        t.boundary_loops);
  const std::vector<bool> sharp = check_edges(c, t, angle, sign);
  verdict.signs = sign.counts();
  prove(verdict, "sharp edges: {} of {} edges, and no others, are above {} degrees; {} are equal",
        c.sharp.size(), t.edges.size(), c.angle, c.ties);
  check_counts(c, t, sharp);
  prove(verdict, "network: {} nodes, {} ends; the edges part the faces into {} patches", c.nodes,
        c.ends, c.patches);
}

}  // namespace

extern const ClaimChecker sharp_edges_claim;
const ClaimChecker sharp_edges_claim = {kSharpEdges, kSharpEdgesVersion, "sharp-edges",
                                        verify_sharp_edges};

}  // namespace crest::certify
