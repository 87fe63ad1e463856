// SPDX-License-Identifier: GPL-3.0-or-later
// The reference's patches, ridges and certificate.
#include <algorithm>
#include <set>

#include "tests/certify/reference_ridges.hpp"
#include "tests/support/random.hpp"

namespace crest::tests {
namespace {

using u32 = std::uint32_t;

bool contains(const std::vector<u32>& faces, u32 f) {
  return std::find(faces.begin(), faces.end(), f) != faces.end();
}

}  // namespace

std::vector<PatchFaces> ReferenceRidges::single_faces() const {
  std::vector<PatchFaces> out;
  for (u32 f = 0; f < twice_index_.size(); ++f)
    if (twice_index_[f] != 0) out.push_back({f, {f}});
  return out;
}

std::vector<PatchFaces> ReferenceRidges::grown(std::size_t size, Random& random) const {
  std::vector<PatchFaces> out = single_faces();
  std::vector<u32> taken;
  for (const auto& patch : out) taken.push_back(patch.centre);
  for (auto& patch : out) {
    std::vector<u32> now = patch.faces;
    for (std::size_t tries = 0; tries < 4 * size && now.size() < size; ++tries) {
      const auto side = sides(now[random() % now.size()])[random() % 3];
      for (const u32 f : edge_faces_[side.edge]) {
        if (contains(now, f) || contains(taken, f)) continue;
        now.push_back(f);
        if (!is_disk(now)) now.pop_back();
      }
      if (is_coherent(now)) patch.faces = now;
    }
    taken.insert(taken.end(), patch.faces.begin(), patch.faces.end());
    std::sort(patch.faces.begin(), patch.faces.end());
  }
  return out;
}

bool ReferenceRidges::is_disk(const std::vector<u32>& faces) const {
  std::set<u32> vertices;
  std::set<std::size_t> edges;
  for (const u32 f : faces)
    for (const auto& side : sides(f)) {
      vertices.insert(side.from);
      edges.insert(side.edge);
    }
  if (vertices.size() + faces.size() != edges.size() + 1) return false;
  std::vector<u32> reached = {faces.front()};
  for (std::size_t i = 0; i < reached.size(); ++i)
    for (const auto& side : sides(reached[i]))
      for (const u32 g : edge_faces_[side.edge])
        if (contains(faces, g) && !contains(reached, g)) reached.push_back(g);
  if (reached.size() != faces.size()) return false;
  for (const u32 v : vertices) {
    // Fans: changes from outside to inside along the ring.
    const Ring& ring = rings_[v];
    std::size_t inside = 0, starts = 0;
    bool before = ring.closed && contains(faces, ring.faces.back());
    for (const u32 f : ring.faces) {
      const bool in = contains(faces, f);
      inside += in;
      starts += in && !before;
      before = in;
    }
    if (starts > 1 || inside == 0) return false;
  }
  return true;
}

bool ReferenceRidges::is_coherent(const std::vector<u32>& faces) const {
  int twice = 0;
  std::array<int, 2> count{};
  for (const u32 f : faces) {
    twice += twice_index_[f];
    for (const auto& side : sides(f)) {
      int inside = 0;
      for (const u32 g : edge_faces_[side.edge]) inside += contains(faces, g);
      for (std::size_t colour = 0; colour < 2; ++colour)
        count[colour] += inside == 1 && crossed(colour, side.edge);
    }
  }
  return std::abs(twice) == 1 && count[0] == count[1] && (count[0] == 1 || count[0] == 3);
}

void ReferenceRidges::trace(std::size_t colour, const std::vector<int>& patch_of,
                            certify::RidgesMeshCertificate& out) const {
  const auto interior = [&](std::size_t e) {
    const auto& f = edge_faces_[e];
    return f.size() == 2 && patch_of[f[0]] >= 0 && patch_of[f[0]] == patch_of[f[1]];
  };
  std::set<std::size_t> left;
  for (std::size_t e = 0; e < edges_.size(); ++e)
    if (crossed(colour, e) && !interior(e)) left.insert(e);
  // Across `face` from edge e: the other crossed side, or e itself if the ridge stops there.
  const auto across = [&](std::size_t e, u32 face) {
    if (patch_of[face] >= 0) return e;
    for (const auto& side : sides(face))
      if (side.edge != e && crossed(colour, side.edge)) return side.edge;
    return e;
  };
  const auto beyond = [&](std::size_t e, std::optional<u32> from) -> std::optional<u32> {
    for (const u32 f : edge_faces_[e])
      if (f != from) return f;
    return std::nullopt;
  };
  while (!left.empty()) {
    // Walk one way until the ridge stops or closes, then the other way from there.
    std::size_t e = *left.begin();
    std::optional<u32> face = edge_faces_[e][0];
    bool loop = false;
    const std::size_t first = e;
    while (face && across(e, *face) != e) {
      e = across(e, *face);
      if (e == first) {
        loop = true;
        break;
      }
      face = beyond(e, face);
    }
    certify::RidgeRecord ridge{};
    ridge.flags = static_cast<std::uint8_t>(colour | (loop ? 2U : 0U));
    const auto end = [&](std::size_t i, std::optional<u32> f) {
      ridge.end_kind[i] = f ? 1 : 2;
      ridge.end_patch[i] = f ? static_cast<u32>(patch_of[*f]) : 0;
    };
    if (!loop) {
      end(0, face);
      face = beyond(e, face);
    } else {
      face = edge_faces_[e][0];
    }
    const std::size_t start = e;
    while (true) {
      left.erase(e);
      auto type = crossing_type(colour, e);
      const bool goes_on = face && across(e, *face) != e;
      if (goes_on) type |= segment_type(colour, *face) << 2;
      ridge.nodes.push_back({static_cast<u32>(e), static_cast<std::uint8_t>(type)});
      if (!goes_on) {
        end(1, face);
        break;
      }
      e = across(e, *face);
      if (e == start) break;
      face = beyond(e, face);
    }
    ++out.counts[2 * colour + (loop ? 0 : 1)];
    out.ridges.push_back(ridge);
  }
}

std::uint32_t ReferenceRidges::boundary_loops() const {
  std::map<u32, u32> step;
  for (u32 v = 0; v < rings_.size(); ++v)
    if (!rings_[v].closed) step[v] = rings_[v].neighbours.front();
  u32 loops = 0;
  while (!step.empty()) {
    ++loops;
    for (auto at = step.begin(); at != step.end();) {
      const u32 to = at->second;
      step.erase(at);
      at = step.find(to);
    }
  }
  return loops;
}

std::optional<certify::RidgesMeshCertificate> ReferenceRidges::certificate(
    const std::vector<PatchFaces>& patches) const {
  certify::RidgesMeshCertificate out;
  out.data = data_;
  out.euler_characteristic = static_cast<int>(data_.positions.size()) -
                             static_cast<int>(edges_.size()) + static_cast<int>(data_.faces.size());
  out.boundary_loops = boundary_loops();
  out.ambiguous_edges = ambiguous_;
  for (const auto& m : data_.monge) {
    out.zero_extremalities[0] += m[8] == 0;
    out.zero_extremalities[1] += m[11] == 0;
  }
  count_frames(out);
  std::vector<int> patch_of(data_.faces.size(), -1);
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto& [centre, faces] = patches[p];
    certify::PatchRecord record{centre, 0, 0, 0, faces};
    if (faces.empty() || !contains(faces, centre)) return std::nullopt;
    int twice = 0;
    for (const u32 f : faces) {
      if (f >= patch_of.size() || patch_of[f] >= 0) return std::nullopt;
      patch_of[f] = static_cast<int>(p);
      twice += twice_index_[f];
    }
    if (twice == 0 || centre != central_face(faces) || !is_disk(faces)) return std::nullopt;
    record.twice_index = static_cast<std::int8_t>(twice);
    record.kind = static_cast<std::uint8_t>(kind(centre));
    record.coherent = is_coherent(faces);
    if (!record.coherent && faces.size() != 1) return std::nullopt;
    out.patches.push_back(record);
  }
  for (u32 f = 0; f < patch_of.size(); ++f) {
    int product = 1;
    for (const auto& side : sides(f)) product *= acute_[side.edge];
    out.conflict_triangles += product < 0;
    out.twice_index_sum += twice_index_[f];
    if (twice_index_[f] == 0) continue;
    out.face_indices.push_back({f, static_cast<std::int8_t>(twice_index_[f])});
    if (patch_of[f] < 0) return std::nullopt;
  }
  trace(0, patch_of, out);
  trace(1, patch_of, out);
  return out;
}

}  // namespace crest::tests
