// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/ridges_mesh/signs.hpp"

#include <cmath>

#include "certify/exact/vector.hpp"
#include "certify/ridges_mesh/monge_fields.hpp"

namespace crest::certify {
namespace {

using kernel::Sign;
using Monge = std::array<double, 14>;

constexpr std::int8_t number(Sign s) {
  return static_cast<std::int8_t>(s);
}
constexpr std::int8_t plain_sign(double x) {
  return static_cast<std::int8_t>(x > 0 ? 1 : x < 0 ? -1 : 0);
}
/// b0 for blue, b3 for red.
constexpr std::size_t extremality_field(Colour colour) {
  return colour == blue ? field::b0 : field::b3;
}

/// The first non-zero term of the perturbation of a product that is exactly zero.
Sign perturbed_acute(const double* d, const double* e, SignLadder& sign) {
  for (std::size_t i = 0; i < 3; ++i)
    if (const int s = plain_sign(d[i]) * plain_sign(e[i]); s != 0) return static_cast<Sign>(s);
  static constexpr std::size_t kPairs[3][2] = {{0, 1}, {0, 2}, {1, 2}};
  for (const auto& [i, j] : kPairs) {
    const Sign s = sign(
        [&, i = i, j = j](auto lift) { return lift(d[i]) * lift(e[j]) + lift(d[j]) * lift(e[i]); });
    if (s != Sign::zero) return s;
  }
  return Sign::zero;  // impossible: d and e are not zero (check_geometry)
}

std::int8_t extremality_sign(const Monge& m, Colour colour) {
  if (const auto s = plain_sign(m[extremality_field(colour)]); s != 0) return s;
  for (std::size_t i = 0; i < 3; ++i)
    if (const auto s = plain_sign(m[field::d1 + i]); s != 0) return s;
  return 0;  // impossible: d1 is not zero
}

void decide_vertices(const MeshData& data, MeshSigns& out) {
  for (const Colour colour : {blue, red}) {
    auto& signs = out.extremality[colour];
    signs.reserve(data.monge.size());
    for (const Monge& m : data.monge) {
      signs.push_back(extremality_sign(m, colour));
      if (m[extremality_field(colour)] == 0) ++out.zero_extremalities[colour];
    }
  }
}

void decide_edges(const MeshData& data, const Topology& topology, SignLadder& sign,
                  MeshSigns& out) {
  out.acute.reserve(topology.edges.size());
  out.crossings.reserve(topology.edges.size());
  for (const Edge& edge : topology.edges) {
    const double* const d = &data.monge[edge.low][field::d1];
    const double* const e = &data.monge[edge.high][field::d1];
    Sign s = sign([&](auto lift) { return dot(lift_vector(lift, d), lift_vector(lift, e)); });
    if (s == Sign::zero) {
      ++out.ambiguous_edges;
      s = perturbed_acute(d, e, sign);
    }
    unsigned crossed = 0;
    for (const Colour colour : {blue, red}) {
      const auto& beta = out.extremality[colour];
      if (number(s) * beta[edge.low] * beta[edge.high] < 0) crossed |= 1U << colour;
    }
    out.acute.push_back(number(s));
    out.crossings.push_back(static_cast<std::uint8_t>(crossed));
  }
}

/// 3 b^2 + (k - l)(c - 3 k^3): P1 with (k1, k2, b1, c0), P2 with (k2, k1, b2, c4).
template <class Lift>
auto second_derivative(const Lift& lift, const Monge& m, Colour colour) {
  const auto k = lift(m[colour == blue ? field::k1 : field::k2]);
  const auto l = lift(m[colour == blue ? field::k2 : field::k1]);
  const auto b = lift(m[colour == blue ? field::b1 : field::b2]);
  const auto c = lift(m[colour == blue ? field::c0 : field::c4]);
  const auto three = lift(3);
  return three * b * b + (k - l) * (c - three * k * k * k);
}

/// The direction u: d1, or n x d1.
template <class Lift>
auto blue_direction(const Lift& lift, const Monge& m) {
  return lift_vector(lift, &m[field::d1]);
}
template <class Lift>
auto red_direction(const Lift& lift, const Monge& m) {
  return cross(lift_vector(lift, &m[field::n]), lift_vector(lift, &m[field::d1]));
}

/// A positive multiple of r2 - r1 is (x + y) e13 - (z + w) e12, e1j = vj - v1.
struct SegmentWeights {
  double x, y, z, w;
};

/// rj = v1 + tj e1j with tj = |b1| / (|b1| + |bj|), or 1/2 if both are zero. Multiply t3 - t2 by
/// the denominators, and by 1 / |b1| unless b1 = 0.
SegmentWeights segment_weights(double b1, double b2, double b3) {
  b1 = std::fabs(b1), b2 = std::fabs(b2), b3 = std::fabs(b3);
  if (b1 != 0) return {b1, b2, b1, b3};
  const double numerator2 = b2 == 0 ? 1 : 0, denominator2 = b2 == 0 ? 2 : b2;
  const double numerator3 = b3 == 0 ? 1 : 0, denominator3 = b3 == 0 ? 2 : b3;
  return {numerator3 * denominator2, 0, numerator2 * denominator3, 0};
}

}  // namespace

MeshSigns decide_signs(const MeshData& data, const Topology& topology, SignLadder& sign) {
  MeshSigns out;
  decide_vertices(data, out);
  decide_edges(data, topology, sign, out);
  out.conflict.reserve(data.faces.size());
  for (std::size_t c = 0; c < topology.edge_of.size(); c += 3) {
    const int product = out.acute[topology.edge_of[c]] * out.acute[topology.edge_of[c + 1]] *
                        out.acute[topology.edge_of[c + 2]];
    out.conflict.push_back(product < 0);
    out.conflict_triangles += product < 0;
  }
  return out;
}

unsigned crossing_type(const MeshData& data, const Edge& edge, Colour colour, SignLadder& sign) {
  const Monge &p = data.monge[edge.low], &q = data.monge[edge.high];
  double weight_p = std::fabs(q[extremality_field(colour)]);
  double weight_q = std::fabs(p[extremality_field(colour)]);
  if (weight_p == 0 && weight_q == 0) weight_p = weight_q = 1;
  const Sign s = sign([&](auto lift) {
    return lift(weight_p) * second_derivative(lift, p, colour) +
           lift(weight_q) * second_derivative(lift, q, colour);
  });
  return s == Sign::negative ? 1 : s == Sign::positive ? 2 : 0;
}

unsigned segment_type(const MeshData& data, const MeshSigns& signs, std::uint32_t corner,
                      Colour colour, SignLadder& sign) {
  const std::array<std::uint32_t, 3> v = {vertex_of(data.faces, corner),
                                          vertex_of(data.faces, next_corner(corner)),
                                          vertex_of(data.faces, previous_corner(corner))};
  const std::size_t b = extremality_field(colour);
  const auto weights =
      segment_weights(data.monge[v[0]][b], data.monge[v[1]][b], data.monge[v[2]][b]);
  // (r2 - r1) x N, so that det(u, r2 - r1, N) = u . (r2 - r1) x N.
  const auto across = [&](const auto& lift) {
    const auto v1 = lift_vector(lift, data.positions[v[0]].data());
    const auto e12 = lift_vector(lift, data.positions[v[1]].data()) - v1;
    const auto e13 = lift_vector(lift, data.positions[v[2]].data()) - v1;
    return cross(
        (lift(weights.x) + lift(weights.y)) * e13 - (lift(weights.z) + lift(weights.w)) * e12,
        cross(e12, e13));
  };
  const auto plain = [](double x) { return filtered(x); };
  const auto plain_across = across(plain);
  int sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Monge& m = data.monge[v[i]];
    const auto by_triage = colour == blue ? sign.triage(dot(blue_direction(plain, m), plain_across))
                                          : sign.triage(dot(red_direction(plain, m), plain_across));
    const auto by_ladder = [&] {
      return colour == blue
                 ? sign([&](auto lift) { return dot(blue_direction(lift, m), across(lift)); })
                 : sign([&](auto lift) { return dot(red_direction(lift, m), across(lift)); });
    };
    const Sign s = by_triage ? *by_triage : by_ladder();
    sum += (i == 0 ? 1 : -1) * signs.extremality[colour][v[i]] * number(s);
  }
  if (sum == 0) return 0;
  return (sum > 0) == (colour == blue) ? 1 : 2;
}

bool less_gap(const MeshData& data, std::uint32_t p, std::uint32_t q, SignLadder& sign) {
  return sign([&](auto lift) {
           const Monge &m = data.monge[p], &k = data.monge[q];
           return (lift(m[field::k1]) - lift(m[field::k2])) -
                  (lift(k[field::k1]) - lift(k[field::k2]));
         }) == Sign::negative;
}

std::uint32_t least_gap_corner(const MeshData& data, std::uint32_t face, SignLadder& sign) {
  const auto& corners = data.faces[face];
  std::uint32_t least = corners[0];
  if (less_gap(data, corners[1], least, sign)) least = corners[1];
  if (less_gap(data, corners[2], least, sign)) least = corners[2];
  return least;
}

unsigned umbilic_kind(const MeshData& data, std::uint32_t face, SignLadder& sign) {
  const Monge& m = data.monge[least_gap_corner(data, face, sign)];
  const Sign s = sign([&](auto lift) {
    const auto b0 = lift(m[field::b0]), b1 = lift(m[field::b1]), b2 = lift(m[field::b2]),
               b3 = lift(m[field::b3]);
    const auto middle = b0 * b3 - b1 * b2;
    return middle * middle - lift(4) * (b0 * b2 - b1 * b1) * (b1 * b3 - b2 * b2);
  });
  return s == Sign::positive ? 1 : s == Sign::negative ? 3 : 0;
}

}  // namespace crest::certify
