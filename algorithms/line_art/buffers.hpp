// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The enhanced frame buffer: what is seen at every pixel of the page, to look at and to trace in;
// visibility is not decided here.
#include <optional>
#include <vector>

#include "algorithms/line_art/barriers.hpp"
#include "algorithms/line_art/field.hpp"

namespace crest::line_art {

struct LightOptions {
  Vec3 light{-0.5, 0.7, 0.6};  ///< right, up, towards the eye
};

/// Row by row from the upper left. Pixel (i, j) has its centre at ((i + 1/2), (j + 1/2)) pixel.
struct Buffers {
  int width = 0, height = 0;
  double pixel = 0.12;                              ///< mm
  std::vector<Index> face;                          ///< of the mesh, kNone: paper
  std::vector<float> near;                          ///< grows towards the eye
  std::vector<float> luminance;                     ///< 0 black to 1
  std::vector<float> curvature;                     ///< larger |k|, per mm of the page
  std::vector<std::array<float, 3>> normal;         ///< right, up, towards the eye
  std::vector<std::array<float, 2>> rib, backbone;  ///< on the page, unit; zero: unknown
  std::vector<std::uint8_t> closed;  ///< bit 0: a barrier before the right neighbour, 1: the lower

  std::size_t size() const { return face.size(); }
  /// Of the pixel that holds a point of the page; nothing beyond it.
  std::optional<std::size_t> at(const Vec2& p) const {
    const int i = static_cast<int>(std::floor(p[0] / pixel));
    const int j = static_cast<int>(std::floor(p[1] / pixel));
    if (i < 0 || j < 0 || i >= width || j >= height) return std::nullopt;
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(i);
  }
  Vec2 centre(std::size_t k) const {
    const auto w = static_cast<std::size_t>(width);
    return {(static_cast<double>(k % w) + 0.5) * pixel, (static_cast<double>(k / w) + 0.5) * pixel};
  }
};

/// What is drawn: a surface with a field. Refers to all of it.
struct Model {
  const kernel::TriangleMesh& mesh;
  const std::vector<PrincipalFrame>& frames;
  const DirectionField& field;
};

Buffers fill_buffers(const Model& model, const View& view, const Barriers& barriers,
                     const LightOptions& light, std::optional<double> crease);

}  // namespace crest::line_art
