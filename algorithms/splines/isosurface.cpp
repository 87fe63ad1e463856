// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/splines/isosurface.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <set>

#include "algorithms/splines/active_cubes.hpp"
#include "algorithms/splines/edge_layers.hpp"
#include "algorithms/splines/isosurface_topology.hpp"
#include "algorithms/splines/leaf_test.hpp"
#include "algorithms/splines/marching_cases.hpp"
#include "kernel/geometry/input_error.hpp"
#include "kernel/geometry/parallel.hpp"

namespace crest::splines {

using kernel::Index;
using kernel::kNone;
using kernel::Sign;
using kernel::operator*;
using kernel::operator+;
using kernel::operator-;

namespace {

/// Where an edge's polynomial, of different signs at its ends, has the zero next to its end below.
struct EdgeZero {
  double at, low, high;  ///< from the end below: at, and what holds it
};

/// b0 < 0 <= b2, exactly but for the error.
EdgeZero zero_of(const AlongEdge& along) {
  const double f0 = -along.b0, f1 = -along.b1, f2 = -along.b2;
  const double h = f0 - f1, q = f0 - 2 * f1 + f2, root = std::sqrt(std::max(0.0, h * h - q * f0));
  EdgeZero zero;
  const double at = h > 0 ? f0 / (h + root) : (h - root) / q;
  zero.at = std::isfinite(at) ? std::clamp(at, 0.0, 1.0) : 1.0;
  const auto f = [&](double s) {
    const double r = 1 - s, c1 = r * f0 + s * f1;
    return r * c1 + s * (r * f1 + s * f2);
  };
  const double slack = along.error + 0x1p-48 * (std::fabs(f0) + std::fabs(f1) + std::fabs(f2));
  // Wider until both sides are certain: there f is positive all the way from 0, and not positive.
  for (double wide = 0x1p-52;; wide *= 4) {
    zero.low = std::max(0.0, zero.at - wide);
    zero.high = std::min(1.0, zero.at + wide);
    // Positive on [0, low] if it is at both ends and (one zero) not at 1.
    const bool low = zero.low == 0 || (f(zero.low) > slack && f2 <= 0);
    const bool high = zero.high == 1 || f(zero.high) < -slack;
    if (low && high) return zero;
  }
}

/// Leaves that are bisected for their own sake, of one tetrahedron and of all: where the level set
/// touches a plane of faces or a plateau their number would double with every third level.
constexpr std::size_t kMostLeaves = 16384;
std::size_t most_leaves(std::size_t tetrahedra) {
  return 65536 + 4 * tetrahedra;
}

class Mesher {
 public:
  Mesher(const QuadraticSpline& spline, double c)
      : spline_(spline),
        test_(spline, c),
        active_(spline, c),
        forest_(spline.cubes()),
        lattice_edges_(spline.cubes()) {}

  Isosurface run(int max_depth);

 private:
  struct Leaf {
    Cube cube;
    std::size_t tetrahedron;
    std::array<std::size_t, 4> letters;  ///< which of the tetrahedron's corners, 4: none
    std::array<Index, 4> numbers;        ///< in the forest, of leaves of trees
    FineCorners corners;
    bool mirrored;  ///< the triple product of its edges from corner 0 is negative
    LeafNet net;
  };

  /// Calls visit(cube, coefficients, signs) for active cubes of a layer in their order.
  template <class Visit>
  void for_each_active(int z, const Visit& visit) const;

  std::vector<Root> unsettled_roots();
  void bisect(int max_depth);
  void march();
  void march_cube(const Cube& cube, const CubeCoefficients<double>& a, const CubeSigns& signs);
  void march_tree(const Forest::Tree& tree, Index node, const CubeCoefficients<double>& a);
  void march_leaf(const Leaf& leaf);
  void write_tree(Index node);
  void list(const FineCorners& corners);
  Index vertex(const Leaf& leaf, std::size_t i, std::size_t k, bool i_below);
  Index make_vertex(const Leaf& leaf, std::size_t n, std::size_t p);
  void note_border(const Leaf& leaf, const std::array<Index, 6>& on);

  const QuadraticSpline& spline_;
  LeafTest test_;
  ActiveCubes active_;
  Forest forest_;
  std::size_t met_ = 0;  ///< tetrahedra that are not empty
  Isosurface mesh_;
  EdgeLayers lattice_edges_;
  EdgeNumbers fine_edges_;
  std::set<FinePoint> exact_;
  std::vector<MeshEdge> border_;
};

double coordinate(std::int64_t fine) {
  return static_cast<double>(fine) / static_cast<double>(std::int64_t{1} << kFineBits);
}

bool is_mirrored(const FineCorners& corners) {
  Vec3 edges[3];
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t r = 0; r < 3; ++r)
      // Small integers, but for a power of two.
      edges[i][r] = coordinate(corners[i + 1][r] - corners[0][r]);
  return kernel::determinant(edges[0], edges[1], edges[2]) < 0;
}

Isosurface Mesher::run(int max_depth) {
  bisect(max_depth);
  march();
  describe(mesh_, border_);
  mesh_.exact_corners = exact_.size();
  constexpr std::size_t kPiece = 1 << 16;  // of values, which are not kept
  const std::span<const Vec3> points(mesh_.points);
  mesh_.gradients.reserve(points.size());
  for (std::size_t first = 0; first < points.size(); first += kPiece)
    for (const auto& at :
         spline_.evaluate(points.subspan(first, std::min(kPiece, points.size() - first))))
      // Rounded, a point of the border may be outside.
      mesh_.gradients.push_back(std::isnan(at.value) ? Vec3{} : at.gradient);
  return std::move(mesh_);
}

template <class Visit>
void Mesher::for_each_active(int z, const Visit& visit) const {
  const Cube& n = spline_.cubes();
  for (int y = 0; y < n[1]; ++y)
    for (int x = 0; x < n[0]; ++x) {
      // Four at once.
      if ((x & 3) == 0 &&
          (active_.word(0, x >> 2, y >> 2, z >> 2) >> ActiveCubes::bit(0, y, z) & 15) == 0) {
        x += 3;
        continue;
      }
      const Cube cube = {x, y, z};
      if (!active_.active(cube)) continue;
      const auto a = test_.coefficients(cube);
      visit(cube, a, test_.signs(a));
    }
}

/// The tetrahedra that are not settled; by threads.
std::vector<Root> Mesher::unsettled_roots() {
  std::vector<std::vector<Root>> layers(static_cast<std::size_t>(spline_.cubes()[2]));
  std::atomic<std::size_t> met{0};
  kernel::parallel_for(0, spline_.cubes()[2], [&](int z) {
    std::size_t here = 0;
    for_each_active(
        z, [&](const Cube& cube, const CubeCoefficients<double>& a, const CubeSigns& signs) {
          for (std::size_t t = 0; t < kTetrahedra; ++t) {
            if (LeafTest::empty(signs, t)) continue;
            ++here;
            if (!test_.settled(test_.net(a, cube, t, nullptr), cube, t, nullptr))
              layers[static_cast<std::size_t>(z)].push_back(forest_.root_of(cube, t));
          }
        });
    met += here;
  });
  met_ = met;
  std::vector<Root> roots;
  for (const auto& layer : layers) roots.insert(roots.end(), layer.begin(), layer.end());
  return roots;
}

void Mesher::bisect(int max_depth) {
  const std::vector<Root> roots = unsettled_roots();
  if (max_depth == 0) {
    for (const Root root : roots) list(forest_.corners_of(root));
    return;
  }
  std::vector<std::size_t> leaves;  // of each tree
  std::size_t all = 0;
  Cube known = {-1, -1, -1};
  CubeCoefficients<double> a;  // of the known cube: leaves in a row are often in one
  forest_.bisect(roots, [&](Index tree, const Forest::Node& node) {
    if (tree >= leaves.size()) leaves.resize(std::max(tree + std::size_t{1}, 2 * leaves.size()));
    const Root root = forest_.trees()[tree].root;
    const Cube cube = forest_.cube_of(root);
    const std::size_t t = root % kTetrahedra;
    const FineCorners corners = forest_.corners_of(node);
    if (cube != known) a = test_.coefficients(known = cube);
    const LeafNet net = test_.net(a, cube, t, &corners);
    if (test_.empty(net)) return Fate::empty;
    if (test_.settled(net, cube, t, &corners)) return Fate::settled;
    if (node.depth >= max_depth || leaves[tree] >= kMostLeaves || all >= most_leaves(met_))
      return Fate::undecided;
    ++leaves[tree];
    ++all;
    return Fate::bisect;
  });
  mesh_.depth = forest_.depth();
}

void Mesher::march() {
  std::vector<Forest::Tree> trees = forest_.trees();
  std::sort(trees.begin(), trees.end(),
            [](const Forest::Tree& a, const Forest::Tree& b) { return a.root < b.root; });
  for (const Forest::Tree& tree : trees) {
    mesh_.bisected.push_back(static_cast<std::uint32_t>(tree.root));
    write_tree(tree.node);
  }
  // About as many, without the copies of growing; what is not used costs nothing.
  mesh_.triangles.reserve(2 * met_);
  mesh_.points.reserve(met_);
  mesh_.brackets.reserve(met_);
  // Of cubes that are not active all leaves are empty.
  for (int z = 0; z < spline_.cubes()[2]; ++z)
    for_each_active(
        z, [&](const Cube& cube, const CubeCoefficients<double>& a, const CubeSigns& signs) {
          kernel::stop_point();
          march_cube(cube, a, signs);
        });
}

void Mesher::write_tree(Index node) {
  const Index child = forest_.node(node).first_child;
  mesh_.trees.push_back(child != kNone);
  if (child == kNone) return;
  write_tree(child);
  write_tree(child + 1);
}

void Mesher::march_cube(const Cube& cube, const CubeCoefficients<double>& a,
                        const CubeSigns& signs) {
  lattice_edges_.enter(cube);
  const Forest::Planted* trees = forest_.planted(cube);
  for (std::size_t t = 0; t < kTetrahedra; ++t) {
    if (trees != nullptr && (*trees)[t] != kNone) {
      const Forest::Tree& tree = forest_.trees()[(*trees)[t]];
      march_tree(tree, tree.node, a);
      continue;
    }
    if (LeafTest::empty(signs, t)) continue;
    static const std::array<bool, kTetrahedra> kMirrored = [&] {
      std::array<bool, kTetrahedra> mirrored{};
      for (std::size_t i = 0; i < kTetrahedra; ++i)
        mirrored[i] = is_mirrored(forest_.corners_of(Root{i}));
      return mirrored;
    }();
    march_leaf({cube,
                t,
                {0, 1, 2, 3},
                {},
                Forest::corners_of(cube, t),
                kMirrored[t],
                test_.net(a, cube, t, nullptr)});
  }
}

void Mesher::march_tree(const Forest::Tree& tree, Index at, const CubeCoefficients<double>& a) {
  const Forest::Node& node = forest_.node(at);
  if (node.first_child != kNone) {
    march_tree(tree, node.first_child, a);
    march_tree(tree, node.first_child + 1, a);
    return;
  }
  if (node.fate == Fate::empty) return;
  Leaf leaf;
  leaf.cube = forest_.cube_of(tree.root);
  leaf.tetrahedron = tree.root % kTetrahedra;
  leaf.corners = forest_.corners_of(node);
  leaf.net = test_.net(a, leaf.cube, leaf.tetrahedron, &leaf.corners);
  if (node.fate == Fate::undecided) list(leaf.corners);
  leaf.numbers = node.corners;
  const auto& letters = forest_.node(tree.node).corners;
  for (std::size_t i = 0; i < 4; ++i)
    leaf.letters[i] = static_cast<std::size_t>(
        std::find(letters.begin(), letters.end(), leaf.numbers[i]) - letters.begin());
  leaf.mirrored = is_mirrored(leaf.corners);
  march_leaf(leaf);
}

void Mesher::list(const FineCorners& corners) {
  Vec3 middle{};
  for (const FinePoint& p : corners)
    for (std::size_t k = 0; k < 3; ++k) middle[k] += 0.25 * coordinate(p[k]);
  mesh_.undecided.push_back(spline_.frame().to_world(middle));
}

void Mesher::march_leaf(const Leaf& leaf) {
  std::size_t below = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Sign sign = test_.sign(leaf.net, leaf.cube, leaf.tetrahedron, &leaf.corners, i);
    below |= static_cast<std::size_t>(sign == Sign::negative) << i;
    if (sign == Sign::zero) exact_.insert(leaf.corners[i]);
  }
  const MarchingCase& c = kMarchingCases[below];
  if (c.count == 0) return;
  std::array<Index, 6> on;
  for (std::size_t e = 0; e < 6; ++e) {
    const auto [i, k] = kTetrahedronEdges[e];
    const bool i_below = below >> i & 1, k_below = below >> k & 1;
    on[e] = i_below == k_below ? kNone : vertex(leaf, i, k, i_below);
  }
  const bool towards_below = c.towards_below != leaf.mirrored;
  for (std::size_t n = 0; n < c.count; ++n) {
    const auto [p, q, r] = c.triangles[n];
    if (towards_below != spline_.frame().mirrored())
      mesh_.triangles.push_back({on[p], on[q], on[r]});
    else
      mesh_.triangles.push_back({on[p], on[r], on[q]});
  }
  note_border(leaf, on);
}

/// The sides of triangles in faces that lie in the domain's border.
void Mesher::note_border(const Leaf& leaf, const std::array<Index, 6>& on) {
  const Cube& n = spline_.cubes();
  for (std::size_t k = 0; k < 3; ++k)
    for (const int border : {0, 2 * n[k]}) {
      if (leaf.cube[k] != (border == 0 ? 0 : n[k] - 1)) continue;
      const auto inside = [&](std::size_t i) {
        return leaf.corners[i][k] == std::int64_t{border} << kFineBits;
      };
      MeshEdge side;
      std::size_t corners = 0, ends = 0;
      for (std::size_t i = 0; i < 4; ++i) corners += inside(i);
      if (corners < 3) continue;
      for (std::size_t e = 0; e < 6; ++e)
        if (on[e] != kNone && inside(kTetrahedronEdges[e][0]) && inside(kTetrahedronEdges[e][1]))
          side[ends++] = on[e];
      if (ends == 2) border_.push_back(side);
    }
}

Index Mesher::vertex(const Leaf& leaf, std::size_t i, std::size_t k, bool i_below) {
  const std::size_t n = i_below ? i : k, p = i_below ? k : i;
  const std::size_t letter_i = leaf.letters[i], letter_k = leaf.letters[k];
  if (letter_i < 4 && letter_k < 4) {
    const std::size_t slot = kSlots[leaf.tetrahedron][pair_position(letter_i, letter_k)];
    const Index known = lattice_edges_.find(slot);
    if (known != kNone) return known;
    lattice_edges_.add(slot, static_cast<Index>(mesh_.points.size()));
  } else {
    const Index known = fine_edges_.find(leaf.numbers[i], leaf.numbers[k]);
    if (known != kNone) return known;
    fine_edges_.add(leaf.numbers[i], leaf.numbers[k], static_cast<Index>(mesh_.points.size()));
  }
  return make_vertex(leaf, n, p);
}

/// On the edge from corner n, below the level, to p.
Index Mesher::make_vertex(const Leaf& leaf, std::size_t n, std::size_t p) {
  if (mesh_.points.size() == kNone)
    throw kernel::InputError("isosurface: has more than 4294967294 vertices; cut the volume");
  const EdgeZero zero =
      zero_of(test_.along(leaf.net, leaf.cube, leaf.tetrahedron, &leaf.corners, n, p));
  const bool forward = precedes(leaf.corners[n], leaf.corners[p]);
  const FinePoint &from = leaf.corners[forward ? n : p], &to = leaf.corners[forward ? p : n];
  double s = zero.at, low = zero.low, high = zero.high;
  if (!forward) {
    s = 1 - s;
    low = zero.high == 1 ? 0 : std::nextafter(1 - zero.high, 0.0);
    high = zero.low == 0 ? 1 : std::nextafter(1 - zero.low, 2.0);
  }
  mesh_.brackets.push_back({low, high});
  Vec3 place;
  for (std::size_t r = 0; r < 3; ++r) {
    const double start = coordinate(from[r]), end = coordinate(to[r]);
    place[r] = start + s * (end - start);
  }
  mesh_.points.push_back(spline_.frame().to_world(place));
  return static_cast<Index>(mesh_.points.size() - 1);
}

}  // namespace

Isosurface extract_isosurface(const QuadraticSpline& spline, double c, int max_depth) {
  if (spline.cube_count() > 0xffffffffU / kTetrahedra)
    throw kernel::InputError("samples: are more than 178 million cubes; cut the volume");
  return Mesher(spline, c).run(max_depth);
}

}  // namespace crest::splines
