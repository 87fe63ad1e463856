// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/extremal/extremal_picture.hpp"

#include <algorithm>
#include <cmath>

#include "io/page/scene.hpp"
#include "io/picture/picture_file.hpp"

namespace crest::io {
namespace {

using extremal::Reason;
using extremal::Result;
using kernel::Index;
using kernel::Vec3;
using kernel::operator-;

/// Triangles with points of their own: at each the normal, which has no sign, is on the triangle's
/// side.
struct Triangles {
  std::vector<Vec3> points, normals, tints;
  std::vector<kernel::Triangle> faces;
};

constexpr Vec3 kMerelyCritical = {0.66, 0.66, 0.68};

/// From blue (columns, 1/2) over sand to red (plates, 1).
Vec3 tint_of(double plateness) {
  constexpr Vec3 stops[3] = {{0.42, 0.58, 0.92}, {0.98, 0.90, 0.66}, {0.93, 0.32, 0.22}};
  const double t = 4 * std::clamp(plateness, 0.5, 1.0) - 2;
  const std::size_t i = t < 1 ? 0 : 1;
  const double share = t - static_cast<double>(i);
  return combine(1 - share, stops[i], share, stops[i + 1]);
}

/// The mean of the polygons round each point.
std::vector<Vec3> point_tints(const Result& r) {
  std::vector<Vec3> sums(r.points.size(), Vec3{});
  std::vector<double> counts(r.points.size(), 0);
  for (std::size_t p = 0; p < r.polygons(); ++p) {
    if (r.critical_type[p] != 1) continue;
    const Vec3 tint = tint_of(r.plateness[p]);
    for (Index i = r.first[p]; i < r.first[p + 1]; ++i) {
      sums[r.corners[i]] = combine(1, sums[r.corners[i]], 1, tint);
      ++counts[r.corners[i]];
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v)
    for (double& x : sums[v]) x /= std::fmax(counts[v], 1);
  return sums;
}

Triangles triangles_of(const Result& r) {
  const std::vector<Vec3> tints = point_tints(r);
  Triangles all;
  for (std::size_t p = 0; p < r.polygons(); ++p) {
    const Index* corners = r.corners.data() + r.first[p];
    const std::size_t count = r.first[p + 1] - r.first[p];
    // Of a quadrilateral the shorter diagonal.
    const auto apart = [&](std::size_t a, std::size_t b) {
      const Vec3 d = r.points[corners[a]] - r.points[corners[b]];
      return dot(d, d);
    };
    const std::size_t apex = count == 4 && apart(1, 3) < apart(0, 2) ? 1 : 0;
    for (std::size_t i = 1; i + 1 < count; ++i) {
      const Index v[3] = {corners[apex], corners[(apex + i) % count],
                          corners[(apex + i + 1) % count]};
      const Vec3 side = cross(r.points[v[1]] - r.points[v[0]], r.points[v[2]] - r.points[v[0]]);
      const auto first = static_cast<Index>(all.points.size());
      for (const Index x : v) {
        const Vec3& n = r.normals[x];
        all.points.push_back(r.points[x]);
        all.normals.push_back(dot(n, side) < 0 ? combine(-1, n, 0, n) : n);
        all.tints.push_back(r.critical_type[p] == 1 ? tints[x] : kMerelyCritical);
      }
      all.faces.push_back({first, first + 1, first + 2});
    }
  }
  return all;
}

/// In the order of painting.
constexpr struct {
  Reason reason;
  const char* label;
  Rgb colour;
  double width;
} kReasons[] = {{Reason::trim, "cut at the threshold", {70, 70, 78}, 0.5},
                {Reason::border, "end of the data", {120, 120, 130}, 0.5},
                {Reason::inflection, "inflection", {20, 130, 60}, 1},
                {Reason::discontinuity, "singularity of n", {20, 40, 160}, 1.3},
                {Reason::undecided, "undecided", {200, 0, 170}, 1.3}};

void add_features(const Result& r, const Camera& camera, const Canvas& canvas, Drawing& drawing) {
  for (const auto& reason : kReasons) {
    drawing.classes.push_back(
        {.label = reason.label, .colour = reason.colour, .strokes = {}, .width = reason.width});
    StrokeMaker strokes(camera, canvas, drawing);
    for (const extremal::Feature& f : r.features) {
      if (f.reason != reason.reason || f.a == f.b) continue;
      drawing.classes.back().in_graph = true;
      strokes.add(r.points[f.a], r.points[f.b], drawing.classes.size() - 1);
      strokes.end();
    }
  }
}

/// Lines no wider than a part of their edges: rims of small sheets are not to hide these.
void thin_lines(const Result& r, const Camera& camera, Drawing& drawing) {
  double length = 0;
  for (const extremal::Feature& f : r.features) {
    const Vec3 d = r.points[f.a] - r.points[f.b];
    length += camera.scale * std::sqrt(dot(d, d));
  }
  if (r.features.empty()) return;
  const double mean = length / static_cast<double>(r.features.size());
  drawing.stroke_width = std::clamp(0.15 * mean, 0.8, drawing.stroke_width);
  drawing.casing_width = drawing.stroke_width;
}

/// Where places of the world lie in a picture of an image, its first row at the top.
class ImageFrame {
 public:
  ImageFrame(const kernel::SampledGrid& image, int width) : image_(image) {
    const double least = std::min(image.spacing[0], image.spacing[1]);
    for (std::size_t k = 0; k < 2; ++k) pixel_[k] = image.spacing[k] / least;
    const double columns = static_cast<double>(image.size[0]) * pixel_[0];
    scale_ = std::max(1.0, std::floor(width / columns));
    for (double& x : pixel_) x *= scale_;
  }
  int width() const {
    return static_cast<int>(std::ceil(static_cast<double>(image_.size[0]) * pixel_[0]));
  }
  int height() const {
    return static_cast<int>(std::ceil(static_cast<double>(image_.size[1]) * pixel_[1]));
  }
  double pixel(std::size_t axis) const { return pixel_[axis]; }
  double scale() const { return scale_; }
  Vec3 place(const Vec3& p) const {
    const Vec3 d = p - image_.origin;
    Vec3 at{};
    for (std::size_t k = 0; k < 2; ++k)
      at[k] = (dot(d, image_.directions[k]) / image_.spacing[k] + 0.5) * pixel_[k];
    return at;
  }

 private:
  const kernel::SampledGrid& image_;
  double pixel_[2] = {1, 1}, scale_ = 1;
};

/// Greys from the least sample to the largest, lightened so that curves stand out.
void draw_image(const kernel::SampledGrid& image, const ImageFrame& frame, Canvas& canvas) {
  double low = image.at(0), high = low;
  for (std::size_t i = 0; i < image.count(); ++i) {
    low = std::fmin(low, image.at(i));
    high = std::fmax(high, image.at(i));
  }
  for (std::size_t y = 0; y < image.size[1]; ++y)
    for (std::size_t x = 0; x < image.size[0]; ++x) {
      const double share =
          high > low ? (image.at(y * image.size[0] + x) / 2 - low / 2) / (high / 2 - low / 2) : 0.5;
      const auto grey = static_cast<std::uint8_t>(70 + 180 * share);
      const double left = static_cast<double>(x) * frame.pixel(0);
      const double top = static_cast<double>(y) * frame.pixel(1);
      canvas.fill_box(left, top, left + frame.pixel(0), top + frame.pixel(1), {grey, grey, grey});
    }
}

/// Quadrilaterals in two, with the polygon behind each triangle.
SceneSurface page_surface(const Result& r) {
  SceneSurface surface{"extremal surface", r.points, {}};
  SceneField plateness{"plateness", {}, true}, strength{"strength", {}, true},
      component{"component", {}, true, ColourMap::labels},
      type{"extremal (0: merely critical)", {}, true};
  for (std::size_t p = 0; p < r.polygons(); ++p) {
    for (Index i = r.first[p] + 1; i + 1 < r.first[p + 1]; ++i) {
      surface.faces.push_back({r.corners[r.first[p]], r.corners[i], r.corners[i + 1]});
      plateness.values.push_back(r.plateness[p]);
      strength.values.push_back(r.strength[p]);
      component.values.push_back(r.component[p]);
      type.values.push_back(r.critical_type[p]);
    }
  }
  surface.fields = {plateness, strength, component, type};
  return surface;
}

SceneLayer rim_layer(const Result& r) {
  SceneLayer layer{"Edges where the surface ends or meets", {}};
  for (const auto& reason : kReasons)
    layer.kinds.push_back({reason.label, reason.colour, reason.width});
  for (const extremal::Feature& f : r.features) {
    layer.add_item();
    const auto* reason = std::find_if(std::begin(kReasons), std::end(kReasons),
                                      [&](const auto& k) { return k.reason == f.reason; });
    const auto kind = static_cast<std::uint32_t>(reason - std::begin(kReasons));
    if (f.a == f.b)
      layer.add_run(kind, {&r.points[f.a], 1});
    else
      layer.add_run(kind, std::array{r.points[f.a], r.points[f.b]});
  }
  return layer;
}

/// Of an image.
SceneLayer curve_layer(const Result& r) {
  SceneLayer layer{"Curves",
                   {{"merely critical", {40, 90, 220}}, {"extremal", {215, 30, 25}}},
                   {{"strength", "strength"}}};
  for (std::size_t p = 0; p < r.polygons(); ++p) {
    Columns& row = layer.add_item();
    row.add("strength", r.strength[p]);
    row.add("component", static_cast<int>(r.component[p]));
    const Index* corners = r.corners.data() + r.first[p];
    layer.add_run(r.critical_type[p], std::array{r.points[corners[0]], r.points[corners[1]]});
  }
  return layer;
}

/// Samples as vertices, every so many that there are at most 512 a side.
SceneSurface image_surface(const kernel::SampledGrid& image) {
  SceneSurface surface{"image", {}, {}};
  const std::size_t longest = std::max(image.size[0], image.size[1]);
  const std::size_t step = (longest + 511) / 512;
  const std::size_t columns = (image.size[0] - 1) / step + 1, rows = (image.size[1] - 1) / step + 1;
  SceneField grey{"samples", {}, false, ColourMap::grey};
  for (std::size_t y = 0; y < rows; ++y)
    for (std::size_t x = 0; x < columns; ++x) {
      surface.points.push_back(
          image.to_world({static_cast<double>(x * step) * image.spacing[0],
                          static_cast<double>(y * step) * image.spacing[1], 0}));
      grey.values.push_back(image.at(y * step * image.size[0] + x * step));
    }
  const auto corner = [&](std::size_t x, std::size_t y) {
    return static_cast<Index>(y * columns + x);
  };
  for (std::size_t y = 0; y + 1 < rows; ++y)
    for (std::size_t x = 0; x + 1 < columns; ++x) {
      surface.faces.push_back({corner(x, y), corner(x + 1, y), corner(x + 1, y + 1)});
      surface.faces.push_back({corner(x, y), corner(x + 1, y + 1), corner(x, y + 1)});
    }
  surface.fields.push_back(std::move(grey));
  return surface;
}

}  // namespace

void write_extremal_picture(const std::string& path, const Result& result,
                            const Viewpoint& viewpoint) {
  check_picture_path(path);
  check_viewpoint(viewpoint);
  const Triangles all = triangles_of(result);
  const SurfaceView view(all.points, all.faces);
  const Camera camera = make_camera(view, viewpoint, 1200);
  Canvas canvas(camera.width, camera.height);
  canvas.draw_surface(camera, view, all.normals, &all.tints);
  Drawing drawing;
  add_features(result, camera, canvas, drawing);
  set_sizes(camera, drawing);
  thin_lines(result, camera, drawing);
  add_class_legend(drawing);
  write_drawing(path, camera, canvas, drawing, true);
}

void write_extremal_picture(const std::string& path, const Result& result,
                            const kernel::SampledGrid& image) {
  check_picture_path(path);
  const ImageFrame frame(image, 1200);
  Canvas canvas(frame.width(), frame.height());
  draw_image(image, frame, canvas);
  const double width = std::clamp(0.5 * frame.scale(), 1.2, 4.0);
  for (const bool extremal : {false, true})
    for (std::size_t p = 0; p < result.polygons(); ++p) {
      if ((result.critical_type[p] == 1) != extremal) continue;
      const Index* corners = result.corners.data() + result.first[p];
      canvas.draw_stroke(frame.place(result.points[corners[0]]),
                         frame.place(result.points[corners[1]]), width,
                         extremal ? Rgb{215, 30, 25} : Rgb{40, 90, 220});
    }
  for (const extremal::Feature& f : result.features)
    if (f.reason == Reason::discontinuity)
      canvas.fill_disk(frame.place(result.points[f.a]), 1.5 * width, {250, 190, 0});
  write_canvas(path, canvas, frame.width(), frame.height());
}

Scene extremal_scene(const Result& result, const kernel::SampledGrid* image,
                     const Viewpoint& viewpoint) {
  Scene scene{image ? "Extremal curves" : "Extremal surface"};
  if (image) {
    scene.flat = true;
    scene.surfaces.push_back(image_surface(*image));
    const Vec3 down = image->directions[1];
    scene.camera = Camera{image->directions[0],
                          combine(-1, down, 0, down),
                          cross(image->directions[0], down),
                          {},
                          1,
                          1200,
                          1200};
    scene.layers = {curve_layer(result), rim_layer(result)};
    return scene;
  }
  scene.surfaces.push_back(page_surface(result));
  const SceneSurface& surface = scene.surfaces.front();
  if (!surface.faces.empty())
    scene.camera = make_camera(SurfaceView(surface.points, surface.faces), viewpoint, 1200);
  scene.layers = {rim_layer(result)};
  return scene;
}

}  // namespace crest::io
