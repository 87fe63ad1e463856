// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/splines/isosurface.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "algorithms/splines/active_cubes.hpp"
#include "algorithms/splines/leaf_test.hpp"
#include "kernel/geometry/disjoint_sets.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::splines {

using kernel::Index;
using kernel::operator*;
using kernel::operator+;
using kernel::operator-;

namespace {

/// Where an edge's polynomial, of different signs at its ends, has the zero next to its end below.
struct EdgeZero {
  double at, low, high;  ///< from the end below: at, and what holds it
};

/// b0 < 0 <= b2, exactly but for `error`.
EdgeZero zero_of(double b0, double b1, double b2, double error) {
  const double f0 = -b0, f1 = -b1, f2 = -b2;
  const double h = f0 - f1, q = f0 - 2 * f1 + f2, root = std::sqrt(std::fmax(0, h * h - q * f0));
  EdgeZero zero;
  const double at = h > 0 ? f0 / (h + root) : (h - root) / q;
  zero.at = std::isfinite(at) ? std::clamp(at, 0.0, 1.0) : 1.0;
  const auto f = [&](double s) {
    const double r = 1 - s, c1 = r * f0 + s * f1;
    return r * c1 + s * (r * f1 + s * f2);
  };
  const double slack = error + 0x1p-48 * (std::fabs(f0) + std::fabs(f1) + std::fabs(f2));
  // Wider until both sides are certain: there f is positive all the way from 0, and not positive.
  for (double wide = 0x1p-52;; wide *= 4) {
    zero.low = std::fmax(0, zero.at - wide);
    zero.high = std::fmin(1, zero.at + wide);
    // Positive on [0, low] if it is at both ends and (one zero) not at 1.
    const bool low = zero.low == 0 || (f(zero.low) > slack && f2 <= 0);
    const bool high = zero.high == 1 || f(zero.high) < -slack;
    if (low && high) return zero;
  }
}

/// Leaves that are bisected for their own sake, of one tetrahedron and of all: where the level set
/// touches a plane of faces or a plateau their number would double with every third level.
constexpr std::size_t kMostLeaves = 1024;
std::size_t most_leaves(std::size_t tetrahedra) {
  return 65536 + 4 * tetrahedra;
}

class Mesher {
 public:
  Mesher(const QuadraticSpline& spline, double c)
      : spline_(spline), test_(spline, c), active_(spline, c), forest_(spline.cubes()) {}

  Isosurface run(int max_depth);

 private:
  struct Leaf {
    Root root;
    Cube cube;
    std::size_t tetrahedron;
    FineCorners corners;
    LeafNet net;
  };

  Root root_of(const Cube& cube) const {
    const Cube& n = spline_.cubes();
    return kTetrahedra *
           (static_cast<Root>(cube[0]) +
            static_cast<Root>(n[0]) * (static_cast<Root>(cube[1]) +
                                       static_cast<Root>(n[1]) * static_cast<Root>(cube[2])));
  }

  /// Calls visit(cube, coefficients) for active cubes in their order.
  template <class Visit>
  void for_each_active(const Visit& visit) const {
    const Cube& n = spline_.cubes();
    for (int z = 0; z < n[2]; ++z)
      for (int y = 0; y < n[1]; ++y)
        for (int x = 0; x < n[0]; ++x) {
          // Four at once.
          if ((x & 3) == 0 &&
              (active_.word(0, x >> 2, y >> 2, z >> 2) >> ActiveCubes::bit(0, y, z) & 15) == 0) {
            x += 3;
            continue;
          }
          const Cube cube = {x, y, z};
          if (active_.active(cube)) visit(cube, test_.coefficients(cube));
        }
  }

  void bisect(int max_depth);
  bool settled(Root root, const FineCorners& corners) const;
  void march();
  void write_tree(const Forest::Tree& tree, std::int32_t at);
  void march_tree(const Forest::Tree& tree, std::int32_t at, const CubeCoefficients<double>& a,
                  Leaf leaf);
  void list(const Leaf& leaf);
  static double coordinate(std::int64_t fine) {
    return static_cast<double>(fine) / static_cast<double>(std::int64_t{1} << kFineBits);
  }

  void march_leaf(const Leaf& leaf);
  void add_one(const Leaf& leaf, const std::array<bool, 4>& below,
               const std::array<std::array<Index, 4>, 4>& on, bool side);
  void add_two(const Leaf& leaf, const std::array<bool, 4>& below,
               const std::array<std::array<Index, 4>, 4>& on);
  static double triple(const Leaf& leaf, std::size_t a, std::size_t b, std::size_t c, std::size_t d,
                       std::size_t e, std::size_t f);

  /// `towards_below`: in the lattice the normal points to where s < c.
  void add(const kernel::Triangle& t, bool towards_below) {
    const bool keep = towards_below != spline_.frame().mirrored();
    mesh_.triangles.push_back(keep ? t : kernel::Triangle{t[0], t[2], t[1]});
  }

  Index vertex(const Leaf& leaf, std::size_t i, std::size_t k, bool i_below);
  void count();

  const QuadraticSpline& spline_;
  LeafTest test_;
  ActiveCubes active_;
  Forest forest_;
  Isosurface mesh_;
  std::unordered_map<FineEdge, Index, FineEdgeHash> vertices_;
  std::set<FinePoint> exact_;
};

Isosurface Mesher::run(int max_depth) {
  bisect(max_depth);
  march();
  count();
  return std::move(mesh_);
}

void Mesher::bisect(int max_depth) {
  std::vector<Root> roots;
  std::size_t met = 0;  // tetrahedra that are not empty
  if (max_depth > 0)
    for_each_active([&](const Cube& cube, const CubeCoefficients<double>& a) {
      for (std::size_t t = 0; t < kTetrahedra; ++t) {
        const LeafNet net = test_.net(a, cube, t, nullptr);
        if (test_.empty(net)) continue;
        ++met;
        const Root root = root_of(cube) + t;
        if (!test_.settled(net, cube, t, forest_.corners_of(root))) roots.push_back(root);
      }
    });
  std::unordered_map<Root, std::size_t> leaves;
  std::size_t all = 0;
  forest_.bisect(roots, [&](Root root, const Forest::Node& node) {
    if (node.depth >= max_depth || leaves[root] >= kMostLeaves || all >= most_leaves(met))
      return false;
    if (settled(root, node.corners)) return false;
    ++leaves[root];
    ++all;
    return true;
  });
  mesh_.depth = forest_.depth();
}

bool Mesher::settled(Root root, const FineCorners& corners) const {
  const Cube cube = forest_.cube_of(root);
  const std::size_t t = root % kTetrahedra;
  const LeafNet net = test_.net(test_.coefficients(cube), cube, t, &corners);
  return test_.settled(net, cube, t, corners);
}

void Mesher::march() {
  const auto& trees = forest_.trees();
  for (const auto& [root, tree] : trees) {
    mesh_.bisected.push_back(static_cast<std::uint32_t>(root));
    write_tree(tree, 0);
  }
  for_each_active([&](const Cube& cube, const CubeCoefficients<double>& a) {
    const Root first = root_of(cube);
    for (std::size_t t = 0; t < kTetrahedra; ++t) {
      const auto found = trees.find(first + t);
      if (found != trees.end()) {
        march_tree(found->second, 0, a, {first + t, cube, t, {}, {}});
        continue;
      }
      Leaf leaf{first + t, cube, t, {}, test_.net(a, cube, t, nullptr)};
      if (test_.empty(leaf.net)) continue;
      leaf.corners = forest_.corners_of(leaf.root);
      march_leaf(leaf);
    }
  });
  // Of cubes that are not active all leaves are empty.
}

void Mesher::write_tree(const Forest::Tree& tree, std::int32_t at) {
  const std::int32_t child = tree[static_cast<std::size_t>(at)].first_child;
  mesh_.trees.push_back(child >= 0);
  if (child < 0) return;
  write_tree(tree, child);
  write_tree(tree, child + 1);
}

void Mesher::march_tree(const Forest::Tree& tree, std::int32_t at,
                        const CubeCoefficients<double>& a, Leaf leaf) {
  const Forest::Node& node = tree[static_cast<std::size_t>(at)];
  if (node.first_child >= 0) {
    march_tree(tree, node.first_child, a, leaf);
    march_tree(tree, node.first_child + 1, a, leaf);
    return;
  }
  leaf.corners = node.corners;
  leaf.net = test_.net(a, leaf.cube, leaf.tetrahedron, &leaf.corners);
  if (test_.empty(leaf.net)) return;
  if (!test_.settled(leaf.net, leaf.cube, leaf.tetrahedron, leaf.corners)) list(leaf);
  march_leaf(leaf);
}

void Mesher::list(const Leaf& leaf) {
  Vec3 middle{};
  for (const FinePoint& p : leaf.corners)
    for (std::size_t k = 0; k < 3; ++k) middle[k] += 0.25 * coordinate(p[k]);
  mesh_.undecided.push_back(spline_.frame().to_world(middle));
}

void Mesher::march_leaf(const Leaf& leaf) {
  std::array<bool, 4> below;
  int count = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    below[i] = test_.below(leaf.net, leaf.cube, leaf.tetrahedron, leaf.corners, i);
    count += below[i];
    if (test_.on_level(leaf.net, leaf.cube, leaf.tetrahedron, leaf.corners, i))
      exact_.insert(leaf.corners[i]);
  }
  if (count == 0 || count == 4) return;
  std::array<std::array<Index, 4>, 4> on;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = i + 1; k < 4; ++k)
      if (below[i] != below[k]) on[i][k] = on[k][i] = vertex(leaf, i, k, below[i]);
  if (count == 2)
    add_two(leaf, below, on);
  else
    add_one(leaf, below, on, count == 1);
}

/// A corner v alone on its side.
void Mesher::add_one(const Leaf& leaf, const std::array<bool, 4>& below,
                     const std::array<std::array<Index, 4>, 4>& on, bool side) {
  std::size_t v = 0;
  while (below[v] != side) ++v;
  std::array<std::size_t, 3> others;
  std::size_t n = 0;
  for (std::size_t i = 0; i < 4; ++i)
    if (i != v) others[n++] = i;
  const auto [a, b, c] = others;
  // Seen from v, a b c are clockwise iff the triple product is positive.
  const double turn = triple(leaf, v, a, v, b, v, c);
  add({on[v][a], on[v][b], on[v][c]}, (turn < 0) == side);
}

void Mesher::add_two(const Leaf& leaf, const std::array<bool, 4>& below,
                     const std::array<std::array<Index, 4>, 4>& on) {
  std::array<std::size_t, 2> p, n;
  std::size_t np = 0, nn = 0;
  for (std::size_t i = 0; i < 4; ++i) (below[i] ? n[nn++] : p[np++]) = i;
  // The normal of p0n0, p0n1, p1n1 is (n1 - n0) x (p1 - p0), but for a positive factor.
  const bool towards_below = triple(leaf, n[0], n[1], p[0], p[1], p[0], n[0]) > 0;
  add({on[p[0]][n[0]], on[p[0]][n[1]], on[p[1]][n[1]]}, towards_below);
  add({on[p[0]][n[0]], on[p[1]][n[1]], on[p[1]][n[0]]}, towards_below);
}

/// (b - a) x (d - c) . (f - e) of corners: small integers, but for a power of two.
double Mesher::triple(const Leaf& leaf, std::size_t a, std::size_t b, std::size_t c, std::size_t d,
                      std::size_t e, std::size_t f) {
  const auto edge = [&](std::size_t i, std::size_t k) {
    Vec3 x;
    for (std::size_t r = 0; r < 3; ++r) x[r] = coordinate(leaf.corners[k][r] - leaf.corners[i][r]);
    return x;
  };
  return kernel::determinant(edge(a, b), edge(c, d), edge(e, f));
}

Index Mesher::vertex(const Leaf& leaf, std::size_t i, std::size_t k, bool i_below) {
  const FineEdge edge(leaf.corners[i], leaf.corners[k]);
  const auto [at, fresh] = vertices_.try_emplace(edge, static_cast<Index>(mesh_.points.size()));
  if (!fresh) return at->second;
  if (mesh_.points.size() == kernel::kNone)
    throw kernel::InputError("isosurface: has more than 4294967294 vertices; cut the volume");
  const std::size_t n = i_below ? i : k, p = i_below ? k : i;
  const auto b = [&](std::size_t x, std::size_t y) { return test_.at(leaf.net, x, y); };
  const EdgeZero zero = zero_of(b(n, n), b(n, p), b(p, p), leaf.net.error);
  const bool forward = leaf.corners[n] == edge.low;
  double s = zero.at, low = zero.low, high = zero.high;
  if (!forward) {
    s = 1 - s;
    low = zero.high == 1 ? 0 : std::nextafter(1 - zero.high, 0.0);
    high = zero.low == 0 ? 1 : std::nextafter(1 - zero.low, 2.0);
  }
  mesh_.brackets.push_back({low, high});
  Vec3 place;
  for (std::size_t r = 0; r < 3; ++r) {
    const double from = coordinate(edge.low[r]), to = coordinate(edge.high[r]);
    place[r] = from + s * (to - from);
  }
  mesh_.points.push_back(spline_.frame().to_world(place));
  return at->second;
}

void Mesher::count() {
  const auto vertices = static_cast<Index>(mesh_.points.size());
  std::vector<std::array<Index, 2>> sides;
  sides.reserve(3 * mesh_.triangles.size());
  kernel::DisjointSets parts(vertices);
  for (const auto& t : mesh_.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = t[k], b = t[(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b)});
      parts.unite(a, b);
    }
  std::sort(sides.begin(), sides.end());
  kernel::DisjointSets loops(vertices);
  std::vector<bool> at_border(vertices, false);
  std::size_t edges = 0, border_vertices = 0, joins = 0;
  for (std::size_t i = 0; i < sides.size(); ++edges) {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end] == sides[i]) ++end;
    if (end == i + 1) {
      for (const Index v : sides[i])
        if (!at_border[v]) {
          at_border[v] = true;
          ++border_vertices;
        }
      joins += loops.unite(sides[i][0], sides[i][1]);
    }
    i = end;
  }
  mesh_.components = parts.count();
  mesh_.boundary_loops = border_vertices - joins;
  mesh_.euler_characteristic = std::int64_t{vertices} - static_cast<std::int64_t>(edges) +
                               static_cast<std::int64_t>(mesh_.triangles.size());
  mesh_.exact_corners = exact_.size();
  std::vector<Vec3> places = mesh_.points;
  std::sort(places.begin(), places.end());
  mesh_.coincident =
      static_cast<std::size_t>(places.end() - std::unique(places.begin(), places.end()));
  const auto values = spline_.evaluate(mesh_.points);
  mesh_.gradients.resize(vertices);
  for (Index v = 0; v < vertices; ++v)
    // Rounded, a point of the border may be outside.
    mesh_.gradients[v] = std::isnan(values[v].value) ? Vec3{} : values[v].gradient;
}

}  // namespace

Isosurface extract_isosurface(const QuadraticSpline& spline, double c, int max_depth) {
  if (spline.cube_count() > 0xffffffffU / kTetrahedra)
    throw kernel::InputError("samples: are more than 178 million cubes; cut the volume");
  return Mesher(spline, c).run(max_depth);
}

}  // namespace crest::splines
