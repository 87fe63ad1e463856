// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of VTP and VTU before VTK reads it: VTK allocates whatever a header or a block announces.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <optional>

#include "io/formats/files.hpp"
#include "io/formats/text_scan.hpp"
#include "io/formats/vtk_input.hpp"

namespace crest::io {
namespace {

/// zlib expands a byte to at most 1032.
constexpr std::uint64_t kExpansion = 1032, kSlack = 1 << 20;

constexpr std::string_view kTruncatedXml =
    "the file is truncated or its header wrong; export the mesh again";

/// The number at `text`, past blanks, '=' and quotes; a number too large is the largest.
std::uint64_t leading_number(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n=\"'"), text.size());
  std::uint64_t value = 0;
  const auto end = text.data() + text.size();
  const auto result = std::from_chars(text.data() + begin, end, value);
  return result.ec == std::errc::result_out_of_range ? ~std::uint64_t{0} : value;
}

/// Sum of an XML attribute's values over all its occurrences, capped.
std::uint64_t attribute_sum(std::string_view bytes, std::string_view name) {
  constexpr std::uint64_t cap = std::uint64_t{1} << 62;
  std::uint64_t sum = 0;
  for (std::size_t at = bytes.find(name); at != std::string_view::npos;
       at = bytes.find(name, at + 1))
    sum = std::min(cap, sum + std::min(leading_number(bytes.substr(at + name.size())), cap));
  return sum;
}

/// How the file stores binary arrays.
struct Storage {
  bool compressed, wide, big_endian;
  bool base64 = true;        ///< of appended data
  std::size_t appended = 0;  ///< where it starts, or the file's size
  std::size_t word() const { return wide ? 8 : 4; }
};

Storage storage_of(std::string_view bytes) {
  const std::string_view head =
      bytes.substr(0, std::min({bytes.find("<PolyData"), bytes.find("<UnstructuredGrid"),
                                bytes.find("<ImageData")}));
  Storage storage{head.find("compressor") != std::string_view::npos,
                  head.find("UInt64") != std::string_view::npos,
                  head.find("BigEndian") != std::string_view::npos};
  const std::size_t tag = bytes.find("<AppendedData");
  const std::size_t close = tag == std::string_view::npos ? tag : bytes.find('>', tag);
  const std::size_t mark = close == std::string_view::npos ? close : bytes.find('_', close);
  storage.appended = mark == std::string_view::npos ? bytes.size() : mark + 1;
  if (close != std::string_view::npos)
    storage.base64 = bytes.substr(tag, close - tag).find("raw") == std::string_view::npos;
  return storage;
}

int base64_value(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

/// Reads the words of a block's header one after another.
class WordReader {
 public:
  WordReader(std::string_view text, const Storage& storage, bool base64)
      : text_(text), storage_(storage), base64_(base64) {}

  std::optional<std::uint64_t> next() {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < storage_.word(); ++i) {
      const int byte = next_byte();
      if (byte < 0) return std::nullopt;
      const auto b = static_cast<std::uint64_t>(byte);
      value = storage_.big_endian ? value << 8 | b : value | b << (8 * i);
    }
    return value;
  }

 private:
  int next_byte() {
    if (!base64_) return at_ < text_.size() ? static_cast<unsigned char>(text_[at_++]) : -1;
    while (bits_ < 8) {
      const int digit = at_ < text_.size() ? base64_value(text_[at_++]) : -1;
      if (digit < 0) return -1;
      pool_ = (pool_ << 6 | static_cast<unsigned>(digit)) & 0xffffffu;
      bits_ += 6;
    }
    bits_ -= 8;
    return static_cast<int>(pool_ >> bits_ & 0xff);
  }

  std::string_view text_;
  const Storage& storage_;
  bool base64_;
  std::size_t at_ = 0;
  unsigned pool_ = 0;
  int bits_ = 0;
};

/// A binary array starts with its size, or with block count, block size, last block's size and the
/// compressed size of each block. A header that ends early is left to VTK.
void check_array(std::string_view text, const Storage& storage, bool base64, std::size_t room,
                 std::size_t array) {
  const auto check = [&](std::uint64_t announced, std::uint64_t limit) {
    if (announced <= limit) return;
    fail(fmt::format("array {}", array),
         fmt::format("announces {}, more than the file holds", announced),
         std::string(kTruncatedXml));
  };
  WordReader words(text, storage, base64);
  const auto first = words.next();
  if (!first) return;
  check(*first, room);
  if (!storage.compressed) return;
  const auto size = words.next(), last = words.next();
  if (!size || !last) return;
  const std::uint64_t limit = kExpansion * room + kSlack;
  check(*size, limit);
  check(*last, *size);
  if (*first == 0 ? *last != 0 : *size == 0) {
    fail(fmt::format("array {}", array), "its blocks contradict each other",
         "export the mesh again");
  }
  if (*first > 0) check(*size, limit / *first + kSlack);
  for (std::uint64_t i = 0; i < *first; ++i) {
    const auto block = words.next();
    if (!block) return;
    check(*block, room);
  }
}

/// VTK refuses points of another dimension, but loses memory over it.
void check_points(std::string_view text) {
  for (std::size_t at = text.find("<Points"); at != text.npos; at = text.find("<Points", at + 1)) {
    const std::size_t array = std::min(text.find("<DataArray", at), text.size());
    const std::string_view tag = text.substr(array, text.find('>', array) - array);
    const std::string_view name = "NumberOfComponents=";
    const std::size_t found = tag.find(name);
    if (found == tag.npos || leading_number(tag.substr(found + name.size())) != 3)
      fail("points", "do not have 3 components", "export the mesh again");
  }
}

}  // namespace

void check_xml(std::string_view bytes) {
  const Storage storage = storage_of(bytes);
  const std::uint64_t room = bytes.size() * (storage.compressed ? 100 : 1);
  for (const char* name :
       {"NumberOfPoints", "NumberOfVerts", "NumberOfLines", "NumberOfStrips", "NumberOfPolys",
        "NumberOfCells", "NumberOfTuples", "NumberOfComponents"}) {
    const std::uint64_t count = attribute_sum(bytes, name);
    if (count > room) {
      fail("header", fmt::format("{} is {}, more than the file holds", name, count),
           std::string(kTruncatedXml));
    }
  }
  const std::string_view text = bytes;
  check_points(text);
  const std::string_view tag_name = "<DataArray";
  std::size_t array = 0;
  for (std::size_t at = text.find(tag_name); at < storage.appended && at != text.npos;
       at = text.find(tag_name, at + 1), ++array) {
    const std::size_t close = text.find('>', at);
    if (close == text.npos) return;
    const std::string_view tag = text.substr(at, close - at);
    if (tag.find("appended") != tag.npos) {
      // Not the "offsets" of Name="offsets".
      const std::size_t offset = tag.find("offset=");
      if (offset == tag.npos) continue;
      const std::uint64_t begin = leading_number(tag.substr(offset + 6));
      if (begin > text.size() - storage.appended) continue;
      check_array(text.substr(storage.appended + begin), storage, storage.base64, text.size(),
                  array);
    } else if (tag.find("binary") != tag.npos) {
      const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n", close + 1), text.size());
      check_array(text.substr(begin), storage, true, text.size(), array);
    }
  }
}

void check_extents(std::string_view bytes) {
  constexpr std::string_view name = "Extent=";
  for (std::size_t at = bytes.find(name); at != bytes.npos; at = bytes.find(name, at + 1)) {
    const std::string text(bytes.substr(at + name.size() + 1, 200));
    const char* p = text.c_str();
    double count = 1;
    for (int k = 0; k < 3; ++k) {
      char* end = nullptr;
      const double low = std::strtod(p, &end), high = std::strtod(end, &end);
      p = end;
      count *= high - low + 1;
    }
    if (!(count > 0 && count < static_cast<double>(kExpansion * bytes.size())))
      fail("header",
           fmt::format("the extent {} is empty or more than the file holds",
                       io::quoted(text.substr(0, text.find('"')))),
           "the file is truncated or its header wrong; export it again");
  }
}

}  // namespace crest::io
