// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A z-buffer in software: no display, no driver, the same pixels everywhere.
#include <cstdint>
#include <string>
#include <vector>

#include "io/picture/camera.hpp"

namespace crest::io {

struct Rgb {
  std::uint8_t red, green, blue;
};

/// Light grey under a key light at the upper left, a fill light at the right, and a soft gloss.
/// The unit normal, of either sign, is in the camera's axes (right, up, towards the eye).
Rgb shaded(kernel::Vec3 normal);

/// Shares of 255 that samples are covered, row by row from the upper left.
struct Mask {
  const std::uint8_t* shares;
  int width, height, stride;
};

/// Samples per pixel and axis.
inline constexpr int kSamples = 2;

/// A picture of kSamples x kSamples samples a pixel, with depth.
class Canvas {
 public:
  Canvas(int width, int height);
  int sample_width() const { return width_; }
  int sample_height() const { return height_; }

  /// Smoothly shaded, two-sided; tints: factors on red, green and blue at each vertex.
  /// Requires: one unit normal a vertex, and one tint if there are any.
  void draw_surface(const Camera& camera, const SurfaceView& mesh,
                    const std::vector<kernel::Vec3>& normals,
                    const std::vector<kernel::Vec3>* tints = nullptr);
  /// True where a point of the surface is nearest to the eye, up to `bias` (all in pixels).
  bool visible(const kernel::Vec3& pixel, double bias) const;

  /// A stroke with round ends, in front of everything.
  void draw_stroke(const kernel::Vec3& from, const kernel::Vec3& to, double width, Rgb colour);
  void fill_disk(const kernel::Vec3& centre, double radius, Rgb colour);
  /// Convex; corners in either order.
  void fill_polygon(const std::vector<kernel::Vec3>& corners, Rgb colour);
  /// Axis-parallel, in pixels; clipped.
  void fill_box(double x0, double y0, double x1, double y1, Rgb colour);

  /// Covers samples from (left, top) on with a colour; clipped.
  void stamp(int left, int top, const Mask& mask, Rgb colour);

  /// Adds white rows of pixels below.
  void extend(int rows);

  /// The averaged samples as a PNG file's bytes.
  std::string png() const;

 private:
  void draw_triangle(const kernel::Vec3 (&corner)[3], const kernel::Vec3 (&normal)[3],
                     const kernel::Vec3 (*tint)[3]);
  /// Sets every sample whose centre satisfies the predicate, within a box of samples.
  template <class Inside>
  void paint(double x0, double y0, double x1, double y1, Rgb colour, Inside&& inside);

  int width_, height_;  ///< in samples
  std::vector<Rgb> colour_;
  std::vector<float> depth_;
};

}  // namespace crest::io
