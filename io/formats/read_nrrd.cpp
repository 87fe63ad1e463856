// SPDX-License-Identifier: GPL-3.0-or-later
// NRRD: raw, gzip and text; spacings or space directions; the samples behind the header or in a
// file of their own.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "io/formats/plain_samples.hpp"
#include "io/formats/text_scan.hpp"

namespace crest::io {
namespace {

using kernel::operator*;

constexpr const char* kCorrectNrrd = "correct the NRRD header";

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r'))
    text.remove_suffix(1);
  return text;
}

/// The lines "KEY: VALUE" up to a blank one.
class NrrdHeader {
 public:
  explicit NrrdHeader(std::string_view bytes) {
    if (!bytes.starts_with("NRRD000"))
      fail("header (line 1)", "does not start with 'NRRD000'", kCorrectNrrd);
    for (std::size_t begin = 0; begin < bytes.size();) {
      const std::size_t end = std::min(bytes.find('\n', begin), bytes.size());
      const std::string_view line = trimmed(bytes.substr(begin, end - begin));
      begin = std::min(end + 1, bytes.size());
      ++line_;
      if (line.empty()) {
        size_ = begin;
        return;
      }
      if (line_ > 1 && line[0] != '#') add(line);
    }
    size_ = bytes.size();
  }
  /// Bytes up to the samples.
  std::size_t size() const { return size_; }
  bool has(const char* key) const { return values_.count(key) > 0; }
  /// The value, as it stands there; empty: there is none.
  std::string value(const char* key) const {
    const auto found = values_.find(key);
    return found == values_.end() ? std::string() : found->second.text;
  }
  std::string where(const char* key) const {
    const auto found = values_.find(key);
    return found == values_.end() ? "header" : fmt::format("{} (line {})", key, found->second.line);
  }
  std::vector<std::size_t> counts(const char* key) const {
    std::vector<std::size_t> result;
    const std::string text = value(key);
    TextScan scan(text);
    while (scan.in_line()) {
      std::uint64_t n = 0;
      if (!scan.take(n) || n == 0)
        fail(where(key), fmt::format("{} is no count", io::quoted(scan.peek())), kCorrectNrrd);
      result.push_back(n);
    }
    return result;
  }

 private:
  struct Value {
    std::string text;
    std::size_t line;
  };
  void add(std::string_view line) {
    const std::size_t colon = line.find(": ");
    if (colon != line.npos) {
      values_[lower(line.substr(0, colon))] = {std::string(trimmed(line.substr(colon + 2))), line_};
    } else if (line.find(":=") == line.npos && line.back() != ':') {
      fail(fmt::format("header (line {})", line_), fmt::format("{} is no field", io::quoted(line)),
           kCorrectNrrd);
    }
  }
  std::map<std::string, Value> values_;
  std::size_t size_ = 0, line_ = 0;
};

NumberType number_type(const NrrdHeader& header) {
  static const std::map<std::string, NumberType> types = {
      {"signed char", NumberType::i8},
      {"int8", NumberType::i8},
      {"int8_t", NumberType::i8},
      {"uchar", NumberType::u8},
      {"unsigned char", NumberType::u8},
      {"uint8", NumberType::u8},
      {"uint8_t", NumberType::u8},
      {"short", NumberType::i16},
      {"short int", NumberType::i16},
      {"signed short", NumberType::i16},
      {"signed short int", NumberType::i16},
      {"int16", NumberType::i16},
      {"int16_t", NumberType::i16},
      {"ushort", NumberType::u16},
      {"unsigned short", NumberType::u16},
      {"unsigned short int", NumberType::u16},
      {"uint16", NumberType::u16},
      {"uint16_t", NumberType::u16},
      {"int", NumberType::i32},
      {"signed int", NumberType::i32},
      {"int32", NumberType::i32},
      {"int32_t", NumberType::i32},
      {"uint", NumberType::u32},
      {"unsigned int", NumberType::u32},
      {"uint32", NumberType::u32},
      {"uint32_t", NumberType::u32},
      {"longlong", NumberType::i64},
      {"long long", NumberType::i64},
      {"long long int", NumberType::i64},
      {"signed long long", NumberType::i64},
      {"signed long long int", NumberType::i64},
      {"int64", NumberType::i64},
      {"int64_t", NumberType::i64},
      {"ulonglong", NumberType::u64},
      {"unsigned long long", NumberType::u64},
      {"unsigned long long int", NumberType::u64},
      {"uint64", NumberType::u64},
      {"uint64_t", NumberType::u64},
      {"float", NumberType::f32},
      {"double", NumberType::f64}};
  const auto found = types.find(lower(header.value("type")));
  if (found == types.end())
    fail(header.where("type"),
         fmt::format("the type {} is not read", io::quoted(header.value("type"))),
         "convert the samples to uint8, int16 or float");
  return found->second;
}

/// "(a,b,c)", "(a,b)" or "none", which is zero.
kernel::Vec3 vector_of(const std::string& where, std::string_view text) {
  kernel::Vec3 v{};
  if (text == "none") return v;
  std::string numbers(text);
  for (char& c : numbers)
    if (c == '(' || c == ')' || c == ',') c = ' ';
  TextScan scan(numbers);
  std::size_t k = 0;
  while (scan.in_line())
    if (k == 3 || !scan.take(v[k++])) fail(where, io::quoted(text) + " is no vector", kCorrectNrrd);
  if (k < 2) fail(where, io::quoted(text) + " is no vector", kCorrectNrrd);
  return v;
}

/// The vectors of a line, whatever blanks they hold.
std::vector<kernel::Vec3> vectors_of(const NrrdHeader& header, const char* key) {
  const std::string text = header.value(key);
  std::vector<kernel::Vec3> result;
  for (std::size_t at = text.find_first_not_of(" \t"); at < text.size();
       at = text.find_first_not_of(" \t", at)) {
    const std::size_t end = text[at] == '(' ? std::min(text.find(')', at), text.size() - 1) + 1
                                            : std::min(text.find_first_of(" \t", at), text.size());
    result.push_back(vector_of(header.where(key), std::string_view(text).substr(at, end - at)));
    at = end;
  }
  return result;
}

/// Whether the first axis is none of space: of a vector's or tensor's components.
bool holds_components(const NrrdHeader& header) {
  const std::string kinds = header.value("kinds");
  const std::string first = lower(kinds.substr(0, kinds.find_first_of(" \t")));
  return first.find("vector") != first.npos || first.find("normal") != first.npos ||
         first.find("matrix") != first.npos;
}

void place(const NrrdHeader& header, Volume& volume) {
  const std::size_t axes = volume.size.size();
  const auto check = [&](const char* key, std::size_t count) {
    if (count != axes)
      fail(header.where(key), fmt::format("there are {}, the dimension is {}", count, axes),
           kCorrectNrrd);
  };
  volume.steps.assign(axes, {});
  std::size_t k = 0;  // of the axes in space, of which vectors and the like are none
  for (std::size_t i = 0; i < axes; ++i)
    if (volume.size[i] > 1 && k < 3 && !(i == 0 && holds_components(header)))
      volume.steps[i][k++] = 1;
  if (header.has("space directions")) {
    volume.steps = vectors_of(header, "space directions");
    check("space directions", volume.steps.size());
  } else if (header.has("spacings")) {
    const std::string text = header.value("spacings");
    TextScan scan(text);
    std::size_t i = 0;
    for (; scan.in_line(); ++i) {
      double spacing = 0;
      if (!scan.take(spacing))
        fail(header.where("spacings"), io::quoted(scan.peek()) + " is no number", kCorrectNrrd);
      if (i < axes && std::isfinite(spacing)) volume.steps[i] = spacing * volume.steps[i];
    }
    check("spacings", i);
  }
  if (header.has("space origin"))
    volume.origin = vector_of(header.where("space origin"), header.value("space origin"));
}

Samples text_samples(NumberType type, std::string_view bytes,
                     const std::vector<std::size_t>& size) {
  const std::size_t count = product(size);
  if (count > (bytes.size() + 1) / 2)
    fail("samples", fmt::format("the header announces {}, the file ends before", count),
         "the file is truncated or its header wrong; export it again");
  TextScan scan(bytes);
  return with_type(type, [&](auto zero) -> Samples {
    using Native = decltype(zero);
    std::vector<Native> samples(count);
    for (Native& to : samples) {
      std::conditional_t<std::is_floating_point_v<Native>, double,
                         std::conditional_t<std::is_signed_v<Native>, std::int64_t, std::uint64_t>>
          x = 0;
      if (!scan.more()) fail("samples", "the file ends in them", "export it again");
      if (!scan.take(x))
        fail(fmt::format("samples (line {})", scan.line()),
             io::quoted(scan.peek()) + " is no number of the type", "correct it");
      if constexpr (std::is_integral_v<Native>)
        if (!std::in_range<Native>(x))
          fail(fmt::format("samples (line {})", scan.line()),
               fmt::format("{} does not fit the type", x), "correct it");
      to = static_cast<Native>(x);
    }
    return samples;
  });
}

/// All but the samples.
PlainSamples frame_of(const NrrdHeader& header) {
  PlainSamples plain;
  Volume& volume = plain.volume;
  volume.size = header.counts("sizes");
  const auto dimension = header.counts("dimension");
  if (dimension.size() != 1 || dimension[0] != volume.size.size() || dimension[0] == 0)
    fail(header.where("sizes"),
         fmt::format("there are {}, not as many as the dimension", volume.size.size()),
         kCorrectNrrd);
  place(header, volume);
  plain.type = number_type(header);
  plain.big_endian = lower(header.value("endian")) == "big";
  plain.offset = header.size();
  for (const char* key : {"line skip", "lineskip", "byte skip", "byteskip"})
    if (header.has(key) && header.value(key) != "0")
      fail(header.where(key), "is not read", "save the file without skipped bytes");
  return plain;
}

const char* data_file_key(const NrrdHeader& header) {
  return header.has("data file") ? "data file" : "datafile";
}

void check_endian(const NrrdHeader& header, NumberType type, const std::string& encoding) {
  if (size_of(type) > 1 && !header.has("endian") && encoding != "ascii" && encoding != "text" &&
      encoding != "txt")
    fail("header", "does not say which endian the samples are",
         "add 'endian: little' or 'endian: big'");
}

}  // namespace

std::optional<PlainSamples> plain_nrrd(std::string_view bytes) {
  const NrrdHeader header(bytes);
  PlainSamples plain = frame_of(header);
  if (header.has(data_file_key(header)) || lower(header.value("encoding")) != "raw") return {};
  check_endian(header, plain.type, "raw");
  return plain;
}

Volume read_nrrd(std::string_view bytes, const VolumeRequest& request) {
  const NrrdHeader header(bytes);
  PlainSamples plain = frame_of(header);
  Volume& volume = plain.volume;
  const NumberType type = plain.type;
  const char* const data_file = data_file_key(header);
  std::string_view data = bytes.substr(header.size());
  FileBytes other(0);
  if (header.has(data_file)) {
    const std::string name = header.value(data_file);
    if (name.starts_with("LIST") || name.find('%') != name.npos || !request.companion)
      fail(header.where(data_file), "several files are not read", "save it as one .nrrd");
    other = request.companion(name);
    data = other;
  }
  const std::string encoding = lower(header.value("encoding"));
  check_endian(header, type, encoding);
  if (encoding == "raw") {
    volume.samples = load_samples(type, data, volume.size, plain.big_endian);
  } else if (encoding == "gzip" || encoding == "gz") {
    const std::size_t expected = product(volume.size) * size_of(type);
    volume.samples = load_samples(type, inflated(data, expected), volume.size, plain.big_endian);
  } else if (encoding == "ascii" || encoding == "text" || encoding == "txt") {
    volume.samples = text_samples(type, data, volume.size);
  } else {
    fail(header.where("encoding"), fmt::format("the encoding {} is not read", io::quoted(encoding)),
         "save it as raw or gzip (unu save -f nrrd -e gzip)");
  }
  return std::move(plain.volume);
}

}  // namespace crest::io
