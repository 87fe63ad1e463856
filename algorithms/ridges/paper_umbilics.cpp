// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/patches.hpp"

namespace crest::ridges {
namespace {

using kernel::MongeForm;

class PaperMethod {
 public:
  PaperMethod(const kernel::TriangleMesh& mesh, const std::vector<MongeForm>& forms)
      : mesh_(mesh), grower_(mesh), gap_(mesh.face_count(), 0) {
    for (Index f = 0; f < mesh.face_count(); ++f)
      for (Index v : mesh.faces()[f]) gap_[f] += (forms[v].k1 - forms[v].k2) / 3;
  }

  PaperUmbilics run(const RidgeGraph& graph, double size) {
    // The winding along a disk's contour is the sum of the indices of its faces
    // (certify/ridges_mesh/SPEC.md).
    std::vector<int> twice(mesh_.face_count(), 0);
    for (const FaceIndex& i : graph.face_indices) twice[i.face] = i.twice_index;
    const std::vector<Index> nobody(mesh_.face_count(), kernel::kNone);
    PaperUmbilics result;
    for (Index f = 0; f < mesh_.face_count(); ++f) {
      if (!least_among_neighbours(f)) continue;  // cheap: most triangles stop here
      const std::vector<Index>& patch = grower_.grow(f, size, nobody);
      int sum = 0;
      bool least = true;
      for (Index g : patch) {
        sum += twice[g];
        least = least && !before(g, f);
      }
      if (!least) continue;
      ++result.candidates;
      result.plus += sum == 1;
      result.minus += sum == -1;
      result.other += sum != 0 && sum != 1 && sum != -1;
    }
    return result;
  }

 private:
  bool before(Index g, Index f) const {
    return gap_[g] < gap_[f] || (gap_[g] == gap_[f] && g < f);  // ties: one of the two wins
  }
  bool least_among_neighbours(Index f) const {
    for (int k = 0; k < 3; ++k) {
      const Index g = mesh_.neighbour(f, k);
      if (g != kernel::kNone && before(g, f)) return false;
    }
    return true;
  }

  const kernel::TriangleMesh& mesh_;
  PatchGrower grower_;
  std::vector<double> gap_;
};

}  // namespace

PaperUmbilics paper_umbilics(const kernel::TriangleMesh& mesh, const std::vector<MongeForm>& forms,
                             const RidgeGraph& graph, double patch) {
  return PaperMethod(mesh, forms).run(graph, patch);
}

}  // namespace crest::ridges
