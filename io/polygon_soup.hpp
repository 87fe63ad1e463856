// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the format readers hand to read_mesh: points and triangles as they stand in the file.
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "io/mesh_reader.hpp"

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
};

/// "ELEMENT: PROBLEM; REMEDY"; read_mesh puts the file's name in front.
[[noreturn]] void fail(const std::string& element, const std::string& problem,
                       const std::string& remedy);

/// The checks before CGAL or VTK reads: they name the line and element that it would refuse, ignore
/// or crash on, and blank out what it cannot skip. Each throws kernel::InputError.
void check_off(std::string& text);
void check_obj(std::string& text);
void check_ply(const std::string& bytes);
void check_stl(std::string& bytes);
void check_vtp(const std::string& bytes);

PolygonSoup read_off(std::string bytes);
PolygonSoup read_obj(std::string bytes);
PolygonSoup read_ply(std::string bytes);
PolygonSoup read_stl(std::string bytes);
PolygonSoup read_vtp(std::string bytes);

/// The manifold in the soup, oriented. Throws kernel::InputError naming the element that prevents
/// one. Cost: O(V + F) for bounded valences.
MeshFile mesh_of_soup(const PolygonSoup& soup);

}  // namespace crest::io
