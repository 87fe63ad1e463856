// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/pieces.hpp"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "kernel/geometry/parallel.hpp"
#include "kernel/predicates/against_faces.hpp"
#include "kernel/predicates/collinear.hpp"

namespace crest::ridges {
namespace {

using kernel::MeshPart;
using kernel::MeshPiece;
using kernel::MongeForm;
using kernel::TriangleMesh;
using Owned = std::vector<std::vector<Index>>;  ///< vertices by piece

/// Decisions' counts of vertices.
using FrameCounts = std::array<Index, 3>;

void count_frame(const TriangleMesh& mesh, const MongeForm& form, Index v,
                 std::vector<std::array<Vec3, 2>>& sides, FrameCounts& counts) {
  const std::span<const Index> ring = mesh.ring(v);
  const std::size_t faces = ring.size() - (mesh.on_boundary(v) ? 1 : 0);
  sides.clear();
  for (std::size_t k = 0; k < faces; ++k)
    sides.push_back({mesh.points()[ring[k]], mesh.points()[ring[(k + 1) % ring.size()]]});
  counts[0] += kernel::against_faces(form.n, mesh.points()[v], sides);
  counts[1] += form.k1 == form.k2;
  counts[2] += kernel::collinear({0, 0, 0}, form.n, form.d1);
}

void count_frames(const MeshPiece& piece, const std::vector<MongeForm>& forms, Decisions& to) {
  const auto [against, equal, parallel] = kernel::parallel_reduce(
      tbb::blocked_range<Index>(0, piece.mesh().vertex_count(), 4096), FrameCounts{},
      [&](const auto& range, FrameCounts counts) {
        std::vector<std::array<Vec3, 2>> sides;
        for (Index v = range.begin(); v != range.end(); ++v)
          if (piece.owns(v)) count_frame(piece.mesh(), forms[v], v, sides, counts);
        return counts;
      },
      [](FrameCounts a, const FrameCounts& b) {
        for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
        return a;
      });
  to.against_faces = against;
  to.equal_curvatures = equal;
  to.parallel_frames = parallel;
}

Index lowest(const kernel::Triangle& face) {
  return *std::min_element(face.begin(), face.end());
}

/// The items of which `owned` holds, by number.
template <class T, class Test>
std::vector<T> only(const std::vector<T>& items, const Test& owned) {
  std::vector<T> r;
  for (Index i = 0; i < items.size(); ++i)
    if (owned(i)) r.push_back(items[i]);
  return r;
}

/// Puts pieces' items where they belong: each piece's are in the order of the whole mesh.
class Places {
 public:
  Places(Index vertices, const Owned& owned) : piece_of_(vertices), count_(owned.size()) {
    for (Index p = 0; p < owned.size(); ++p)
      for (const Index v : owned[p]) piece_of_[v] = p;
  }
  /// The i-th of `count` items is owner(i)'s owner's; from(p): the items of piece p.
  template <class T, class Owner, class From>
  void join(Index count, const Owner& owner, const From& from, std::vector<T>& to) const {
    std::vector<std::size_t> next(count_);
    to.resize(count);
    for (Index i = 0; i < count; ++i) {
      const Index p = piece_of_[owner(i)];
      to[i] = from(p)[next[p]++];
    }
  }

 private:
  std::vector<Index> piece_of_;
  std::size_t count_;
};

void add_counts(const Decisions& part, Decisions& to) {
  to.states.ambiguous_edges += part.states.ambiguous_edges;
  for (int c = 0; c < 2; ++c) to.states.zero_extremalities[c] += part.states.zero_extremalities[c];
  to.states.acute_counts += part.states.acute_counts;
  to.states.extremality_counts += part.states.extremality_counts;
  to.indices.twice_sum += part.indices.twice_sum;
  to.indices.star_counts += part.indices.star_counts;
  to.indices.rotation_counts += part.indices.rotation_counts;
  to.against_faces += part.against_faces;
  to.equal_curvatures += part.equal_curvatures;
  to.parallel_frames += part.parallel_frames;
}

Decisions join(const TriangleMesh& mesh, const Owned& owned, const std::vector<Decisions>& parts) {
  Decisions r;
  const Places places(mesh.vertex_count(), owned);
  const auto of_edge = [&](Index e) { return mesh.edges()[e].v0; };
  const auto self = [](Index v) { return v; };
  places.join(
      mesh.edge_count(), of_edge, [&](Index p) { return parts[p].states.acute.data(); },
      r.states.acute);
  places.join(
      mesh.edge_count(), of_edge, [&](Index p) { return parts[p].states.crossed.data(); },
      r.states.crossed);
  for (int c = 0; c < 2; ++c)
    places.join(
        mesh.vertex_count(), self, [&](Index p) { return parts[p].states.extremality[c].data(); },
        r.states.extremality[c]);
  places.join(
      mesh.face_count(), [&](Index f) { return lowest(mesh.faces()[f]); },
      [&](Index p) { return parts[p].indices.twice.data(); }, r.indices.twice);
  for (const Decisions& part : parts) add_counts(part, r);
  return r;
}

/// Rings of most supports. A guess: who is left gets twice as many.
Index first_rings(const FitOptions& options) {
  const double rings = options.rings > 0 ? 1.25 * options.rings + 1
                                         : std::sqrt(0.52 * std::max(options.min_points, 1)) + 1;
  return static_cast<Index>(std::ceil(rings));
}

FitJob fit_job(const TriangleMesh& mesh, const std::vector<Index>& owned, Index rings,
               const std::vector<std::uint8_t>& creases, const FitOptions& options) {
  FitJob r{kernel::mesh_part(mesh, owned, rings), {}, options};
  if (!creases.empty())
    for (const Index v : r.part.vertices) r.creases.push_back(creases[v]);
  return r;
}

/// A piece's records to the vertices they are of.
void put(const FitRecords& from, const std::vector<Index>& done, FitRecords& to) {
  for (std::size_t i = 0; i < done.size(); ++i) {
    to.forms[done[i]] = from.forms[i];
    to.quality[done[i]] = from.quality[i];
    if (from.errors.empty()) continue;
    to.errors[done[i]] = from.errors[i];
    to.residuals[done[i]] = from.residuals[i];
  }
}

template <class Job, class Answer>
Workers::Call<Job, Answer> one_by_one() {
  return [](std::size_t jobs, const std::function<Job(std::size_t)>& job) {
    std::vector<Answer> r;
    for (std::size_t i = 0; i < jobs; ++i) r.push_back(work_on(job(i)));
    return r;
  };
}

bool in_one_piece(const Workers* workers) {
  return workers == nullptr || workers->pieces <= 1;
}

}  // namespace

Decisions decide(const MeshPiece& piece, const std::vector<MongeForm>& forms, bool guarded) {
  Decisions r;
  r.states = edge_states(piece, forms, guarded);
  r.indices = face_indices(piece, forms, r.states);
  count_frames(piece, forms, r);
  return r;
}

Decisions owned_of(const MeshPiece& piece, Decisions all) {
  if (piece.is_whole()) return all;
  const TriangleMesh& mesh = piece.mesh();
  const auto edge = [&](Index e) { return piece.owns(mesh.edges()[e].v0); };
  all.states.acute = only(all.states.acute, edge);
  all.states.crossed = only(all.states.crossed, edge);
  for (auto& signs : all.states.extremality)
    signs = only(signs, [&](Index v) { return piece.owns(v); });
  all.indices.twice =
      only(all.indices.twice, [&](Index f) { return piece.owns(lowest(mesh.faces()[f])); });
  return all;
}

FitRecords work_on(const FitJob& job) {
  const TriangleMesh mesh(job.part.points, job.part.faces);
  return fit_records({mesh, job.part}, job.creases, job.options);
}

Decisions work_on(const DecisionJob& job) {
  const TriangleMesh mesh(job.part.points, job.part.faces);
  const MeshPiece piece(mesh, job.part);
  return owned_of(piece, decide(piece, job.forms, job.guarded));
}

Workers workers_here(Index pieces) {
  return {pieces, one_by_one<FitJob, FitRecords>(), one_by_one<DecisionJob, Decisions>()};
}

Decisions decide_all(const TriangleMesh& mesh, const std::vector<MongeForm>& forms, bool guarded,
                     const Workers* workers) {
  if (in_one_piece(workers)) return decide(mesh, forms, guarded);
  constexpr Index kRings = 2;  // all corners of owned faces are inner
  const Owned owned = kernel::cut_points(mesh.points(), workers->pieces);
  return join(mesh, owned, workers->decide(owned.size(), [&](std::size_t p) {
    DecisionJob job{kernel::mesh_part(mesh, owned[p], kRings), {}, guarded};
    for (const Index v : job.part.vertices) job.forms.push_back(forms[v]);
    return job;
  }));
}

FitRecords fit_all(const TriangleMesh& mesh, const std::vector<std::uint8_t>& creases,
                   const FitOptions& options, const Workers* workers) {
  if (in_one_piece(workers)) return fit_records(mesh, creases, options);
  FitRecords r;
  r.forms.resize(mesh.vertex_count());
  r.quality.resize(mesh.vertex_count());
  r.errors.resize(options.errors ? mesh.vertex_count() : 0);
  r.residuals.resize(r.errors.size());
  Owned owned = kernel::cut_points(mesh.points(), workers->pieces);
  for (Index rings = first_rings(options); !owned.empty(); rings *= 2) {
    const auto found = workers->fit(owned.size(), [&](std::size_t p) {
      return fit_job(mesh, owned[p], rings, creases, options);
    });
    for (std::size_t p = 0; p < owned.size(); ++p)
      put(found[p], kernel::take_done(owned[p], found[p].left), r);
    std::erase_if(owned, [](const auto& left) { return left.empty(); });
  }
  return r;
}

}  // namespace crest::ridges
