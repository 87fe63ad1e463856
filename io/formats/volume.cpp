// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/volume.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <limits>

namespace crest::io {
namespace {

static_assert(static_cast<int>(NumberType::f64) == static_cast<int>(kernel::SampleType::f64));

template <class To, class From>
std::vector<To> converted(const std::vector<From>& from) {
  return std::vector<To>(from.begin(), from.end());
}

template <class From>
Samples narrowed_integers(const std::vector<From>& numbers) {
  From low = 0, high = 0;
  for (const From x : numbers) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
  const auto fits = [&](auto type) {
    using To = decltype(type);
    return std::in_range<To>(low) && std::in_range<To>(high);
  };
  if (fits(std::uint8_t{})) return converted<std::uint8_t>(numbers);
  if (fits(std::int8_t{})) return converted<std::int8_t>(numbers);
  if (fits(std::uint16_t{})) return converted<std::uint16_t>(numbers);
  if (fits(std::int16_t{})) return converted<std::int16_t>(numbers);
  if (fits(std::uint32_t{})) return converted<std::uint32_t>(numbers);
  if (fits(std::int32_t{})) return converted<std::int32_t>(numbers);
  return numbers;
}

/// Closes zlib's stream whatever happens.
struct Stream {
  z_stream z{};
  ~Stream() { inflateEnd(&z); }
};

}  // namespace

std::size_t product(const std::vector<std::size_t>& size) {
  std::size_t result = 1;
  for (const std::size_t n : size)
    if (__builtin_mul_overflow(result, n, &result) || result > (std::size_t{1} << 48))
      fail("header", "announces more samples than memory holds", "correct the sizes");
  return result;
}

Samples load_samples(NumberType type, std::string_view bytes, const std::vector<std::size_t>& size,
                     bool big_endian) {
  const std::size_t count = product(size), each = size_of(type);
  if (bytes.size() != count * each) {
    fail("samples",
         fmt::format("there are {} bytes, the header announces {} ({} samples of {})", bytes.size(),
                     count * each, count, each),
         "the file is truncated or its header wrong; export it again");
  }
  return with_type(type, [&](auto zero) -> Samples {
    using Native = decltype(zero);
    std::vector<Native> samples(count);
    if (sizeof(Native) == 1 || !big_endian) {
      if (count > 0) std::memcpy(samples.data(), bytes.data(), bytes.size());
    } else {
      for (std::size_t i = 0; i < count; ++i)
        samples[i] = load_number<Native>(bytes.data() + i * each, true);
    }
    return samples;
  });
}

Samples narrowed(const Field::Numbers& numbers) {
  if (const auto* reals = std::get_if<std::vector<double>>(&numbers)) {
    const bool single = std::all_of(reals->begin(), reals->end(), [](double x) {
      return !(std::fabs(x) > std::numeric_limits<float>::max()) &&
             static_cast<double>(static_cast<float>(x)) == x;
    });
    if (single) return converted<float>(*reals);
    return *reals;
  }
  if (const auto* integers = std::get_if<std::vector<std::int64_t>>(&numbers))
    return narrowed_integers(*integers);
  return narrowed_integers(std::get<std::vector<std::uint64_t>>(numbers));
}

void set_image(Volume& image, std::size_t width, std::size_t height, std::size_t colours,
               const Samples& samples) {
  image.size = {width, height};
  image.steps = {{1, 0, 0}, {0, -1, 0}};
  image.origin = {0, static_cast<double>(height) - 1, 0};
  if (colours == 1) {
    image.samples = samples;
    return;
  }
  std::visit(
      [&](const auto& x) {
        using Native = typename std::decay_t<decltype(x)>::value_type;
        bool grey = true;
        std::vector<Native> first(width * height);
        std::vector<double> luminance(width * height);
        for (std::size_t i = 0; i < luminance.size(); ++i) {
          const Native r = x[3 * i], g = x[3 * i + 1], b = x[3 * i + 2];
          grey = grey && r == g && g == b;
          first[i] = r;
          luminance[i] = 0.2126 * static_cast<double>(r) + 0.7152 * static_cast<double>(g) +
                         0.0722 * static_cast<double>(b);
        }
        if (grey) {
          image.samples = std::move(first);
          return;
        }
        image.samples = std::move(luminance);
        image.warnings.emplace_back(
            "the image has colours: their luminance 0.2126 R + 0.7152 G + 0.0722 B is taken");
      },
      samples);
}

std::string inflated(std::string_view bytes, std::size_t limit) {
  constexpr std::size_t chunk = std::size_t{1} << 18;
  constexpr int any_header = 15 + 32;  // gzip's or zlib's
  const auto damaged = [] {
    fail("compressed data", "are damaged or cut off", "export the file again");
  };
  Stream stream;
  if (inflateInit2(&stream.z, any_header) != Z_OK) throw std::bad_alloc();
  std::string result;
  std::size_t taken = 0;
  int state = Z_OK;
  while (true) {
    const std::size_t before = result.size();
    result.resize(before + chunk);
    stream.z.next_out = reinterpret_cast<Bytef*>(result.data() + before);
    stream.z.avail_out = chunk;
    if (stream.z.avail_in == 0 && taken < bytes.size()) {
      const std::size_t part = std::min<std::size_t>(bytes.size() - taken, 1u << 30);
      stream.z.next_in =
          reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data() + taken));  // zlib only reads
      stream.z.avail_in = static_cast<uInt>(part);
      taken += part;
    }
    state = inflate(&stream.z, Z_NO_FLUSH);
    result.resize(before + chunk - stream.z.avail_out);
    if (result.size() > limit)
      fail("compressed data", fmt::format("hold more than the {} bytes announced", limit),
           "the header is wrong; export the file again");
    if (state == Z_STREAM_END) break;
    if (state != Z_OK ||
        (stream.z.avail_in == 0 && taken == bytes.size() && stream.z.avail_out == chunk))
      damaged();
  }
  return result;
}

}  // namespace crest::io
