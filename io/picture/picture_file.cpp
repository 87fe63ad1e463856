// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/picture/picture_file.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "io/formats/files.hpp"
#include "io/picture/lettering.hpp"
#include "io/write/atomic_file.hpp"
#include "io/write/finite.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {
namespace {

constexpr Rgb kRim = {0, 0, 0};

/// The corners of a mark that is no disk.
std::vector<kernel::Vec3> corners_of(Mark mark, const kernel::Vec3& at, double radius) {
  if (mark == Mark::triangle) {
    const double dx = 0.866 * radius, dy = 0.5 * radius;
    return {{at[0], at[1] - radius, 0}, {at[0] + dx, at[1] + dy, 0}, {at[0] - dx, at[1] + dy, 0}};
  }
  return {{at[0], at[1] - radius, 0},
          {at[0] + radius, at[1], 0},
          {at[0], at[1] + radius, 0},
          {at[0] - radius, at[1], 0}};
}

void paint_mark(Canvas& canvas, const Dot& dot, double unit) {
  const double radius = dot.size * unit;
  for (const bool rim : {true, false}) {
    const double r = rim ? radius : 0.7 * radius;
    const Rgb colour = rim ? kRim : dot.colour;
    if (dot.mark == Mark::disk)
      canvas.fill_disk(dot.centre, r, colour);
    else
      canvas.fill_polygon(corners_of(dot.mark, dot.centre, r), colour);
  }
}

/// Where the legend goes, in pixels, for both media: columns in a band below the surface.
struct LegendLayout {
  double dot = 1, letters = 0, column = 0, row = 0, top = 0;
  std::size_t columns = 1;
  int height = 0;  ///< of the band

  LegendLayout(const Drawing& drawing, const Camera& camera, bool show) {
    if (!show || drawing.legend.empty()) return;
    dot = std::max(1.0, std::round(camera.width / 800.0));
    letters = 10.5 * dot;
    double longest = 0;
    for (const LegendEntry& entry : drawing.legend)
      longest = std::max(longest, text_width(entry.label, letters));
    column = longest + 44 * dot;
    row = 14 * dot;
    columns = static_cast<std::size_t>(std::clamp((camera.width - 16 * dot) / column, 1.0, 4.0));
    const std::size_t rows = (drawing.legend.size() + columns - 1) / columns;
    top = camera.height;
    height = static_cast<int>(row * static_cast<double>(rows) + 8 * dot);
  }
  double x(std::size_t i) const { return dot * 8 + column * static_cast<double>(i % columns); }
  double y(std::size_t i) const { return top + row * (static_cast<double>(i / columns) + 0.5); }
};

void paint_legend(Canvas& canvas, const Drawing& drawing, const LegendLayout& at) {
  if (at.height == 0) return;
  for (std::size_t i = 0; i < drawing.legend.size(); ++i) {
    const LegendEntry& entry = drawing.legend[i];
    const double y = at.y(i), x0 = at.x(i), x1 = x0 + 24 * at.dot;
    if (entry.dot) {
      const Dot dot{{0.5 * (x0 + x1), y, 0}, entry.colour, entry.mark, entry.size};
      paint_mark(canvas, dot, drawing.dot_radius);
    } else {
      canvas.draw_stroke({x0, y, 0}, {x1, y, 0}, drawing.casing_width, casing(entry.colour));
      canvas.draw_stroke({x0, y, 0}, {x1, y, 0}, drawing.stroke_width, entry.colour);
    }
    draw_text(canvas, x0 + 30 * at.dot, y + 3.6 * at.dot, at.letters, entry.label);
  }
}

void paint(Canvas& canvas, const Drawing& drawing) {
  for (const StrokeClass& c : drawing.classes) {
    for (const bool rim : {true, false}) {
      for (const auto& stroke : c.strokes) {
        for (std::size_t i = 0; i + 1 < stroke.size(); ++i) {
          canvas.draw_stroke(stroke[i], stroke[i + 1],
                             c.width * (rim ? drawing.casing_width : drawing.stroke_width),
                             rim ? casing(c.colour) : c.colour);
        }
      }
    }
  }
  for (const Dot& dot : drawing.dots) paint_mark(canvas, dot, drawing.dot_radius);
}

std::string base64(const std::string& bytes) {
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');
  const int length = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                                     reinterpret_cast<const unsigned char*>(bytes.data()),
                                     static_cast<int>(bytes.size()));
  text.resize(static_cast<std::size_t>(length));
  return text;
}

std::string hex(Rgb c) {
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

std::string svg_dot(const Dot& dot, double unit) {
  const double radius = dot.size * unit;
  if (dot.mark == Mark::disk) {
    return fmt::format(
        "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" fill=\"{}\" stroke=\"{}\" "
        "stroke-width=\"{:.2f}\"/>\n",
        dot.centre[0], dot.centre[1], 0.85 * radius, hex(dot.colour), hex(kRim), 0.3 * radius);
  }
  std::string svg;
  for (const bool rim : {true, false}) {
    svg += "<polygon points=\"";
    for (const kernel::Vec3& c : corners_of(dot.mark, dot.centre, rim ? radius : 0.7 * radius))
      svg += fmt::format("{:.2f},{:.2f} ", c[0], c[1]);
    svg.back() = '"';
    svg += fmt::format(" fill=\"{}\"/>\n", hex(rim ? kRim : dot.colour));
  }
  return svg;
}

std::string svg_legend(const Drawing& drawing, const LegendLayout& at) {
  if (at.height == 0) return {};
  std::string svg = fmt::format(
      "<g font-family=\"Helvetica, Arial, sans-serif\" font-size=\"{:.1f}\" "
      "fill=\"#28282c\">\n",
      at.letters);
  for (std::size_t i = 0; i < drawing.legend.size(); ++i) {
    const LegendEntry& entry = drawing.legend[i];
    const double y = at.y(i), x0 = at.x(i), x1 = x0 + 24 * at.dot;
    if (entry.dot) {
      svg += svg_dot({{0.5 * (x0 + x1), y, 0}, entry.colour, entry.mark, entry.size},
                     drawing.dot_radius);
    } else {
      for (const bool rim : {true, false}) {
        svg += fmt::format(
            "<path d=\"M{:.2f} {:.2f}L{:.2f} {:.2f}\" stroke=\"{}\" stroke-width=\"{:.2f}\" "
            "stroke-linecap=\"round\"/>\n",
            x0, y, x1, y, hex(rim ? casing(entry.colour) : entry.colour),
            rim ? drawing.casing_width : drawing.stroke_width);
      }
    }
    svg += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\">{}</text>\n", x0 + 30 * at.dot,
                       y + 3.6 * at.dot, entry.label);
  }
  return svg + "</g>\n";
}

std::string svg_start(int width, int height) {
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
      "width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n",
      width, height);
}

std::string svg_of(const Canvas& surface, const Drawing& drawing, const Camera& camera,
                   const LegendLayout& legend) {
  const int height = camera.height + legend.height;
  std::string svg = svg_start(camera.width, height) +
                    fmt::format(
                        "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n"
                        "<image width=\"{0}\" height=\"{2}\" "
                        "xlink:href=\"data:image/png;base64,{3}\"/>\n"
                        "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n",
                        camera.width, height, camera.height, base64(surface.png()));
  for (const StrokeClass& c : drawing.classes) {
    if (c.strokes.empty()) continue;
    const std::string data = path_data(c.strokes);
    for (const bool rim : {true, false}) {
      svg += fmt::format("<path stroke=\"{}\" stroke-width=\"{:.2f}\" d=\"{}\"/>\n",
                         hex(rim ? casing(c.colour) : c.colour),
                         c.width * (rim ? drawing.casing_width : drawing.stroke_width), data);
    }
  }
  svg += "</g>\n";
  for (const Dot& dot : drawing.dots) svg += svg_dot(dot, drawing.dot_radius);
  svg += svg_legend(drawing, legend);
  return svg + "</svg>\n";
}

/// As every output: no number that is not finite.
void require_sound(const Drawing& drawing) {
  for (const double x : {drawing.stroke_width, drawing.casing_width, drawing.dot_radius})
    require_finite(x, "line width");
  const auto require_point = [](const kernel::Vec3& p) {
    for (const double x : p) require_finite(x, "picture");
  };
  for (const StrokeClass& c : drawing.classes)
    for (const auto& stroke : c.strokes)
      for (const kernel::Vec3& p : stroke) require_point(p);
  for (const Dot& dot : drawing.dots) require_point(dot.centre);
}

}  // namespace

void check_picture_path(const std::string& path) {
  const std::string extension = lower_extension(path);
  if (extension != ".png" && extension != ".svg")
    throw kernel::InputError(path + ": file: has an unknown extension; write .png or .svg");
}

void write_drawing(const std::string& path, const Camera& camera, Canvas& canvas,
                   const Drawing& drawing, bool show_legend) {
  require_sound(drawing);
  const LegendLayout legend(drawing, camera, show_legend);
  if (lower_extension(path) == ".svg")
    return write_atomically(path, svg_of(canvas, drawing, camera, legend));
  paint(canvas, drawing);
  canvas.extend(legend.height);
  paint_legend(canvas, drawing, legend);
  write_atomically(path, canvas.png());
}

void write_canvas(const std::string& path, const Canvas& canvas, int width, int height) {
  const std::string png = canvas.png();
  if (lower_extension(path) == ".png") return write_atomically(path, png);
  write_atomically(path, fmt::format("{}<image width=\"{}\" height=\"{}\" "
                                     "xlink:href=\"data:image/png;base64,{}\"/>\n</svg>\n",
                                     svg_start(width, height), width, height, base64(png)));
}

}  // namespace crest::io
