// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/exact/spline_volume.hpp"

#include <algorithm>

#include "certify/container/plain_numbers.hpp"
#include "certify/container/reject.hpp"
#include "kernel/arithmetic/rational.hpp"

namespace crest::certify {
namespace {

void require_form(bool condition, const char* what) {
  if (!condition) throw Malformed(what);
}

template <std::size_t n>
void read_plain(ByteReader& reader, std::array<double, n>& numbers, const char* what) {
  for (double& x : numbers) {
    const auto bits = reader.integer<std::uint64_t>();
    require_plain(is_plain(bits), what);
    x = std::bit_cast<double>(bits);
  }
}

/// Floating-point samples are plain; of 64-bit integers every one is a double.
void require_exact_samples(const SplineVolume& volume) {
  constexpr std::uint64_t kMost = std::uint64_t{1} << 53;
  bool good = true;
  ByteReader reader(volume.samples);
  if (volume.type == 6)
    while (reader.left() > 0) good = reader.integer<std::uint64_t>() + kMost <= 2 * kMost && good;
  else if (volume.type == 7)
    while (reader.left() > 0) good = reader.integer<std::uint64_t>() <= kMost && good;
  else if (volume.type == 8)
    while (reader.left() > 0) {
      const auto bits = reader.integer<std::uint32_t>();
      good = (bits & 0x7f800000U) != 0x7f800000U && bits != 0x80000000U && good;
    }
  else if (volume.type == 9)
    while (reader.left() > 0) good = is_plain(reader.integer<std::uint64_t>()) && good;
  require_form(good, "samples: a number is infinite, NaN, -0 or an integer beyond 2^53");
}

}  // namespace

void require_fit(const SplineVolume& volume) {
  if (volume.type >= kVolumeSampleSize.size() ||
      volume.samples.size() != volume.sample_count() * kVolumeSampleSize.at(volume.type))
    throw std::invalid_argument("certificate: samples that do not fit their grid");
}

std::size_t encoded_size(const SplineVolume& volume) {
  return 2 + 3 * 4 + 16 * 8 + volume.samples.size();
}

void write_volume(ByteWriter& out, const SplineVolume& volume) {
  out.integer(volume.type);
  out.integer(std::uint8_t{volume.extended});
  out.numbers(volume.nodes);
  out.numbers(volume.origin);
  out.numbers(volume.spacing);
  out.numbers(volume.direction);
  out.number(volume.level);
  out.bytes(volume.samples);
}

SplineVolume read_volume(ByteReader& reader) {
  SplineVolume volume;
  volume.type = reader.integer<std::uint8_t>();
  require_form(volume.type < kVolumeSampleSize.size(), "data section: no such type of samples");
  const auto extended = reader.integer<std::uint8_t>();
  require_form(extended <= 1, "data section: a flag is neither 0 nor 1");
  volume.extended = extended == 1;
  std::uint64_t nodes = 1;
  for (auto& n : volume.nodes) {
    n = reader.integer<std::uint32_t>();
    require_form(n >= (volume.extended ? 2U : 3U), "data section: too few nodes along an axis");
    nodes *= n;
    require_form(nodes <= 0x8000000U, "data section: more than 2^27 nodes");
  }
  read_plain(reader, volume.origin, "origin");
  read_plain(reader, volume.spacing, "spacings");
  require_form(std::ranges::all_of(volume.spacing, [](double h) { return h > 0; }),
               "data section: a spacing is not positive");
  read_plain(reader, volume.direction, "directions");
  std::array<double, 1> level{};
  read_plain(reader, level, "level");
  volume.level = level[0];
  const auto samples = reader.take(volume.sample_count() * kVolumeSampleSize[volume.type]);
  volume.samples.assign(samples.begin(), samples.end());
  require_exact_samples(volume);
  return volume;
}

kernel::Sign orientation(const SplineVolume& volume) {
  const kernel::Sign sign = kernel::sign_of(determinant(world_matrix<kernel::Rational>(volume)));
  require(sign != kernel::Sign::zero, "the grid's matrix is singular");
  return sign;
}

}  // namespace crest::certify
