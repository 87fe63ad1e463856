// SPDX-License-Identifier: GPL-3.0-or-later
// Hatches: blending, order of bands, tone of flat patches, fields, sidecar, the same bytes.
#include <tbb/global_control.h>

#include <catch2/catch.hpp>
#include <numbers>
#include <set>

#include "algorithms/line_art/certificate.hpp"
#include "algorithms/line_art/fishbone.hpp"
#include "algorithms/line_art/line_art.hpp"
#include "algorithms/line_art/steering.hpp"
#include "certify/lineart/encode.hpp"
#include "certify/verify.hpp"
#include "io/line_art/drawing_writer.hpp"
#include "io/line_art/sidecar.hpp"
#include "io/write/atomic_file.hpp"
#include "tests/line_art/drawn.hpp"
#include "tests/support/program.hpp"

using namespace crest;
using namespace crest::line_art;
using namespace crest::tests;
using kernel::norm;
using kernel::operator-;

namespace {

RibSide draw_side(Draw& d, int edges) {
  RibSide side{3 * d.uniform(), {}};
  for (int i = 1; i < edges; ++i) side.turns.push_back(0.1 * d.uniform());
  return side;
}

kernel::TriangleMesh mesh_of(const Scene& scene) {
  return {scene.points, scene.faces};
}

kernel::TriangleMesh ring(int m, int n) {
  return mesh_of(revolved(m, n, true, [](double u, double v) {
                   const double r = 3 + std::cos(v);
                   return Vec3{r * std::cos(u), r * std::sin(u), std::sin(v)};
                 }).scene());
}

}  // namespace

TEST_CASE("Blended ribs are the key ribs at both ends, with edges of one length between") {
  Draw d(21);
  for (int i = 0; i < 50; ++i) {
    const RibSide a = draw_side(d, 12 + i % 5), b = draw_side(d, 15);
    const Vec2 start = {d.uniform(), d.uniform()};
    const auto ends = [&](const RibSide& key, double t) {
      const auto x = rib_points(start, key, 0.2), y = rib_points(start, blend(a, b, t), 0.2);
      REQUIRE(x.size() <= y.size());
      double most = 0;
      for (std::size_t k = 0; k < x.size(); ++k) most = std::max(most, norm(x[k] - y[k]));
      return most;
    };
    CHECK(ends(a, 0) < 1e-12);
    CHECK(ends(b, 1) < 1e-12);
    const auto middle = rib_points(start, blend(a, b, 0.4), 0.2);
    for (std::size_t k = 1; k < middle.size(); ++k)
      CHECK(norm(middle[k] - middle[k - 1]) == Approx(0.2).epsilon(1e-12));
    const RibSide again = side_of(middle, 0.2);
    CHECK(again.turns.size() + 2 == middle.size());
  }
  // The shorter list borrows the longer's tail.
  const RibSide g = blend({0, {0.1}}, {0, {0.3, 0.2, 0.2}}, 0.5);
  CHECK(g.turns == std::vector<double>{0.2, 0.2, 0.2});
}

TEST_CASE("Bands are painted level by level, each once") {
  for (Index n = 1; n <= 100; ++n) {
    const auto order = bit_reversed(n);
    REQUIRE(order.size() == n);
    REQUIRE(std::set<Index>(order.begin(), order.end()).size() == n);
  }
  CHECK(bit_reversed(8) == std::vector<Index>{0, 4, 2, 6, 1, 5, 3, 7});
  CHECK(bit_reversed(5) == std::vector<Index>{0, 4, 2, 1, 3});
}

TEST_CASE("A Coons patch goes through its curves") {
  const std::array<std::vector<Vec2>, 4> curves = {
      {{{0, 0}, {2, -1}, {4, 0}}, {{4, 0}, {5, 2}, {4, 4}}, {{0, 4}, {4, 4}}, {{0, 0}, {0, 4}}}};
  for (const double t : {0.0, 0.25, 0.5, 1.0}) {
    CHECK(coons_point(curves, 1, t).place[0] >= 4 - 1e-12);
    CHECK(coons_point(curves, 0, t).place[0] == Approx(0).margin(1e-12));
    CHECK(coons_point(curves, t, 1).place[1] == Approx(4));
    CHECK(coons_point(curves, t, 0).place[1] <= 1e-12);
    const double h = 1e-5, u = 0.3;
    const Vec2 slope = coons_point(curves, u + h, t).place - coons_point(curves, u - h, t).place;
    CHECK(coons_point(curves, u, t).along_u[0] == Approx(slope[0] / (2 * h)).epsilon(1e-4));
  }
}

TEST_CASE("Indices of a smoothed field sum to the Euler characteristic") {
  for (const bool cross : {false, true}) {
    FieldOptions options;
    options.cross = cross;
    options.spacing = 0.1;
    options.smooth = 0.3;
    const auto ball = mesh_of(sphere_scene(12, 18));
    const DirectionField on_ball = direction_field(ball, frames_of(ball), options);
    CHECK(on_ball.index_sum == 2 * on_ball.symmetry);
    CHECK_FALSE(on_ball.singular.empty());
    const auto torus = ring(20, 12);
    const DirectionField on_torus = direction_field(torus, frames_of(torus), options);
    CHECK(on_torus.index_sum == 0);
    CHECK(on_torus.singular.empty());
  }
}

TEST_CASE("Inks of flat patches are those wanted, in bands and widths") {
  // A page of parallel strokes at the spacing, no surface needed.
  // Up to where the thinnest stroke is the ink wanted.
  for (const double c : {0.1, 0.35, 0.5, 0.65, 0.8, 0.93}) {
    Buffers b;
    b.width = b.height = 300;
    const std::size_t n = 300 * 300;
    b.face.assign(n, 0);
    b.luminance.assign(n, static_cast<float>(c));
    b.closed.assign(n, 0);
    ToneOptions options;
    std::vector<Hatch> hatches;
    for (double y = 0.4; y < 36; y += options.spacing) {
      Hatch h;
      h.free_start = h.free_end = false;
      for (double x = 0.1; x < 36; x += 0.2) h.stroke.points.push_back({x, y});
      hatches.push_back(h);
    }
    const auto ink = layer_ink(b, options);
    const OwnedArea owned = owned_area(b, hatches, 1.5 * options.spacing);
    std::vector<Hatch> wide = hatches, bands = hatches;
    set_widths(b, {{wide, ink, owned}}, options);
    const auto error = [&](const std::vector<Hatch>& lines) {
      return tone_error(tone_cells(b, coverage(b, lines), ink, owned, options.spacing));
    };
    const ToneError by_width = error(wide);
    CHECK(by_width.cells.size() > 50);
    CHECK(by_width.mean < 0.01);
    CHECK(by_width.max < 0.05);
    set_bands(b, ink, options, bands);
    const ToneError by_bands = error(bands);
    CHECK(by_bands.mean < 0.02);
  }
}

TEST_CASE("A drawing's hatches keep off contours, and its certificate holds") {
  for (const HatchStyle style : {HatchStyle::fishbone, HatchStyle::streamlines}) {
    HatchOptions options;
    options.style = style;
    options.cross_hatch = true;
    const Drawing drawing = draw(ring(30, 16), {1, 0.8, 1.2}, options, 100);
    CHECK(drawing.counts.over_contours == 0);
    CHECK(drawing.hatches.size() > 50);
    const ToneError& tone = drawing.counts.tone;
    CHECK(tone.cells.size() > 50);
    CHECK(tone.mean < 0.01);
    CHECK(tone.p95 < 0.035);
    CHECK(tone.max < 0.1);
    const auto verdict = certify::verify(certify::encode(line_art_record(drawing)));
    CHECK(verdict.reason == "");
    CHECK(verdict.accepted);
  }
}

TEST_CASE(
    "A drawing's bytes do not depend on the number of threads, and a sidecar makes it again") {
  const auto mesh = ring(24, 14);
  HatchOptions options;
  options.cross_field = options.cross_hatch = true;
  const Drawing drawing = draw(mesh, {1, 0.8, 1.2}, options);
  std::string svg = io::svg_of(drawing), pdf = io::pdf_of(drawing), eps = io::eps_of(drawing);
  for (const std::size_t threads : {1, 2, 5}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const Drawing again = draw(mesh, {1, 0.8, 1.2}, options);
    CHECK(io::svg_of(again) == svg);
    CHECK(io::pdf_of(again) == pdf);
    CHECK(io::eps_of(again) == eps);
    CHECK(io::sidecar_of(again) == io::sidecar_of(drawing));
  }
  const TemporaryFolder folder;
  const std::string path = (folder / "sidecar.json").string();
  io::write_atomically(path, io::sidecar_of(drawing));
  options.steering = io::read_sidecar(path, drawing.view);
  CHECK(options.steering.segments.size() == drawing.segments.size());
  const Drawing steered = draw(mesh, {1, 0.8, 1.2}, options);
  CHECK(io::svg_of(steered) == svg);
  options.tone_style = ToneStyle::bands;
  CHECK(draw(mesh, {1, 0.8, 1.2}, options).counts.bare == drawing.counts.bare);
  const Drawing other = draw(mesh, {1, 0.9, 1.2}, {});
  CHECK_THROWS_WITH(io::read_sidecar(path, other.view), Catch::Contains("of another view"));
}

TEST_CASE("Random strokes are as many as full black needs, drawn over 1 - c of their length") {
  Drawing nothing;
  nothing.view.page = {60, 60};
  const Barriers none(nothing.scene, nothing.view, nothing.contours);
  const ToneOptions options;
  const double most = 10 * options.spacing, width = 0.35 * options.spacing;
  for (const double c : {0.1, 0.35, 0.5, 0.65, 0.8, 0.96}) {
    Buffers b;
    b.width = b.height = 500;
    const std::size_t n = 500 * 500;
    b.face.assign(n, 0);
    b.luminance.assign(n, static_cast<float>(c));
    b.closed.assign(n, 0);
    b.normal.assign(n, {0, 0, 1});
    b.rib.assign(n, {1, 0});
    b.backbone.assign(n, {0, 1});
    const auto lines =
        random_streamlines({b, none, {}, options.spacing, false}, options.brightest, width);
    if (c > options.brightest) {
      CHECK(lines.empty());
      continue;
    }
    std::size_t inside = 0;
    double length = 0;
    for (const Hatch& h : lines) {
      const auto& p = h.stroke.points;
      if (std::min(p.front()[0], p.back()[0]) < 9 || std::max(p.front()[0], p.back()[0]) > 51)
        continue;
      ++inside;
      length += h.stroke.length();
    }
    REQUIRE(inside > 500);
    CHECK(std::abs(length / static_cast<double>(inside) - most * (1 - c)) < 2 * Tracer::kStep);
    CHECK(static_cast<double>(lines.size()) * most * width == Approx(60.0 * 60).epsilon(0.02));
  }
}
