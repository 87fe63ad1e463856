// SPDX-License-Identifier: GPL-3.0-or-later
// PGM and PPM, text and binary, 8 and 16 bits.
#include <fmt/format.h>

#include "io/formats/text_scan.hpp"
#include "io/formats/volume.hpp"

namespace crest::io {
namespace {

std::size_t take_count(TextScan& scan, const char* what, std::size_t most) {
  std::uint64_t n = 0;
  const bool given = scan.more();
  const std::string word = io::quoted(scan.peek());
  if (!given || !scan.take(n) || n < 1 || n > most)
    fail(fmt::format("header (line {})", scan.line()), fmt::format("{} {} is none", what, word),
         "correct it");
  return n;
}

Samples text_samples(TextScan& scan, std::size_t count, std::size_t most) {
  if (count > (scan.room() + 1) / 2)
    fail("samples", fmt::format("the header announces {}, the file ends before", count),
         "the file is truncated or its header wrong; export it again");
  std::vector<std::uint16_t> samples(count);
  for (std::uint16_t& x : samples) {
    std::uint64_t n = 0;
    if (!scan.more()) fail("samples", "the file ends in them", "export the image again");
    if (!scan.take(n) || n > most)
      fail(fmt::format("samples (line {})", scan.line()),
           fmt::format("{} is none up to {}", io::quoted(scan.peek()), most), "correct it");
    x = static_cast<std::uint16_t>(n);
  }
  if (most > 255) return samples;
  return std::vector<std::uint8_t>(samples.begin(), samples.end());
}

}  // namespace

Volume read_pnm(std::string_view bytes, const VolumeRequest&) {
  if (bytes.size() < 3 || bytes[0] != 'P')
    fail("header", "does not start with P2, P3, P5 or P6", "save the image as PGM");
  const char kind = bytes[1];
  if (kind != '2' && kind != '3' && kind != '5' && kind != '6')
    fail("header", fmt::format("{} is not read", io::quoted(bytes.substr(0, 2))),
         "save the image as PGM");
  TextScan scan(bytes, '#');
  scan.take_bytes(2);
  const std::size_t colours = kind == '3' || kind == '6' ? 3 : 1;
  const std::size_t width = take_count(scan, "the width", 1u << 30);
  const std::size_t height = take_count(scan, "the height", 1u << 30);
  const std::size_t most = take_count(scan, "the largest value", 65535);
  const std::vector<std::size_t> size = {colours, width, height};
  Samples samples;
  if (kind <= '3') {
    samples = text_samples(scan, product(size), most);
  } else {
    const NumberType type = most > 255 ? NumberType::u16 : NumberType::u8;
    const std::size_t begin = std::min(scan.position() + 1, bytes.size());  // one blank
    samples = load_samples(type, bytes.substr(begin), size, true);
  }
  Volume image;
  set_image(image, width, height, colours, samples);
  return image;
}

}  // namespace crest::io
