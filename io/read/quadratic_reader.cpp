// SPDX-License-Identifier: GPL-3.0-or-later
// From nodes and cells to a QuadraticMesh. Errors name the file's own nodes and faces.
#include "io/read/quadratic_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "io/clean/clean.hpp"
#include "io/clean/finite.hpp"
#include "io/formats/files.hpp"
#include "io/formats/readers.hpp"
#include "io/read/point_values.hpp"
#include "kernel/expressions/evaluate.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {
namespace {

using kernel::Index;
using kernel::kNone;
using kernel::Vec3;

using EdgeValues = std::unordered_map<std::uint64_t, double>;

std::uint64_t edge_key(Index a, Index b) {
  return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

/// The claim speaks of values alone; places are computed on straight edges.
std::size_t curved_sides(const Soup& soup, const Surface& surface) {
  std::size_t curved = 0;
  for (std::size_t f = 0; f < surface.midside.size(); ++f) {
    for (std::size_t k = 0; surface.midside[f][0] != kNone && k < 3; ++k) {
      const Vec3& a = surface.points[surface.faces[f][k]];
      const Vec3& b = surface.points[surface.faces[f][(k + 1) % 3]];
      const Vec3& m = soup.points[surface.midside[f][k]];
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

std::string edge_name(const Soup& soup, const Surface& surface, Index a, Index b) {
  return fmt::format("edge {}-{}", soup.point_tag(surface.point_of[a]),
                     soup.point_tag(surface.point_of[b]));
}

/// Throws for neighbours with different values in the middle of their edge.
void require_agreement(const Soup& soup, const Surface& surface,
                       const std::vector<std::array<double, 3>>& middles) {
  std::unordered_map<std::uint64_t, std::pair<std::size_t, double>> seen;
  for (std::size_t f = 0; f < middles.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = surface.faces[f][k], b = surface.faces[f][(k + 1) % 3];
      const auto [other, first] = seen.try_emplace(edge_key(a, b), f, middles[f][k]);
      if (first || other->second.second == middles[f][k]) continue;
      const auto tag = [&](std::size_t face) { return soup.cell_tag(surface.cell_of[face]); };
      fail(edge_name(soup, surface, a, b),
           fmt::format("faces {} and {} have the values {} and {} at its middle",
                       tag(other->second.first), tag(f), other->second.second, middles[f][k]),
           "make the function continuous");
    }
  }
}

class Builder {
 public:
  /// `field`: nothing if the source has an expression. Takes the surface's points and faces.
  Builder(const Soup& soup, Surface& surface, const PointValues* field,
          const FunctionSource& source)
      : soup_(soup), surface_(surface), field_(field) {
    if (source.linear) surface_.midside.clear();
    if (source.expression) expression_.emplace(kernel::double_evaluator(*source.expression));
    // Of an expression that is linear on every face, samples in the middle would add nothing but
    // their rounding, and with it critical points where its values all but agree.
    const bool linear =
        surface_.midside.empty() && source.expression && source.expression->affine();
    sampled_middles_ = source.expression && !source.linear && !linear;
  }

  kernel::QuadraticMesh build() {
    check_middles();
    for (Index v = 0; v < surface_.vertex_count(); ++v)
      values_.push_back(node_value(surface_.point_of[v]));
    const std::vector<std::array<double, 3>> middles = middle_values();
    try {
      return {surface_.points, surface_.faces, values_, middles};
    } catch (const kernel::InputError&) {
      require_agreement(soup_, surface_, middles);
      throw;
    }
  }

 private:
  bool quadratic(std::size_t f) const {
    return !surface_.midside.empty() && surface_.midside[f][0] != kNone;
  }

  void check_middles() const {
    std::vector<bool> is_corner(surface_.midside.empty() ? 0 : soup_.points.size(), false);
    if (is_corner.empty()) return;
    for (const Index point : surface_.point_of) is_corner[point] = true;
    for (const auto& middle : surface_.midside) {
      for (const Index m : middle) {
        if (m == kNone) continue;
        require_finite(soup_, m);
        if (is_corner[m]) {
          fail(soup_.point_name(m), "is a corner of one face and a mid-side node of another",
               "split the larger face");
        }
      }
    }
  }

  double sample(const Vec3& p) { return (*expression_)(std::span<const double>(p)); }

  double node_value(Index point) {
    if (!expression_) return field_->at(point);
    const double value = sample(soup_.points[point]);
    if (!std::isfinite(value)) {
      fail(soup_.point_name(point), fmt::format("the expression is {} there", value),
           "change the expression");
    }
    return value;
  }

  /// At the middle of an edge of a linear face. Independent of the direction of the edge.
  double side_value(Index a, Index b, const EdgeValues& of_quadratic) {
    if (!sampled_middles_) return 0.5 * values_[a] + 0.5 * values_[b];
    const auto known = of_quadratic.find(edge_key(a, b));
    if (known != of_quadratic.end()) return known->second;
    const Vec3 &p = surface_.points[a], &q = surface_.points[b];
    const double value =
        sample({0.5 * p[0] + 0.5 * q[0], 0.5 * p[1] + 0.5 * q[1], 0.5 * p[2] + 0.5 * q[2]});
    if (!std::isfinite(value)) {
      fail(edge_name(soup_, surface_, a, b),
           fmt::format("the expression is {} at its middle", value), "change the expression");
    }
    return value;
  }

  std::vector<std::array<double, 3>> middle_values() {
    std::vector<std::array<double, 3>> middles;
    if (surface_.midside.empty() && !sampled_middles_) return middles;
    const std::vector<kernel::Triangle>& faces = surface_.faces;
    middles.resize(faces.size());
    EdgeValues of_quadratic;  // needed where both kinds meet
    bool mixed = false;
    for (std::size_t f = 0; f < faces.size(); ++f) mixed = mixed || !quadratic(f);
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if (!quadratic(f)) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        middles[f][k] = node_value(surface_.midside[f][k]);
        if (mixed)
          of_quadratic.emplace(edge_key(faces[f][k], faces[f][(k + 1) % 3]), middles[f][k]);
      }
    }
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if (quadratic(f)) continue;
      for (std::size_t k = 0; k < 3; ++k)
        middles[f][k] = side_value(faces[f][k], faces[f][(k + 1) % 3], of_quadratic);
    }
    return middles;
  }

  const Soup& soup_;
  Surface& surface_;
  const PointValues* field_;
  std::optional<kernel::Evaluator<double>> expression_;
  bool sampled_middles_ = false;
  std::vector<double> values_;
};

FieldRequest fields(const FunctionSource& source) {
  return {!source.expression, source.field, false, source.step};
}

}  // namespace

QuadraticFile quadratic_mesh_of_soup(const Soup& soup, const FunctionSource& source) {
  CleanUp done;
  Surface surface = clean(soup, source.clean, Purpose::function, done);
  std::optional<PointValues> field;
  if (!source.expression) field.emplace(soup, source.field, "use --expression");
  Builder builder(soup, surface, field ? &*field : nullptr, source);
  QuadraticFile file{builder.build(), file_numbers(soup, surface),
                     field ? field->name() : source.expression->text(), done, soup.warnings};
  const auto lines = words(done);
  file.warnings.insert(file.warnings.end(), lines.begin(), lines.end());
  if (const std::size_t curved = curved_sides(soup, surface)) {
    file.warnings.push_back(fmt::format(
        "{} sides are curved: the graph is that of the curved faces, places are given on "
        "straight ones",
        curved));
  }
  if (const auto note = field ? field->note() : std::nullopt) file.warnings.push_back(*note);
  return file;
}

QuadraticFile read_quadratic_mesh(const std::string& path, const FunctionSource& source) {
  std::optional<QuadraticFile> file;
  read_named(
      path, [&] { file.emplace(quadratic_mesh_of_soup(read_soup(path, fields(source)), source)); });
  return std::move(*file);
}

QuadraticFile read_quadratic_mesh_bytes(const std::string& name, std::string_view bytes,
                                        const FunctionSource& source) {
  std::optional<QuadraticFile> file;
  read_named(name, [&] {
    file.emplace(quadratic_mesh_of_soup(read_soup(name, bytes, fields(source)), source));
  });
  return std::move(*file);
}

}  // namespace crest::io
