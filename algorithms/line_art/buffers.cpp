// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/line_art/buffers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

#include "kernel/geometry/parallel.hpp"

namespace crest::line_art {
namespace {

using kernel::cross, kernel::dot, kernel::norm;
using kernel::operator+, kernel::operator-, kernel::operator*;

Vec3 unit_vector(const Vec3& a) {
  const double n = norm(a);
  return n > 0 ? (1 / n) * a : a;
}

/// What is interpolated over a face.
struct Corner {
  Vec2 page;
  double near;
  Vec3 normal, rib;
  double curvature;
};

/// Paints the rows from `first` on, before `last`.
class Painter {
 public:
  Painter(const Model& model, const View& view, const LightOptions& light, int first, int last,
          Buffers& out)
      : model_(model), view_(view), first_(first), last_(last), out_(out) {
    const Vec3 l = unit_vector(light.light);
    light_ = l[0] * view.x + l[1] * view.y + (-l[2]) * view.z;
  }

  void paint(Index f, const std::array<Vec3, 3>& normals) {
    const kernel::Triangle& t = model_.mesh.faces()[f];
    const auto& p = model_.mesh.points();
    const Vec3 facing = unit_vector(cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]));
    std::array<Corner, 3> c;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = t[k];
      const PrincipalFrame& frame = model_.frames[v];
      const Vec3 d = model_.field.direction[v];
      c[k] = {view_.project(p[v]), view_.see(p[v]).near, normals[k],
              k == 0 ? d : matching(d, frame.n, c[0].rib),
              std::max(std::abs(frame.k1), std::abs(frame.k2))};
    }
    const double area = cross(c[1].page - c[0].page, c[2].page - c[0].page);
    if (area == 0 || !std::isfinite(area)) return;
    const auto bound = [&](std::size_t k, int from, int to) {
      const auto [low, high] = std::minmax({c[0].page[k], c[1].page[k], c[2].page[k]});
      return std::pair{std::clamp(static_cast<int>(std::floor(low / out_.pixel - 0.5)), from, to),
                       std::clamp(static_cast<int>(std::ceil(high / out_.pixel + 0.5)), from, to)};
    };
    const auto [i0, i1] = bound(0, 0, out_.width);
    const auto [j0, j1] = bound(1, first_, last_);
    for (int j = j0; j < j1; ++j)
      for (int i = i0; i < i1; ++i) {
        const std::size_t at = static_cast<std::size_t>(j) * static_cast<std::size_t>(out_.width) +
                               static_cast<std::size_t>(i);
        const Vec2 q = out_.centre(at) - c[0].page;
        const double b = cross(q, c[2].page - c[0].page) / area;
        const double g = cross(c[1].page - c[0].page, q) / area;
        if (b < -1e-9 || g < -1e-9 || b + g > 1 + 1e-9) continue;
        set(at, f, c, {1 - b - g, b, g}, facing);
      }
  }

 private:
  /// Of the directions that a representative stands for, the one nearest to another.
  Vec3 matching(const Vec3& d, const Vec3& n, const Vec3& other) const {
    Vec3 best = dot(d, other) < 0 ? -1.0 * d : d;
    if (model_.field.symmetry == 2) return best;
    const Vec3 turned = cross(n, d);
    if (std::abs(dot(turned, other)) > std::abs(dot(d, other)))
      best = dot(turned, other) < 0 ? -1.0 * turned : turned;
    return best;
  }

  std::array<float, 2> on_page(const Vec3& p, const Vec3& d) const {
    const Vec2 e = view_.derivative(p, d);
    const double n = norm(e);
    if (!(n > 1e-12)) return {0, 0};
    return {static_cast<float>(e[0] / n), static_cast<float>(e[1] / n)};
  }

  void set(std::size_t at, Index f, const std::array<Corner, 3>& c, const std::array<double, 3>& w,
           const Vec3& facing) {
    const auto near = static_cast<float>(w[0] * c[0].near + w[1] * c[1].near + w[2] * c[2].near);
    if (!(near > out_.near[at])) return;
    const kernel::Triangle& t = model_.mesh.faces()[f];
    const auto& p = model_.mesh.points();
    const Vec3 place = w[0] * p[t[0]] + w[1] * p[t[1]] + w[2] * p[t[2]];
    const auto mean = [&](Vec3 Corner::*member) {
      return w[0] * (c[0].*member) + w[1] * (c[1].*member) + w[2] * (c[2].*member);
    };
    const Vec3 eye = view_.towards_eye(place);
    Vec3 n = unit_vector(mean(&Corner::normal));
    if (dot(facing, eye) < 0) n = -1.0 * n;
    Vec3 rib = mean(&Corner::rib);
    rib = unit_vector(rib - dot(rib, facing) * facing);
    out_.near[at] = near;
    out_.face[at] = f;
    out_.normal[at] = {static_cast<float>(dot(n, view_.x)), static_cast<float>(dot(n, view_.y)),
                       static_cast<float>(-dot(n, view_.z))};
    out_.luminance[at] = static_cast<float>(std::min(
        1.0, 0.06 + 0.72 * std::max(0.0, dot(n, light_)) + 0.22 * std::max(0.0, dot(n, eye))));
    out_.curvature[at] = static_cast<float>(
        (w[0] * c[0].curvature + w[1] * c[1].curvature + w[2] * c[2].curvature) / view_.scale);
    out_.rib[at] = on_page(place, rib);
    out_.backbone[at] = on_page(place, cross(facing, rib));
  }

  const Model& model_;
  const View& view_;
  int first_, last_;
  Buffers& out_;
  Vec3 light_;
};

/// Means of the normals around a corner as far as they agree with its face's.
class CornerNormals {
 public:
  CornerNormals(const kernel::TriangleMesh& mesh, std::optional<double> crease)
      : mesh_(mesh), cosine_(crease ? std::cos(*crease * std::numbers::pi / 180) : -2) {
    for (const kernel::Triangle& t : mesh.faces()) {
      const auto& p = mesh.points();
      areas_.push_back(cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]));
      lengths_.push_back(norm(areas_.back()));
    }
  }
  std::array<Vec3, 3> of(Index f) const {
    std::array<Vec3, 3> normals;
    for (std::size_t k = 0; k < 3; ++k) {
      Vec3 sum{};
      for (const Index g : mesh_.fan(mesh_.faces()[f][k]))
        if (dot(areas_[f], areas_[g]) >= cosine_ * lengths_[f] * lengths_[g]) sum = sum + areas_[g];
      normals[k] = unit_vector(norm(sum) > 0 ? sum : areas_[f]);
    }
    return normals;
  }

 private:
  const kernel::TriangleMesh& mesh_;
  double cosine_;
  std::vector<Vec3> areas_;
  std::vector<double> lengths_;
};

constexpr int kRows = 32;  // of a strip

/// The faces that may reach each strip of the page.
std::vector<std::vector<Index>> by_strip(const kernel::TriangleMesh& mesh, const View& view,
                                         const Buffers& b) {
  std::vector<std::vector<Index>> strips(static_cast<std::size_t>((b.height + kRows - 1) / kRows));
  std::vector<double> row;
  for (const Vec3& p : mesh.points()) row.push_back(view.project(p)[1] / b.pixel);
  const auto strip = [&](double y) {
    const double last = static_cast<double>(strips.size()) - 1;
    return static_cast<std::size_t>(std::clamp(y / kRows, 0.0, last));
  };
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto& [u, v, w] = mesh.faces()[f];
    const auto [low, high] = std::minmax({row[u], row[v], row[w]});
    for (std::size_t k = strip(low - 1); k <= strip(high + 2); ++k) strips[k].push_back(f);
  }
  return strips;
}

/// By parts: a large page has gigabytes.
template <class T>
void fill(std::vector<T>& list, std::size_t count, const std::type_identity_t<T>& value) {
  constexpr std::size_t kPart = std::size_t{1} << 20;
  list.reserve(count);
  while (list.size() < count) {
    kernel::stop_point();
    list.insert(list.end(), std::min(kPart, count - list.size()), value);
  }
}

/// Marks the links between centres of neighbouring pixels that a barrier crosses.
void close_links(const Barriers& barriers, Buffers& b) {
  const auto mark = [&](std::size_t along, const Vec2& from, const Vec2& to) {
    // Lines of centres across `along`: rows if the links run along x.
    const std::size_t other = 1 - along;
    const int lines = other == 1 ? b.height : b.width, links = other == 1 ? b.width : b.height;
    const double low = std::min(from[other], to[other]) / b.pixel - 0.5;
    const double high = std::max(from[other], to[other]) / b.pixel - 0.5;
    for (int line = std::max(0, static_cast<int>(std::ceil(low)));
         line <= std::min(lines - 1, static_cast<int>(std::floor(high))); ++line) {
      const double span = to[other] - from[other];
      const double t = span != 0 ? ((line + 0.5) * b.pixel - from[other]) / span : 0;
      const double x = from[along] + t * (to[along] - from[along]);
      const int link = static_cast<int>(std::floor(x / b.pixel - 0.5));
      if (link < 0 || link >= links) continue;
      const std::size_t at =
          along == 0 ? static_cast<std::size_t>(line) * static_cast<std::size_t>(b.width) +
                           static_cast<std::size_t>(link)
                     : static_cast<std::size_t>(link) * static_cast<std::size_t>(b.width) +
                           static_cast<std::size_t>(line);
      b.closed[at] |= along == 0 ? 1 : 2;
    }
  };
  for (const Barrier& barrier : barriers.all()) {
    kernel::stop_point();
    mark(0, barrier.from, barrier.to);
    mark(1, barrier.from, barrier.to);
  }
}

}  // namespace

Buffers fill_buffers(const Model& model, const View& view, const Barriers& barriers,
                     const LightOptions& light, std::optional<double> crease) {
  Buffers b;
  b.width = static_cast<int>(std::ceil(view.page[0] / b.pixel));
  b.height = static_cast<int>(std::ceil(view.page[1] / b.pixel));
  const std::size_t n = static_cast<std::size_t>(b.width) * static_cast<std::size_t>(b.height);
  fill(b.face, n, kNone);
  fill(b.near, n, -std::numeric_limits<float>::infinity());
  fill(b.luminance, n, 1);
  fill(b.curvature, n, 0);
  fill(b.normal, n, {0, 0, 0});
  fill(b.rib, n, {0, 0});
  fill(b.backbone, n, {0, 0});
  fill(b.closed, n, 0);
  const CornerNormals normals(model.mesh, crease);
  // Pixels of a strip are one thread's: faces meet them in their own order.
  const auto strips = by_strip(model.mesh, view, b);
  kernel::parallel_for(std::size_t{0}, strips.size(), [&](std::size_t k) {
    const int first = static_cast<int>(k) * kRows;
    Painter painter(model, view, light, first, std::min(b.height, first + kRows), b);
    for (const Index f : strips[k]) painter.paint(f, normals.of(f));
  });
  close_links(barriers, b);
  return b;
}

}  // namespace crest::line_art
