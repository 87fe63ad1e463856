// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/msh_source.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/formats/binary.hpp"
#include "io/formats/files.hpp"
#include "io/formats/remedy.hpp"

namespace crest::io {
namespace {

constexpr std::size_t kNone = ~std::size_t{0};

}  // namespace

TagTable::TagTable(const std::vector<std::int64_t>& tags, const char* what) {
  if (tags.empty()) return;
  const auto [low, high] = std::minmax_element(tags.begin(), tags.end());
  first_ = *low;
  const std::uint64_t range = static_cast<std::uint64_t>(*high) - static_cast<std::uint64_t>(*low);
  if (range / 4 <= tags.size()) table_.assign(range + 1, kNone);
  for (std::size_t i = 0; i < tags.size(); ++i) {
    const std::int64_t tag = tags[i];
    bool is_new = false;
    if (table_.empty()) {
      is_new = map_.emplace(tag, i).second;
    } else {
      std::size_t& slot = table_[static_cast<std::size_t>(tag - first_)];
      is_new = slot == kNone;
      slot = i;
    }
    if (!is_new) fail(fmt::format("{} {}", what, tag), "is there twice", kExportMesh);
  }
}

std::optional<std::size_t> TagTable::find(std::int64_t tag) const {
  if (table_.empty()) {
    const auto found = map_.find(tag);
    return found == map_.end() ? std::nullopt : std::optional(found->second);
  }
  const bool inside =
      tag >= first_ &&
      static_cast<std::uint64_t>(tag) - static_cast<std::uint64_t>(first_) < table_.size();
  if (!inside || table_[static_cast<std::size_t>(tag - first_)] == kNone) return std::nullopt;
  return table_[static_cast<std::size_t>(tag - first_)];
}

std::string MshSource::next_section() {
  while (scan_.more()) {
    const std::string_view word = scan_.peek(40);
    scan_.next_line();
    if (word[0] == '$') return section_ = word;
  }
  return {};
}

void MshSource::end_section() {
  const std::string end = "$End" + section_.substr(1);
  const std::size_t at = bytes_.find(end, scan_.position());
  if (at == bytes_.npos)
    fail(section_, "does not end", "the file is truncated; export the mesh again");
  scan_.move_to(at + end.size());
  scan_.next_line();
}

void MshSource::set_binary() {
  binary_ = true;
  if (load<std::int32_t>() == 1) return;
  big_endian_ = true;
  scan_.move_to(scan_.position() - 4);
  if (load<std::int32_t>() != 1) fail(section_, "has no mark of the byte order", kExportMesh);
}

void MshSource::begin_line() {
  if (!scan_.more() || scan_.peek(1) == "$") fail_end();
}

void MshSource::fail_end() const {
  fail(section_, binary_ ? "ends early" : fmt::format("ends early ({})", line()),
       "the file is truncated; export the mesh again");
}

void MshSource::require_word() {
  if (scan_.in_line()) return;
  if (scan_.room() == 0) fail_end();
  fail(line(), "has too few numbers", kExportMesh);
}

std::int64_t MshSource::word_integer() {
  std::int64_t value = 0;
  require_word();
  if (!scan_.take(value))
    fail(line(), fmt::format("{} is not an integer", quoted(scan_.peek())), kExportMesh);
  return value;
}

double MshSource::word_real() {
  double value = 0;
  require_word();
  if (!scan_.take(value))
    fail(line(), fmt::format("{} is not a number", quoted(scan_.peek())), kExportMesh);
  return value;
}

template <class T>
T MshSource::load() {
  if (scan_.room() < sizeof(T)) fail_end();
  return load_number<T>(scan_.take_bytes(sizeof(T)).data(), big_endian_);
}
template std::int32_t MshSource::load<std::int32_t>();
template std::int64_t MshSource::load<std::int64_t>();
template double MshSource::load<double>();

std::string MshSource::line() const {
  return fmt::format("line {}", scan_.line());
}

std::string MshSource::name_of(const char* what, std::int64_t tag) const {
  const std::string name = fmt::format("{} {}", what, tag);
  return binary_ ? name : fmt::format("{} ({})", name, line());
}

}  // namespace crest::io
