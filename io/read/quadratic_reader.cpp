// SPDX-License-Identifier: GPL-3.0-or-later
// From nodes and cells to a QuadraticMesh. Errors name the file's own nodes and faces.
#include "io/read/quadratic_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>
#include <utility>

#include "io/formats/field_soup.hpp"
#include "io/formats/text_scan.hpp"
#include "io/write/formats.hpp"
#include "kernel/expressions/evaluate.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {
namespace {

using kernel::Index;
using kernel::kNone;
using kernel::Triangle;
using kernel::Vec3;

using EdgeValues = std::unordered_map<std::uint64_t, double>;

std::uint64_t edge_key(Index a, Index b) {
  return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

class Builder {
 public:
  Builder(const FieldSoup& file, const FunctionSource& source)
      : file_(file), faces_(proper_faces(file.soup)) {
    if (!source.linear) midside_ = file.midside;
    if (source.expression) expression_.emplace(kernel::double_evaluator(*source.expression));
    // Of an expression that is linear on every face, samples in the middle would add nothing but
    // their rounding, and with it critical points where its values all but agree.
    const bool linear = midside_.empty() && source.expression && source.expression->affine();
    sampled_middles_ = source.expression && !source.linear && !linear;
  }

  QuadraticFile build() {
    number_vertices();
    take_values();
    const std::vector<std::array<double, 3>> middles = middle_values();
    if (!midside_.empty()) warn_of_curved_sides();
    const std::size_t unused =
        static_cast<std::size_t>(std::count(number_.begin(), number_.end(), kNone));
    if (unused > 0)
      warnings_.push_back(fmt::format("dropped {} vertices that belong to no face", unused));
    std::vector<Triangle> renumbered = faces_;
    for (Triangle& face : renumbered)
      for (Index& v : face) v = number_[v];
    try {
      return {kernel::QuadraticMesh(std::move(points_), std::move(renumbered), std::move(values_),
                                    middles),
              {},
              std::move(warnings_)};
    } catch (const kernel::InputError&) {
      require_manifold(file_.soup, faces_);
      require_agreement(middles);
      throw;
    }
  }

 private:
  static constexpr Index kMiddle = kNone - 1;

  bool quadratic(std::size_t f) const { return !midside_.empty() && midside_[f][0] != kNone; }
  std::string node_name(Index v) const { return fmt::format("node {}", file_.soup.point_tag(v)); }

  Vec3 place(Index v) const {
    const SoupPoint& p = file_.soup.points[v];
    return {p.x(), p.y(), p.z()};
  }

  /// Corners in the order of their nodes; number_ is kMiddle for mid-side nodes.
  void number_vertices() {
    number_.assign(file_.soup.points.size(), kNone);
    for (std::size_t f = 0; f < file_.midside.size(); ++f) {
      for (const Index v : file_.midside[f])
        if (v != kNone) number_[v] = kMiddle;
    }
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      for (const Index v : faces_[f]) {
        if (number_[v] == kMiddle) {
          fail(node_name(v), "is a corner of one face and a mid-side node of another",
               "split the larger face");
        }
        number_[v] = 0;
      }
    }
    for (Index v = 0; v < number_.size(); ++v) {
      if (number_[v] != 0) continue;
      number_[v] = static_cast<Index>(points_.size());
      points_.push_back(place(v));
    }
  }

  double sample(const Vec3& p) { return (*expression_)(std::span<const double>(p)); }

  double node_value(Index v) {
    const double value = expression_ ? sample(place(v)) : file_.values[v];
    if (!expression_ && !file_.missing.empty() && file_.missing[v])
      fail(node_name(v), fmt::format("has no value of '{}'", file_.field), "give every node one");
    if (!std::isfinite(value)) {
      fail(node_name(v),
           expression_ ? fmt::format("the expression is {} there", value)
                       : fmt::format("its value of '{}' is {}", file_.field, value),
           expression_ ? "change the expression" : "repair the field");
    }
    return value;
  }

  void take_values() {
    for (Index v = 0; v < number_.size(); ++v)
      if (number_[v] < kMiddle) values_.push_back(node_value(v));
  }

  /// At the middle of an edge of a linear face. Independent of the direction of the edge.
  double side_value(Index a, Index b, const EdgeValues& of_quadratic) {
    if (!sampled_middles_) return 0.5 * values_[number_[a]] + 0.5 * values_[number_[b]];
    const auto known = of_quadratic.find(edge_key(a, b));
    if (known != of_quadratic.end()) return known->second;
    const Vec3 p = place(a), q = place(b);
    const double value =
        sample({0.5 * p[0] + 0.5 * q[0], 0.5 * p[1] + 0.5 * q[1], 0.5 * p[2] + 0.5 * q[2]});
    if (!std::isfinite(value)) {
      fail(fmt::format("edge {}-{}", file_.soup.point_tag(a), file_.soup.point_tag(b)),
           fmt::format("the expression is {} at its middle", value), "change the expression");
    }
    return value;
  }

  std::vector<std::array<double, 3>> middle_values() {
    std::vector<std::array<double, 3>> middles;
    if (midside_.empty() && !sampled_middles_) return middles;
    middles.resize(faces_.size());
    EdgeValues of_quadratic;  // needed where both kinds meet
    bool mixed = false;
    for (std::size_t f = 0; f < faces_.size(); ++f) mixed = mixed || !quadratic(f);
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      if (!quadratic(f)) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        middles[f][k] = node_value(midside_[f][k]);
        if (mixed)
          of_quadratic.emplace(edge_key(faces_[f][k], faces_[f][(k + 1) % 3]), middles[f][k]);
      }
    }
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      if (quadratic(f)) continue;
      for (std::size_t k = 0; k < 3; ++k)
        middles[f][k] = side_value(faces_[f][k], faces_[f][(k + 1) % 3], of_quadratic);
    }
    return middles;
  }

  /// The claim speaks of values alone; places are computed on straight edges.
  void warn_of_curved_sides() {
    std::size_t curved = 0;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      for (std::size_t k = 0; quadratic(f) && k < 3; ++k) {
        const Vec3 a = place(faces_[f][k]), b = place(faces_[f][(k + 1) % 3]);
        const Vec3 m = place(midside_[f][k]);
        double off = 0, length = 0;
        for (std::size_t i = 0; i < 3; ++i) {
          off = std::hypot(off, m[i] - (0.5 * a[i] + 0.5 * b[i]));
          length = std::hypot(length, b[i] - a[i]);
        }
        curved += off > 1e-6 * length;
      }
    }
    if (curved == 0) return;
    warnings_.push_back(fmt::format(
        "{} sides are curved: the graph is that of the curved faces, places are given on straight "
        "ones",
        curved));
  }

  /// Neighbours with different values in the middle of their edge.
  void require_agreement(const std::vector<std::array<double, 3>>& middles) const {
    std::unordered_map<std::uint64_t, std::pair<std::size_t, double>> seen;
    for (std::size_t f = 0; f < middles.size(); ++f) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Index a = faces_[f][k], b = faces_[f][(k + 1) % 3];
        const auto [other, first] = seen.try_emplace(edge_key(a, b), f, middles[f][k]);
        if (first || other->second.second == middles[f][k]) continue;
        fail(fmt::format("edge {}-{}", file_.soup.point_tag(a), file_.soup.point_tag(b)),
             fmt::format("faces {} and {} have the values {} and {} at its middle",
                         file_.soup.face_tag(other->second.first), file_.soup.face_tag(f),
                         other->second.second, middles[f][k]),
             "make the function continuous");
      }
    }
  }

  const FieldSoup& file_;
  std::vector<Triangle> faces_;
  std::vector<std::array<Index, 3>> midside_;
  std::optional<kernel::Evaluator<double>> expression_;
  bool sampled_middles_ = false;
  std::vector<Index> number_;
  std::vector<Vec3> points_;
  std::vector<double> values_;
  std::vector<std::string> warnings_;
};

using FieldReader = FieldSoup (*)(std::string, const FieldRequest&);

/// Nothing for the formats without fields.
FieldReader field_reader(const std::string& extension) {
  static const std::map<std::string, FieldReader> readers = {
      {".vtu", read_vtu},
      {".vtp", read_vtp_field},
      {".msh", [](std::string bytes, const FieldRequest& request) {
         check_text(bytes);
         return read_msh(bytes, request);
       }}};
  const auto reader = readers.find(extension);
  return reader == readers.end() ? nullptr : reader->second;
}

QuadraticFile read(const std::string& extension, const FunctionSource& source,
                   const std::function<std::string()>& bytes) {
  const FieldRequest request{!source.expression, source.field};
  FieldSoup soup;
  if (const FieldReader reader = field_reader(extension)) {
    soup = reader(bytes(), request);
  } else {
    const SoupReader mesh_reader = soup_reader(extension, ".vtu, .msh, ");
    if (request.wanted) {
      fail("fields", extension.substr(1) + " files have none",
           "use --expression, or a .vtu, .msh or .vtp file");
    }
    soup.soup = mesh_reader(bytes());
  }
  QuadraticFile file = Builder(soup, source).build();
  file.function = source.expression ? source.expression->text() : soup.field;
  file.warnings.insert(file.warnings.begin(), soup.warnings.begin(), soup.warnings.end());
  return file;
}

}  // namespace

QuadraticFile read_quadratic_mesh(const std::string& path, const FunctionSource& source) {
  std::optional<QuadraticFile> file;
  read_named(
      path, [&] { file.emplace(read(lower_extension(path), source, [&] { return load(path); })); });
  return std::move(*file);
}

QuadraticFile read_quadratic_mesh_bytes(const std::string& name, std::string bytes,
                                        const FunctionSource& source) {
  std::optional<QuadraticFile> file;
  read_named(name, [&] {
    file.emplace(read(lower_extension(name), source, [&] {
      if (bytes.empty()) fail("file", "is empty", "export the mesh again");
      return std::move(bytes);
    }));
  });
  return std::move(*file);
}

}  // namespace crest::io
