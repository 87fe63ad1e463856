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

namespace {

/// Whether a bracket on an edge holds the limit of its zero of s - c + e for e -> 0: s - c is not
/// negative from the positive end to there, and negative beyond.
template <class Number>
std::optional<bool> holds_limit(const std::array<Number, 3>& b,
                                const std::array<double, 2>& bracket) {
  const auto at = [&](double t) {
    const Number u(t), v = Number(1) - u;
    return v * v * b[0] + Number(2) * v * u * b[1] + u * u * b[2];
  };
  const auto falls = is_negative(b[2]);  // from the first end, which is positive
  if (!falls) return std::nullopt;
  const Number near = at(bracket[*falls ? 0 : 1]), far = at(bracket[*falls ? 1 : 0]);
  const auto too_far = is_negative(near), too_near = is_positive(far);
  if (!too_far || !too_near) return std::nullopt;
  if (*too_far || *too_near) return false;
  // At the end itself s - c may be 0 and positive behind.
  if (*falls ? bracket[1] > 0 : bracket[0] < 1) return true;
  const auto rises = is_positive(b[1]);
  return rises ? std::optional(!*rises) : std::nullopt;
}

template <class Number>
std::optional<bool> holds_limit_on(const SplineVolume& volume, const QuadraticSpline& spline,
                                   const Forest& forest, const ActiveLeaf& leaf,
                                   const std::array<std::size_t, 2>& ends,
                                   const std::array<double, 2>& bracket) {
  const std::size_t cube = leaf.root / kTetrahedra;
  const Tetrahedron tet = tetrahedron(leaf.root % kTetrahedra);
  const auto root_form = quadratic(spline.neighbourhood<Number>(spline.position(cube)), tet);
  const auto form = leaf_form(root_form, tet, forest.cube_corner(cube), leaf.simplex, volume.level);
  return holds_limit(form.edge(ends[0], ends[1]), bracket);
}

}  // namespace

void check_brackets(const SplineIsosurfaceCertificate& c, const QuadraticSpline& spline,
                    const Forest& forest, const Leaves& leaves, const Mesh& mesh) {
  const auto holds = [&](std::size_t i) {
    const Mesh::Vertex& vertex = mesh.vertices[i];
    const ActiveLeaf& leaf = leaves.active[vertex.leaf];
    const kernel::RoundUpward guard;
    const auto near =
        holds_limit_on<Interval>(c.volume, spline, forest, leaf, vertex.ends, c.brackets[i]);
    return near ? *near
                : *holds_limit_on<Rational>(c.volume, spline, forest, leaf, vertex.ends,
                                            c.brackets[i]);
  };
  parallel_for(
      mesh.vertices.size(), [] { return 0; },
      [&](int, std::size_t i) {
        require(holds(i), "the bracket of vertex {} does not hold its zero", i);
      });
}

}  // namespace crest::certify::spline_isosurface
