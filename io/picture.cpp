// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/picture.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "io/atomic_file.hpp"
#include "io/camera.hpp"
#include "io/drawing.hpp"
#include "io/formats.hpp"
#include "io/rasteriser.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {
namespace {

constexpr Colour kRim = {0, 0, 0};

/// Where the legend's parts go, in pixels, for both media.
struct LegendLayout {
  double dot, line, left, top, width, height;
  LegendLayout(const Drawing& drawing, const Camera& camera)
      : dot(std::max(1.0, std::round(camera.width / 700.0))), line(14 * dot), left(8 * dot) {
    double longest = 0;
    for (const LegendEntry& entry : drawing.legend) {
      longest = std::max(longest, text_width(entry.label));
    }
    width = dot * (longest + 44);
    height = line * static_cast<double>(drawing.legend.size()) + 8 * dot;
    top = camera.height - height - 8 * dot;
  }
  double baseline(std::size_t i) const {
    return top + 4 * dot + line * (static_cast<double>(i) + 0.5);
  }
};

void paint_legend(Canvas& canvas, const Drawing& drawing, const Camera& camera) {
  if (drawing.legend.empty()) return;
  const LegendLayout at(drawing, camera);
  canvas.fill_box(at.left, at.top, at.left + at.width, at.top + at.height, {255, 255, 255}, 0.85);
  for (std::size_t i = 0; i < drawing.legend.size(); ++i) {
    const LegendEntry& entry = drawing.legend[i];
    const double y = at.baseline(i), x0 = at.left + 6 * at.dot, x1 = at.left + 30 * at.dot;
    if (entry.dot) {
      canvas.fill_disk({0.5 * (x0 + x1), y, 0}, drawing.dot_radius, kRim);
      canvas.fill_disk({0.5 * (x0 + x1), y, 0}, 0.7 * drawing.dot_radius, entry.colour);
    } else {
      canvas.draw_stroke({x0, y, 0}, {x1, y, 0}, drawing.casing_width, casing(entry.colour), 1);
      canvas.draw_stroke({x0, y, 0}, {x1, y, 0}, drawing.stroke_width, entry.colour, 1);
    }
    draw_text(canvas, at.left + 36 * at.dot, y - 4 * at.dot, at.dot, entry.label);
  }
}

void paint(Canvas& canvas, const Drawing& drawing) {
  for (const StrokeClass& c : drawing.classes) {
    for (const bool rim : {true, false}) {
      for (const auto& stroke : c.strokes) {
        for (std::size_t i = 0; i + 1 < stroke.size(); ++i) {
          canvas.draw_stroke(stroke[i], stroke[i + 1],
                             rim ? drawing.casing_width : drawing.stroke_width,
                             rim ? casing(c.colour) : c.colour, 1);
        }
      }
    }
  }
  for (const Dot& dot : drawing.dots) {
    canvas.fill_disk(dot.centre, drawing.dot_radius, kRim);
    canvas.fill_disk(dot.centre, 0.7 * drawing.dot_radius, dot.colour);
  }
}

std::string base64(const std::string& bytes) {
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');
  const int length = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                                     reinterpret_cast<const unsigned char*>(bytes.data()),
                                     static_cast<int>(bytes.size()));
  text.resize(static_cast<std::size_t>(length));
  return text;
}

std::string hex(Colour c) {
  return fmt::format("#{:02x}{:02x}{:02x}", c.red, c.green, c.blue);
}

std::string path_data(const std::vector<std::vector<kernel::Vec3>>& strokes) {
  std::string data;
  for (const auto& stroke : strokes) {
    for (std::size_t i = 0; i < stroke.size(); ++i) {
      fmt::format_to(std::back_inserter(data), "{}{:.2f} {:.2f}", i == 0 ? "M" : "L", stroke[i][0],
                     stroke[i][1]);
    }
  }
  return data;
}

std::string svg_dot(double x, double y, double radius, Colour colour) {
  return fmt::format(
      "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" fill=\"{}\" stroke=\"{}\" "
      "stroke-width=\"{:.2f}\"/>\n",
      x, y, 0.85 * radius, hex(colour), hex(kRim), 0.3 * radius);
}

std::string svg_legend(const Drawing& drawing, const Camera& camera) {
  if (drawing.legend.empty()) return {};
  const LegendLayout at(drawing, camera);
  std::string svg = fmt::format(
      "<g font-family=\"Helvetica, Arial, sans-serif\" font-size=\"{:.1f}\" fill=\"#28282c\">\n"
      "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"#ffffff\" "
      "fill-opacity=\"0.85\"/>\n",
      10.5 * at.dot, at.left, at.top, at.width, at.height);
  for (std::size_t i = 0; i < drawing.legend.size(); ++i) {
    const LegendEntry& entry = drawing.legend[i];
    const double y = at.baseline(i), x0 = at.left + 6 * at.dot, x1 = at.left + 30 * at.dot;
    if (entry.dot) {
      svg += svg_dot(0.5 * (x0 + x1), y, drawing.dot_radius, entry.colour);
    } else {
      for (const bool rim : {true, false}) {
        svg += fmt::format(
            "<path d=\"M{:.2f} {:.2f}L{:.2f} {:.2f}\" stroke=\"{}\" stroke-width=\"{:.2f}\" "
            "stroke-linecap=\"round\"/>\n",
            x0, y, x1, y, hex(rim ? casing(entry.colour) : entry.colour),
            rim ? drawing.casing_width : drawing.stroke_width);
      }
    }
    svg += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\">{}</text>\n", at.left + 36 * at.dot,
                       y + 3.6 * at.dot, entry.label);
  }
  return svg + "</g>\n";
}

std::string svg_of(const Canvas& surface, const Drawing& drawing, const Camera& camera,
                   bool legend) {
  std::string svg = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
      "width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n"
      "<image width=\"{0}\" height=\"{1}\" xlink:href=\"data:image/png;base64,{2}\"/>\n"
      "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n",
      camera.width, camera.height, base64(surface.png()));
  for (const StrokeClass& c : drawing.classes) {
    if (c.strokes.empty()) continue;
    const std::string data = path_data(c.strokes);
    for (const bool rim : {true, false}) {
      svg += fmt::format("<path stroke=\"{}\" stroke-width=\"{:.2f}\" d=\"{}\"/>\n",
                         hex(rim ? casing(c.colour) : c.colour),
                         rim ? drawing.casing_width : drawing.stroke_width, data);
    }
  }
  svg += "</g>\n";
  for (const Dot& dot : drawing.dots) {
    svg += svg_dot(dot.centre[0], dot.centre[1], drawing.dot_radius, dot.colour);
  }
  if (legend) svg += svg_legend(drawing, camera);
  return svg + "</svg>\n";
}

void check(const std::string& path, const PictureOptions& options) {
  const std::string extension = lower_extension(path);
  if (extension != ".png" && extension != ".svg") {
    throw kernel::InputError(path + ": file: has an unknown extension; write .png or .svg");
  }
  if (options.width < 16 || options.width > 16384) {
    throw kernel::InputError(path + ": picture: the width is out of range; take 16 to 16384");
  }
  if (!options.view) return;
  const kernel::Vec3& v = *options.view;
  const double squared = dot(v, v);
  if (!(squared > 0) || !std::isfinite(squared)) {
    throw kernel::InputError(path + ": picture: the view is no direction; give three numbers");
  }
}

}  // namespace

void write_picture(const std::string& path, const kernel::TriangleMesh& mesh,
                   const ridges::RidgeGraph& graph, const PictureOptions& options) {
  check(path, options);
  const std::vector<kernel::Vec3> normals = vertex_normals(mesh);
  const kernel::Vec3 view = options.view ? *options.view : automatic_view(mesh, normals, graph);
  const Camera camera = fit_camera(mesh, view, options.width);
  Canvas canvas(camera.width, camera.height);
  canvas.draw_surface(camera, mesh, normals);
  const Drawing drawing = make_drawing(camera, canvas, graph, options.order);
  if (lower_extension(path) == ".svg") {
    return write_atomically(path, svg_of(canvas, drawing, camera, options.show_legend));
  }
  paint(canvas, drawing);
  if (options.show_legend) paint_legend(canvas, drawing, camera);
  write_atomically(path, canvas.png());
}

}  // namespace crest::io
