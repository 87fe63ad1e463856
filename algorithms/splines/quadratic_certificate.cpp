// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/splines/quadratic_certificate.hpp"

#include <bit>
#include <cstring>

namespace crest::splines {

static_assert(std::endian::native == std::endian::little);

certify::SplineVolume volume_record(const QuadraticSpline& spline, double level) {
  const kernel::SampledGrid& grid = spline.grid();
  certify::SplineVolume volume;
  volume.type = static_cast<std::uint8_t>(grid.type());
  volume.extended = spline.border() == Border::extend;
  // Certificates hold no -0: adding 0 makes it 0.
  for (std::size_t k = 0; k < 3; ++k) {
    volume.nodes[k] = static_cast<std::uint32_t>(grid.size[k]);
    volume.origin[k] = grid.origin[k] + 0.0;
    volume.spacing[k] = grid.spacing[k];
    for (std::size_t r = 0; r < 3; ++r) volume.direction[3 * r + k] = grid.directions[k][r] + 0.0;
  }
  volume.level = level + 0.0;
  std::visit(
      [&](const auto& samples) {
        using Native = typename std::decay_t<decltype(samples)>::value_type;
        volume.samples.resize(samples.size() * sizeof(Native));
        for (std::size_t i = 0; i < samples.size(); ++i) {
          const auto x = static_cast<Native>(samples[i] + Native(0));
          std::memcpy(volume.samples.data() + i * sizeof x, &x, sizeof x);
        }
      },
      grid.samples);
  return volume;
}

certify::SplineRaysCertificate rays_certificate(const QuadraticSpline& spline, double level,
                                                std::span<const Ray> rays,
                                                std::span<const Hit> hits) {
  certify::SplineRaysCertificate c;
  c.volume = volume_record(spline, level);
  const Cube& n = spline.cubes();
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto &o = rays[i].origin, &d = rays[i].direction;
    c.rays.push_back({o[0] + 0.0, o[1] + 0.0, o[2] + 0.0, d[0] + 0.0, d[1] + 0.0, d[2] + 0.0});
    const Hit& hit = hits[i];
    c.meets.push_back(hit.hit);
    if (!hit.hit) continue;
    const int cube = hit.cube[0] + n[0] * (hit.cube[1] + n[1] * hit.cube[2]);
    c.hits.push_back({static_cast<std::uint32_t>(cube), hit.tetrahedron, hit.t_lo, hit.t_hi});
  }
  return c;
}

certify::SplineIsosurfaceCertificate isosurface_certificate(const QuadraticSpline& spline,
                                                            double level,
                                                            const Isosurface& surface) {
  certify::SplineIsosurfaceCertificate c;
  c.volume = volume_record(spline, level);
  c.bisected = surface.bisected;
  c.trees = surface.trees;
  c.brackets = surface.brackets;
  c.triangles = surface.triangles;
  c.euler_characteristic = static_cast<std::int32_t>(surface.euler_characteristic);
  c.components = static_cast<std::uint32_t>(surface.components);
  c.boundary_loops = static_cast<std::uint32_t>(surface.boundary_loops);
  return c;
}

}  // namespace crest::splines
