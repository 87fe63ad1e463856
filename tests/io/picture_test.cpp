// SPDX-License-Identifier: GPL-3.0-or-later
// Cameras and words in pictures.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "io/picture/camera.hpp"
#include "io/picture/lettering.hpp"
#include "io/picture/standing.hpp"
#include "kernel/geometry/input_error.hpp"

namespace {

using namespace crest::io;
using crest::kernel::Triangle;
using crest::kernel::Vec3;

struct Shape {
  std::vector<Vec3> points;
  std::vector<Triangle> faces;
  SurfaceView view() const { return {points, faces}; }
};

/// Legs at four corners, a body between, and a back that is a line; the third axis is up, the body
/// leans forwards, so that its principal axes are not the file's.
Shape animal(std::size_t right, std::size_t up) {
  Shape shape;
  const auto add = [&](double along, double across, double height) {
    Vec3 p{};
    p[3 - right - up] = along;
    p[right] = across;
    p[up] = height;
    shape.points.push_back(p);
  };
  for (const double along : {-1.0, 1.0})
    for (const double across : {-0.3, 0.3}) {
      add(along, across, 0);
      add(along, across, 1 + 0.4 * along);
    }
  add(-1, 0, 1);
  add(1.4, 0, 2.4);
  for (const Triangle& f : {Triangle{0, 2, 1},
                            {1, 2, 3},
                            {4, 6, 5},
                            {5, 6, 7},
                            {1, 3, 5},
                            {5, 3, 7},
                            {1, 5, 8},
                            {8, 5, 9},
                            {3, 8, 7},
                            {8, 9, 7},
                            {5, 7, 9}})
    shape.faces.push_back(f);
  return shape;
}

Shape ball() {
  Shape shape;
  for (int i = 0; i < 4000; ++i) {
    const double z = 1 - 2 * (i + 0.5) / 4000, r = std::sqrt(1 - z * z), t = 2.399963 * i;
    shape.points.push_back({r * std::cos(t), r * std::sin(t), z});
  }
  return shape;
}

}  // namespace

TEST_CASE("a shape stands on its feet, along whichever axis of the file", "[io]") {
  for (const std::array<std::size_t, 2> axes : {std::array<std::size_t, 2>{0, 2}, {2, 1}, {1, 0}}) {
    Vec3 up{};
    up[axes[1]] = 1;
    const Shape shape = animal(axes[0], axes[1]);
    CHECK(standing_direction(shape.view()) == up);
    const Camera camera = make_camera(shape.view(), {}, 400);
    CHECK(dot(camera.up, up) > 0.8);
    Shape moved = shape;  // to where doubles are coarse
    for (Vec3& p : moved.points)
      for (double& x : p) x += 1e9;
    CHECK(standing_direction(moved.view()) == up);
    for (Vec3& p : moved.points)  // on its back
      for (double& x : p) x = -x;
    CHECK(standing_direction(moved.view()) != up);
  }
  CHECK_FALSE(standing_direction(ball().view()));
  CHECK_FALSE(standing_direction(Shape{}.view()));
  CHECK_FALSE(standing_direction(Shape{{{1, 2, 3}}, {}}.view()));
}

TEST_CASE("cameras stand where they are told to", "[io]") {
  const Shape shape = animal(0, 2);
  const Vec3 view = {1, 2, -0.5}, up = {0, 1, 0.2};
  const Camera seen = make_camera(shape.view(), {view, {}}, 400);
  CHECK(dot(seen.forward, view) == Approx(std::sqrt(dot(view, view))));
  CHECK(seen.right[2] == Approx(0).margin(1e-12));  // up is the shape's
  const Camera turned = make_camera(shape.view(), {view, up}, 400);
  CHECK(dot(turned.right, up) == Approx(0).margin(1e-12));
  CHECK(dot(turned.up, up) > 0);
  const Camera chosen = make_camera(shape.view(), {{}, up}, 400);
  CHECK(dot(chosen.right, up) == Approx(0).margin(1e-12));
  CHECK(dot(chosen.forward, up) < 0);  // from above
  // Along the way the shape stands: another vertical.
  CHECK(make_camera(shape.view(), {Vec3{0, 0, -1}, {}}, 400).up == Vec3{0, 1, 0});
  for (const Camera& c : {seen, turned, chosen}) {
    for (const Vec3& p : shape.points) {
      const Vec3 at = c.project(p);
      CHECK(at[0] > 0);
      CHECK(at[0] < c.width);
      CHECK(at[1] > 0);
      CHECK(at[1] < c.height);
    }
  }
  check_viewpoint({});
  check_viewpoint({view, up});
  const double nan = std::nan("");
  for (const Viewpoint& wrong :
       {Viewpoint{Vec3{}, {}}, Viewpoint{{}, Vec3{}}, Viewpoint{Vec3{nan, 1, 0}, {}},
        Viewpoint{Vec3{0, 0, 1}, Vec3{0, 0, -2}}, Viewpoint{{}, Vec3{HUGE_VAL, 0, 0}}})
    CHECK_THROWS_AS(check_viewpoint(wrong), crest::kernel::InputError);
}

TEST_CASE("words have a width and stay in it", "[io]") {
  CHECK(text_width("", 12) == 0);
  CHECK(text_width("umbilic", 24) == Approx(2 * text_width("umbilic", 12)));
  CHECK(text_width("wide", 12) > text_width("thin", 12));
  const auto written = [](double x, double y, const std::string& text) {
    Canvas canvas(200, 40);
    draw_text(canvas, x, y, 16, text);
    return canvas;
  };
  const std::string empty = Canvas(200, 40).png();
  CHECK(written(10, 30, "").png() == empty);
  CHECK(written(10, 30, "graph").png() != empty);
  CHECK(written(10, 30, "graph").png() == written(10, 30, "graph").png());
  CHECK(written(250, 30, "graph").png() == empty);  // outside
  CHECK(written(10, 300, "graph").png() == empty);
  CHECK(written(-20, 2, "graph").png() != empty);  // in part
  // White over all but where the words are: nothing is left.
  Canvas canvas = written(10, 30, "graph Q,3");
  canvas.fill_box(10, 10, 10 + text_width("graph Q,3", 16) + 1, 36, {255, 255, 255});
  CHECK(canvas.png() == empty);
}
