// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The one reason why a test may be skipped: the shared data are not installed.
#include <string>
#include <vector>

namespace crest::tests {

/// The exit code of a test program that skipped a case (CTest's SKIP_RETURN_CODE); failures come
/// first.
inline constexpr int kSkipped = 77;

/// Why, a line a skipped case: printed at the program's end.
inline std::vector<std::string> skipped;

}  // namespace crest::tests
