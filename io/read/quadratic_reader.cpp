// SPDX-License-Identifier: GPL-3.0-or-later
// From nodes and cells to a QuadraticMesh. Errors name the file's own nodes and faces.
#include "io/read/quadratic_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>
#include <utility>

#include "io/formats/fields.hpp"
#include "io/formats/files.hpp"
#include "io/formats/readers.hpp"
#include "io/read/soup_to_mesh.hpp"
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

/// The claim speaks of values alone; places are computed on straight edges.
std::size_t curved_sides(const Soup& soup, const std::vector<Triangle>& faces,
                         const std::vector<std::array<Index, 3>>& midside) {
  std::size_t curved = 0;
  for (std::size_t f = 0; f < midside.size(); ++f) {
    for (std::size_t k = 0; midside[f][0] != kNone && k < 3; ++k) {
      const Vec3 &a = soup.points[faces[f][k]], &b = soup.points[faces[f][(k + 1) % 3]];
      const Vec3& m = soup.points[midside[f][k]];
      double off = 0, length = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        off = std::hypot(off, m[i] - (0.5 * a[i] + 0.5 * b[i]));
        length = std::hypot(length, b[i] - a[i]);
      }
      curved += off > 1e-6 * length;
    }
  }
  return curved;
}

/// Throws for neighbours with different values in the middle of their edge.
void require_agreement(const Soup& soup, const SoupFaces& cells, const std::vector<Triangle>& faces,
                       const std::vector<std::array<double, 3>>& middles) {
  std::unordered_map<std::uint64_t, std::pair<std::size_t, double>> seen;
  for (std::size_t f = 0; f < middles.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = faces[f][k], b = faces[f][(k + 1) % 3];
      const auto [other, first] = seen.try_emplace(edge_key(a, b), f, middles[f][k]);
      if (first || other->second.second == middles[f][k]) continue;
      fail(fmt::format("edge {}-{}", soup.point_tag(a), soup.point_tag(b)),
           fmt::format("faces {} and {} have the values {} and {} at its middle",
                       cells.tag(soup, other->second.first), cells.tag(soup, f),
                       other->second.second, middles[f][k]),
           "make the function continuous");
    }
  }
}

class Builder {
 public:
  /// `field`: one of the soup's, unless the source has an expression.
  Builder(const Soup& soup, const SoupFaces& cells, const Field* field,
          const FunctionSource& source)
      : soup_(soup), cells_(cells), field_(field) {
    if (field) node_values_ = exact_doubles(soup, *field);
    faces_ = proper_corners(soup, cells);
    if (!source.linear) midside_ = cells.midside;
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
    if (const std::size_t curved = curved_sides(soup_, faces_, midside_)) {
      warnings_.push_back(fmt::format(
          "{} sides are curved: the graph is that of the curved faces, places are given on "
          "straight ones",
          curved));
    }
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
      require_manifold(soup_, cells_, faces_);
      require_agreement(soup_, cells_, faces_, middles);
      throw;
    }
  }

 private:
  static constexpr Index kMiddle = kNone - 1;

  bool quadratic(std::size_t f) const { return !midside_.empty() && midside_[f][0] != kNone; }
  std::string node_name(Index v) const { return fmt::format("node {}", soup_.point_tag(v)); }

  const Vec3& place(Index v) const { return soup_.points[v]; }

  /// Corners in the order of their nodes; number_ is kMiddle for mid-side nodes.
  void number_vertices() {
    number_.assign(soup_.points.size(), kNone);
    for (const auto& middle : cells_.midside) {
      for (const Index v : middle)
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
    const double value = expression_ ? sample(place(v)) : node_values_[v];
    if (!expression_ && !field_->missing.empty() && field_->missing[v])
      fail(node_name(v), fmt::format("has no value of '{}'", field_->name), "give every node one");
    if (!std::isfinite(value)) {
      fail(node_name(v),
           expression_ ? fmt::format("the expression is {} there", value)
                       : fmt::format("its value of '{}' is {}", field_->name, value),
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
      fail(fmt::format("edge {}-{}", soup_.point_tag(a), soup_.point_tag(b)),
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

  const Soup& soup_;
  const SoupFaces& cells_;
  const Field* field_;
  std::vector<double> node_values_;
  std::vector<Triangle> faces_;
  std::vector<std::array<Index, 3>> midside_;
  std::optional<kernel::Evaluator<double>> expression_;
  bool sampled_middles_ = false;
  std::vector<Index> number_;
  std::vector<Vec3> points_;
  std::vector<double> values_;
  std::vector<std::string> warnings_;
};

/// Nothing for the formats without fields.
SoupReader field_reader(const std::string& extension) {
  static const std::map<std::string, SoupReader> readers = {
      {".vtu", read_vtu}, {".vtp", read_vtp}, {".msh", read_msh}};
  const auto reader = readers.find(extension);
  return reader == readers.end() ? nullptr : reader->second;
}

QuadraticFile read(const std::string& extension, const FunctionSource& source,
                   const std::function<std::string()>& bytes) {
  const FieldRequest request{!source.expression, source.field};
  SoupReader reader = field_reader(extension);
  if (!reader) {
    reader = soup_reader(extension);
    if (request.wanted) {
      fail("fields", extension.substr(1) + " files have none",
           "use --expression, or a .vtu, .msh or .vtp file");
    }
  }
  const Soup soup = reader(bytes(), request);
  const SoupFaces cells = faces_of(soup);
  const Field* field =
      request.wanted ? &choose_scalar(soup, source.field, "use --expression") : nullptr;
  QuadraticFile file = Builder(soup, cells, field, source).build();
  file.function = field ? field->name : source.expression->text();
  std::vector<std::string> warnings;
  cells.warn(warnings);
  file.warnings.insert(file.warnings.begin(), warnings.begin(), warnings.end());
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
