// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/ridges_mesh/vertex_angles.hpp"

#include <cmath>
#include <utility>

#include "certify/container/reject.hpp"
#include "certify/exact/vector.hpp"
#include "certify/ridges_mesh/monge_fields.hpp"

namespace crest::certify {
namespace {

using kernel::MpInterval;
using kernel::Rational;
using kernel::Sign;
using u32 = std::uint32_t;

constexpr mpfr_prec_t kBits = 256;

mpfr_prec_t bits_of(AngleStage stage) {
  return stage == AngleStage::bits128 ? 128 : kBits;
}

MpInterval as_interval(const MpInterval& x) {
  return x;
}
MpInterval as_interval(const Rational& x) {
  return MpInterval::from(x, kBits);
}

/// The angle of a triangle at `corner`, from the cosine and the squared sine times the lengths.
template <class Lift>
MpInterval corner_angle(const MeshData& data, u32 corner, const Lift& lift) {
  const auto at = [&](u32 c) {
    return lift_vector(lift, data.positions[vertex_of(data.faces, c)].data());
  };
  const auto e = at(next_corner(corner)) - at(corner), f = at(previous_corner(corner)) - at(corner);
  const auto normal = cross(e, f);
  return atan2(sqrt(as_interval(dot(normal, normal))), as_interval(dot(e, f)));
}

/// (x, y) of the definition of phi, towards the neighbour w.
template <class Lift>
auto direction(const MeshData& data, u32 v, u32 w, const Lift& lift) {
  const auto n = lift_vector(lift, &data.monge[v][field::n]);
  const auto d = lift_vector(lift, &data.monge[v][field::d1]);
  const auto e =
      lift_vector(lift, data.positions[w].data()) - lift_vector(lift, data.positions[v].data());
  const auto normal_to_e = cross(n, e);
  return std::pair(dot(normal_to_e, cross(n, d)), dot(normal_to_e, d));
}

/// Is the point (x, y) the origin? Empty: not decided.
std::optional<bool> is_origin(const MpInterval& x, const MpInterval& y) {
  const auto sx = certain_sign(x), sy = certain_sign(y);
  if ((sx && *sx != Sign::zero) || (sy && *sy != Sign::zero)) return false;
  if (sx && sy) return true;
  return std::nullopt;
}
std::optional<bool> is_origin(const Rational& x, const Rational& y) {
  return x == 0 && y == 0;
}

template <class Lift>
std::optional<VertexAngles> enclose(const MeshData& data, const Topology& t, u32 v,
                                    AngleStage stage, const Lift& lift) {
  const mpfr_prec_t bits = bits_of(stage);
  const u32 begin = t.ring_start[v], faces = t.ring_start[v + 1] - begin;
  VertexAngles out{{}, MpInterval(bits)};
  out.sums.reserve(faces + 1);
  out.sums.emplace_back(bits);
  for (u32 k = 0; k < faces; ++k)
    out.sums.push_back(out.sums.back() + corner_angle(data, t.ring[begin + k], lift));
  if (!t.on_boundary[v]) {
    const MpInterval two_pi = MpInterval::pi(bits) + MpInterval::pi(bits);
    const MpInterval scale = two_pi / out.sums.back();
    for (u32 k = 1; k < faces; ++k) out.sums[k] = out.sums[k] * scale;
    out.sums[faces] = two_pi;
  }
  const u32 neighbours = t.on_boundary[v] ? faces + 1 : faces;
  for (u32 k = 0; k < neighbours; ++k) {
    const u32 w = k < faces ? vertex_of(data.faces, next_corner(t.ring[begin + k]))
                            : vertex_of(data.faces, previous_corner(t.ring[begin + faces - 1]));
    const auto [x, y] = direction(data, v, w, lift);
    const auto origin = is_origin(x, y);
    if (!origin) return std::nullopt;
    if (*origin) continue;
    // Beyond pi or not: phi matters modulo 2 pi only.
    out.phi = out.sums[k] + atan2(as_interval(y), as_interval(x));
    return out;
  }
  // d1 is parallel to n.
  const double* d1 = &data.monge[v][field::d1];
  while (*d1 == 0) ++d1;
  if (*d1 < 0) out.phi = MpInterval::pi(bits);
  return out;
}

/// The representative of x modulo 2 pi in [-pi + 2^-200, pi + 2^-200); empty if not decided at this
/// width. `tie`: it is nearer to pi than 2^-200.
std::optional<MpInterval> representative(const MpInterval& x, mpfr_prec_t bits, bool& tie) {
  const MpInterval pi = MpInterval::pi(bits), margin(0x1p-200, bits);
  const double turns = std::nearbyint((x.lower() / 2 + x.upper() / 2) / (2 * M_PI));
  if (!(std::fabs(turns) < 0x1p40) || !(x.width() < 1)) return std::nullopt;
  const MpInterval r = x - MpInterval(2 * turns, bits) * pi;
  const auto above = certain_sign(r - pi - margin), below = certain_sign(r + pi - margin);
  std::optional<MpInterval> omega;
  if (above == Sign::negative && below == Sign::positive) omega = r;
  if (above == Sign::positive) omega = r - pi - pi;
  if (below == Sign::negative) omega = r + pi + pi;
  tie = omega && certain_sign(*omega - pi + margin) == Sign::positive;
  return omega;
}

}  // namespace

std::optional<VertexAngles> enclose_vertex(const MeshData& data, const Topology& topology,
                                           u32 vertex, AngleStage stage) {
  if (stage == AngleStage::rational)
    return enclose(data, topology, vertex, stage, [](double x) { return Rational(x); });
  const mpfr_prec_t bits = bits_of(stage);
  return enclose(data, topology, vertex, stage, [bits](double x) { return MpInterval(x, bits); });
}

MpAngles::MpAngles(const MeshData& data, const Topology& topology,
                   const std::vector<std::int8_t>& acute, AngleStage first, AngleCounts& counts)
    : data_(data), topology_(topology), acute_(acute), first_(first), counts_(counts) {
  for (auto& stage : vertices_) stage.resize(data.positions.size());
  rotations_.resize(topology.edges.size());
}

const VertexAngles* MpAngles::vertex(u32 v, AngleStage stage) {
  auto& kept = vertices_[static_cast<std::size_t>(stage)][v];
  if (!kept)
    kept =
        std::make_unique<std::optional<VertexAngles>>(enclose_vertex(data_, topology_, v, stage));
  return kept->has_value() ? &**kept : nullptr;
}

/// a(v, w) for the side v -> w, or, where the edge has only the other side, the last sum of v.
const MpInterval& MpAngles::sum_before(const VertexAngles& angles, u32 side) const {
  return side == kNone ? angles.sums.back() : angles.sums[topology_.ring_position[side]];
}

std::optional<MpInterval> MpAngles::try_rotation(u32 edge, AngleStage stage) {
  const Edge& e = topology_.edges[edge];
  const VertexAngles *low = vertex(e.low, stage), *high = vertex(e.high, stage);
  if (low == nullptr || high == nullptr) return std::nullopt;
  const mpfr_prec_t bits = bits_of(stage);
  const MpInterval pi = MpInterval::pi(bits);
  const MpInterval transport = sum_before(*high, e.backward) + pi - sum_before(*low, e.forward);
  MpInterval x = high->phi - low->phi - transport;
  if (acute_[edge] < 0) x = x + pi;
  bool tie = false;
  auto omega = representative(x, bits, tie);
  counts_.ties += tie;
  return omega;
}

const MpInterval& MpAngles::rotation(u32 edge) {
  auto& kept = rotations_[edge];
  if (kept) return *kept;
  ++counts_.mpfr_edges;
  for (auto stage = static_cast<std::size_t>(first_); stage < 3 && !kept; ++stage)
    if (auto omega = try_rotation(edge, static_cast<AngleStage>(stage)))
      kept = std::make_unique<MpInterval>(std::move(*omega));
  if (!kept)
    throw Undecided(fmt::format("edge {}: the rotation is too close to half a turn", edge));
  return *kept;
}

int MpAngles::twice_index(u32 face) {
  ++counts_.mpfr_faces;
  const mpfr_prec_t bits = bits_of(first_);
  const MpInterval pi = MpInterval::pi(bits);
  MpInterval turn = -pi;
  int product = 1;
  for (u32 c = 3 * face; c < 3 * face + 3; ++c) {
    const u32 edge = topology_.edge_of[c], v = vertex_of(data_.faces, c);
    const MpInterval& omega = rotation(edge);
    turn = topology_.edges[edge].low == v ? turn + omega : turn - omega;
    product *= acute_[edge];
    // Of the first stage that encloses the angle: undefined ones have no width below 1.
    std::optional<MpInterval> angle;
    for (auto s = static_cast<std::size_t>(first_); !angle && s < 3; ++s)
      if (const auto* around = vertex(v, static_cast<AngleStage>(s))) {
        const u32 k = topology_.ring_position[c];
        const MpInterval found = around->sums[k + 1] - around->sums[k];
        if (found.width() < 1) angle = found;
      }
    if (!angle) throw Undecided(fmt::format("face {}: an angle cannot be enclosed", face));
    turn = turn + *angle;
  }
  // Lemma 2: the only multiple of pi of the right parity in the enclosure.
  const MpInterval quotient = turn / pi;
  const double odd = product < 0 ? 1 : 0;
  const double twice =
      2 * std::nearbyint((quotient.lower() / 4 + quotient.upper() / 4) - odd / 2) + odd;
  if (!(quotient.lower() > twice - 2 && quotient.upper() < twice + 2))
    throw Undecided(fmt::format("face {}: the index cannot be enclosed", face));
  if (!(quotient.lower() <= twice && twice <= quotient.upper()))
    throw std::logic_error(fmt::format("face {}: angle enclosures contradict lemma 2", face));
  return static_cast<int>(twice);
}

}  // namespace crest::certify
