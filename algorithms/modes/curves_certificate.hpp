// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Degenerate curves as claim 7 (certify/modes_curves/SPEC.md).
#include <span>

#include "algorithms/modes/degenerate_result.hpp"
#include "certify/modes_curves/records.hpp"

namespace crest::modes {

certify::ModesCurvesCertificate curves_certificate(std::span<const kernel::Vec3> points,
                                                   std::span<const TetCorners> tets,
                                                   std::span<const Tensor> tensors,
                                                   const DegenerateCurves& curves);

}  // namespace crest::modes
