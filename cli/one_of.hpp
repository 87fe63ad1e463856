// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// An option whose value is one of some words.
#include <CLI/CLI.hpp>
#include <string>

namespace crest::cli {

/// Turns a word, in any case, into its value; --help shows the words without their values.
template <class Words>
CLI::Validator one_of(const Words& words) {
  std::string shown;
  for (const auto& [word, value] : words) shown += (shown.empty() ? "" : ",") + std::string(word);
  return CLI::CheckedTransformer(words, CLI::ignore_case).description("{" + shown + "}");
}

}  // namespace crest::cli
