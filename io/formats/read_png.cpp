// SPDX-License-Identifier: GPL-3.0-or-later
// PNG of 1 to 16 bits, not interlaced. Own code: VTK's reader crashes on damaged files.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "io/formats/volume.hpp"

namespace crest::io {
namespace {

enum class ColourType : std::uint8_t { grey = 0, rgb = 2, palette = 3, grey_alpha = 4, rgba = 6 };

struct PngHeader {
  std::size_t width = 0, height = 0;
  unsigned depth = 0;
  ColourType type{};

  std::size_t channels() const {
    switch (type) {
      case ColourType::rgb:
        return 3;
      case ColourType::grey_alpha:
        return 2;
      case ColourType::rgba:
        return 4;
      default:
        return 1;
    }
  }
  /// Bytes of a row.
  std::size_t row() const { return (width * channels() * depth + 7) / 8; }
};

std::uint32_t word(std::string_view bytes, std::size_t at) {
  return load_number<std::uint32_t>(bytes.data() + at, true);
}

PngHeader read_header(std::string_view chunk) {
  PngHeader header;
  if (chunk.size() != 13) fail("header", "is none of PNG", "save the image as PNG");
  header.width = word(chunk, 0);
  header.height = word(chunk, 4);
  header.depth = static_cast<unsigned char>(chunk[8]);
  const auto type = static_cast<unsigned char>(chunk[9]);
  header.type = static_cast<ColourType>(type);
  const bool packed = header.depth == 1 || header.depth == 2 || header.depth == 4;
  if ((type > 6 || type == 1 || type == 5) ||
      !(packed || header.depth == 8 || header.depth == 16) || (packed && type != 0 && type != 3) ||
      (header.depth == 16 && type == 3) || chunk[10] != 0 || chunk[11] != 0)
    fail("header", fmt::format("colour type {} of {} bits is none of PNG", type, header.depth),
         "save the image again");
  if (chunk[12] != 0) fail("header", "the image is interlaced", "save it without interlacing");
  constexpr std::size_t most = std::size_t{1} << 30;
  if (header.width < 1 || header.height < 1 || header.width > most || header.height > most)
    fail("header", fmt::format("has the size {} by {}", header.width, header.height),
         "save the image again");
  return header;
}

/// The chunks of a file, their checksums not looked at: zlib's guards the samples.
struct Chunks {
  std::optional<PngHeader> header;
  std::string packed;
  std::string_view palette;

  explicit Chunks(std::string_view bytes) {
    constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";
    if (!bytes.starts_with(signature)) fail("header", "is none of PNG", "save the image as PNG");
    for (std::size_t at = signature.size(); at + 12 <= bytes.size();) {
      const std::size_t size = word(bytes, at);
      if (size > bytes.size() - at - 12)
        fail(fmt::format("byte {}", at), "the file ends in its chunk", "export the image again");
      const std::string_view type = bytes.substr(at + 4, 4), data = bytes.substr(at + 8, size);
      if (type == "IHDR") header = read_header(data);
      if (type == "PLTE") palette = data;
      if (type == "IDAT") packed += data;
      if (type == "IEND") break;
      at += size + 12;
    }
    if (!header) fail("header", "is missing", "export the image again");
  }
};

/// The predictor of Paeth.
unsigned paeth(int left, int up, int corner) {
  const int p = left + up - corner;
  const int a = std::abs(p - left), b = std::abs(p - up), c = std::abs(p - corner);
  return static_cast<unsigned>(a <= b && a <= c ? left : b <= c ? up : corner);
}

/// Undoes the filter of each row, which its first byte names; the rows without that byte.
std::string unfiltered(const std::string& data, const PngHeader& header) {
  const std::size_t row = header.row();
  const std::size_t step = std::max<std::size_t>(1, header.channels() * header.depth / 8);
  std::string result(row * header.height, '\0');
  const auto byte = [](char c) { return static_cast<unsigned>(static_cast<unsigned char>(c)); };
  for (std::size_t y = 0; y < header.height; ++y) {
    const char* from = data.data() + y * (row + 1);
    const unsigned filter = byte(*from++);
    if (filter > 4)
      fail(fmt::format("row {}", y), "has an unknown filter", "export the image again");
    char* to = result.data() + y * row;
    const char* above = y > 0 ? to - row : nullptr;
    for (std::size_t x = 0; x < row; ++x) {
      const unsigned left = x >= step ? byte(to[x - step]) : 0, up = above ? byte(above[x]) : 0;
      const unsigned corner = x >= step && above ? byte(above[x - step]) : 0;
      const unsigned guess = filter == 1   ? left
                             : filter == 2 ? up
                             : filter == 3 ? (left + up) / 2
                             : filter == 4 ? paeth(static_cast<int>(left), static_cast<int>(up),
                                                   static_cast<int>(corner))
                                           : 0;
      to[x] = static_cast<char>(byte(from[x]) + guess);
    }
  }
  return result;
}

/// Samples of fewer than 8 bits, the first in the highest bits of its byte.
std::string unpacked(const std::string& rows, const PngHeader& header) {
  std::string result;
  result.reserve(header.width * header.height);
  for (std::size_t y = 0; y < header.height; ++y)
    for (std::size_t x = 0; x < header.width; ++x) {
      const auto byte = static_cast<unsigned char>(rows[y * header.row() + x * header.depth / 8]);
      const std::size_t shift = 8 - header.depth - x * header.depth % 8;
      result += static_cast<char>(byte >> shift & ((1u << header.depth) - 1));
    }
  return result;
}

std::string looked_up(const std::string& indices, std::string_view palette) {
  std::string colours;
  colours.reserve(3 * indices.size());
  for (const char c : indices) {
    const std::size_t i = static_cast<unsigned char>(c);
    if (3 * i + 3 > palette.size())
      fail(fmt::format("colour {}", i), "is not in the palette", "export the image again");
    colours += palette.substr(3 * i, 3);
  }
  return colours;
}

/// Without every `channels`-th sample, the opacity.
template <class Native>
Samples opaque(const std::vector<Native>& samples, std::size_t channels) {
  std::vector<Native> result;
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (i % channels != channels - 1) result.push_back(samples[i]);
  return result;
}

}  // namespace

Volume read_png(std::string_view bytes, const VolumeRequest&) {
  const Chunks chunks(bytes);
  const PngHeader& header = *chunks.header;
  const std::size_t expected = product({header.height, header.row() + 1});
  const std::string data = inflated(chunks.packed, expected);
  if (data.size() != expected)
    fail("samples",
         fmt::format("there are {} bytes, the header announces {}", data.size(), expected),
         "the file is truncated or its header wrong; export it again");
  std::string rows = unfiltered(data, header);
  if (header.depth < 8) rows = unpacked(rows, header);
  std::size_t channels = header.channels();
  if (header.type == ColourType::palette) {
    rows = looked_up(rows, chunks.palette);
    channels = 3;
  }
  const NumberType type = header.depth == 16 ? NumberType::u16 : NumberType::u8;
  Samples samples = load_samples(type, rows, {channels, header.width, header.height}, true);
  Volume image;
  if (channels % 2 == 0) {
    samples = std::visit([&](const auto& x) { return opaque(x, channels); }, samples);
    --channels;
    image.warnings.emplace_back("the image's opacity is passed over");
  }
  set_image(image, header.width, header.height, channels, samples);
  return image;
}

}  // namespace crest::io
