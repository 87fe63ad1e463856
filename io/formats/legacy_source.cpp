// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/legacy_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "io/formats/files.hpp"
#include "io/formats/remedy.hpp"

namespace crest::io {
namespace {

std::vector<std::int64_t> unpacked_bits(std::string_view bytes, std::size_t count) {
  std::vector<std::int64_t> bits;
  bits.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    bits.push_back(static_cast<unsigned char>(bytes[i / 8]) >> (7 - i % 8) & 1);
  return bits;
}

template <class T>
std::vector<T> loaded(std::string_view bytes, NumberType type, std::size_t count) {
  std::vector<T> numbers(count);
  with_type(type, [&](auto sample) {
    const char* at = bytes.data();
    for (T& x : numbers) {
      x = static_cast<T>(load_number<decltype(sample)>(at, true));
      at += sizeof sample;
    }
  });
  return numbers;
}

std::string decoded(std::string_view name) {
  const auto digit = [](char c) {
    return c >= '0' && c <= '9' ? c - '0' : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
  };
  std::string result;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool code =
        name[i] == '%' && i + 2 < name.size() && digit(name[i + 1]) >= 0 && digit(name[i + 2]) >= 0;
    result += code ? static_cast<char>(16 * digit(name[i + 1]) + digit(name[i + 2])) : name[i];
    i += code ? 2 : 0;
  }
  return result;
}

}  // namespace

LegacySource::LegacySource(std::string_view bytes) : scan_(bytes) {
  constexpr std::string_view start = "# vtk datafile version";
  if (!is_keyword(scan_.peek_bytes(start.size()), start))
    fail("header (line 1)", "does not start with '# vtk DataFile Version'", kExportMesh);
  scan_.take_bytes(start.size());
  if (!scan_.in_line() || !scan_.take(version_) || !(version_ >= 1 && version_ < 6))
    fail("header (line 1)", "has no version from 1.0 to 5.1", kExportMesh);
  scan_.next_line();  // to the title, which may be empty
  scan_.next_line();
  const std::string_view kind = scan_.more() ? scan_.word() : "";  // as VTK: past blank lines
  binary_ = is_keyword(kind, "binary");
  if (!binary_ && !is_keyword(kind, "ascii"))
    fail("header (line 3)", "is neither ASCII nor BINARY", kExportMesh);
  if (binary_) return;
  const std::string_view text = check_text(bytes);
  const std::size_t place = std::min(scan_.position(), text.size());
  scan_ = TextScan(text);
  scan_.move_to(place);
}

bool LegacySource::next_section() {
  if (!scan_.more()) return false;
  section_ = scan_.word().substr(0, 40);
  for (char& c : section_)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return true;
}

std::string LegacySource::where() const {
  return fmt::format("{} (line {})", section_, scan_.line());
}

std::string_view LegacySource::take_word() {
  if (!scan_.in_line()) fail(where(), "ends early", kExportMesh);
  return scan_.word();
}

std::string LegacySource::take_name() {
  return decoded(take_word());
}

std::size_t LegacySource::take_count() {
  std::int64_t count = 0;
  if (!scan_.in_line() || !scan_.take(count) || count < 0)
    fail(where(), fmt::format("has a bad count {}", quoted(scan_.peek())), kExportMesh);
  return static_cast<std::size_t>(count);
}

double LegacySource::take_real() {
  double x = 0;
  if (!scan_.in_line() || !scan_.take(x))
    fail(where(), fmt::format("{} is not a number", quoted(scan_.peek())), kExportMesh);
  return x;
}

LegacyType LegacySource::take_type() {
  // vtkIdType has 32 bits in files, long 64.
  static const std::map<std::string, NumberType> types = {{"char", NumberType::i8},
                                                          {"signed_char", NumberType::i8},
                                                          {"unsigned_char", NumberType::u8},
                                                          {"short", NumberType::i16},
                                                          {"unsigned_short", NumberType::u16},
                                                          {"int", NumberType::i32},
                                                          {"unsigned_int", NumberType::u32},
                                                          {"long", NumberType::i64},
                                                          {"unsigned_long", NumberType::u64},
                                                          {"vtkidtype", NumberType::i32},
                                                          {"vtktypeint8", NumberType::i8},
                                                          {"vtktypeuint8", NumberType::u8},
                                                          {"vtktypeint16", NumberType::i16},
                                                          {"vtktypeuint16", NumberType::u16},
                                                          {"vtktypeint32", NumberType::i32},
                                                          {"vtktypeuint32", NumberType::u32},
                                                          {"vtktypeint64", NumberType::i64},
                                                          {"vtktypeuint64", NumberType::u64},
                                                          {"float", NumberType::f32},
                                                          {"double", NumberType::f64}};
  const std::string_view word = take_word();
  if (is_keyword(word, "bit")) return {NumberType::u8, true};
  for (const auto& [name, type] : types)
    if (is_keyword(word, name)) return {type, false};
  fail(where(), fmt::format("has the type {}", quoted(word)), "save the array as double or int");
}

bool LegacySource::take_line_of(std::string_view lower) {
  const std::size_t before = scan_.position();
  if (scan_.more() && is_keyword(scan_.peek(lower.size() + 1), lower)) {
    scan_.rest_of_line();
    return true;
  }
  scan_.move_to(before);
  return false;
}

void LegacySource::skip_block() {
  while (scan_.next_line() && scan_.in_line()) {
  }
}

void LegacySource::skip_lines(std::size_t count) {
  for (; count > 0 && scan_.next_line(); --count) {
  }
  scan_.rest_of_line();
}

void LegacySource::require_more() {
  if (!scan_.more()) fail_end();
}

void LegacySource::fail_end() const {
  fail(section_, "the file ends in it", "the file is truncated; export the mesh again");
}

void LegacySource::require_words(std::size_t count) const {
  if (count > (scan_.room() + 1) / 2) fail_end();
}

std::size_t LegacySource::product(std::size_t a, std::size_t b) const {
  std::size_t result = 0;
  if (__builtin_mul_overflow(a, b, &result)) fail(where(), "has a bad count", kExportMesh);
  return result;
}

std::string_view LegacySource::take_bytes(LegacyType type, std::size_t count) {
  scan_.next_line();
  const std::size_t size = size_of(type.number);
  if (type.bits) count = count / 8 + (count % 8 != 0 ? 1 : 0);
  if (count > scan_.room() / size) fail_end();
  return scan_.take_bytes(count * size);
}

template <class T>
std::vector<T> LegacySource::take_words(std::size_t count) {
  require_words(count);
  std::vector<T> numbers(count);
  for (T& x : numbers) {
    require_more();
    if (scan_.take(x)) continue;
    const char* kind = std::is_integral_v<T> ? " is not an integer" : " is not a number";
    fail(where(), quoted(scan_.peek()) + kind, "correct it");
  }
  return numbers;
}

Field::Numbers LegacySource::take(LegacyType type, std::size_t count) {
  const bool real = is_real(type.number), natural = type.number == NumberType::u64;
  if (!binary_) {
    if (real) return take_words<double>(count);
    if (natural) return take_words<std::uint64_t>(count);
    return take_words<std::int64_t>(count);
  }
  const std::string_view bytes = take_bytes(type, count);
  if (type.bits) return unpacked_bits(bytes, count);
  if (real) return loaded<double>(bytes, type.number, count);
  if (natural) return loaded<std::uint64_t>(bytes, type.number, count);
  return loaded<std::int64_t>(bytes, type.number, count);
}

std::vector<std::int64_t> LegacySource::take_integers(LegacyType type, std::size_t count) {
  Field::Numbers numbers = take(type, count);
  if (auto* integers = std::get_if<std::vector<std::int64_t>>(&numbers))
    return std::move(*integers);
  fail(section_, "does not hold signed integers", "save it as vtktypeint64");
}

void LegacySource::skip(LegacyType type, std::size_t count) {
  if (binary_) {
    take_bytes(type, count);
    return;
  }
  require_words(count);
  for (std::size_t i = 0; i < count; ++i) {
    require_more();
    scan_.skip_word();
  }
}

}  // namespace crest::io
