// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/architecture/bodies.hpp"

#include <algorithm>
#include <cctype>
#include <regex>

namespace crest::tests {
namespace {

/// Where the comment, literal or preprocessor line that begins at i ends; i where none begins.
std::size_t end_of_blank(const std::string& text, std::size_t i, bool at_line_start) {
  const auto from = [&](const std::string& end, std::size_t start) {
    const auto found = text.find(end, start);
    return found == std::string::npos ? text.size() : found + end.size();
  };
  if (text.compare(i, 2, "//") == 0) return std::min(text.find('\n', i), text.size());
  if (text.compare(i, 2, "/*") == 0) return from("*/", i + 2);
  if (text[i] == '#' && at_line_start) {
    std::size_t end = text.find('\n', i);
    while (end != std::string::npos && text[end - 1] == '\\') end = text.find('\n', end + 1);
    return std::min(end, text.size());
  }
  if (text.compare(i, 2, "R\"") == 0) {
    const auto open = text.find('(', i);
    return from(")" + text.substr(i + 2, open - i - 2) + "\"", open);
  }
  // An apostrophe between digits separates them.
  const bool separator =
      text[i] == '\'' && i > 0 && std::isalnum(static_cast<unsigned char>(text[i - 1]));
  if ((text[i] != '"' && text[i] != '\'') || separator) return i;
  std::size_t end = i + 1;
  while (end < text.size() && text[end] != text[i]) end += text[end] == '\\' ? 2 : 1;
  return std::min(end + 1, text.size());
}

/// Where the angle bracket at `open` is closed, past its end; `open` if it is not.
std::size_t end_of_angle(const std::string& head, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < head.size(); ++i) {
    depth += head[i] == '<' ? 1 : head[i] == '>' ? -1 : 0;
    if (depth == 0) return i + 1;
  }
  return open;
}

/// What stands before a brace, without what is in angle brackets.
std::string plain_head(const std::string& head) {
  std::string plain;
  for (std::size_t i = 0; i < head.size(); ++i) {
    const std::size_t end = head[i] == '<' ? end_of_angle(head, i) : i;
    if (end > i)
      i = end - 1;
    else
      plain += head[i];
  }
  return std::regex_replace(plain, std::regex("\\s*\\btemplate\\b\\s*|\\s+"), " ");
}

struct Open {
  enum Kind { space, type, function, initialiser, other } kind;
  std::string name;
  std::size_t line = 0;
  std::string head = {};
};

Open opened(const std::string& head, bool inside_function) {
  std::smatch m;
  const std::string plain = plain_head(head);
  if (std::regex_search(plain, m,
                        std::regex("^ ?(?:struct|class|union) (?:alignas\\([^)]*\\) ?)?([\\w:]+)")))
    return {Open::type, m[1]};
  if (inside_function) return {Open::other, ""};
  if (std::regex_search(plain, std::regex("\\bnamespace\\b"))) return {Open::space, ""};
  // A member in a constructor's list: the body is still to come.
  if (std::regex_search(plain, std::regex("\\) ?(?:noexcept ?)?:[^:].*\\w ?$")))
    return {Open::initialiser, ""};
  if (std::regex_search(plain, m, std::regex("([~\\w:]+|operator[^(]*) ?\\(")))
    return {Open::function, m[1]};
  return {Open::other, ""};
}

}  // namespace

std::string without_comments(const std::string& text) {
  std::string result = text;
  bool at_line_start = true;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t end = end_of_blank(text, i, at_line_start);
    at_line_start = text[i] == '\n' || (at_line_start && text[i] == ' ');
    for (std::size_t j = i; j < end; ++j)
      if (result[j] != '\n') result[j] = ' ';
    i = std::max(end, i + 1);
  }
  return result;
}

std::vector<Body> bodies_of(const std::string& text) {
  std::vector<Body> bodies;
  std::vector<Open> stack;
  std::string head;
  std::size_t line = 1;
  const auto inside_function = [&] {
    return std::any_of(stack.begin(), stack.end(),
                       [](const Open& o) { return o.kind == Open::function; });
  };
  for (const char c : without_comments(text)) {
    line += c == '\n';
    std::string kept;
    if (c == '{') {
      stack.push_back(opened(head, inside_function()));
      stack.back().line = line;
      stack.back().head = head;
    } else if (c == '}' && !stack.empty()) {
      const Open top = stack.back();
      if (top.kind == Open::initialiser) kept = top.head;
      stack.pop_back();
      const bool is_class = top.kind == Open::type;
      if (is_class || (top.kind == Open::function && !inside_function())) {
        std::string name;
        for (const Open& o : stack)
          if (o.kind == Open::type) name += o.name + "::";
        const std::size_t lines = line == top.line ? 0 : line - top.line - 1;
        bodies.push_back({name + top.name, is_class, lines});
      }
    }
    if (c == ';' || c == '{' || c == '}')
      head = kept;
    else
      head += c;
  }
  return bodies;
}

}  // namespace crest::tests
