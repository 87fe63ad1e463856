// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Eight faces at once through what costs most of their tests: the chart, E1 and E2, and these with
// a derivative. Each gets what it would alone, to the last bit
// (kernel/arithmetic/taylor_lanes.hpp).
//
// A face that fails on the way goes on as a copy of another one. Where something is undefined in
// one of them all are left to be tested alone: jets do not keep lanes apart there.
#include <memory>
#include <span>

#include "algorithms/smooth_ridges/face_values.hpp"

namespace crest::smooth_ridges {

class FaceLanes {
 public:
  static constexpr std::size_t kCount = kernel::Lanes::count;

  explicit FaceLanes(const Surface& surface);
  ~FaceLanes();
  FaceLanes(FaceLanes&&) noexcept;

  /// How far a face came: the chart; F_m > 0; (R), and sigma's enclosure holds zero; all, then
  /// there are values.
  enum class Passed : std::uint8_t { none, chart, slope, wide, regular };
  struct Start {
    Passed passed = Passed::none;
    Chart<FaceModel> chart;
    std::array<kernel::Range, 3> image{};  ///< of chart.x
    Frame frame{};
    std::uint8_t w = 0;
    Extremalities<0> values;
  };
  /// Of 1 to kCount faces; false: test them alone.
  bool start(std::span<const Corners* const> faces, std::span<Start> starts);

  struct Derived {
    Passed passed = Passed::slope;  ///< or wide, or regular
    Extremalities<1> values;
    std::array<FaceModel, 3> gradient;  ///< implicit: of F
  };
  /// The same with a derivative, of faces that are regular.
  bool derive(std::span<const Start* const> starts, std::span<Derived> derived);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace crest::smooth_ridges
