// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/smooth_ridges/certificate.hpp"

namespace crest::smooth_ridges {
namespace {

using certify::SmoothFaceRecord;

SmoothFaceRecord face_record(const FaceResult& r) {
  SmoothFaceRecord record;
  record.frame = r.frame;
  record.w = r.w;
  record.purple = r.purple;
  for (std::size_t j = 0; j < 2; ++j) {
    record.type[j] = static_cast<std::uint8_t>(r.colour[j].type);
    record.verdict[j] = r.colour[j].no_zero ? SmoothFaceRecord::kNoZero : r.colour[j].monotone;
  }
  return record;
}

certify::SmoothPatchRecord patch_record(const UmbilicPatch& patch) {
  const Umbilic& u = patch.umbilic;
  certify::SmoothPatchRecord record;
  record.axis = static_cast<std::uint8_t>(u.centre.axis);
  record.twice_index = static_cast<std::int8_t>(u.branches.twice_index);
  for (std::size_t j = 0; j < 2; ++j)
    record.branches[j] = static_cast<std::uint8_t>(u.branches.count[j]);
  record.centre = u.centre.z;
  record.rho = u.rho;
  record.radius = u.radius;
  record.height = u.heights;
  record.faces = patch.faces;
  return record;
}

void count(const SmoothRidges& result, certify::RidgesSmoothCertificate& c) {
  for (const UmbilicPoint& u : result.umbilics) {
    ++c.umbilics[u.twice_index > 0 ? 0 : 1];
    ++c.umbilics[u.branches[0] == 1 ? 2 : 3];
  }
  for (const SmoothRidge& r : result.ridges)
    ++c.counts[2 * static_cast<std::size_t>(r.colour) + (r.loop ? 0 : 1)];
  for (const RidgePoint& p : result.turning_points)
    ++c.turning_points[static_cast<std::size_t>(p.colour)];
  c.purple_points = static_cast<std::uint32_t>(result.purple_points.size());
}

}  // namespace

certify::RidgesSmoothCertificate make_certificate(const Surface& surface,
                                                  const RefinedSurface& refined,
                                                  const SmoothRidges& result, const Cover& cover,
                                                  const OneSheet& sheets) {
  certify::RidgesSmoothCertificate c;
  c.surface = surface.data();
  c.euler_characteristic = result.euler_characteristic;
  c.boundary_loops = static_cast<std::uint32_t>(result.boundary_loops);
  c.components = static_cast<std::uint32_t>(result.components);
  count(result, c);
  c.vertices = refined.mesh.vertices();
  c.faces = refined.mesh.faces();
  if (surface.any_period()) c.lifts = refined.mesh.lifts();
  for (Index f = 0; f < c.faces.size(); ++f) {
    if (refined.patch_of[f] == kNone) {
      c.face_records.push_back(face_record(refined.faces[f]));
    } else {
      c.face_records.emplace_back();
      c.face_records.back().in_patch = true;
    }
  }
  for (const UmbilicPatch& patch : refined.patches) c.patches.push_back(patch_record(patch));
  for (const Index face : sheets.faces) c.one_sheet.emplace_back().face = face;
  c.graph_boxes = cover.boxes;
  c.tree = cover.tree;
  return c;
}

}  // namespace crest::smooth_ridges
