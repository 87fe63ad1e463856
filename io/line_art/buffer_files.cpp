// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/line_art/buffer_files.hpp"

#include <cairo/cairo.h>
#include <fmt/format.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "io/formats/volume.hpp"
#include "io/write/formats.hpp"

namespace crest::io {
namespace {

using line_art::Buffers, line_art::Stroke, line_art::kNone;
using Colour = std::array<double, 3>;

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

/// A colour a pixel, strokes in black over it.
template <class ColourOf>
std::string png_of(const Buffers& b, const std::vector<Stroke>& strokes, ColourOf&& colour_of) {
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, b.width, b.height), cairo_surface_destroy);
  cairo_surface_flush(surface.get());
  unsigned char* const data = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (std::size_t k = 0; k < b.size(); ++k) {
    const Colour c = colour_of(k);
    std::uint32_t word = 0;
    for (const double x : c)
      word = word << 8 | static_cast<std::uint32_t>(std::lround(255 * std::clamp(x, 0.0, 1.0)));
    const auto w = static_cast<std::size_t>(b.width);
    auto* row = reinterpret_cast<std::uint32_t*>(data + (k / w) * static_cast<std::size_t>(stride));
    row[k % w] = word;
  }
  cairo_surface_mark_dirty(surface.get());
  {
    const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> context(cairo_create(surface.get()),
                                                                     cairo_destroy);
    cairo_scale(context.get(), 1 / b.pixel, 1 / b.pixel);
    for (const Stroke& s : strokes) {
      for (const auto& p : line_art::outline(s)) cairo_line_to(context.get(), p[0], p[1]);
      cairo_fill(context.get());
    }
  }
  std::string bytes;
  if (cairo_surface_write_to_png_stream(surface.get(), append, &bytes) != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error("cairo cannot write a PNG");
  return bytes;
}

Colour grey(double x) {
  return {x, x, x};
}

/// White noise by the pixel's place.
double noise(std::size_t k) {
  std::uint64_t h = (k + 1) * 0x9e3779b97f4a7c15u;
  h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
  h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
  return static_cast<double>((h ^ (h >> 31)) >> 11) * 0x1p-53;
}

/// The mean noise along the ribs' stream line, 10 pixels to either side, its contrast restored.
double convolved(const Buffers& b, std::size_t k) {
  constexpr int kReach = 10;
  double sum = noise(k);
  int count = 1;
  for (const double sense : {1.0, -1.0}) {
    line_art::Vec2 p = b.centre(k);
    line_art::Vec2 d = {sense * static_cast<double>(b.rib[k][0]),
                        sense * static_cast<double>(b.rib[k][1])};
    for (int step = 0; step < kReach; ++step) {
      p = {p[0] + b.pixel * d[0], p[1] + b.pixel * d[1]};
      const auto at = b.at(p);
      if (!at || b.face[*at] == kNone) break;
      const line_art::Vec2 next = {static_cast<double>(b.rib[*at][0]),
                                   static_cast<double>(b.rib[*at][1])};
      const double along = next[0] * d[0] + next[1] * d[1];
      if (std::abs(along) < 0.5) break;
      d = along < 0 ? line_art::Vec2{-next[0], -next[1]} : next;
      sum += noise(*at);
      ++count;
    }
  }
  return 0.5 + (sum / count - 0.5) * std::sqrt(static_cast<double>(count));
}

std::string vti_of(const Buffers& b) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(b.width, b.height, 1);
  image->SetSpacing(b.pixel, b.pixel, 1);
  image->SetOrigin(0.5 * b.pixel, 0.5 * b.pixel, 0);
  const auto add = [&](const char* name, int components, auto&& value) {
    vtkNew<vtkFloatArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(static_cast<vtkIdType>(b.size()));
    // VTK's rows run upwards.
    const auto w = static_cast<std::size_t>(b.width), h = static_cast<std::size_t>(b.height);
    for (std::size_t k = 0; k < b.size(); ++k)
      for (int c = 0; c < components; ++c)
        array->SetComponent(static_cast<vtkIdType>((h - 1 - k / w) * w + k % w), c,
                            static_cast<double>(value(k, static_cast<std::size_t>(c))));
    image->GetPointData()->AddArray(array);
  };
  const float none = -1;
  add("face", 1, [&](std::size_t k, std::size_t) {
    return b.face[k] == kNone ? none : static_cast<float>(b.face[k]);
  });
  add("nearness", 1,
      [&](std::size_t k, std::size_t) { return b.face[k] == kNone ? 0.0F : b.near[k]; });
  add("luminance", 1, [&](std::size_t k, std::size_t) { return b.luminance[k]; });
  add("curvature", 1, [&](std::size_t k, std::size_t) { return b.curvature[k]; });
  add("normal", 3, [&](std::size_t k, std::size_t c) { return b.normal[k][c]; });
  add("rib", 2, [&](std::size_t k, std::size_t c) { return b.rib[k][c]; });
  add("backbone", 2, [&](std::size_t k, std::size_t c) { return b.backbone[k][c]; });
  image->GetPointData()->SetActiveScalars("luminance");
  return vti_bytes(*image);
}

}  // namespace

std::string buffer_file(const std::string& which, const Buffers& b,
                        const std::vector<Stroke>& contours) {
  if (which == "-buffers.vti") return vti_of(b);
  if (which == "-luminance.png")
    return png_of(b, {}, [&](std::size_t k) { return grey(static_cast<double>(b.luminance[k])); });
  if (which == "-normal.png")
    return png_of(b, {}, [&](std::size_t k) {
      const auto& n = b.normal[k];
      if (b.face[k] == kNone) return grey(1);
      return Colour{0.5 + 0.5 * static_cast<double>(n[0]), 0.5 + 0.5 * static_cast<double>(n[1]),
                    0.5 + 0.5 * static_cast<double>(n[2])};
    });
  if (which == "-curvature.png") {
    std::vector<float> sorted;
    for (std::size_t k = 0; k < b.size(); ++k)
      if (b.face[k] != kNone) sorted.push_back(b.curvature[k]);
    std::sort(sorted.begin(), sorted.end());
    const double most = sorted.empty() ? 1 : static_cast<double>(sorted[sorted.size() * 95 / 100]);
    return png_of(b, contours, [&](std::size_t k) {
      const double x = most > 0 ? static_cast<double>(b.curvature[k]) / most : 0;
      return b.face[k] == kNone ? grey(1) : Colour{0.25 + 0.75 * x, 0.45, 1 - 0.75 * x};
    });
  }
  return png_of(b, contours, [&](std::size_t k) {
    return grey(b.face[k] == kNone ? 1 : 0.25 + 0.7 * convolved(b, k));
  });
}

void read_luminance(const std::string& path, Buffers& b) {
  read_named(path, [&] {
    const FileBytes bytes = load(path);
    if (!std::string_view(bytes).starts_with("\x89PNG"))
      fail("file", "is no PNG", "give the -luminance.png of --save-buffers, edited");
    const Volume image = read_png(bytes, {});
    if (image.size.size() < 2 || image.size[0] != static_cast<std::size_t>(b.width) ||
        image.size[1] != static_cast<std::size_t>(b.height))
      fail("image", fmt::format("is not {} by {} pixels", b.width, b.height),
           "save the buffers of this view again");
    std::visit(
        [&](const auto& samples) {
          using Native = typename std::decay_t<decltype(samples)>::value_type;
          const double white = sizeof(Native) == 1 ? 255 : 65535;
          const auto w = static_cast<std::size_t>(b.width), h = static_cast<std::size_t>(b.height);
          for (std::size_t k = 0; k < b.size(); ++k)
            b.luminance[k] = static_cast<float>(
                static_cast<double>(samples[(h - 1 - k / w) * w + k % w]) / white);
        },
        image.samples);
  });
}

}  // namespace crest::io
