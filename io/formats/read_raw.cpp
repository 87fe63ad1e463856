// SPDX-License-Identifier: GPL-3.0-or-later
// Samples without a header.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "io/formats/plain_samples.hpp"
#include "io/formats/text_scan.hpp"

namespace crest::io {

PlainSamples plain_raw(const std::string& shape) {
  static const std::map<std::string, NumberType> types = {
      {"int8", NumberType::i8},    {"uint8", NumberType::u8},   {"int16", NumberType::i16},
      {"uint16", NumberType::u16}, {"int32", NumberType::i32},  {"uint32", NumberType::u32},
      {"int64", NumberType::i64},  {"uint64", NumberType::u64}, {"float", NumberType::f32},
      {"double", NumberType::f64}};
  const auto refuse = [&] {
    fail("--raw", io::quoted(shape) + " is no NX,NY,NZ,TYPE",
         "give three sizes and one of int8 uint8 .. int64 uint64 float double");
  };
  std::string words = shape;
  for (char& c : words)
    if (c == ',') c = ' ';
  TextScan scan(words);
  PlainSamples plain;
  Volume& volume = plain.volume;
  for (std::size_t k = 0; k < 3; ++k) {
    std::uint64_t n = 0;
    if (!scan.in_line() || !scan.take(n) || n == 0) refuse();
    volume.size.push_back(n);
    volume.steps.emplace_back()[k] = 1;
  }
  const auto type = types.find(std::string(scan.in_line() ? scan.word() : ""));
  if (type == types.end() || scan.in_line()) refuse();
  plain.type = type->second;
  return plain;
}

void check_length(const PlainSamples& plain, std::size_t file_size) {
  const std::size_t count = product(plain.volume.size), each = size_of(plain.type);
  const std::size_t bytes = file_size - std::min(file_size, plain.offset);
  if (bytes != count * each)
    fail("samples",
         fmt::format("there are {} bytes, the header announces {} ({} samples of {})", bytes,
                     count * each, count, each),
         "the file is truncated or its header wrong; export it again");
}

Volume read_raw(std::string_view bytes, const std::string& shape) {
  PlainSamples plain = plain_raw(shape);
  plain.volume.samples = load_samples(plain.type, bytes, plain.volume.size, false);
  return std::move(plain.volume);
}

}  // namespace crest::io
