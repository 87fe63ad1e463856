// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How a checker says what it has proven.
#include <fmt/format.h>

#include "certify/container/verdict.hpp"

namespace crest::certify {

/// Adds a line to the verdict.
template <class... Arguments>
void prove(Verdict& verdict, fmt::format_string<Arguments...> text, Arguments&&... arguments) {
  verdict.lines.push_back(fmt::format(text, std::forward<Arguments>(arguments)...));
  if (verdict.progress) verdict.progress(verdict.lines.back());
}

}  // namespace crest::certify
