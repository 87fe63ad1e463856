// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/face_indices.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "kernel/geometry/parallel.hpp"
#include "kernel/predicates/rotation.hpp"

namespace crest::ridges {
namespace {

using kernel::MongeForm;
using kernel::Stage;

constexpr Index kGrain = 4096;

// All angles of the connection: phi by vertex, positions by edge end, scaled corners by face.
// Positions are floats, which the triage of a rotation counts in; corners and rotations are only
// summed, to a multiple of pi.
struct Angles {
  std::vector<double> phi, error;            // V
  std::vector<std::array<float, 2>> at;      // E: a(v0, v1), a(v1, v0)
  std::vector<std::array<float, 3>> corner;  // F
  // In place of a position, once both are used.
  float& omega(Index e) { return at[e][0]; }
};

std::size_t corner_of(const kernel::Triangle& t, Index v) {
  return t[0] == v ? 0 : t[1] == v ? 1 : 2;
}

void ring_points(const kernel::TriangleMesh& mesh, Index v, std::vector<Vec3>& out) {
  out.clear();
  for (Index w : mesh.ring(v)) out.push_back(mesh.points()[w]);
}

kernel::Star star_of(const kernel::TriangleMesh& mesh, const MongeForm& form, Index v,
                     const std::vector<Vec3>& ring) {
  return {mesh.points()[v], ring, !mesh.on_boundary(v), form.d1, form.n};
}

void scatter(const kernel::TriangleMesh& mesh, Index v, const std::vector<double>& position,
             const std::vector<double>& corner, Angles& angles) {
  const auto fan = mesh.fan(v);
  auto put = [&](Index e, double a) {
    angles.at[e][mesh.edges()[e].v0 == v ? 0 : 1] = static_cast<float>(a);
  };
  for (std::size_t j = 0; j < fan.size(); ++j) {
    const std::size_t k = corner_of(mesh.faces()[fan[j]], v);
    angles.corner[fan[j]][k] = static_cast<float>(corner[j]);
    put(mesh.face_edges()[fan[j]][k], position[j]);
    if (mesh.on_boundary(v) && j + 1 == fan.size())
      put(mesh.face_edges()[fan[j]][(k + 2) % 3], position[j + 1]);
  }
}

Angles all_angles(const kernel::MeshPiece& piece, const std::vector<MongeForm>& forms,
                  StageCounts& total) {
  const kernel::TriangleMesh& mesh = piece.mesh();
  Angles angles;
  angles.phi.resize(mesh.vertex_count());
  angles.error.resize(mesh.vertex_count());
  angles.at.resize(mesh.edge_count());
  angles.corner.resize(mesh.face_count());
  tbb::enumerable_thread_specific<StageCounts> counts;
  kernel::parallel_for(
      tbb::blocked_range<Index>(0, mesh.vertex_count(), kGrain), [&](const auto& r) {
        std::vector<Vec3> ring;
        std::vector<double> position, corner;
        StageCounts local;
        for (Index v = r.begin(); v != r.end(); ++v) {
          if (!piece.is_inner(v)) continue;
          ring_points(mesh, v, ring);
          position.resize(ring.size());
          corner.resize(ring.size());
          const kernel::StarAngles s =
              kernel::star_angles(star_of(mesh, forms[v], v, ring), position, corner);
          if (piece.owns(v)) local.add(s.stage);
          angles.phi[v] = s.phi;
          angles.error[v] = s.error;
          scatter(mesh, v, position, corner, angles);
        }
        counts.local() += local;
      });
  for (const StageCounts& c : counts) total += c;
  return angles;
}

kernel::Rotation rotation(const kernel::TriangleMesh& mesh, const std::vector<MongeForm>& forms,
                          const EdgeStates& states, const Angles& angles, Index e) {
  const Index v = mesh.edges()[e].v0, w = mesh.edges()[e].v1;
  const bool reversed = states.acute[e] < 0;
  const double here{angles.at[e][0]}, there{angles.at[e][1]};
  const double raw =
      angles.phi[w] - angles.phi[v] - (there + kernel::kPi) + here + (reversed ? kernel::kPi : 0.0);
  const double rounding = 0x1p-23 * (std::fabs(here) + std::fabs(there));
  if (const auto omega = kernel::triage_rotation(raw, angles.error[v] + angles.error[w] + rounding))
    return {*omega, Stage::triage};
  std::vector<Vec3> ring_v, ring_w;
  ring_points(mesh, v, ring_v);
  ring_points(mesh, w, ring_w);
  auto place = [&](Index from, Index to) {
    const auto ring = mesh.ring(from);
    return static_cast<std::size_t>(std::find(ring.begin(), ring.end(), to) - ring.begin());
  };
  const kernel::EdgeStars stars{star_of(mesh, forms[v], v, ring_v),
                                star_of(mesh, forms[w], w, ring_w), place(v, w), place(w, v),
                                reversed};
  if (const auto omega = kernel::interval_rotation(stars)) return {*omega, Stage::interval};
  return {kernel::symbolic_rotation(), Stage::symbolic};
}

std::int8_t twice_index(const kernel::TriangleMesh& mesh, const EdgeStates& states, Angles& angles,
                        Index f) {
  double t = -kernel::kPi;
  for (std::size_t k = 0; k < 3; ++k) {
    const Index e = mesh.face_edges()[f][k];
    const double omega{angles.omega(e)};
    t += double{angles.corner[f][k]} + (mesh.edges()[e].v0 == mesh.faces()[f][k] ? omega : -omega);
  }
  // t is an integer multiple of pi known to far less than pi (lemma 2).
  const double twice = std::nearbyint(t / kernel::kPi);
  if (std::fabs(t / kernel::kPi - twice) > 0.1 ||
      (std::lround(twice) % 2 != 0) != states.conflict(mesh, f))
    throw std::logic_error("the rotation around face " + std::to_string(f) +
                           " is not a multiple of pi of the right parity");
  return static_cast<std::int8_t>(twice);
}

}  // namespace

FaceIndices face_indices(const kernel::MeshPiece& piece, const std::vector<MongeForm>& forms,
                         const EdgeStates& states) {
  const kernel::TriangleMesh& mesh = piece.mesh();
  FaceIndices result;
  Angles angles = all_angles(piece, forms, result.star_counts);
  tbb::enumerable_thread_specific<StageCounts> counts;
  kernel::parallel_for(tbb::blocked_range<Index>(0, mesh.edge_count(), kGrain), [&](const auto& r) {
    StageCounts local;
    for (Index e = r.begin(); e != r.end(); ++e) {
      if (states.acute[e] == 0) continue;
      const kernel::Rotation turn = rotation(mesh, forms, states, angles, e);
      if (piece.owns(mesh.edges()[e].v0)) local.add(turn.stage);
      angles.omega(e) = static_cast<float>(turn.omega);
    }
    counts.local() += local;
  });
  for (const StageCounts& c : counts) result.rotation_counts += c;

  result.twice.resize(mesh.face_count());
  result.twice_sum = kernel::parallel_reduce(
      tbb::blocked_range<Index>(0, mesh.face_count(), kGrain), 0,
      [&](const auto& r, int sum) {
        for (Index f = r.begin(); f != r.end(); ++f) {
          const auto& corners = mesh.faces()[f];
          if (!piece.owns(*std::min_element(corners.begin(), corners.end()))) continue;
          result.twice[f] = twice_index(mesh, states, angles, f);
          sum += result.twice[f];
        }
        return sum;
      },
      std::plus<>());
  return result;
}

}  // namespace crest::ridges
