// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/predicates/planar_field.hpp"

#include "kernel/predicates/collinear.hpp"
#include "kernel/predicates/stages.hpp"

namespace crest::kernel {

CREST_INSTANTIATE_STAGES(VectorTurn)
CREST_INSTANTIATE_STAGES(FieldTrace)
CREST_INSTANTIATE_STAGES(FieldDiscriminant)
CREST_INSTANTIATE_STAGES(FlowAcross)
CREST_INSTANTIATE_STAGES(FlowAlong)

Sign exact_vector_turn(const Vec2& a, const Vec2& b) {
  const double p = a[0] * b[1];
  // Equal rounded products of middling size: their rounding errors, which are doubles, decide.
  if (std::fabs(p) > 0x1p-900 && std::fabs(p) < HUGE_VAL)
    return sign_of(std::fma(a[0], b[1], -p) - std::fma(a[1], b[0], -p));
  const bool left = a[0] == 0 || b[1] == 0, right = a[1] == 0 || b[0] == 0;
  if (left && right) return Sign::zero;
  return exact_stage(VectorTurn{a, b});
}

Sign symbolic_vector_turn(std::uint32_t i, const Vec2& a, std::uint32_t j, const Vec2& b) {
  if (i > j) return -symbolic_vector_turn(j, b, i, a);
  if (const Sign s = vector_turn(a, b); s != Sign::zero) return s;
  for (const double x : {-b[0], b[1], a[0]})
    if (x != 0) return sign_of(x);
  return Sign::positive;
}

Sign trace_sign(const FieldOnTriangle& t) {
  return climb(FieldTrace{t}).sign;
}

Sign field_discriminant_sign(const FieldOnTriangle& t) {
  return climb(FieldDiscriminant{t}).sign;
}

Sign flow_across(const Vec2& p, const Vec2& q, const Vec2& v) {
  return climb(FlowAcross{p, q, v}).sign;
}

Sign flow_along(const Vec2& p, const Vec2& q, const Vec2& v) {
  return climb(FlowAlong{p, q, v}).sign;
}

Sign orientation(const Vec2& p, const Vec2& q, const Vec2& r) {
  return climb(CrossCoordinate{p[0], p[1], q[0], q[1], r[0], r[1]}).sign;
}

}  // namespace crest::kernel
