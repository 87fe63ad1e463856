// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read/tet_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "io/formats/files.hpp"
#include "io/formats/readers.hpp"

namespace crest::io {
namespace {

using kernel::Index;
using Node = Cells::Node;

/// A solid's faces by its corners.
struct Solid {
  std::size_t corners;
  std::vector<std::vector<std::size_t>> faces;
};

const Solid* solid(CellType type) {
  static const Solid tet{4, {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}};
  static const Solid pyramid{5, {{0, 1, 2, 3}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
  static const Solid wedge{6, {{0, 1, 2}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}};
  static const Solid hexahedron{
      8, {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
  static const Solid voxel{
      8, {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}}};
  switch (type) {
    case CellType::tetrahedron:
    case CellType::quadratic_tetrahedron:
    case CellType::lagrange_tetrahedron:
      return &tet;
    case CellType::pyramid:
    case CellType::quadratic_pyramid:
    case CellType::lagrange_pyramid:
      return &pyramid;
    case CellType::wedge:
    case CellType::quadratic_wedge:
    case CellType::biquadratic_wedge:
    case CellType::lagrange_wedge:
      return &wedge;
    case CellType::hexahedron:
    case CellType::quadratic_hexahedron:
    case CellType::triquadratic_hexahedron:
    case CellType::lagrange_hexahedron:
      return &hexahedron;
    case CellType::voxel:
      return &voxel;
    default:
      return nullptr;
  }
}

/// Collects tetrahedra by the file's points.
class Tetrahedra {
 public:
  explicit Tetrahedra(const Soup& soup) : soup_(soup) {}

  void add_all() {
    for (std::size_t c = 0; c < soup_.cells.size(); ++c) {
      const Solid* s = solid(soup_.cells.type(c));
      if (!s) {
        ++left_out_;
        continue;
      }
      const auto nodes = soup_.cells.nodes(c);
      if (nodes.size() < s->corners)
        fail(name(c), fmt::format("has {} nodes", nodes.size()), "export the file again");
      for (std::size_t i = 0; i < s->corners; ++i)
        if (nodes[i] < 0 || static_cast<std::size_t>(nodes[i]) >= soup_.points.size())
          fail(name(c), "has a node that does not exist", "export the file again");
      if (nodes.size() > s->corners) ++curved_;
      if (s->corners == 4)
        add(c, {nodes[0], nodes[1], nodes[2], nodes[3]});
      else
        split(c, *s, nodes);
    }
    if (tets.empty()) fail("cells", "none is a solid", "give tetrahedra");
  }
  void warn(std::vector<std::string>& warnings) const {
    if (left_out_ > 0)
      warnings.push_back(fmt::format("{} cells that are no solids left out", left_out_));
    if (split_ > 0)
      warnings.push_back(fmt::format("{} other solids split into tetrahedra", split_));
    if (curved_ > 0)
      warnings.push_back(fmt::format("of {} curved cells the corners were taken", curved_));
    if (thin_ > 0)
      warnings.push_back(fmt::format("{} parts of solids with repeated corners left out", thin_));
  }

  std::vector<std::array<Node, 4>> tets;
  std::vector<std::int64_t> cell_of;

 private:
  std::string name(std::size_t c) const { return fmt::format("cell {}", soup_.cell_tag(c)); }
  void add(std::size_t c, const std::array<Node, 4>& t) {
    tets.push_back(t);
    cell_of.push_back(soup_.cell_tag(c));
  }
  /// From the lowest corner to the triangles of the faces without it.
  void split(std::size_t c, const Solid& s, std::span<const Node> nodes) {
    ++split_;
    const Node apex =
        *std::min_element(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(s.corners));
    for (const auto& face : s.faces) {
      std::vector<Node> v;
      for (const std::size_t i : face) v.push_back(nodes[i]);
      if (std::find(v.begin(), v.end(), apex) != v.end()) continue;
      std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
      for (std::size_t i = 1; i + 1 < v.size(); ++i) {
        const std::array<Node, 4> t = {apex, v[0], v[i], v[i + 1]};
        if (t[1] == t[2] || t[1] == t[3] || t[2] == t[3])
          ++thin_;
        else
          add(c, t);
      }
    }
  }

  const Soup& soup_;
  std::size_t left_out_ = 0, split_ = 0, curved_ = 0, thin_ = 0;
};

std::string tensor_names(const Soup& soup) {
  std::string names;
  for (const Field& f : soup.point_fields)
    if (f.components == 6 || f.components == 9)
      names += fmt::format("{}'{}'", names.empty() ? "" : ", ", f.name.substr(0, 60));
  if (!names.empty()) return "the tensors of points are " + names;
  std::string all;
  for (const Field& f : soup.point_fields)
    all += fmt::format("{}'{}' ({})", all.empty() ? "" : ", ", f.name.substr(0, 60), f.components);
  return all.empty() ? "the file has no array of points"
                     : "no array of points has 6 or 9 components; there are " + all;
}

const Field& tensor_field(const Soup& soup, const std::string& wanted) {
  const Field* found = nullptr;
  for (const Field& f : soup.point_fields) {
    if (wanted.empty() ? f.components != 6 && f.components != 9 : f.name != wanted) continue;
    if (found)
      fail("tensors", wanted.empty() ? "there are several" : "the name is there twice",
           tensor_names(soup) + "; choose one with --tensor");
    found = &f;
  }
  const std::string element = wanted.empty() ? "tensors" : fmt::format("array '{}'", wanted);
  if (!found) fail(element, "does not exist", tensor_names(soup));
  if (found->components != 6 && found->components != 9)
    fail(element, fmt::format("has {} components", found->components), tensor_names(soup));
  if (found->size() != static_cast<std::size_t>(found->components) * soup.points.size())
    fail(element, "has not one tensor a point", "export it again");
  return *found;
}

/// Where each of xx yy zz xy yz xz stands.
std::array<std::size_t, 6> places(const std::string& order) {
  static const std::map<std::string, std::size_t> words = {{"xx", 0}, {"yy", 1}, {"zz", 2},
                                                           {"xy", 3}, {"yx", 3}, {"yz", 4},
                                                           {"zy", 4}, {"xz", 5}, {"zx", 5}};
  std::array<std::size_t, 6> r;
  r.fill(6);
  std::string text = order;
  std::replace(text.begin(), text.end(), ',', ' ');
  std::size_t count = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    at = end + 1;
    if (word.empty()) continue;
    const auto found = words.find(word);
    if (found == words.end() || r[found->second] != 6 || count == 6)
      fail("order", fmt::format("'{}' is none", order.substr(0, 60)),
           "name xx yy zz xy yz xz once each");
    r[found->second] = count++;
  }
  if (count != 6)
    fail("order", fmt::format("'{}' is none", order.substr(0, 60)),
         "name xx yy zz xy yz xz once each");
  return r;
}

double number(const Field& f, std::size_t i) {
  return std::visit([i](const auto& x) { return static_cast<double>(x[i]); }, f.numbers);
}

std::array<double, 6> tensor_at(const Field& f, std::size_t v,
                                const std::array<std::size_t, 6>& place, double& asymmetry) {
  std::array<double, 6> t{};
  if (f.components == 6) {
    for (std::size_t k = 0; k < 6; ++k) t[k] = number(f, 6 * v + place[k]);
    return t;
  }
  constexpr std::size_t upper[6] = {0, 4, 8, 1, 5, 2}, lower[6] = {0, 4, 8, 3, 7, 6};
  for (std::size_t k = 0; k < 6; ++k) {
    const double a = number(f, 9 * v + upper[k]), b = number(f, 9 * v + lower[k]);
    t[k] = a == b ? a : 0.5 * a + 0.5 * b;
    asymmetry = std::fmax(asymmetry, std::fabs(a - b));
  }
  return t;
}

TensorFile from_soup(const Soup& soup, const TensorRequest& request) {
  TensorFile file;
  Tetrahedra tetrahedra(soup);
  tetrahedra.add_all();
  file.warnings = soup.warnings;
  tetrahedra.warn(file.warnings);
  const Field& field = tensor_field(soup, request.field);
  file.field = field.name;
  const auto place = places(request.order);
  std::vector<Index> number_of(soup.points.size(), ~Index{0});
  for (const auto& t : tetrahedra.tets)
    for (const Node v : t) number_of[static_cast<std::size_t>(v)] = 0;
  std::vector<kernel::Vec3> points;
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    if (number_of[v] != 0) continue;
    number_of[v] = static_cast<Index>(points.size());
    points.push_back(soup.points[v]);
    file.tensors.push_back(tensor_at(field, v, place, file.max_asymmetry));
    for (const double x : soup.points[v])
      if (!std::isfinite(x)) fail(soup.point_name(v), "is not finite", "repair it");
    const bool missing = !field.missing.empty() && field.missing[v];
    for (const double x : file.tensors.back())
      if (missing || !std::isfinite(x))
        fail(
            soup.point_name(v),
            fmt::format("its tensor of '{}' is {}", field.name, missing ? "missing" : "not finite"),
            "repair the field");
  }
  if (points.size() < soup.points.size())
    file.warnings.push_back(
        fmt::format("{} points that no solid uses left out", soup.points.size() - points.size()));
  std::vector<kernel::TetMesh::Tet> tets;
  for (const auto& t : tetrahedra.tets) {
    auto& to = tets.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) to[i] = number_of[static_cast<std::size_t>(t[i])];
  }
  file.cell_of = std::move(tetrahedra.cell_of);
  file.mesh = kernel::TetMesh(std::move(points), std::move(tets));
  return file;
}

}  // namespace

TensorFile read_tensors(const std::string& path, const TensorRequest& request) {
  TensorFile file;
  read_named(path, [&] {
    FieldRequest fields;
    fields.wanted = true;
    fields.name = request.field;
    const Soup soup = soup_reader(lower_extension(path))(load(path), fields);
    file = from_soup(soup, request);
  });
  return file;
}

}  // namespace crest::io
