// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Eight whole faces at once: the values that their statements are about, by the formulas that serve
// one face (face.hpp), over models side by side (kernel/arithmetic/taylor_lanes.hpp).
//
// Every lane encloses what its face's models would; nothing is concluded here. A face that fails on
// the way goes on as a copy of another. Where something is undefined in one face all are left to be
// evaluated alone: (A) is shown there.
#include <memory>
#include <span>

#include "certify/ridges_smooth/face.hpp"
#include "kernel/arithmetic/taylor_lanes.hpp"

namespace crest::certify::smooth {

template <int Order, int K>
class FaceLanes {
 public:
  using Model = kernel::TaylorModel<Order>;
  using Values = typename FaceProver<Model>::template WholeFace<K>;
  static constexpr std::size_t kCount = kernel::Lanes::count;

  FaceLanes(const Surface& surface, const RidgesSmoothCertificate& c);
  ~FaceLanes();
  FaceLanes(FaceLanes&&) noexcept;

  /// Of 1 to kCount faces. steep: as a witness says, or nothing (a producer): what suits the face.
  /// Returns none if a face is to be evaluated alone.
  std::vector<Values> evaluate(std::span<const std::uint32_t> faces,
                               std::span<const std::optional<bool>> steep);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace crest::certify::smooth
