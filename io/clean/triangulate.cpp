// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/clean/triangulate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "io/clean/finite.hpp"
#include "io/clean/polygon_cutter.hpp"
#include "io/formats/files.hpp"

namespace crest::io {
namespace {

using kernel::Index;
using kernel::kNone;
using kernel::Vec3;

/// Of VTK's types of dimension 2: the corners that come first, and all nodes; 0: any number.
struct Nodes {
  std::size_t corners, least;
};

Nodes nodes_of(const Soup& soup, std::size_t cell) {
  const std::size_t half = (soup.cells.nodes(cell).size() + 1) / 2;
  switch (soup.cells.type(cell)) {
    case CellType::triangle:
    case CellType::lagrange_triangle:
    case CellType::bezier_triangle:
      return {3, 3};
    case CellType::quadratic_triangle:
      return {3, 6};
    case CellType::biquadratic_triangle:
      return {3, 7};
    case CellType::pixel:
    case CellType::quad:
    case CellType::lagrange_quad:
    case CellType::bezier_quad:
      return {4, 4};
    case CellType::quadratic_linear_quad:
      return {4, 6};
    case CellType::quadratic_quad:
      return {4, 8};
    case CellType::biquadratic_quad:
      return {4, 9};
    case CellType::quadratic_polygon:
      return {half, 2 * half};
    case CellType::polygon:
    case CellType::triangle_strip:
      return {0, 0};
    default:
      fail(fmt::format("cell {}", soup.cell_tag(cell)),
           fmt::format("has VTK's type {}", static_cast<int>(soup.cells.type(cell))),
           "give triangles, quadrilaterals, polygons or strips");
  }
}

Index node(const Soup& soup, std::size_t cell, std::size_t at) {
  const Cells::Node n = soup.cells.nodes(cell)[at];
  if (n < 0 || n >= static_cast<Cells::Node>(soup.points.size())) {
    fail(fmt::format("face {}", soup.cell_tag(cell)),
         fmt::format("vertex {} (counted from 0) does not exist", n),
         fmt::format("the file has {} vertices", soup.points.size()));
  }
  return static_cast<Index>(n);
}

class Triangulation {
 public:
  Triangulation(const Soup& soup, bool curved, CleanUp& done)
      : soup_(soup), curved_(curved), done_(done) {}

  Surface run() {
    surface_.points = soup_.points;
    surface_.point_of.resize(soup_.points.size());
    std::iota(surface_.point_of.begin(), surface_.point_of.end(), Index{0});
    surface_.faces.reserve(soup_.cells.size());
    surface_.cell_of.reserve(soup_.cells.size());
    for (std::size_t c = 0; c < soup_.cells.size(); ++c) {
      const CellType type = soup_.cells.type(c);
      const int dimension = dimension_of(type);
      if (dimension != 2 && dimension >= 0)
        ++done_.other_cells[type];
      else if (type == CellType::triangle && soup_.cells.nodes(c).size() == 3)
        add(c, {node(soup_, c, 0), node(soup_, c, 1), node(soup_, c, 2)});
      else if (type == CellType::triangle_strip)
        add_strip(c);
      else
        add_polygon(c);
    }
    if (!surface_.midside.empty()) surface_.midside.resize(surface_.faces.size(), kNowhere);
    if (!surface_.places.empty()) surface_.places.resize(surface_.faces.size(), kNowhere);
    return std::move(surface_);
  }

 private:
  static constexpr std::array<Index, 3> kNowhere = {kNone, kNone, kNone};

  void add(std::size_t cell, const kernel::Triangle& face) {
    if (surface_.faces.size() >= kNone / 3) fail("mesh", "has over 1.4 billion faces", "split it");
    surface_.faces.push_back(face);
    surface_.cell_of.push_back(static_cast<Index>(cell));
  }

  void add_strip(std::size_t cell) {
    const std::size_t nodes = soup_.cells.nodes(cell).size();
    if (nodes < 3) ++done_.repeated_corners;
    if (nodes > 3) ++done_.polygons;
    for (std::size_t i = 0; i + 2 < nodes; ++i) {
      const std::size_t odd = i % 2;
      add(cell,
          {node(soup_, cell, i + odd), node(soup_, cell, i + 1 - odd), node(soup_, cell, i + 2)});
    }
  }

  void add_polygon(std::size_t cell) {
    const std::vector<Index> corners = corners_of(soup_, cell);
    const std::size_t nodes = soup_.cells.nodes(cell).size();
    const bool keeps_sides = curved_ && soup_.cells.type(cell) == CellType::quadratic_triangle;
    for (std::size_t k = corners.size(); k < nodes; ++k)
      surface_.between.push_back(node(soup_, cell, k));
    if (nodes > corners.size() && !keeps_sides) ++done_.curved_faces;
    if (corners.size() < 3) {
      ++done_.repeated_corners;
      return;
    }
    if (corners.size() == 3) {
      add(cell, {corners[0], corners[1], corners[2]});
      if (!keeps_sides) return;
      surface_.midside.resize(surface_.faces.size(), kNowhere);
      for (std::size_t k = 0; k < 3; ++k) surface_.midside.back()[k] = node(soup_, cell, 3 + k);
      return;
    }
    ++done_.polygons;
    places_.clear();
    for (const Index v : corners) {
      require_finite(soup_, v);
      places_.push_back(soup_.points[v]);
    }
    if (!gathered_) gather_sides();
    const bool again = repeats(corners);
    if (again) surface_.places.resize(surface_.faces.size(), kNowhere);
    for (const auto& [a, b, c] : cutter_.cut(places_, corners, edges_)) {
      add(cell, {corners[a], corners[b], corners[c]});
      if (again)
        surface_.places.push_back(
            {static_cast<Index>(a), static_cast<Index>(b), static_cast<Index>(c)});
    }
  }

  bool repeats(const std::vector<Index>& corners) {
    sorted_ = corners;
    std::sort(sorted_.begin(), sorted_.end());
    return std::adjacent_find(sorted_.begin(), sorted_.end()) != sorted_.end();
  }

  /// Of all faces, when the first polygon is met.
  void gather_sides() {
    gathered_ = true;
    for (std::size_t c = 0; c < soup_.cells.size(); ++c) {
      if (dimension_of(soup_.cells.type(c)) != 2) continue;
      const bool strip = soup_.cells.type(c) == CellType::triangle_strip;
      const std::vector<Index> corners = corners_of(soup_, c);
      for (std::size_t k = 0; k < corners.size(); ++k) {
        if (!strip || k + 1 < corners.size())
          edges_.insert(corners[k], corners[(k + 1) % corners.size()]);
        if (strip && k + 2 < corners.size()) edges_.insert(corners[k], corners[k + 2]);
      }
    }
  }

  const Soup& soup_;
  bool curved_;
  CleanUp& done_;
  Surface surface_;
  PolygonCutter cutter_;
  EdgeSet edges_;
  bool gathered_ = false;
  std::vector<Vec3> places_;
  std::vector<Index> sorted_;  ///< a polygon's
};

}  // namespace

std::vector<Index> corners_of(const Soup& soup, std::size_t cell) {
  const std::size_t given = soup.cells.nodes(cell).size();
  const auto [corners, least] = nodes_of(soup, cell);
  if (given < least) {
    fail(fmt::format("cell {}", soup.cell_tag(cell)),
         fmt::format("has {} nodes instead of {}", given, least), "export the mesh again");
  }
  std::vector<Index> list;
  for (std::size_t k = 0; k < (corners > 0 ? corners : given); ++k)
    list.push_back(node(soup, cell, k));
  if (soup.cells.type(cell) == CellType::pixel) std::swap(list[2], list[3]);
  return list;
}

Surface triangulate(const Soup& soup, bool curved, CleanUp& done) {
  if (soup.points.size() >= kNone || soup.cells.size() >= kNone)
    fail("mesh", "has more than 4.2 billion vertices or cells", "split it");
  Surface surface = Triangulation(soup, curved, done).run();
  if (surface.faces.empty() && done.repeated_corners == 0) {
    const bool solid = std::any_of(done.other_cells.begin(), done.other_cells.end(),
                                   [](const auto& kind) { return dimension_of(kind.first) == 3; });
    fail("faces", solid ? "there are none, only solids" : "there are none",
         solid ? "extract their surface first" : "export the mesh with its faces");
  }
  return surface;
}

}  // namespace crest::io
