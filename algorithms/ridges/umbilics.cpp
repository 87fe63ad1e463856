// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/umbilics.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "kernel/geometry/parallel.hpp"
#include "kernel/predicates/umbilic_kind.hpp"

namespace crest::ridges {
namespace {

using kernel::MongeForm;

double mean_gap(const kernel::TriangleMesh& mesh, const std::vector<MongeForm>& forms, Index f) {
  double sum = 0;
  for (Index v : mesh.faces()[f]) sum += forms[v].k1 - forms[v].k2;
  return sum / 3;
}

bool less_gap(const MongeForm& m, const MongeForm& b) {
  return kernel::compare_gaps({m.k1, m.k2, b.k1, b.k2}).sign == kernel::Sign::negative;
}

/// The corner with the least k1 - k2, exactly; ties: the first.
Index least_gap_corner(const kernel::TriangleMesh& mesh, const std::vector<MongeForm>& forms,
                       Index f) {
  Index best = mesh.faces()[f][0];
  for (Index v : mesh.faces()[f])
    if (less_gap(forms[v], forms[best])) best = v;
  return best;
}

UmbilicKind kind_of(const kernel::TriangleMesh& mesh, const std::vector<MongeForm>& forms, Index f,
                    StageCounts& counts) {
  const MongeForm& m = forms[least_gap_corner(mesh, forms, f)];
  const kernel::Decision d = kernel::umbilic_kind({m.b0, m.b1, m.b2, m.b3});
  counts.add(d.stage);
  if (d.sign == kernel::Sign::zero) return UmbilicKind::degenerate;
  return d.sign == kernel::Sign::positive ? UmbilicKind::one_ridge : UmbilicKind::three_ridge;
}

bool coherent(int twice_index, const std::array<Index, 2>& crossings) {
  return (twice_index == 1 || twice_index == -1) && crossings[0] == crossings[1] &&
         (crossings[0] == 1 || crossings[0] == 3);
}

/// An umbilic of a seed, as long as none of the faces it depends on has got an owner since.
struct Attempt {
  Umbilic umbilic;
  std::vector<Index> asked;
  StageCounts counts;
};

/// What seeds look at of a face: where there are many of them, once a face.
class FaceTable {
 public:
  FaceTable(const kernel::TriangleMesh& mesh, const EdgeStates& states)
      : mesh_(mesh), states_(states) {}

  void fill() {
    faces_.resize(mesh_.face_count());
    crossed_.resize(mesh_.face_count());
    kernel::parallel_for(tbb::blocked_range<Index>(0, mesh_.face_count(), 4096),
                         [&](const auto& range) {
                           for (Index f = range.begin(); f != range.end(); ++f) {
                             faces_[f] = patch_face(mesh_, f);
                             crossed_[f] = look_at_sides(f);
                           }
                         });
  }

  /// Of the whole mesh, or none.
  std::span<const PatchFace> faces() const { return faces_; }
  /// Bit 2 k + c: side k is crossed by colour c.
  unsigned crossed(Index f) const { return crossed_.empty() ? look_at_sides(f) : crossed_[f]; }

 private:
  std::uint8_t look_at_sides(Index f) const {
    unsigned bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits |= unsigned{states_.crossed[mesh_.face_edges()[f][k]]} << 2 * k;
    return static_cast<std::uint8_t>(bits);
  }

  const kernel::TriangleMesh& mesh_;
  const EdgeStates& states_;
  std::vector<PatchFace> faces_;
  std::vector<std::uint8_t> crossed_;
};

/// The patches go to the seeds one after the other, each of what the earlier ones have left: a
/// greedy order, which does not depend on threads. They are tried side by side, and those that turn
/// out to depend on a patch of the same batch once more.
class Finder {
 public:
  Finder(const kernel::TriangleMesh& mesh, const std::vector<MongeForm>& forms,
         const EdgeStates& states, const FaceIndices& indices, double size)
      : mesh_(mesh), forms_(forms), states_(states), indices_(indices), size_(size) {
    result_.owner.assign(mesh.face_count(), kernel::kNone);
  }

  UmbilicPatches run() {
    constexpr std::size_t batch = 512, few = 64;
    const std::vector<Index> order = seeds();
    if (order.size() > mesh_.face_count() / 256) table_.fill();
    own_.emplace(workspace());
    const bool alone =
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism) == 1;
    if (order.size() < few || alone) {
      for (Index seed : order) {
        kernel::stop_point();
        if (result_.owner[seed] == kernel::kNone) add(attempt(seed, *own_));
      }
    } else {
      for (std::size_t i = 0; i < order.size(); i += batch)
        add_batch(std::span(order).subspan(i, std::min(batch, order.size() - i)));
    }
    renumber();
    return std::move(result_);
  }

 private:
  std::vector<Index> seeds() const {
    std::vector<std::pair<double, Index>> order;
    for (Index f = 0; f < mesh_.face_count(); ++f)
      if (indices_.twice[f] != 0) order.push_back({mean_gap(mesh_, forms_, f), f});
    std::sort(order.begin(), order.end());
    std::vector<Index> faces;
    for (const auto& [gap, f] : order) faces.push_back(f);
    return faces;
  }

  /// What a thread works with.
  struct Workspace {
    PatchGrower grower;
    std::vector<Index> rank;  ///< of the faces of the patch in hand
  };

  Workspace workspace() const {
    return {PatchGrower(mesh_, table_.faces()), std::vector<Index>(mesh_.face_count())};
  }

  Attempt attempt(Index seed, Workspace& work) const {
    Attempt a;
    Umbilic& u = a.umbilic;
    const std::vector<Index>& faces = work.grower.grow(seed, size_, result_.owner);
    a.asked = work.grower.asked();
    u.patch.assign(faces.begin(),
                   faces.begin() + static_cast<std::ptrdiff_t>(choose(faces, work, u)));
    std::sort(u.patch.begin(), u.patch.end());
    u.face = central_face(u.patch);
    u.point = work.grower.face(u.face).centroid;
    u.kind = kind_of(mesh_, forms_, u.face, a.counts);
    return a;
  }

  bool owned(Index f) const { return result_.owner[f] != kernel::kNone; }

  void add(Attempt a) {
    for (Index f : a.umbilic.patch) result_.owner[f] = static_cast<Index>(result_.umbilics.size());
    result_.kind_counts += a.counts;
    result_.umbilics.push_back(std::move(a.umbilic));
  }

  void add_batch(std::span<const Index> seeds) {
    std::vector<Attempt> attempts(seeds.size());
    kernel::parallel_for(std::size_t{0}, seeds.size(), [&](std::size_t i) {
      if (!owned(seeds[i])) attempts[i] = attempt(seeds[i], of_threads_.local());
    });
    for (std::size_t i = 0; i < seeds.size(); ++i) {
      if (owned(seeds[i])) continue;
      const std::vector<Index>& asked = attempts[i].asked;
      const bool stale = std::any_of(asked.begin(), asked.end(), [&](Index f) { return owned(f); });
      add(stale ? attempt(seeds[i], *own_) : std::move(attempts[i]));
    }
  }

  // Of non-zero index, with the least k1 - k2 at a corner; ties: the least number.
  Index central_face(const std::vector<Index>& patch) const {
    Index central = kernel::kNone, least = kernel::kNone;
    for (Index f : patch) {
      if (indices_.twice[f] == 0) continue;
      const Index corner = least_gap_corner(mesh_, forms_, f);
      if (central != kernel::kNone && !less_gap(forms_[corner], forms_[least])) continue;
      central = f;
      least = corner;
    }
    return central;
  }

  // Every prefix of the faces in order of joining is a disk: takes the longest coherent one, else
  // the seed alone. Returns its length and fills the umbilic's numbers.
  std::size_t choose(const std::vector<Index>& faces, Workspace& work, Umbilic& u) const {
    std::size_t best = 0;
    int twice_index = 0;
    std::array<Index, 2> crossings{};
    for (std::size_t i = 0; i < faces.size(); ++i) work.rank[faces[i]] = static_cast<Index>(i);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const Index f = faces[i];
      twice_index += indices_.twice[f];
      const std::array<Index, 3> around = work.grower.face(f).around;
      const unsigned crossed = table_.crossed(f);
      for (std::size_t k = 0; k < 3; ++k) {
        const Index g = around[k];
        const bool inner = g != kernel::kNone && work.grower.contains(g) && work.rank[g] < i;
        for (std::size_t c = 0; c < 2; ++c)
          if (crossed >> (2 * k + c) & 1u) crossings[c] += inner ? -1u : 1u;
      }
      const bool good = coherent(twice_index, crossings);
      if (i > 0 && !good) continue;
      best = i + 1;
      u.twice_index = twice_index;
      u.coherent = good;
      u.border_crossings[0] = crossings[0];
      u.border_crossings[1] = crossings[1];
    }
    return best;
  }

  void renumber() {
    std::sort(result_.umbilics.begin(), result_.umbilics.end(),
              [](const Umbilic& a, const Umbilic& b) { return a.face < b.face; });
    for (Index i = 0; i < result_.umbilics.size(); ++i)
      for (Index f : result_.umbilics[i].patch) result_.owner[f] = i;
  }

  const kernel::TriangleMesh& mesh_;
  const std::vector<MongeForm>& forms_;
  const EdgeStates& states_;
  const FaceIndices& indices_;
  double size_;
  FaceTable table_{mesh_, states_};
  std::optional<Workspace> own_;
  tbb::enumerable_thread_specific<Workspace> of_threads_{[this] { return workspace(); }};
  UmbilicPatches result_;
};

}  // namespace

UmbilicPatches find_umbilics(const kernel::TriangleMesh& mesh, const std::vector<MongeForm>& forms,
                             const EdgeStates& states, const FaceIndices& indices, double size) {
  return Finder(mesh, forms, states, indices, size).run();
}

}  // namespace crest::ridges
