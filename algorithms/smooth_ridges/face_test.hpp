// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The conditions on one face (certify/ridges_smooth/SPEC.md, Faces outside patches; paper 002,
// section 6). Turning point: a ridge changes between elliptic and hyperbolic. Purple point: a blue
// and a red ridge cross.
#include <cmath>
#include <memory>
#include <span>

#include "algorithms/smooth_ridges/chart.hpp"
#include "algorithms/smooth_ridges/frame.hpp"
#include "kernel/geometry/ridge_words.hpp"

namespace crest::smooth_ridges {

using kernel::RidgeType;

/// What stopped a proof.
enum class FaceStatus : std::uint8_t {
  proven,
  chart,    ///< the map to the surface: too coarse, or the surface is singular
  regular,  ///< (R): near an umbilic, or too coarse
  ridge,    ///< an extremality is neither free of zeros nor monotone
  type,     ///< elliptic or hyperbolic is not decided
  purple,   ///< the order of a blue and a red arc is not decided
  untested
};

struct ColourResult {
  bool no_zero = false;
  std::uint8_t monotone = 0;           ///< direction number if not no_zero
  std::array<bool, 3> crossed{};       ///< edge i from corner i to corner i + 1
  std::array<bool, 3> edge_decided{};  ///< exactly as many zeros as `crossed` says
  std::array<double, 3> at{};          ///< where on a crossed edge, in [0, 1] from its corner i
  RidgeType type = RidgeType::none;
  /// A corner of the domain where the sign is not certain and taken positive, or -1; then the sign
  /// of the derivative along each edge, 0 if not certain.
  int loose_corner = -1;
  std::array<int, 3> slope{};
};

/// Enclosures of the image of a face: of x, y, z (implicit) or lifted U, V, 0.
using FaceImage = std::array<kernel::Range, 3>;
inline constexpr FaceImage kAnywhere = {
    kernel::Range{-HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, HUGE_VAL}};

struct FaceResult {
  FaceStatus status = FaceStatus::chart;
  FaceImage image = kAnywhere;
  Frame frame{};  ///< implicit
  std::uint8_t w = 0;
  std::array<ColourResult, 2> colour;  ///< blue, red
  bool purple = false;
};

/// Not for two threads at a time.
class FaceTest {
 public:
  explicit FaceTest(const Surface& surface);
  ~FaceTest();
  FaceTest(FaceTest&&) noexcept;

  FaceResult operator()(const std::array<Vertex, 3>& corners);
  /// The same of many faces, several at a time.
  void operator()(std::span<const std::array<Vertex, 3>> faces, std::span<FaceResult> results);
  /// Nothing if the chart is not proven.
  std::optional<FaceImage> image(const std::array<Vertex, 3>& corners);

 private:
  struct State;
  struct Together;
  std::unique_ptr<State> state_;
};

}  // namespace crest::smooth_ridges
