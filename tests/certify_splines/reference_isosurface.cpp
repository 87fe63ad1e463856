// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/certify_splines/reference_isosurface.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace crest::tests {
namespace {

using certify::SplineIsosurfaceCertificate;

template <class Point>
Point middle(const Point& a, const Point& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}
constexpr std::int64_t kScale = std::int64_t{1} << 24;
Exact3 exact(const LatticePoint& x) {
  return {Rational(x[0]) / kScale, Rational(x[1]) / kScale, Rational(x[2]) / kScale};
}
Exact3 minus(const Exact3& a, const Exact3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Rational dot(const Exact3& a, const Exact3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Exact3 cross(const Exact3& a, const Exact3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The vector with these products with three others.
Exact3 from_products(const std::array<Exact3, 3>& e, const Exact3& w) {
  const Rational det = dot(e[0], cross(e[1], e[2]));
  Exact3 sum;
  sum.fill(0);
  for (std::size_t i = 0; i < 3; ++i) {
    const Exact3 dual = cross(e[(i + 1) % 3], e[(i + 2) % 3]);
    for (std::size_t d = 0; d < 3; ++d) sum[d] += w[i] * dual[d] / det;
  }
  return sum;
}

bool positive_with_mean(const std::vector<Exact3>& gradients) {
  Exact3 sum;
  sum.fill(0);
  for (const Exact3& g : gradients)
    for (std::size_t d = 0; d < 3; ++d) sum[d] += g[d];
  return std::ranges::all_of(gradients, [&](const Exact3& g) { return dot(g, sum) > 0; });
}

}  // namespace

bool ReferenceForm::is_empty(const std::vector<std::size_t>& which) const {
  int negative = 0, all = 0;
  for (const std::size_t i : which)
    for (const std::size_t j : which) {
      negative += b[i][j] < 0;
      ++all;
    }
  return negative == 0 || negative == all;
}

bool ReferenceForm::is_simple(const IsosurfaceOptions& options) const {
  std::vector<Exact3> gradients;
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<Exact3, 3> sides;
    Exact3 products;
    for (std::size_t k = 0; k < 3; ++k) {
      sides[k] = minus(corners[k + 1], corners[0]);
      products[k] = 2 * (b[i][k + 1] - b[i][0]);
    }
    gradients.push_back(from_products(sides, products));
  }
  if (!positive_with_mean(gradients)) return false;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      const Rational &b0 = b[i][i], &b1 = b[i][j], &b2 = b[j][j];
      const bool first = b0 < 0, last = b2 < 0;
      if (first != last) continue;
      if (first ? !(b1 < 0 || b1 * b1 < b0 * b2) : !(b1 >= 0 || b1 * b1 <= b0 * b2)) return false;
    }
  for (std::size_t out = 0; out < 4 && options.faces; ++out) {
    std::vector<std::size_t> face;
    for (std::size_t i = 0; i < 4; ++i)
      if (i != out) face.push_back(i);
    if (options.empty_faces && is_empty(face)) continue;
    const Exact3 normal =
        cross(minus(corners[face[1]], corners[face[0]]), minus(corners[face[2]], corners[face[0]]));
    std::vector<Exact3> tangential;
    for (const std::size_t i : face) {
      const Exact3& g = gradients[i];
      const Rational part = dot(g, normal) / dot(normal, normal);
      tangential.push_back(
          {g[0] - part * normal[0], g[1] - part * normal[1], g[2] - part * normal[2]});
    }
    if (!positive_with_mean(tangential)) return false;
  }
  return true;
}

ReferenceForm reference_form(const std::array<Exact3, 4>& corners,
                             const std::function<Rational(const Exact3&)>& f) {
  ReferenceForm form{corners, {}};
  for (std::size_t i = 0; i < 4; ++i) form.b[i][i] = f(corners[i]);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      if (i != j)
        form.b[i][j] = 2 * f(middle(corners[i], corners[j])) - (form.b[i][i] + form.b[j][j]) / 2;
  return form;
}

namespace {

class MeshWriter {
 public:
  explicit MeshWriter(SplineIsosurfaceCertificate& c) : c_(c) {
    const auto& d = c_.volume.direction;
    const auto column = [&](std::size_t k) { return Exact3{d[k], d[3 + k], d[6 + k]}; };
    direct_ = dot(column(0), cross(column(1), column(2))) > 0;
  }

  void add(const ReferenceLeaf& leaf, const ReferenceForm& form) {
    std::vector<std::size_t> positive, negative;
    for (std::size_t i = 0; i < 4; ++i) (form.b[i][i] < 0 ? negative : positive).push_back(i);
    if (positive.empty() || negative.empty()) return;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j)
        if ((form.b[i][i] < 0) != (form.b[j][j] < 0)) vertex(leaf, form, i, j);
    using Pairs = std::vector<std::array<std::size_t, 2>>;
    std::vector<Pairs> triangles;
    const auto& p = positive;
    const auto& n = negative;
    if (p.size() == 1) triangles = {{{p[0], n[0]}, {p[0], n[1]}, {p[0], n[2]}}};
    if (n.size() == 1) triangles = {{{n[0], p[0]}, {n[0], p[1]}, {n[0], p[2]}}};
    if (p.size() == 2)
      triangles = {{{p[0], n[0]}, {p[0], n[1]}, {p[1], n[1]}},
                   {{p[0], n[0]}, {p[1], n[1]}, {p[1], n[0]}}};
    for (const Pairs& triangle : triangles) {
      std::array<std::uint32_t, 3> corners{};
      std::array<Exact3, 3> at;
      for (std::size_t k = 0; k < 3; ++k) {
        corners[k] = vertex(leaf, form, triangle[k][0], triangle[k][1]);
        at[k] = middle(form.corners[triangle[k][0]], form.corners[triangle[k][1]]);
      }
      const Exact3 normal = cross(minus(at[1], at[0]), minus(at[2], at[0]));
      const Exact3 down = minus(form.corners[negative[0]], form.corners[positive[0]]);
      if ((dot(normal, down) > 0) != direct_) std::swap(corners[1], corners[2]);
      c_.triangles.push_back(corners);
    }
  }

  void count() {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    std::vector<std::uint32_t> part(c_.brackets.size());
    for (std::uint32_t v = 0; v < part.size(); ++v) part[v] = v;
    const auto join = [](std::vector<std::uint32_t>& classes, std::uint32_t a, std::uint32_t b) {
      const auto from = std::max(classes[a], classes[b]), to = std::min(classes[a], classes[b]);
      for (auto& x : classes) x = x == from ? to : x;
    };
    for (const auto& t : c_.triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        ++sides[std::minmax({t[k], t[(k + 1) % 3]})];
        join(part, t[k], t[(k + 1) % 3]);
      }
    auto border = part;
    std::set<std::uint32_t> on_border;
    for (std::uint32_t v = 0; v < border.size(); ++v) border[v] = v;
    for (const auto& [side, times] : sides)
      if (times == 1) {
        join(border, side.first, side.second);
        on_border.insert({side.first, side.second});
      }
    std::set<std::uint32_t> loops;
    for (const std::uint32_t v : on_border) loops.insert(border[v]);
    c_.components =
        static_cast<std::uint32_t>(std::set<std::uint32_t>(part.begin(), part.end()).size());
    c_.boundary_loops = static_cast<std::uint32_t>(loops.size());
    c_.euler_characteristic =
        static_cast<std::int32_t>(c_.brackets.size() - sides.size() + c_.triangles.size());
  }

 private:
  std::uint32_t vertex(const ReferenceLeaf& leaf, const ReferenceForm& form, std::size_t i,
                       std::size_t j) {
    const auto lower = [](const LatticePoint& a, const LatticePoint& b) {
      return std::tie(a[2], a[1], a[0]) < std::tie(b[2], b[1], b[0]);
    };
    if (!lower(leaf.corners[i], leaf.corners[j])) std::swap(i, j);
    const auto [at, is_new] = numbers_.try_emplace({leaf.corners[i], leaf.corners[j]},
                                                   static_cast<std::uint32_t>(c_.brackets.size()));
    if (!is_new) return at->second;
    const auto q = [&](double t) {
      const Rational u = t, v = 1 - u;
      return Rational(v * v * form.b[i][i] + 2 * u * v * form.b[i][j] + u * u * form.b[j][j]);
    };
    const bool negative = q(0) < 0;
    const bool at_end = form.b[i][j] <= 0;  // where s - c is 0 at a positive end
    const double high = least_double(
        0, 1, [&](double t) { return negative ? q(t) >= 0 : q(t) <= 0 && (t > 0 || at_end); });
    c_.brackets.push_back({q(high) == 0 ? high : std::nextafter(high, 0.0), high});
    return at->second;
  }

  SplineIsosurfaceCertificate& c_;
  bool direct_ = true;
  std::map<std::pair<LatticePoint, LatticePoint>, std::uint32_t> numbers_;
};

class Maker {
 public:
  Maker(const SplineVolume& volume, const IsosurfaceOptions& options)
      : spline_(volume), options_(options), level_(volume.level) {
    c_.volume = volume;
    std::size_t node = 0;
    for (std::uint32_t root = 0; root < 24 * cubes(); ++root) {
      const auto at = std::ranges::find(options.roots, root);
      if (at == options.roots.end())
        insert(root_of(root));
      else
        insert_tree(root_of(root), node);
    }
  }

  std::optional<SplineIsosurfaceCertificate> make() {
    if (!refine()) return std::nullopt;
    write_trees();
    MeshWriter writer(c_);
    for (const auto& [key, leaf] : leaves_)
      if (!is_surely_empty(leaf)) writer.add(leaf, form_of(leaf));
    writer.count();
    return c_;
  }

 private:
  std::uint32_t cubes() const {
    return static_cast<std::uint32_t>(spline_.cubes(0) * spline_.cubes(1) * spline_.cubes(2));
  }
  Int3 cube_of(std::uint32_t root) const {
    const int cube = static_cast<int>(root / 24);
    return {cube % spline_.cubes(0), cube / spline_.cubes(0) % spline_.cubes(1),
            cube / spline_.cubes(0) / spline_.cubes(1)};
  }
  ReferenceLeaf root_of(std::uint32_t root) const {
    ReferenceLeaf leaf{root, "", {}, 0};
    const Int3 cube = cube_of(root);
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t d = 0; d < 3; ++d)
        leaf.corners[i][d] =
            kScale * (2 * cube[d] + 1 + reference_tets()[root % 24].vertices[i][d]);
    return leaf;
  }
  static std::array<ReferenceLeaf, 2> halves(const ReferenceLeaf& leaf) {
    std::array<ReferenceLeaf, 2> parts = {leaf, leaf};
    parts[0].path += '0';
    parts[1].path += '1';
    const auto& [x0, x1, x2, x3] = leaf.corners;
    using Corners = std::array<LatticePoint, 4>;
    const auto set = [&](unsigned tag, const Corners& first, const Corners& second) {
      parts[0].corners = first;
      parts[1].corners = second;
      parts[0].tag = parts[1].tag = tag;
    };
    if (leaf.tag == 0) {
      const LatticePoint m = middle(x1, x2);
      set(3, {x0, x3, m, x1}, {x0, x3, m, x2});
    } else if (leaf.tag == 3) {
      const LatticePoint z = middle(x0, x3);
      set(2, {x0, x1, x2, z}, {x1, x2, x3, z});
    } else if (leaf.tag == 2) {
      const LatticePoint z = middle(x0, x2);
      set(1, {x0, x1, z, x3}, {x1, x2, z, x3});
    } else {
      const LatticePoint z = middle(x0, x1);
      set(3, {x0, z, x2, x3}, {x1, z, x2, x3});
    }
    return parts;
  }

  void insert(const ReferenceLeaf& leaf) {
    vertices_.insert(leaf.corners.begin(), leaf.corners.end());
    leaves_.emplace(std::pair(leaf.root, leaf.path), leaf);
  }
  void insert_tree(const ReferenceLeaf& leaf, std::size_t& node) {
    if (options_.trees[node++] == 0) return insert(leaf);
    for (const auto& half : halves(leaf)) insert_tree(half, node);
  }

  bool hangs(const ReferenceLeaf& leaf) const {
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j)
        if (vertices_.contains(middle(leaf.corners[i], leaf.corners[j]))) return true;
    return false;
  }
  ReferenceForm form_of(const ReferenceLeaf& leaf) const {
    const Int3 cube = cube_of(leaf.root);
    std::array<Exact3, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) corners[i] = exact(leaf.corners[i]);
    return reference_form(corners, [&](const Exact3& x) {
      return Rational(spline_.polynomial(cube, leaf.root % 24, x) - level_);
    });
  }
  /// All coefficients of the tetrahedron it is part of have one sign.
  bool is_surely_empty(const ReferenceLeaf& leaf) const {
    int negative = 0;
    for (const auto& row : spline_.form(cube_of(leaf.root), leaf.root % 24))
      for (const Rational& a : row) negative += a < level_;
    return negative == 0 || negative == 16;
  }
  bool is_good(const ReferenceLeaf& leaf) const {
    if (is_surely_empty(leaf)) return true;
    const ReferenceForm form = form_of(leaf);
    return form.is_empty({0, 1, 2, 3}) || form.is_simple(options_);
  }

  /// Bisects what is bad or has a vertex on an edge until there is none.
  bool refine() {
    std::set<std::pair<std::uint32_t, std::string>> good;
    for (bool changed = true; changed;) {
      changed = false;
      const auto before = leaves_;
      for (const auto& [key, leaf] : before) {
        const bool known = good.contains(key);
        if (known || is_good(leaf)) {
          good.insert(key);
          if (!hangs(leaf)) continue;
        }
        if (leaf.path.size() >= options_.depth) return false;
        leaves_.erase(key);
        for (const auto& half : halves(leaf)) insert(half);
        changed = true;
      }
    }
    return true;
  }

  void write_tree(std::uint32_t root, const std::string& path) {
    const bool leaf = leaves_.contains({root, path});
    c_.trees.push_back(leaf ? 0 : 1);
    if (leaf) return;
    write_tree(root, path + '0');
    write_tree(root, path + '1');
  }
  void write_trees() {
    for (std::uint32_t root = 0; root < 24 * cubes(); ++root)
      if (!leaves_.contains({root, ""})) {
        c_.bisected.push_back(root);
        write_tree(root, "");
      }
  }

  ReferenceSpline spline_;
  IsosurfaceOptions options_;
  Rational level_;
  SplineIsosurfaceCertificate c_;
  std::map<std::pair<std::uint32_t, std::string>, ReferenceLeaf> leaves_;
  std::set<LatticePoint> vertices_;
};

}  // namespace

std::optional<SplineIsosurfaceCertificate> reference_isosurface(const SplineVolume& volume,
                                                                const IsosurfaceOptions& options) {
  return Maker(volume, options).make();
}

}  // namespace crest::tests
