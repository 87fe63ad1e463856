// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Simplices without degenerate tensors, and edges that consist of them (SPEC.md).
#include "certify/exact/tensor_field.hpp"

namespace crest::certify::curves {

/// Whether |mode| < 1 on the closed simplex, by coefficients in doubles with an error.
bool is_free(const modes::Field& field, const std::array<modes::u32, 3>& corners);
bool is_free(const modes::Field& field, const std::array<modes::u32, 4>& corners);
/// The same of parts of a triangle, halved until it is clear or 4096 parts are looked at.
bool is_free_in_parts(const std::array<std::array<double, 6>, 3>& tensors);

/// Whether the closed edge has neither a degenerate tensor nor zero; exact.
bool is_free(modes::ExactTensors& exact, const std::array<modes::u32, 2>& corners);
/// Whether all tensors of the closed edge are degenerate, and not zero; exact.
bool is_degenerate(modes::ExactTensors& exact, const std::array<modes::u32, 2>& corners);

}  // namespace crest::certify::curves
