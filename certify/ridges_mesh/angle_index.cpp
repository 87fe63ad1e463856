// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/ridges_mesh/angle_index.hpp"

#include <cmath>
#include <limits>
#include <memory>

#include "certify/container/reject.hpp"
#include "certify/exact/argument.hpp"
#include "certify/exact/vector.hpp"
#include "certify/ridges_mesh/monge_fields.hpp"
#include "certify/ridges_mesh/vertex_angles.hpp"

namespace crest::certify {
namespace {

using u32 = std::uint32_t;

constexpr double kU = 0x1p-53;
constexpr double kPi = Argument::kPi;
constexpr double kUnknown = std::numeric_limits<double>::infinity();

/// Error of a triangle's angle in enclose_corners. e, f: the exact difference vectors, L = |e||f|.
///   Rounding the differences turns e and f by at most 1.01 u each:                       2.02 u.
///   dot: three products and two sums, the absolute products sum to at most L:        3.01 u L.
///   |e x f|: component errors 2.01 u (|e_i f_j| + |e_j f_i|), as a vector at most
///     2.01 sqrt(2) u L = 2.85 u L; squares, sums and root 2.51 u |e x f|:             5.36 u L.
///   As |(dot, |e x f|)| = L, the pair turns by at most asin of 6.15 u:                    6.16 u.
///   The argument itself (Argument::kError):                                                7 u.
constexpr double kCornerError = 16 * kU;

/// Squared lengths in this range keep every product above clear of underflow and overflow: L is at
/// least 2^-200, so products that underflow (2^-1075, after the root 2^-537) are lost in the slack.
bool moderate(double squared) {
  return squared > 0x1p-200 && squared < 0x1p200;
}

/// Unscaled angles of all corners; error is unknown at the corners of immoderate faces.
void enclose_corners(const MeshData& data, const Argument& argument, DoubleAngles& out) {
  const auto lift = [](double x) { return x; };
  for (std::size_t f = 0; f < data.faces.size(); ++f) {
    const auto& face = data.faces[f];
    const auto p = lift_vector(lift, data.positions[face[0]].data());
    const auto q = lift_vector(lift, data.positions[face[1]].data());
    const auto r = lift_vector(lift, data.positions[face[2]].data());
    const Vector<double> side[3] = {q - p, r - q, p - r};
    bool good = true;
    for (const auto& e : side) good = good && moderate(dot(e, e));
    for (std::size_t i = 0; i < 3; ++i) {
      if (!good) {
        out.error[face[i]] = kUnknown;
        continue;
      }
      const auto &e = side[i], &back = side[(i + 2) % 3];
      const auto normal = cross(e, back);
      out.angle[3 * f + i] = argument(std::sqrt(dot(normal, normal)), -dot(e, back));
    }
  }
}

/// Partial sums around v, scaled to 2 pi at an interior vertex; returns the bound of their errors.
/// n faces, S the computed sum, D = n (kCornerError + u S) its error and that of every partial sum.
/// A scaled partial sum 2 pi A / S errs by at most 2 pi (D / S + D / S): both A and S are off by D
/// and A <= S. Rounding 2 pi, the quotient and the product: 3.2 u of at most 2 pi, below 21 u.
double scale_ring(const Topology& t, u32 v, DoubleAngles& out) {
  const u32 begin = t.ring_start[v], end = t.ring_start[v + 1];
  double sum = 0;
  for (u32 i = begin; i < end; ++i) {
    out.before[t.ring[i]] = sum;
    sum += out.angle[t.ring[i]];
  }
  out.total[v] = sum;
  const double spread = 1.01 * (end - begin) * (kCornerError + kU * sum);
  if (t.on_boundary[v]) return spread;
  if (!(sum > 4 * spread)) return kUnknown;
  const double scale = 2 * kPi / sum;
  for (u32 i = begin; i < end; ++i) {
    out.before[t.ring[i]] *= scale;
    out.angle[t.ring[i]] *= scale;
  }
  out.total[v] = 2 * kPi;
  return 1.01 * 4 * kPi * (spread / sum) + 21 * kU;
}

/// phi at v from its first neighbour; returns the bound of its error. The pair (x, y) is off by
/// (bx, by), so its argument by at most asin((bx + by) / |(x, y)|) <= 1.6 of that quotient.
double enclose_phi(const MeshData& data, const Topology& t, const Argument& argument, u32 v,
                   DoubleAngles& out) {
  const u32 w = vertex_of(data.faces, next_corner(t.ring[t.ring_start[v]]));
  const auto lift = [](double x) { return filtered(x); };
  const auto n = lift_vector(lift, &data.monge[v][field::n]);
  const auto d = lift_vector(lift, &data.monge[v][field::d1]);
  const auto e =
      lift_vector(lift, data.positions[w].data()) - lift_vector(lift, data.positions[v].data());
  const auto normal_to_e = cross(n, e);
  const auto x = dot(normal_to_e, cross(n, d));
  const auto y = dot(normal_to_e, d);
  const double size = std::max(std::fabs(x.value), std::fabs(y.value));
  const double quotient = (x.bound() + y.bound()) / size;
  if (!(quotient < 0.5) || !(size > 0x1p-500 && size < 0x1p500)) return kUnknown;
  out.phi[v] = argument(y.value, x.value);
  return 1.6 * quotient + Argument::kError;
}

/// omega(low, high) from doubles; returns false if (-pi, pi] is not decided.
bool double_rotation(const DoubleAngles& angles, const Edge& e, int acute, double& omega) {
  const double error = angles.error[e.low] + angles.error[e.high];
  if (!(error < 0.5)) return false;
  const double from_high = e.backward == kNone ? angles.total[e.high] : angles.before[e.backward];
  const double from_low = e.forward == kNone ? angles.total[e.low] : angles.before[e.forward];
  double x = angles.phi[e.high] - angles.phi[e.low] - (from_high + kPi - from_low);
  if (acute < 0) x += kPi;
  const double turns = std::nearbyint(x * (0.5 / kPi));
  omega = x - turns * (2 * kPi);
  return std::fabs(omega) < kPi - error;
}

/// Twice the index of a face from doubles, empty if not determined. `twice` must be the only
/// integer of the right parity in the enclosure of T / pi.
std::optional<int> double_index(const MeshData& data, const Topology& t, const MeshSigns& signs,
                                const DoubleAngles& angles, const std::vector<double>& omega,
                                u32 face) {
  double turn = -kPi, error = 0;
  for (u32 c = 3 * face; c < 3 * face + 3; ++c) {
    const u32 v = vertex_of(data.faces, c), edge = t.edge_of[c];
    turn += t.edges[edge].low == v ? omega[edge] : -omega[edge];
    turn += angles.angle[c];
    error += angles.error[v];
  }
  // Each vertex enters two rotations and one angle; seven sums below 32 round by 16 u each.
  const double bound = 3 * error + 128 * kU;
  if (!(bound < 1)) return std::nullopt;
  const double odd = signs.conflict[face];
  const double twice = 2 * std::nearbyint(turn / (2 * kPi) - odd / 2) + odd;
  // The two further multiples are at least 2 pi - |off| away: outside, as |off| <= bound < 1.
  const double off = turn - twice * kPi;
  if (!(std::fabs(off) <= bound + 64 * kU))
    throw std::logic_error(fmt::format("face {}: angle enclosures contradict lemma 2", face));
  return static_cast<int>(twice);
}

std::vector<std::int8_t> indices_by_mpfr(const Topology& topology, MpAngles& mp) {
  std::vector<std::int8_t> indices(topology.twin.size() / 3);
  for (u32 f = 0; f < indices.size(); ++f) indices[f] = static_cast<std::int8_t>(mp.twice_index(f));
  return indices;
}

}  // namespace

DoubleAngles enclose_angles(const MeshData& data, const Topology& topology) {
  const std::size_t vertices = data.positions.size(), corners = topology.twin.size();
  DoubleAngles out;
  out.before.resize(corners);
  out.angle.resize(corners);
  out.total.resize(vertices);
  out.phi.resize(vertices);
  out.error.assign(vertices, 0);
  static const Argument argument;
  enclose_corners(data, argument, out);
  for (u32 v = 0; v < vertices; ++v) {
    out.error[v] += scale_ring(topology, v, out);
    out.error[v] += enclose_phi(data, topology, argument, v, out);
    // This vertex's share of the roundings in double_rotation: seven operations and the constants
    // pi, relative to the sum of all magnitudes (8 u of it).
    out.error[v] += 8 * kU * (std::fabs(out.phi[v]) + out.total[v] + 8);
  }
  return out;
}

std::vector<std::int8_t> face_indices(const MeshData& data, const Topology& topology,
                                      const MeshSigns& signs, Arithmetic arithmetic,
                                      AngleCounts& counts) {
  counts.edges = topology.edges.size();
  if (arithmetic == Arithmetic::mpfr) {
    MpAngles mp(data, topology, signs.acute, AngleStage::bits128, counts);
    return indices_by_mpfr(topology, mp);
  }
  // Made at the first edge that doubles leave open: most meshes have none.
  std::unique_ptr<MpAngles> mp;
  const auto escalate = [&]() -> MpAngles& {
    if (!mp)
      mp = std::make_unique<MpAngles>(data, topology, signs.acute, AngleStage::bits256, counts);
    return *mp;
  };
  const DoubleAngles angles = enclose_angles(data, topology);
  std::vector<double> omega(topology.edges.size());
  for (u32 e = 0; e < omega.size(); ++e) {
    if (double_rotation(angles, topology.edges[e], signs.acute[e], omega[e])) continue;
    omega[e] = escalate().rotation(e).lower();
  }
  std::vector<std::int8_t> indices(data.faces.size());
  for (u32 f = 0; f < indices.size(); ++f) {
    const auto twice = double_index(data, topology, signs, angles, omega, f);
    indices[f] = static_cast<std::int8_t>(twice ? *twice : escalate().twice_index(f));
  }
  return indices;
}

}  // namespace crest::certify
