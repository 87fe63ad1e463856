// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/container/parallel.hpp"
#include "certify/container/reject.hpp"
#include "certify/spline_isosurface/leaf_test.hpp"
#include "certify/spline_isosurface/mesh.hpp"

namespace crest::certify::spline_isosurface {
namespace {

using kernel::Interval;
using kernel::Rational;

/// The leaves of one cube.
class CubeLeaves {
 public:
  CubeLeaves(const SplineVolume& volume, const QuadraticSpline& spline, const Forest& forest,
             std::size_t cube)
      : volume_(volume),
        spline_(spline),
        forest_(forest),
        cube_(cube),
        corner_(forest.cube_corner(cube)),
        near_(spline.neighbourhood<Interval>(spline.position(cube))) {}

  /// False if a leaf is neither empty nor simple.
  bool check(Leaves& leaves) {
    for (unsigned number = 0; number < kTetrahedra; ++number) {
      const auto root = static_cast<std::uint32_t>(kTetrahedra * cube_ + number);
      const Tetrahedron tet = tetrahedron(number);
      const auto form = quadratic<Interval>(tet, near_);
      bool good = true;
      forest_.for_each_leaf(root, [&](const Simplex& leaf) {
        good = good &&
               check_leaf(root, leaf, leaf_form(form, tet, corner_, leaf, volume_.level), leaves);
      });
      if (!good) return false;
    }
    return true;
  }

 private:
  bool check_leaf(std::uint32_t root, const Simplex& leaf, const LeafForm<Interval>& form,
                  Leaves& leaves) {
    if (const auto done = judge(root, leaf, form, leaves)) return *done;
    return *judge(root, leaf, exact_form(root, leaf), leaves);
  }
  LeafForm<Rational> exact_form(std::uint32_t root, const Simplex& leaf) const {
    const Tetrahedron tet = tetrahedron(root % kTetrahedra);
    const auto samples = spline_.neighbourhood<Rational>(spline_.position(cube_));
    return leaf_form(quadratic(samples, tet), tet, corner_, leaf, volume_.level);
  }
  /// Nothing if it is not decided.
  template <class Number>
  static std::optional<bool> judge(std::uint32_t root, const Simplex& leaf,
                                   const LeafForm<Number>& form, Leaves& leaves) {
    const auto kind = kind_of(form);
    if (!kind) return std::nullopt;
    if (*kind == LeafKind::empty) return true;
    if (*kind == LeafKind::neither) return false;
    unsigned negative = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto sign = is_negative(form.b[i][i]);
      if (!sign) return std::nullopt;
      negative |= *sign ? 1U << i : 0U;
    }
    ++leaves.simple;
    if (negative != 0 && negative != 15) leaves.active.push_back({root, leaf, negative});
    return true;
  }

  const SplineVolume& volume_;
  const QuadraticSpline& spline_;
  const Forest& forest_;
  std::size_t cube_;
  Point corner_;
  CubeCoefficients<Interval> near_;
};

}  // namespace

Leaves check_leaves(const SplineVolume& volume, const QuadraticSpline& spline,
                    const Forest& forest) {
  const auto one_sided = spline.one_sided();
  const std::size_t row = spline.cubes(0), rows = spline.cube_count() / row;
  std::vector<Leaves> found(rows);
  parallel_for(
      rows, [] { return 0; },
      [&](int, std::size_t i) {
        for (std::size_t cube = i * row; cube < (i + 1) * row; ++cube) {
          if (one_sided[cube] != 0) continue;
          bool good = false;
          {
            const kernel::RoundUpward guard;
            good = CubeLeaves(volume, spline, forest, cube).check(found[i]);
          }
          require(good, "a leaf in cube {} is neither empty nor simple", cube);
        }
      });
  Leaves all;
  for (Leaves& part : found) {
    all.active.insert(all.active.end(), part.active.begin(), part.active.end());
    all.simple += part.simple;
    part = {};
  }
  return all;
}

void check_brackets(const SplineIsosurfaceCertificate& c, const QuadraticSpline& spline,
                    const Forest& forest, const Leaves& leaves, const Mesh& mesh) {
  // Whether there is no change of sign on the edge before the bracket, and none after it.
  const auto holds = [&]<class Number>(const LeafForm<Number>& form, const Mesh::Vertex& vertex,
                                       const std::array<double, 2>& bracket) {
    const auto b = form.edge(vertex.ends[0], vertex.ends[1]);
    const auto at = [&](double t) {
      const Number u(t), v = Number(1) - u;
      return v * v * b[0] + Number(2) * v * u * b[1] + u * u * b[2];
    };
    const auto first = is_negative(b[0]);
    const Number low = at(bracket[0]), high = at(bracket[1]);
    if (!first) return std::optional<bool>();
    // On the side of the end, or 0.
    const auto beyond_low = *first ? is_positive(low) : is_negative(low);
    const auto beyond_high = *first ? is_negative(high) : is_positive(high);
    if (!beyond_low || !beyond_high) return std::optional<bool>();
    return std::optional(!*beyond_low && !*beyond_high);
  };
  constexpr std::size_t kPiece = 64;
  parallel_for((mesh.vertices.size() + kPiece - 1) / kPiece, [] { return 0; },
               [&](int, std::size_t piece) {
                 const std::size_t end = std::min(mesh.vertices.size(), (piece + 1) * kPiece);
                 for (std::size_t i = piece * kPiece; i < end; ++i) {
                   const Mesh::Vertex& vertex = mesh.vertices[i];
                   const ActiveLeaf& leaf = leaves.active[vertex.leaf];
                   const std::size_t cube = leaf.root / kTetrahedra;
                   const Tetrahedron tet = tetrahedron(leaf.root % kTetrahedra);
                   const auto form = [&]<class Number>(Number) {
                     return leaf_form(
                         quadratic(spline.neighbourhood<Number>(spline.position(cube)), tet), tet,
                         forest.cube_corner(cube), leaf.simplex, c.volume.level);
                   };
                   std::optional<bool> good;
                   {
                     const kernel::RoundUpward guard;
                     good = holds(form(Interval(0)), vertex, c.brackets[i]);
                     if (!good) good = holds(form(Rational(0)), vertex, c.brackets[i]);
                   }
                   require(*good, "the bracket of vertex {} does not hold its zero", i);
                 }
               });
}

}  // namespace crest::certify::spline_isosurface
