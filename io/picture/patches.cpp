// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/picture/patches.hpp"

#include <array>

namespace crest::io {
namespace {

using kernel::Index;
using kernel::Vec3;

/// Corners of their own for each face, so that neither tints nor shading cross a patch's border.
struct PatchedSurface {
  std::vector<Vec3> points, normals, tints;
  std::vector<kernel::Triangle> faces;
};

PatchedSurface patched(const kernel::TriangleMesh& mesh, const std::vector<Index>& face_patch) {
  constexpr std::array<Vec3, 8> palette = {{{1, 0.93, 0.82},
                                            {0.84, 0.93, 1},
                                            {0.88, 1, 0.86},
                                            {1, 0.87, 0.9},
                                            {0.92, 0.88, 1},
                                            {1, 1, 0.8},
                                            {0.82, 1, 0.97},
                                            {0.95, 0.9, 0.84}}};
  const std::vector<Vec3> area = area_vectors(mesh);
  PatchedSurface surface;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Index first = static_cast<Index>(surface.points.size());
    surface.faces.push_back({first, first + 1, first + 2});
    for (const Index v : mesh.faces()[f]) {
      Vec3 normal{};
      for (const Index g : mesh.fan(v))
        if (face_patch[g] == face_patch[f]) normal = combine(1, normal, 1, area[g]);
      surface.points.push_back(mesh.points()[v]);
      surface.normals.push_back(normalised(normal, {0, 0, 1}));
      surface.tints.push_back(palette[face_patch[f] % palette.size()]);
    }
  }
  return surface;
}

}  // namespace

std::vector<Vec3> area_vectors(const kernel::TriangleMesh& mesh) {
  std::vector<Vec3> area;
  for (const auto& [a, b, c] : mesh.faces()) {
    const Vec3& p = mesh.points()[a];
    area.push_back(cross(combine(1, mesh.points()[b], -1, p), combine(1, mesh.points()[c], -1, p)));
  }
  return area;
}

void draw_patches(Canvas& canvas, const Camera& camera, const kernel::TriangleMesh& mesh,
                  const std::vector<Index>& face_patch) {
  const PatchedSurface surface = patched(mesh, face_patch);
  canvas.draw_surface(camera, {surface.points, surface.faces}, surface.normals, &surface.tints);
}

}  // namespace crest::io
