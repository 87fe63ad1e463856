// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/predicates/against_faces.hpp"

#include "kernel/predicates/stages.hpp"

namespace crest::kernel {

CREST_INSTANTIATE_STAGES(AlongNormals)

bool against_faces(const Vec3& n, const Vec3& p, std::span<const std::array<Vec3, 2>> sides) {
  // As a rule all terms have one sign.
  bool positive = true, negative = true;
  for (const auto& [q, r] : sides) {
    const MaybeSign s = triage(AlongNormal{n, p, q, r});
    positive = positive && s == Sign::positive;
    negative = negative && s == Sign::negative;
  }
  if (positive || negative) return negative;
  const AlongNormals sum{n, p, sides};
  const MaybeSign s = interval_stage(sum);
  return (s ? *s : exact_stage(sum)) != Sign::positive;
}

}  // namespace crest::kernel
