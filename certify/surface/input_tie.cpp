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

using Triangle = std::array<std::size_t, 3>;

enum class Match { other, same, opposite };

/// How `face` runs around the corners of `stated`.
Match match(const std::vector<std::size_t>& face, const Triangle& stated) {
  if (face.size() != 3) return Match::other;
  Triangle turned = {face[0], face[1], face[2]};
  for (int i = 0; i < 3; ++i) {
    if (turned == stated) return Match::same;
    if (Triangle{turned[0], turned[2], turned[1]} == stated) return Match::opposite;
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
  }
  return Match::other;
}

/// The least vertex of every vertex's component.
std::vector<std::size_t> components(std::size_t vertices, Faces faces) {
  std::vector<std::size_t> parent(vertices);
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto find = [&](std::size_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const auto& f : faces)
    for (const std::size_t i : {1, 2}) {
      const auto [low, high] = std::minmax({find(f[0]), find(f[i])});
      parent[high] = low;
    }
  for (std::size_t v = 0; v < vertices; ++v) parent[v] = parent[parent[v]];
  return parent;
}

/// The faces are matched one by one: what that says of each component, in words.
std::string orientations(std::size_t vertices, Faces faces, const std::vector<Match>& matches) {
  struct Count {
    std::size_t faces = 0, opposite = 0;
  };
  const auto component = components(vertices, faces);
  std::vector<Count> counts(vertices);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    Count& count = counts[component[faces[f][0]]];
    ++count.faces;
    count.opposite += matches[f] == Match::opposite;
  }
  std::size_t all = 0, turned = 0, mixed = 0, flipped = 0;
  for (const auto& [size, opposite] : counts) {
    all += size > 0;
    turned += size > 0 && opposite == size;
    if (opposite == 0 || opposite == size) continue;
    ++mixed;
    flipped += opposite;
  }
  if (turned == 0 && mixed == 0) return "oriented as in the file";
  std::string words = "re-oriented";
  if (turned > 0) words += fmt::format(" {} of {} components", turned, all);
  if (mixed > 0)
    words += fmt::format("{} {} faces of {} components that the file does not orient alike",
                         turned > 0 ? " and" : "", flipped, mixed);
  return words;
}

}  // namespace

std::string check_input(const std::string& path, std::span<const Position> positions, Faces faces) {
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
  std::vector<Match> matches;
  matches.reserve(faces.size());
  for (std::size_t f = 0; f < soup.faces.size(); ++f) {
    const auto& [a, b, c] = faces[f];
    matches.push_back(match(soup.faces[f], {a, b, c}));
    require(matches.back() != Match::other, "{}: face {} has other corners", path, f);
  }
  return orientations(positions.size(), faces, matches);
}

}  // namespace crest::certify
