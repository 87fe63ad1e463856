// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/ridges_mesh/geometry.hpp"

#include "certify/container/reject.hpp"

namespace crest::certify {
namespace {

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

}  // namespace crest::certify
