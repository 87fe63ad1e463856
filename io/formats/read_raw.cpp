// SPDX-License-Identifier: GPL-3.0-or-later
// Samples without a header.
#include <fmt/format.h>

#include <map>

#include "io/formats/text_scan.hpp"
#include "io/formats/volume.hpp"

namespace crest::io {

Volume read_raw(std::string_view bytes, const std::string& shape) {
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
  Volume volume;
  for (std::size_t k = 0; k < 3; ++k) {
    std::uint64_t n = 0;
    if (!scan.in_line() || !scan.take(n) || n == 0) refuse();
    volume.size.push_back(n);
    volume.steps.emplace_back()[k] = 1;
  }
  const auto type = types.find(std::string(scan.in_line() ? scan.word() : ""));
  if (type == types.end() || scan.in_line()) refuse();
  volume.samples = load_samples(type->second, bytes, volume.size, false);
  return volume;
}

}  // namespace crest::io
