// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the format readers hand to read_mesh: points and triangles as they stand in the file.
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "io/read/mesh_reader.hpp"

namespace crest::io {

/// The corners of a face as CGAL's readers fill them. No list longer than 3 is ever allocated,
/// whatever length a file announces.
class Corners {
 public:
  using value_type = std::int64_t;
  void resize(std::size_t n) {
    if (n > 3) throw std::length_error("face with more than 3 vertices");
    size_ = n;
  }
  std::size_t size() const { return size_; }
  std::int64_t& operator[](std::size_t k) { return at_[k]; }
  const std::int64_t& operator[](std::size_t k) const { return at_[k]; }

 private:
  std::array<std::int64_t, 3> at_{};
  std::size_t size_ = 0;
};

using SoupPoint = CGAL::Simple_cartesian<double>::Point_3;

struct PolygonSoup {
  std::vector<SoupPoint> points;
  std::vector<Corners> faces;
  /// What the file calls them, for messages; empty: by position.
  std::vector<std::int64_t> point_tags = {}, face_tags = {};

  std::int64_t point_tag(std::size_t v) const {
    return point_tags.empty() ? static_cast<std::int64_t>(v) : point_tags[v];
  }
  std::int64_t face_tag(std::size_t f) const {
    return face_tags.empty() ? static_cast<std::int64_t>(f) : face_tags[f];
  }
};

/// "ELEMENT: PROBLEM; REMEDY"; read_mesh puts the file's name in front.
[[noreturn]] void fail(const std::string& element, const std::string& problem,
                       const std::string& remedy);

/// OFF with checks like those below, which have to read every number anyway; CGAL's reader takes
/// ten times as long as they do. Numbers are rounded as an istream does, bit for bit.
PolygonSoup parse_off(std::string_view text);

/// The checks before CGAL or VTK reads: they name the line and element that it would refuse, ignore
/// or crash on, and blank out what it cannot skip. Each throws kernel::InputError.
void check_obj(std::string& text);
void check_ply(const std::string& bytes);
void check_stl(std::string& bytes);
void check_vtp(const std::string& bytes);  ///< and VTU

PolygonSoup read_off(std::string bytes);
PolygonSoup read_obj(std::string bytes);
PolygonSoup read_ply(std::string bytes);
PolygonSoup read_stl(std::string bytes);
PolygonSoup read_vtp(std::string bytes);

/// The bytes of a regular file.
std::string load(const std::string& path);

/// The reader of an extension (lower case); fails for an unknown one, saying `others` are known
/// too.
using SoupReader = PolygonSoup (*)(std::string);
SoupReader soup_reader(const std::string& extension, const std::string& others = "");

/// Runs `read`; whatever it throws becomes an InputError of one line with the file's name in front.
void read_named(const std::string& name, const std::function<void()>& read);

/// The faces' corners. Throws kernel::InputError unless there are faces, each has three distinct
/// corners and these exist and are finite.
std::vector<kernel::Triangle> proper_faces(const PolygonSoup& soup);

/// Throws kernel::InputError naming an edge in three faces, a vertex with two fans or a face that
/// is there twice. Requires: faces of proper_faces.
void require_manifold(const PolygonSoup& soup, const std::vector<kernel::Triangle>& faces);

/// The manifold in the soup, oriented. Throws kernel::InputError naming the element that prevents
/// one. Cost: O(V + F) for bounded valences.
MeshFile mesh_of_soup(const PolygonSoup& soup);

}  // namespace crest::io
