// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read/tet_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <span>

#include "io/formats/files.hpp"
#include "io/formats/readers.hpp"
#include "io/formats/solid_readers.hpp"
#include "io/read/tensor_fields.hpp"
#include "io/read/tensor_volume.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {
namespace {

using kernel::Index;
using Node = Cells::Node;

/// A solid's faces by its corners, anticlockwise seen from outside, so that all parts of a convex
/// solid are turned alike.
struct Solid {
  std::size_t corners;
  std::vector<std::vector<std::size_t>> faces;
};

const Solid* solid(CellType type) {
  static const Solid tet{4, {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}};
  static const Solid pyramid{5, {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
  static const Solid wedge{6, {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}};
  static const Solid hexahedron{
      8, {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
  static const Solid voxel{
      8, {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}}};
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
    const std::size_t first = tets.size();
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
    // Programs differ in which side of a solid they number first.
    const auto parts = std::span(tets).subspan(first);
    if (std::all_of(parts.begin(), parts.end(), [&](const auto& t) { return is_turned(t); }))
      for (auto& t : parts) std::swap(t[2], t[3]);
  }
  bool is_turned(const std::array<Node, 4>& t) const {
    std::array<kernel::Vec3, 3> d;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        d[i][k] = soup_.points[static_cast<std::size_t>(t[i + 1])][k] -
                  soup_.points[static_cast<std::size_t>(t[0])][k];
    return kernel::determinant(d[0], d[1], d[2]) < 0;
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

double number(const Field& f, std::size_t i) {
  return std::visit([i](const auto& x) { return static_cast<double>(x[i]); }, f.numbers);
}

std::array<double, 6> tensor_at(const Field& f, std::size_t v,
                                const std::array<std::size_t, 6>& place, double& asymmetry) {
  std::array<double, 9> x{};
  const auto n = static_cast<std::size_t>(f.components);
  for (std::size_t k = 0; k < n; ++k) x[k] = number(f, n * v + k);
  return tensor_of({x.data(), n}, place, asymmetry);
}

}  // namespace

TensorFile tensors_of_soup(const Soup& soup, const TensorRequest& request) {
  TensorFile file;
  Tetrahedra tetrahedra(soup);
  tetrahedra.add_all();
  file.warnings = soup.warnings;
  tetrahedra.warn(file.warnings);
  const Field& field = tensor_field(soup, request.field);
  file.field = field.name;
  const auto place = tensor_places(request.order.empty() ? "xx yy zz xy yz xz" : request.order);
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

namespace {

/// Medit's fields stand in a file beside the mesh.
Soup read_medit_pair(const std::string& path) {
  Soup soup = read_medit(load(path));
  const auto beside = std::filesystem::path(path).replace_extension(".sol");
  if (std::filesystem::exists(beside)) {
    try {
      read_medit_solution(load(beside.string()), soup);
    } catch (const kernel::InputError& error) {
      throw kernel::InputError(beside.filename().string() + ": " + error.what());
    }
  }
  return soup;
}

TensorFile read_file(const std::string& path, const TensorRequest& request) {
  const std::string extension = lower_extension(path);
  if (extension == ".nrrd") return read_tensor_volume(load(path), request);
  FieldRequest fields;
  fields.wanted = true;
  fields.name = request.field;
  fields.step = request.step;
  if (extension == ".frd") return tensors_of_soup(read_frd(load(path), fields), request);
  if (extension == ".mesh") return tensors_of_soup(read_medit_pair(path), request);
  for (const char* known : {".vtu", ".pvtu", ".vtk", ".msh"})
    if (extension == known) return tensors_of_soup(read_soup(path, fields), request);
  for (const char* packed : {".gz", ".xz", ".bz2", ".zip"})
    if (extension == packed) fail("file", "is packed", "unpack it");
  fail("file", "has the extension '" + extension + "', which holds no tensors on solids",
       "use .vtu, .pvtu, .vtk, .msh, .mesh, .frd or .nrrd");
}

}  // namespace

TensorFile read_tensors(const std::string& path, const TensorRequest& request) {
  TensorFile file;
  read_named(path, [&] { file = read_file(path, request); });
  return file;
}

}  // namespace crest::io
