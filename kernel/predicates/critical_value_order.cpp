// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/predicates/critical_value_order.hpp"

#include <utility>

#include "kernel/predicates/stages.hpp"

namespace crest::kernel {

using enum ValueKind;
using EdgeVertex = ValueDifference<edge, vertex>;
using FaceVertex = ValueDifference<face, vertex>;
using EdgeEdge = ValueDifference<edge, edge>;
using FaceEdge = ValueDifference<face, edge>;
using FaceFace = ValueDifference<face, face>;

CREST_INSTANTIATE_STAGES(EdgeVertex)
CREST_INSTANTIATE_STAGES(FaceVertex)
CREST_INSTANTIATE_STAGES(EdgeEdge)
CREST_INSTANTIATE_STAGES(FaceEdge)
CREST_INSTANTIATE_STAGES(FaceFace)

namespace {

Sign negated_if(bool swapped, Sign s) {
  return swapped ? -s : s;
}
MaybeSign negated_if(bool swapped, MaybeSign s) {
  return s && swapped ? MaybeSign(-*s) : s;
}
Decision negated_if(bool swapped, Decision d) {
  return {negated_if(swapped, d.sign), d.stage};
}

// One-sided: the formula of the kinds in descending order, the answer of which `stage` is turned
// round for the denominators' signs and for the swap.
template <class Stage>
auto with_formula(const CriticalValue& a, const CriticalValue& b, Stage&& stage) {
  const bool swapped = a.kind < b.kind;
  const CriticalValue &x = swapped ? b : a, &y = swapped ? a : b;
  const bool negated = swapped != (x.denominator * y.denominator == Sign::negative);
  if (y.kind == vertex)
    return negated_if(negated,
                      x.kind == edge ? stage(EdgeVertex{x.f, y.f}) : stage(FaceVertex{x.f, y.f}));
  if (y.kind == edge)
    return negated_if(negated,
                      x.kind == edge ? stage(EdgeEdge{x.f, y.f}) : stage(FaceEdge{x.f, y.f}));
  return negated_if(negated, stage(FaceFace{x.f, y.f}));
}

bool both_vertices(const CriticalValue& x, const CriticalValue& y) {
  return x.kind == vertex && y.kind == vertex;
}

// Equal without a computation.
bool same_data(const CriticalValue& x, const CriticalValue& y) {
  return x.kind == y.kind && normal_form(x).f == normal_form(y).f;
}

Sign compare_vertices(const CriticalValue& x, const CriticalValue& y) {
  const double a = x.f.corner[0], b = y.f.corner[0];
  return a < b ? Sign::negative : a > b ? Sign::positive : Sign::zero;
}

}  // namespace

MaybeSign triage_critical_value_order(const CriticalValue& x, const CriticalValue& y) {
  if (both_vertices(x, y)) return compare_vertices(x, y);
  if (same_data(x, y)) return Sign::zero;
  return with_formula(x, y, [](const auto& f) { return triage(f); });
}
MaybeSign interval_critical_value_order(const CriticalValue& x, const CriticalValue& y) {
  if (both_vertices(x, y)) return compare_vertices(x, y);
  return with_formula(x, y, [](const auto& f) { return interval_stage(f); });
}
Sign exact_critical_value_order(const CriticalValue& x, const CriticalValue& y) {
  if (both_vertices(x, y)) return compare_vertices(x, y);
  return with_formula(x, y, [](const auto& f) { return exact_stage(f); });
}

Decision compare_critical_values(const CriticalValue& x, const CriticalValue& y) {
  if (both_vertices(x, y)) return {compare_vertices(x, y), Stage::triage};
  if (same_data(x, y)) return {Sign::zero, Stage::triage};
  return with_formula(x, y, [](const auto& f) { return climb(f); });
}

}  // namespace crest::kernel
