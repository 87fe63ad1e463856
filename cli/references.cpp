// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/references.hpp"

#include <stdexcept>
#include <string_view>
#include <utility>

namespace crest::cli {
namespace {

/// (key, entry) of every entry: an '@' at the start of a line up to the '}' that closes it.
std::vector<std::pair<std::string, std::string>> entries() {
  std::vector<std::pair<std::string, std::string>> result;
  const std::string text = std::string("\n") + references_text();
  for (auto at = text.find("\n@"); at != std::string::npos; at = text.find("\n@", at + 1)) {
    const auto brace = text.find('{', at);
    const auto comma = text.find(',', brace);
    const auto end = text.find("\n}", comma);
    if (end == std::string::npos) throw std::runtime_error("references.bib: entry without end");
    result.emplace_back(text.substr(brace + 1, comma - brace - 1),
                        text.substr(at + 1, end + 2 - (at + 1)));
  }
  return result;
}

}  // namespace

std::string bibtex(const std::vector<std::string>& keys) {
  const auto all = entries();
  std::string result;
  for (const std::string& key : keys) {
    const std::string* found = nullptr;
    for (const auto& [name, entry] : all)
      if (name == key) found = &entry;
    if (!found) throw std::out_of_range("references.bib has no entry " + key);
    result += (result.empty() ? "" : "\n") + *found + "\n";
  }
  return result;
}

const char* curvature_reference(const std::string& method) {
  if (method == "cf" || method == "qf") return "goldfeather2004novel";
  if (method == "qt") return "welch1994free";
  if (method == "jet" || method == "fit") return "cazals2003jets";
  return method == "normal-cycle" ? "cohensteiner2003restricted" : nullptr;
}

}  // namespace crest::cli
