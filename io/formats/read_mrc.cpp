// SPDX-License-Identifier: GPL-3.0-or-later
// MRC and CCP4 maps (MRC2014), whose axes may stand in any order.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "io/formats/volume.hpp"

namespace crest::io {
namespace {

constexpr std::size_t kMrcHeader = 1024;

/// Words of the header, counted from 0.
class MrcHeader {
 public:
  explicit MrcHeader(std::string_view bytes) : bytes_(bytes) {
    if (bytes.size() < kMrcHeader) fail("header", "the file ends in it", "export it again");
    if (bytes.substr(208, 4) != "MAP ")
      fail("header", "has no 'MAP ' at byte 208", "save the map as MRC2014 or CCP4");
    // The stamp is wrong in many files: the mode and the axes' order are small numbers.
    big_endian_ = integer(3) < 0 || integer(3) > 0xffff || integer(16) < 0 || integer(16) > 3;
  }
  std::int32_t integer(std::size_t word) const {
    return load_number<std::int32_t>(bytes_.data() + 4 * word, big_endian_);
  }
  double real(std::size_t word) const {
    return static_cast<double>(load_number<float>(bytes_.data() + 4 * word, big_endian_));
  }
  bool big_endian() const { return big_endian_; }

 private:
  std::string_view bytes_;
  bool big_endian_ = false;
};

NumberType number_type(std::int32_t mode) {
  switch (mode) {
    case 0:
      return NumberType::i8;
    case 1:
      return NumberType::i16;
    case 2:
      return NumberType::f32;
    case 6:
      return NumberType::u16;
    default:
      fail("header", fmt::format("samples of mode {} are not read", mode),
           "convert them to mode 2 (32-bit reals)");
  }
}

/// The cell's edges a b c: a along x, b in the plane of x and y.
std::array<kernel::Vec3, 3> cell_edges(const MrcHeader& header) {
  constexpr double degree = std::numbers::pi / 180;
  double cosine[3], sine = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const double angle = header.real(13 + k);
    cosine[k] = angle == 90 || !(angle > 0 && angle < 180) ? 0 : std::cos(angle * degree);
  }
  sine = std::sqrt(1 - cosine[2] * cosine[2]);
  const double y = (cosine[0] - cosine[1] * cosine[2]) / sine;
  std::array<kernel::Vec3, 3> edges{
      {{1, 0, 0},
       {cosine[2], sine, 0},
       {cosine[1], y, std::sqrt(std::fmax(0, 1 - cosine[1] * cosine[1] - y * y))}}};
  for (std::size_t k = 0; k < 3; ++k)
    for (double& x : edges[k]) x *= header.real(10 + k);
  return edges;
}

void place(const MrcHeader& header, Volume& volume) {
  auto edges = cell_edges(header);
  std::size_t axis[3];
  bool used[3] = {};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int32_t a = header.integer(16 + i);
    axis[i] = a >= 1 && a <= 3 ? static_cast<std::size_t>(a - 1) : i;
    used[axis[i]] = true;
  }
  if (!used[0] || !used[1] || !used[2])
    fail("header", "its axes MAPC, MAPR and MAPS are not 1, 2 and 3 in some order",
         "export the map again");
  bool unknown = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int32_t intervals = header.integer(7 + k);
    if (intervals > 0 && header.real(10 + k) > 0) {
      for (double& x : edges[k]) x /= intervals;
    } else {
      unknown = true;
      edges[k] = {};
      edges[k][k] = 1;
    }
  }
  if (unknown)
    volume.warnings.emplace_back("the header has no cell along an axis: spacing 1 there");
  const bool has_origin = header.real(49) != 0 || header.real(50) != 0 || header.real(51) != 0;
  for (std::size_t i = 0; i < 3; ++i) {
    volume.steps.push_back(edges[axis[i]]);
    for (std::size_t k = 0; k < 3; ++k)
      volume.origin[k] += has_origin ? 0 : header.integer(4 + i) * edges[axis[i]][k];
  }
  if (has_origin) volume.origin = {header.real(49), header.real(50), header.real(51)};
}

}  // namespace

Volume read_mrc(std::string_view bytes, const VolumeRequest&) {
  const MrcHeader header(bytes);
  Volume volume;
  for (std::size_t k = 0; k < 3; ++k) {
    if (header.integer(k) < 1)
      fail("header", fmt::format("axis {} has the size {}", k, header.integer(k)),
           "export the map again");
    volume.size.push_back(static_cast<std::size_t>(header.integer(k)));
  }
  const std::int32_t extended = header.integer(23);
  if (extended < 0 || static_cast<std::size_t>(extended) > bytes.size() - kMrcHeader)
    fail("header", fmt::format("announces an extended header of {} bytes", extended),
         "the file is truncated or its header wrong; export it again");
  place(header, volume);
  volume.samples = load_samples(number_type(header.integer(3)),
                                bytes.substr(kMrcHeader + static_cast<std::size_t>(extended)),
                                volume.size, header.big_endian());
  return volume;
}

}  // namespace crest::io
