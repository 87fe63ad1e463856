// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/surface/input_tie.hpp"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <fstream>
#include <map>
#include <numeric>

#include "certify/container/reject.hpp"
#include "certify/container/verdict.hpp"

namespace crest::certify {
namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Position = std::array<double, 3>;

struct Soup {
  std::vector<Position> positions;
  std::vector<std::vector<std::size_t>> faces;
};

std::string lower_extension(const std::string& path) {
  const std::size_t dot = path.find_last_of('.');
  std::string extension = dot == std::string::npos ? "" : path.substr(dot + 1);
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

bool read_soup(const std::string& path, const std::string& extension, std::vector<Point>& points,
               std::vector<std::vector<std::size_t>>& faces) {
  std::ifstream in(path, std::ios::binary);
  if (!in) return false;
  if (extension == "off") return CGAL::IO::read_OFF(in, points, faces);
  if (extension == "obj") return CGAL::IO::read_OBJ(in, points, faces);
  if (extension == "ply") return CGAL::IO::read_PLY(in, points, faces);
  return CGAL::IO::read_STL(in, points, faces);
}

/// One form for each number: files may hold -0, the certificate does not.
Position position_of(const Point& p) {
  return {p.x() + 0.0, p.y() + 0.0, p.z() + 0.0};
}

/// Vertices numbered by first appearance in the list of points; equal ones once.
void merge_equal(Soup& soup) {
  std::map<Position, std::size_t> first;
  std::vector<Position> kept;
  std::vector<std::size_t> number;
  for (const Position& p : soup.positions) {
    const auto [entry, fresh] = first.emplace(p, kept.size());
    if (fresh) kept.push_back(p);
    number.push_back(entry->second);
  }
  for (auto& face : soup.faces)
    for (auto& v : face) v = number[v];
  soup.positions = std::move(kept);
}

void drop_unreferenced(Soup& soup) {
  std::vector<std::size_t> number(soup.positions.size(), 0);
  for (const auto& face : soup.faces)
    for (const std::size_t v : face) number[v] = 1;
  std::size_t kept = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == 0) continue;
    soup.positions[kept] = soup.positions[v];
    number[v] = kept++;
  }
  soup.positions.resize(kept);
  for (auto& face : soup.faces)
    for (auto& v : face) v = number[v];
}

Soup read_input(const std::string& path) {
  const std::string extension = lower_extension(path);
  if (extension != "off" && extension != "obj" && extension != "ply" && extension != "stl")
    throw TieUnavailable(path + ": --input reads .off, .obj, .ply and .stl files");
  std::vector<Point> points;
  Soup soup;
  bool good = false;
  try {
    good = read_soup(path, extension, points, soup.faces);
  } catch (const std::exception&) {
    good = false;
  }
  for (const auto& face : soup.faces)
    for (const std::size_t v : face) good = good && v < points.size();
  if (!good) throw InputUnreadable(path + ": cannot be read as a mesh");
  for (const Point& p : points) soup.positions.push_back(position_of(p));
  if (extension == "stl") merge_equal(soup);
  drop_unreferenced(soup);
  return soup;
}

/// The corners in the order of the rotation and orientation that is least.
std::array<std::size_t, 3> unoriented(std::array<std::size_t, 3> face) {
  std::sort(face.begin(), face.end());  // three corners: rotations and reflections are all orders
  return face;
}

}  // namespace

void check_input(const std::string& path, std::span<const Position> positions, Faces faces) {
  const Soup soup = read_input(path);
  require(soup.positions.size() == positions.size(), "{}: {} vertices, {} in the certificate", path,
          soup.positions.size(), positions.size());
  require(soup.faces.size() == faces.size(), "{}: {} faces, {} in the certificate", path,
          soup.faces.size(), faces.size());
  for (std::size_t v = 0; v < soup.positions.size(); ++v)
    for (std::size_t i = 0; i < 3; ++i)
      require(std::bit_cast<std::uint64_t>(soup.positions[v][i]) ==
                  std::bit_cast<std::uint64_t>(positions[v][i]),
              "{}: vertex {} is elsewhere", path, v);
  for (std::size_t f = 0; f < soup.faces.size(); ++f) {
    const auto& face = soup.faces[f];
    const auto& [a, b, c] = faces[f];
    require(face.size() == 3 && unoriented({face[0], face[1], face[2]}) == unoriented({a, b, c}),
            "{}: face {} has other corners", path, f);
  }
}

}  // namespace crest::certify
