// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/picture/rasteriser.hpp"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "io/formats/vtk_quiet.hpp"

namespace crest::io {
namespace {

using kernel::Vec3;

int clamp_to(double x, int limit) {
  return static_cast<int>(std::clamp(x, 0.0, static_cast<double>(limit)));
}

}  // namespace

Rgb shaded(Vec3 n) {
  if (n[2] < 0) n = combine(-1, n, 0, n);
  const Vec3 key = {-0.453, 0.566, 0.689}, fill = {0.745, 0.115, 0.657};
  const Vec3 half = {-0.246, 0.308, 0.919};  // between the key light and the eye
  const double diffuse =
      0.34 + 0.58 * std::max(0.0, dot(n, key)) + 0.20 * std::max(0.0, dot(n, fill));
  const double h = std::max(0.0, dot(n, half)), h4 = h * h * h * h, h16 = h4 * h4 * h4 * h4;
  const double light = diffuse + 0.07 * h16;
  const auto channel = [&](double base) {
    return static_cast<std::uint8_t>(std::min(base * light + 0.5, 255.0));
  };
  return {channel(240), channel(241), channel(244)};
}

Canvas::Canvas(int width, int height)
    : width_(width * kSamples),
      height_(height * kSamples),
      colour_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_),
              Rgb{255, 255, 255}),
      depth_(colour_.size(), std::numeric_limits<float>::infinity()) {}

void Canvas::draw_surface(const Camera& camera, const SurfaceView& mesh,
                          const std::vector<Vec3>& normals, const std::vector<Vec3>* tints) {
  std::vector<Vec3> pixels(mesh.points().size()), turned(mesh.points().size());
  for (std::size_t v = 0; v < pixels.size(); ++v) {
    pixels[v] = camera.project(mesh.points()[v]);
    const Vec3& n = normals[v];
    turned[v] = {dot(n, camera.right), dot(n, camera.up), -dot(n, camera.forward)};
  }
  for (const auto& f : mesh.faces()) {
    Vec3 tint[3];
    for (std::size_t k = 0; tints != nullptr && k < 3; ++k) tint[k] = (*tints)[f[k]];
    draw_triangle({pixels[f[0]], pixels[f[1]], pixels[f[2]]},
                  {turned[f[0]], turned[f[1]], turned[f[2]]}, tints != nullptr ? &tint : nullptr);
  }
}

void Canvas::draw_triangle(const Vec3 (&corner)[3], const Vec3 (&normal)[3],
                           const Vec3 (*tint)[3]) {
  // In samples, whose centres are at half integers.
  double x[3], y[3];
  for (int k = 0; k < 3; ++k) {
    x[k] = corner[k][0] * kSamples - 0.5;
    y[k] = corner[k][1] * kSamples - 0.5;
  }
  const double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
  if (area == 0 || !std::isfinite(area)) return;
  const int first_row = clamp_to(std::ceil(std::min({y[0], y[1], y[2]})), height_);
  const int last_row = clamp_to(std::floor(std::max({y[0], y[1], y[2]})) + 1, height_);
  const int first_column = clamp_to(std::ceil(std::min({x[0], x[1], x[2]})), width_);
  const int last_column = clamp_to(std::floor(std::max({x[0], x[1], x[2]})) + 1, width_);
  const double inverse = 1 / area;
  for (int row = first_row; row < last_row; ++row) {
    for (int column = first_column; column < last_column; ++column) {
      const double px = column, py = row;
      const double w1 = ((px - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (py - y[0])) * inverse;
      const double w2 = ((x[1] - x[0]) * (py - y[0]) - (px - x[0]) * (y[1] - y[0])) * inverse;
      const double w0 = 1 - w1 - w2;
      // A hair outside still counts: no gaps between neighbours.
      if (w0 < -1e-9 || w1 < -1e-9 || w2 < -1e-9) continue;
      const auto depth =
          static_cast<float>(w0 * corner[0][2] + w1 * corner[1][2] + w2 * corner[2][2]);
      const std::size_t at = static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                             static_cast<std::size_t>(column);
      if (!(depth < depth_[at])) continue;
      depth_[at] = depth;
      const Vec3 n = combine(1, combine(w0, normal[0], w1, normal[1]), w2, normal[2]);
      const double squared = dot(n, n);  // of a mean of unit vectors
      colour_[at] = shaded(squared > 0 ? combine(1 / std::sqrt(squared), n, 0, n) : Vec3{0, 0, 1});
      if (tint == nullptr) continue;
      const Vec3 t = combine(1, combine(w0, (*tint)[0], w1, (*tint)[1]), w2, (*tint)[2]);
      const auto scaled = [](std::uint8_t x, double s) {
        return static_cast<std::uint8_t>(std::clamp(x * s, 0.0, 255.0));
      };
      colour_[at] = {scaled(colour_[at].red, t[0]), scaled(colour_[at].green, t[1]),
                     scaled(colour_[at].blue, t[2])};
    }
  }
}

bool Canvas::visible(const Vec3& pixel, double bias) const {
  const int column = static_cast<int>(std::floor(pixel[0] * kSamples));
  const int row = static_cast<int>(std::floor(pixel[1] * kSamples));
  if (column < 0 || row < 0 || column >= width_ || row >= height_) return false;
  // The farthest of the neighbours: on steep ground depth changes much within a sample.
  float farthest = -std::numeric_limits<float>::infinity();
  for (int r = std::max(row - 1, 0); r <= std::min(row + 1, height_ - 1); ++r) {
    for (int c = std::max(column - 1, 0); c <= std::min(column + 1, width_ - 1); ++c) {
      farthest =
          std::max(farthest, depth_[static_cast<std::size_t>(r) * static_cast<std::size_t>(width_) +
                                    static_cast<std::size_t>(c)]);
    }
  }
  return pixel[2] <= static_cast<double>(farthest) + bias;
}

template <class Inside>
void Canvas::paint(double x0, double y0, double x1, double y1, Rgb colour, Inside&& inside) {
  const int rows[2] = {clamp_to(std::floor(y0 * kSamples), height_),
                       clamp_to(std::ceil(y1 * kSamples), height_)};
  const int columns[2] = {clamp_to(std::floor(x0 * kSamples), width_),
                          clamp_to(std::ceil(x1 * kSamples), width_)};
  for (int row = rows[0]; row < rows[1]; ++row) {
    for (int column = columns[0]; column < columns[1]; ++column) {
      if (!inside((column + 0.5) / kSamples, (row + 0.5) / kSamples)) continue;
      colour_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
              static_cast<std::size_t>(column)] = colour;
    }
  }
}

void Canvas::draw_stroke(const Vec3& from, const Vec3& to, double width, Rgb colour) {
  const double r = 0.5 * width, dx = to[0] - from[0], dy = to[1] - from[1];
  const double squared = dx * dx + dy * dy;
  paint(std::min(from[0], to[0]) - r, std::min(from[1], to[1]) - r, std::max(from[0], to[0]) + r,
        std::max(from[1], to[1]) + r, colour, [&](double x, double y) {
          const double along = (x - from[0]) * dx + (y - from[1]) * dy;
          const double t = squared > 0 ? std::clamp(along / squared, 0.0, 1.0) : 0.0;
          const double ex = x - from[0] - t * dx, ey = y - from[1] - t * dy;
          return ex * ex + ey * ey <= r * r;
        });
}

void Canvas::fill_disk(const Vec3& centre, double radius, Rgb colour) {
  draw_stroke(centre, centre, 2 * radius, colour);
}

void Canvas::fill_polygon(const std::vector<Vec3>& corners, Rgb colour) {
  double low[2] = {corners[0][0], corners[0][1]}, high[2] = {low[0], low[1]};
  for (const Vec3& c : corners) {
    for (std::size_t k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], c[k]);
      high[k] = std::max(high[k], c[k]);
    }
  }
  paint(low[0], low[1], high[0], high[1], colour, [&](double x, double y) {
    bool left = true, right = true;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec3 &a = corners[i], &b = corners[(i + 1) % corners.size()];
      const double side = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
      left = left && side >= 0;
      right = right && side <= 0;
    }
    return left || right;
  });
}

void Canvas::fill_box(double x0, double y0, double x1, double y1, Rgb colour) {
  paint(x0, y0, x1, y1, colour,
        [&](double x, double y) { return x >= x0 && x < x1 && y >= y0 && y < y1; });
}

void Canvas::stamp(int left, int top, const Mask& mask, Rgb colour) {
  const auto mixed = [](std::uint8_t under, std::uint8_t over, int share) {
    return static_cast<std::uint8_t>((under * (255 - share) + over * share + 127) / 255);
  };
  for (int row = std::max(0, -top); row < std::min(mask.height, height_ - top); ++row) {
    for (int column = std::max(0, -left); column < std::min(mask.width, width_ - left); ++column) {
      const int share = mask.shares[row * mask.stride + column];
      Rgb& sample = colour_[static_cast<std::size_t>(top + row) * static_cast<std::size_t>(width_) +
                            static_cast<std::size_t>(left + column)];
      sample = {mixed(sample.red, colour.red, share), mixed(sample.green, colour.green, share),
                mixed(sample.blue, colour.blue, share)};
    }
  }
}

void Canvas::extend(int rows) {
  height_ += rows * kSamples;
  const auto size = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  colour_.resize(size, Rgb{255, 255, 255});
  depth_.resize(size, std::numeric_limits<float>::infinity());
}

std::string Canvas::png() const {
  const int width = width_ / kSamples, height = height_ / kSamples;
  vtkNew<vtkImageData> image;
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* out = static_cast<std::uint8_t*>(image->GetScalarPointer());
  // VTK's rows run upwards.
  for (int row = height - 1; row >= 0; --row) {
    for (int column = 0; column < width; ++column) {
      unsigned sum[3] = {0, 0, 0};
      for (int s = 0; s < kSamples * kSamples; ++s) {
        const int r = row * kSamples + s / kSamples, c = column * kSamples + s % kSamples;
        const Rgb& colour = colour_[static_cast<std::size_t>(r) * static_cast<std::size_t>(width_) +
                                    static_cast<std::size_t>(c)];
        sum[0] += colour.red;
        sum[1] += colour.green;
        sum[2] += colour.blue;
      }
      for (unsigned channel : sum)
        *out++ = static_cast<std::uint8_t>((channel + 2) / (kSamples * kSamples));
    }
  }
  const VtkQuiet quiet;
  vtkNew<vtkPNGWriter> writer;
  writer->WriteToMemoryOn();
  writer->SetInputData(image);
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  if (bytes == nullptr || !quiet.complaint().empty())
    throw std::runtime_error("VTK cannot write a PNG: " + quiet.complaint());
  return {reinterpret_cast<const char*>(bytes->GetPointer(0)),
          static_cast<std::size_t>(bytes->GetNumberOfValues())};
}

}  // namespace crest::io
