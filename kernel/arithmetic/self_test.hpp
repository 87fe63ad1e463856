// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Is this machine's floating point what the error bounds assume?

namespace crest::kernel {

/// Throws std::runtime_error (one line, says what is wrong) unless: round to nearest is in force
/// and directed rounding changes results in this build, subnormals are kept (no flush to zero, as
/// linking anything with -ffast-math switches on), and a*b - c*d is not contracted to a fused
/// multiply-add. Called before anything is certified, by producer and checker.
void require_sound_floating_point();

}  // namespace crest::kernel
