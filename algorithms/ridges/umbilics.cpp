// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/umbilics.hpp"

#include <algorithm>

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

class Finder {
 public:
  Finder(const kernel::TriangleMesh& mesh, const std::vector<MongeForm>& forms,
         const EdgeStates& states, const FaceIndices& indices, double size)
      : mesh_(mesh),
        forms_(forms),
        states_(states),
        indices_(indices),
        size_(size),
        grower_(mesh),
        rank_(mesh.face_count(), kernel::kNone) {
    result_.owner.assign(mesh.face_count(), kernel::kNone);
  }

  UmbilicPatches run() {
    for (Index seed : seeds())
      if (result_.owner[seed] == kernel::kNone) add(seed);
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

  void add(Index seed) {
    Umbilic u;
    const std::vector<Index>& faces = grower_.grow(seed, size_, result_.owner);
    u.patch.assign(faces.begin(), faces.begin() + static_cast<std::ptrdiff_t>(choose(faces, u)));
    std::sort(u.patch.begin(), u.patch.end());
    for (Index f : u.patch) result_.owner[f] = static_cast<Index>(result_.umbilics.size());
    u.face = central_face(u.patch);
    u.point = grower_.centroid(u.face);
    u.kind = kind_of(mesh_, forms_, u.face, result_.kind_counts);
    result_.umbilics.push_back(std::move(u));
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
  std::size_t choose(const std::vector<Index>& faces, Umbilic& u) {
    std::size_t best = 0;
    int twice_index = 0;
    std::array<Index, 2> crossings{};
    for (std::size_t i = 0; i < faces.size(); ++i) rank_[faces[i]] = static_cast<Index>(i);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const Index f = faces[i];
      twice_index += indices_.twice[f];
      for (int k = 0; k < 3; ++k) {
        const Index g = mesh_.neighbour(f, k);
        const bool inner = g != kernel::kNone && grower_.contains(g) && rank_[g] < i;
        const Index e = mesh_.face_edges()[f][static_cast<std::size_t>(k)];
        for (Colour c : {Colour::blue, Colour::red})
          if (states_.is_crossed(e, c)) crossings[static_cast<std::size_t>(c)] += inner ? -1u : 1u;
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
  PatchGrower grower_;
  std::vector<Index> rank_;  // of the faces of the patch in hand
  UmbilicPatches result_;
};

}  // namespace

UmbilicPatches find_umbilics(const kernel::TriangleMesh& mesh, const std::vector<MongeForm>& forms,
                             const EdgeStates& states, const FaceIndices& indices, double size) {
  return Finder(mesh, forms, states, indices, size).run();
}

}  // namespace crest::ridges
