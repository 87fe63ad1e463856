// SPDX-License-Identifier: GPL-3.0-or-later
// From a soup to an oriented manifold: errors name the file's own vertex and face numbers, which
// the mesh's constructor no longer knows once vertices were dropped.
#include "io/read/soup_to_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "io/formats/files.hpp"
#include "io/formats/text_scan.hpp"
#include "kernel/geometry/disjoint_sets.hpp"

namespace crest::io {
namespace {

using kernel::Index;
using kernel::kNone;
using kernel::Triangle;
using kernel::Vec3;

/// A side of a face: its corners a -> b with the smaller one first, and the third corner.
struct Side {
  Index low, high, third, face;
  std::uint8_t corner;
  bool direct;  ///< runs from low to high
};

void require_distinct(const Soup& soup, const SoupFaces& faces, const std::vector<Side>& sides) {
  Index first = kNone, original = kNone;
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const Side &s = sides[i - 1], &t = sides[i];
    if (s.low == t.low && s.high == t.high && s.third == t.third && t.face < first) {
      first = t.face;
      original = s.face;
    }
  }
  if (first != kNone) {
    fail(fmt::format("face {}", faces.tag(soup, first)),
         fmt::format("has the vertices of face {}", faces.tag(soup, original)),
         "remove duplicate faces");
  }
}

/// Sorted by low (counting), then by high, third vertex and face.
std::vector<Side> sorted_sides(const std::vector<Triangle>& faces, std::size_t vertices) {
  std::vector<std::size_t> begin(vertices + 1, 0);
  for (const Triangle& face : faces)
    for (std::size_t k = 0; k < 3; ++k) ++begin[std::min(face[k], face[(k + 1) % 3]) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Side> sides(3 * faces.size());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (Index f = 0; f < faces.size(); ++f) {
    for (std::uint8_t k = 0; k < 3; ++k) {
      const Index a = faces[f][k], b = faces[f][(k + 1) % 3], c = faces[f][(k + 2) % 3];
      const Index low = std::min(a, b);
      sides[next[low]++] = {low, std::max(a, b), c, f, k, a < b};
    }
  }
  for (std::size_t v = 0; v < vertices; ++v) {
    std::sort(sides.begin() + static_cast<std::ptrdiff_t>(begin[v]),
              sides.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]),
              [](const Side& s, const Side& t) {
                return std::tie(s.high, s.third, s.face) < std::tie(t.high, t.third, t.face);
              });
  }
  return sides;
}

/// Then the two sides of an interior edge are neighbours.
void require_two_faces(const Soup& soup, const SoupFaces& faces, const std::vector<Side>& sides) {
  for (std::size_t i = 2; i < sides.size(); ++i) {
    const Side &s = sides[i - 2], &t = sides[i];
    if (s.low != t.low || s.high != t.high) continue;
    std::array<Index, 3> f = {s.face, sides[i - 1].face, t.face};
    std::sort(f.begin(), f.end());
    fail(fmt::format("edge {}-{}", soup.point_tag(s.low), soup.point_tag(s.high)),
         fmt::format("is in faces {}, {} and {}, it is not manifold", faces.tag(soup, f[0]),
                     faces.tag(soup, f[1]), faces.tag(soup, f[2])),
         "separate the sheets that meet there");
  }
}

bool paired(const std::vector<Side>& sides, std::size_t i) {
  return i + 1 < sides.size() && sides[i].low == sides[i + 1].low &&
         sides[i].high == sides[i + 1].high;
}

struct Neighbour {
  Index face = kNone;
  bool agrees = true;  ///< orientations of the two faces agree across their edge
};

std::vector<std::array<Neighbour, 3>> neighbours(const std::vector<Side>& sides,
                                                 std::size_t faces) {
  std::vector<std::array<Neighbour, 3>> across(faces);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (!paired(sides, i)) continue;
    const Side &s = sides[i], &t = sides[i + 1];
    const bool agrees = s.direct != t.direct;
    across[s.face][s.corner] = {t.face, agrees};
    across[t.face][t.corner] = {s.face, agrees};
  }
  return across;
}

/// Flips the minority of every component; returns how many faces that were.
Index orient(std::vector<Triangle>& faces, const std::vector<std::array<Neighbour, 3>>& across) {
  constexpr std::uint8_t unseen = 2;
  std::vector<std::uint8_t> against(faces.size(), unseen);  // its component's first face
  std::vector<Index> component;
  Index flipped = 0;
  for (Index first = 0; first < faces.size(); ++first) {
    if (against[first] != unseen) continue;
    against[first] = 0;
    component.assign(1, first);
    std::size_t minority = 0;
    for (std::size_t i = 0; i < component.size(); ++i) {
      const Index f = component[i];
      minority += against[f];
      for (const Neighbour& n : across[f]) {
        if (n.face == kNone) continue;
        const std::uint8_t wanted = against[f] ^ static_cast<std::uint8_t>(!n.agrees);
        if (against[n.face] == unseen) {
          against[n.face] = wanted;
          component.push_back(n.face);
        } else if (against[n.face] != wanted) {
          fail(fmt::format("faces {} and {}", std::min(f, n.face), std::max(f, n.face)),
               "the surface is one-sided (not orientable)", "cut it open");
        }
      }
    }
    const std::uint8_t flip = 2 * minority > component.size() ? 0 : 1;
    for (Index f : component) {
      if (against[f] != flip) continue;
      std::swap(faces[f][1], faces[f][2]);
      ++flipped;
    }
  }
  return flipped;
}

/// Corners of one vertex that share an interior edge belong to one fan; every vertex has one.
void require_fans(const Soup& soup, const std::vector<Triangle>& faces,
                  const std::vector<Side>& sides) {
  kernel::DisjointSets fans(static_cast<Index>(3 * faces.size()));
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (!paired(sides, i)) continue;
    const Side &s = sides[i], &t = sides[i + 1];
    const Index a[2] = {3 * s.face + s.corner, 3 * s.face + (s.corner + 1u) % 3};
    const Index b[2] = {3 * t.face + t.corner, 3 * t.face + (t.corner + 1u) % 3};
    const bool same = s.direct == t.direct;
    fans.unite(a[0], b[same ? 0 : 1]);
    fans.unite(a[1], b[same ? 1 : 0]);
  }
  std::vector<Index> fan(soup.points.size(), kNone);
  Index worst = kNone;
  for (Index c = 0; c < fans.size(); ++c) {
    const Index v = faces[c / 3][c % 3];
    if (fan[v] == kNone) fan[v] = fans.find(c);
    if (fan[v] != fans.find(c)) worst = std::min(worst, v);
  }
  if (worst != kNone) {
    fail(fmt::format("vertex {}", soup.point_tag(worst)),
         "joins several fans of faces, it is not manifold", "give each fan a vertex of its own");
  }
}

/// Corners of faces, ascending.
std::vector<Index> used(std::size_t points, const std::vector<Triangle>& faces) {
  std::vector<bool> is_used(points, false);
  for (const Triangle& face : faces)
    for (const Index v : face) is_used[v] = true;
  std::vector<Index> list;
  for (Index v = 0; v < points; ++v)
    if (is_used[v]) list.push_back(v);
  return list;
}

/// Renumbers the faces' vertices; returns the points that are left.
std::vector<Vec3> drop_unreferenced(const Soup& soup, std::vector<Triangle>& faces) {
  std::vector<Index> number(soup.points.size(), kNone);
  std::vector<Vec3> points;
  for (const Index v : used(soup.points.size(), faces)) {
    number[v] = static_cast<Index>(points.size());
    points.push_back(soup.points[v]);
  }
  for (Triangle& face : faces)
    for (Index& v : face) v = number[v];
  return points;
}

std::array<Index, 3> middle_nodes(const Soup& soup, std::size_t c) {
  const auto nodes = soup.cells.nodes(c);
  std::array<Index, 3> middle{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Cells::Node node = nodes[3 + k];
    if (node < 0 || node >= static_cast<Cells::Node>(soup.points.size())) {
      fail(fmt::format("cell {}", soup.cell_tag(c)),
           fmt::format("mid-side node {} (counted from 0) does not exist", node),
           "add it or make the cell linear");
    }
    middle[k] = static_cast<Index>(node);
  }
  return middle;
}

/// Of a cell that is not thin.
void require_triangle(const Soup& soup, std::size_t c) {
  const CellType type = soup.cells.type(c);
  const std::size_t nodes = soup.cells.nodes(c).size();
  const std::int64_t tag = soup.cell_tag(c);
  if (type == CellType::polygon || type == CellType::quad) {
    check_corner_count(static_cast<std::int64_t>(nodes), fmt::format("face {}", tag));
    return;
  }
  const bool quadratic = type == CellType::quadratic_triangle;
  if (!quadratic && type != CellType::triangle) {
    fail(fmt::format("cell {}", tag), fmt::format("has type {}", static_cast<int>(type)),
         "give triangles, linear (type 5) or quadratic (22)");
  }
  const std::size_t wanted = quadratic ? 6 : 3;
  if (nodes == wanted) return;
  fail(fmt::format("cell {}", tag), fmt::format("has {} nodes instead of {}", nodes, wanted),
       quadratic && nodes < 6 ? "its mid-side nodes are missing, add them or make it linear"
                              : "export the mesh again");
}

}  // namespace

void SoupFaces::warn(std::vector<std::string>& warnings) const {
  if (thin > 0) warnings.push_back(fmt::format("left out {} points and lines", thin));
}

SoupFaces faces_of(const Soup& soup) {
  SoupFaces faces;
  faces.cells.reserve(soup.cells.size());
  for (std::size_t c = 0; c < soup.cells.size(); ++c) {
    const int dimension = dimension_of(soup.cells.type(c));
    if (dimension == 0 || dimension == 1) {
      ++faces.thin;
      continue;
    }
    require_triangle(soup, c);
    if (soup.cells.type(c) == CellType::quadratic_triangle) {
      faces.midside.resize(faces.cells.size(), {kNone, kNone, kNone});
      faces.midside.push_back(middle_nodes(soup, c));
    }
    faces.cells.push_back(c);
  }
  if (!faces.midside.empty()) faces.midside.resize(faces.cells.size(), {kNone, kNone, kNone});
  return faces;
}

std::vector<Triangle> proper_corners(const Soup& soup, const SoupFaces& faces) {
  if (faces.cells.empty()) fail("faces", "there are none", "export the mesh with its faces");
  if (soup.points.size() >= kNone || faces.cells.size() >= kNone / 3)
    fail("mesh", "has more than 1.4 billion faces or 4.2 billion vertices", "split it");
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    const Vec3& p = soup.points[v];
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) {
      fail(fmt::format("vertex {}", soup.point_tag(v)), "a coordinate is not finite",
           "remove or repair the vertex");
    }
  }
  const auto vertices = static_cast<Cells::Node>(soup.points.size());
  std::vector<Triangle> corners;
  corners.reserve(faces.cells.size());
  for (std::size_t f = 0; f < faces.cells.size(); ++f) {
    const auto nodes = soup.cells.nodes(faces.cells[f]);
    const auto name = [&] { return fmt::format("face {}", faces.tag(soup, f)); };
    Triangle triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (nodes[k] < 0 || nodes[k] >= vertices) {
        fail(name(), fmt::format("vertex {} (counted from 0) does not exist", nodes[k]),
             fmt::format("the file has {} vertices", vertices));
      }
      triangle[k] = static_cast<Index>(nodes[k]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if (triangle[k] == triangle[(k + 1) % 3]) {
        fail(name(), fmt::format("repeats vertex {}", soup.point_tag(triangle[k])),
             "remove degenerate faces");
      }
    }
    corners.push_back(triangle);
  }
  return corners;
}

void require_manifold(const Soup& soup, const SoupFaces& faces,
                      const std::vector<Triangle>& corners) {
  const std::vector<Side> sides = sorted_sides(corners, soup.points.size());
  require_distinct(soup, faces, sides);
  require_two_faces(soup, faces, sides);
  require_fans(soup, corners, sides);
}

std::vector<Index> used_points(const Soup& soup) {
  return used(soup.points.size(), proper_corners(soup, faces_of(soup)));
}

MeshFile mesh_of_soup(const Soup& soup) {
  const SoupFaces faces = faces_of(soup);
  std::vector<Triangle> corners = proper_corners(soup, faces);
  const std::vector<Side> sides = sorted_sides(corners, soup.points.size());
  require_distinct(soup, faces, sides);
  require_two_faces(soup, faces, sides);
  require_fans(soup, corners, sides);
  const Index flipped = orient(corners, neighbours(sides, corners.size()));
  MeshFile file;
  faces.warn(file.warnings);
  std::vector<Vec3> points = drop_unreferenced(soup, corners);
  const std::size_t dropped = soup.points.size() - points.size();
  if (dropped > 0)
    file.warnings.push_back(fmt::format("dropped {} vertices that belong to no face", dropped));
  if (flipped > 0) {
    file.warnings.push_back(
        fmt::format("flipped {} faces oriented against the majority of their component", flipped));
  }
  file.mesh = kernel::TriangleMesh(std::move(points), std::move(corners));
  return file;
}

}  // namespace crest::io
