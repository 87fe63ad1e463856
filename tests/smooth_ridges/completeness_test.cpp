// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/smooth_ridges/completeness.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "algorithms/smooth_ridges/chart.hpp"
#include "algorithms/smooth_ridges/initial_mesh.hpp"
#include "tests/smooth_ridges/samples.hpp"
#include "tests/support/random.hpp"

namespace crest::smooth_ridges {
namespace {

using Box = std::array<double, 6>;

/// Bisects until all charts hold.
void refine_to_charts(const Surface& surface, Triangulation& mesh) {
  Charts<kernel::TaylorModel<3>> charts(surface);
  for (int round = 0; round < 20; ++round) {
    std::vector<Index> failed;
    for (Index f = 0; f < mesh.faces().size(); ++f)
      if (!charts(mesh.corners(f))) failed.push_back(f);
    if (failed.empty()) return;
    mesh.refine(failed);
  }
  FAIL("charts do not come to hold");
}

/// Walks the tree; each leaf's claim is tried at random points of its cell.
class TreeWalk {
 public:
  TreeWalk(const Surface& surface, const Cover& cover)
      : f_(surface), surface_(surface), cover_(cover) {}
  void run() {
    walk(surface_.box());
    CHECK(at_ == cover_.tree.size());
    CHECK(leaves_ > 10);
  }

 private:
  void walk(const Box& b) {
    REQUIRE(at_ < cover_.tree.size());
    const std::uint8_t code = cover_.tree[at_++];
    if (code < 3) {
      Box lower = b, upper = b;
      lower[2u * code + 1] = upper[2u * code] = (b[2u * code] + b[2u * code + 1]) / 2;
      walk(lower);
      walk(upper);
      return;
    }
    ++leaves_;
    if (code == 6) return check_box(b);
    int signs = 0;
    for (int i = 0; i < 20; ++i) {
      Vec3 p{};
      for (std::size_t k = 0; k < 3; ++k)
        p[k] = std::uniform_real_distribution<double>(b[2 * k], b[2 * k + 1])(random_);
      const auto s = f_.sample(p);
      const double x = code == 3   ? s.value
                       : code == 4 ? dot(s.gradient, {8, -5, 2})
                                   : dot(s.gradient, {3, 7, -9});
      signs += x > 0 ? 1 : -1;
    }
    REQUIRE(std::abs(signs) == 20);
  }
  void check_box(const Box& b) {
    std::size_t j = 0;
    for (std::size_t i = 0; i < 4; ++i) j |= std::size_t{cover_.tree[at_++]} << (8 * i);
    REQUIRE(j < cover_.boxes.size());
    for (std::size_t k = 0; k < 6; k += 2) {
      REQUIRE(cover_.boxes[j].box[k] <= b[k]);
      REQUIRE(b[k + 1] <= cover_.boxes[j].box[k + 1]);
    }
  }

  Projection f_;
  const Surface& surface_;
  const Cover& cover_;
  crest::tests::Random random_{4};
  std::size_t at_ = 0, leaves_ = 0;
};

}  // namespace

TEST_CASE("closed surfaces are covered, met in each graph box, and have one sheet") {
  for (const Sample& sample : closed_samples()) {
    INFO(sample.name);
    CoverResult result = cover_box(sample.surface);
    REQUIRE(result.cover);
    CHECK_FALSE(result.failure);
    Cover& cover = *result.cover;
    TreeWalk(sample.surface, cover).run();
    // The height has a highest and a lowest point on each component.
    CHECK(cover.boxes.size() >= 2 * sample.components);
    CHECK(cover.boxes.size() % 2 == 0);
    Triangulation mesh = initial_mesh(sample.surface, 1000, {known_points(cover), {}});
    REQUIRE_FALSE(place_vertices(cover, mesh));
    for (const auto& record : cover.boxes)
      for (std::size_t k = 0; k < 3; ++k) {
        CHECK(mesh.vertices()[record.vertex][k] > record.box[2 * k]);
        CHECK(mesh.vertices()[record.vertex][k] < record.box[2 * k + 1]);
      }
    refine_to_charts(sample.surface, mesh);
    const OneSheet sheets = one_sheet(sample.surface, mesh);
    CHECK_FALSE(sheets.failed);
    REQUIRE(sheets.faces.size() == sample.components);
    // Skipped faces are not named.
    std::vector<std::uint8_t> skip(mesh.faces().size(), 0);
    for (const Index f : sheets.faces) skip[f] = 1;
    for (const Index f : one_sheet(sample.surface, mesh, skip).faces) CHECK(skip[f] == 0);
  }
}

TEST_CASE("surfaces that are not closed or not smooth are not covered") {
  const Box box = {-3, 3, -3, 3, -3, 3};
  const auto reason = [&](const std::string& f) {
    const CoverResult r = cover_box(Surface::implicit(f, box));
    CHECK_FALSE(r.cover);
    REQUIRE(r.failure);
    return *r.failure;
  };
  CHECK(reason("x^2+y^2-1").reason == CoverFailure::Reason::boundary);
  CHECK(reason("x^2+y^2-z^2").reason == CoverFailure::Reason::boundary);
  const CoverFailure tip = reason("x^2+y^2-z^2*(1-z^2)");
  CHECK(tip.reason == CoverFailure::Reason::singular);
  CHECK(norm(tip.where) < 1e-3);
  CHECK(cover_box(closed_samples()[2].surface, 100).failure->reason ==
        CoverFailure::Reason::undecided);
}

TEST_CASE("a mesh that lacks a component has no vertex for its graph boxes") {
  const Sample two = closed_samples()[3];
  CoverResult result = cover_box(two.surface);
  REQUIRE(result.cover);
  const Triangulation mesh = initial_mesh(two.surface, 500);
  const auto component = mesh.face_components();
  std::vector<Triangle> faces;
  for (Index f = 0; f < component.size(); ++f)
    if (component[f] == 0) faces.push_back(mesh.faces()[f]);
  std::vector<Index> number(mesh.vertices().size(), kNone);
  std::vector<Vertex> vertices;
  for (Triangle& f : faces)
    for (Index& v : f) {
      if (number[v] == kNone) {
        number[v] = static_cast<Index>(vertices.size());
        vertices.push_back(mesh.vertices()[v]);
      }
      v = number[v];
    }
  Triangulation one(vertices, faces, {}, edge_rules(two.surface));
  CHECK(place_vertices(*result.cover, one));
}

TEST_CASE("a mesh that covers a component twice has no face with one sheet") {
  const Sample sample = closed_samples()[0];
  Triangulation mesh = initial_mesh(sample.surface, 600);
  refine_to_charts(sample.surface, mesh);
  std::vector<Vertex> vertices = mesh.vertices();
  std::vector<Triangle> faces = mesh.faces();
  const Index shift = static_cast<Index>(vertices.size());
  for (Index v = 0; v < shift; ++v) vertices.push_back(Vertex(vertices[v]));
  for (const Triangle& f : mesh.faces())
    faces.push_back({f[0] + shift, f[1] + shift, f[2] + shift});
  CHECK(one_sheet(sample.surface, mesh).faces.size() == 1);
  CHECK(one_sheet(sample.surface, {vertices, faces, {}, edge_rules(sample.surface)}).failed);
}

}  // namespace crest::smooth_ridges
