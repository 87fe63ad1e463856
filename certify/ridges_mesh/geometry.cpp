// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/ridges_mesh/geometry.hpp"

#include "certify/container/reject.hpp"
#include "certify/exact/vector.hpp"
#include "certify/ridges_mesh/monge_fields.hpp"

namespace crest::certify {
namespace {

/// Is a vector zero, whose coordinate k is component(k, lift)?
template <class Component>
bool is_zero(const Component& component, SignLadder& sign) {
  // The order only saves time: the largest component is the one a double can decide.
  std::size_t largest = 0;
  double size = -1;
  for (std::size_t k = 0; k < 3; ++k)
    if (const double x = std::fabs(component(k, filtered).value); x > size) {
      size = x;
      largest = k;
    }
  for (std::size_t k = largest; k < largest + 3; ++k)
    if (sign([&](auto lift) { return component(k % 3, lift); }) != kernel::Sign::zero) return false;
  return true;
}

bool has_zero_area(const MeshData& data, std::size_t f, SignLadder& sign) {
  const auto& a = data.positions[data.faces[f][0]];
  const auto& b = data.positions[data.faces[f][1]];
  const auto& c = data.positions[data.faces[f][2]];
  // Component k of the normal, from the coordinates k + 1 and k + 2.
  const auto component = [&](std::size_t k, auto lift) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    return (lift(b[i]) - lift(a[i])) * (lift(c[j]) - lift(a[j])) -
           (lift(b[j]) - lift(a[j])) * (lift(c[i]) - lift(a[i]));
  };
  return is_zero(component, sign);
}

bool is_parallel_frame(const MeshData& data, std::size_t v, SignLadder& sign) {
  const double *const n = &data.monge[v][field::n], *const d = &data.monge[v][field::d1];
  const auto component = [&](std::size_t k, auto lift) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    return lift(n[i]) * lift(d[j]) - lift(n[j]) * lift(d[i]);
  };
  return is_zero(component, sign);
}

/// n . (q - p) x (r - p) of the face at a corner, p its vertex.
template <class Lift>
auto along_normal(const MeshData& data, std::uint32_t corner, const Lift& lift) {
  const auto at = [&](std::uint32_t c) {
    return lift_vector(lift, data.positions[vertex_of(data.faces, c)].data());
  };
  const auto p = at(corner);
  return dot(lift_vector(lift, &data.monge[vertex_of(data.faces, corner)][field::n]),
             cross(at(next_corner(corner)) - p, at(previous_corner(corner)) - p));
}

bool is_against_faces(const MeshData& data, std::span<const std::uint32_t> corners,
                      SignLadder& sign) {
  // As a rule all terms of the sum have one sign.
  bool positive = true, negative = true;
  for (const std::uint32_t c : corners) {
    const auto s = sign.triage(along_normal(data, c, [](double x) { return filtered(x); }));
    positive = positive && s == kernel::Sign::positive;
    negative = negative && s == kernel::Sign::negative;
  }
  if (positive || negative) return negative;
  return sign.without_triage([&](auto lift) {
    auto sum = lift(0);
    for (const std::uint32_t c : corners) sum = sum + along_normal(data, c, lift);
    return sum;
  }) != kernel::Sign::positive;
}

}  // namespace

void check_geometry(const MeshData& data, SignLadder& sign) {
  for (std::size_t f = 0; f < data.faces.size(); ++f)
    require(!has_zero_area(data, f, sign), "face {}: zero area", f);
  for (std::size_t v = 0; v < data.monge.size(); ++v) {
    const auto& m = data.monge[v];
    require(m[0] != 0 || m[1] != 0 || m[2] != 0, "vertex {}: d1 is zero", v);
    require(m[3] != 0 || m[4] != 0 || m[5] != 0, "vertex {}: n is zero", v);
    require(m[6] >= m[7], "vertex {}: k1 < k2", v);
  }
}

FrameCounts count_frames(const MeshData& data, const Topology& topology, SignLadder& sign) {
  FrameCounts counts;
  const std::span<const std::uint32_t> ring(topology.ring);
  for (std::size_t v = 0; v < data.monge.size(); ++v) {
    const std::uint32_t first = topology.ring_start[v];
    counts.against_faces +=
        is_against_faces(data, ring.subspan(first, topology.ring_start[v + 1] - first), sign);
    counts.equal_curvatures += data.monge[v][field::k1] == data.monge[v][field::k2];
    counts.parallel_frames += is_parallel_frame(data, v, sign);
  }
  return counts;
}

}  // namespace crest::certify
