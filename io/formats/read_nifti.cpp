// SPDX-License-Identifier: GPL-3.0-or-later
// NIfTI 1 and 2 in one file; the samples' slope and intercept are applied here.
#include <fmt/format.h>

#include <cmath>
#include <map>

#include "io/formats/volume.hpp"

namespace crest::io {
namespace {

/// Where the numbers of a header stand: of NIfTI 1 in floats and shorts, of NIfTI 2 in doubles and
/// 64-bit integers.
struct NiftiLayout {
  std::size_t size, magic, datatype, dim, pixdim, offset, slope, qform, sform, quaternion, shift,
      rows;
};
constexpr NiftiLayout kFirst = {348, 344, 70, 40, 76, 108, 112, 252, 254, 256, 268, 280};
constexpr NiftiLayout kSecond = {540, 4, 12, 16, 104, 168, 176, 344, 348, 352, 376, 400};

class NiftiHeader {
 public:
  explicit NiftiHeader(std::string_view bytes) : bytes_(bytes) {
    for (const NiftiLayout& layout : {kFirst, kSecond})
      for (const bool big : {false, true}) {
        if (bytes.size() < layout.size) continue;
        if (load_number<std::int32_t>(bytes.data(), big) != static_cast<std::int32_t>(layout.size))
          continue;
        layout_ = layout;
        big_endian_ = big;
        check_magic();
        return;
      }
    fail("header", "is none of NIfTI", "export the file again");
  }
  bool big_endian() const { return big_endian_; }
  const NiftiLayout& at() const { return layout_; }
  bool second() const { return layout_.size == kSecond.size; }
  double real(std::size_t place, std::size_t k = 0) const {
    return second() ? load_number<double>(bytes_.data() + place + 8 * k, big_endian_)
                    : static_cast<double>(
                          load_number<float>(bytes_.data() + place + 4 * k, big_endian_));
  }
  std::int64_t dim(std::size_t k) const {
    return second() ? load_number<std::int64_t>(bytes_.data() + layout_.dim + 8 * k, big_endian_)
                    : load_number<std::int16_t>(bytes_.data() + layout_.dim + 2 * k, big_endian_);
  }
  int short_at(std::size_t place) const {
    return load_number<std::int16_t>(bytes_.data() + place, big_endian_);
  }
  int code_at(std::size_t place) const {
    return second() ? load_number<std::int32_t>(bytes_.data() + place, big_endian_)
                    : short_at(place);
  }
  /// Bytes up to the samples.
  std::size_t offset() const {
    const double offset = second() ? static_cast<double>(load_number<std::int64_t>(
                                         bytes_.data() + layout_.offset, big_endian_))
                                   : real(layout_.offset);
    if (!(offset >= static_cast<double>(layout_.size) &&
          offset <= static_cast<double>(bytes_.size())) ||
        offset != std::floor(offset))
      fail("header", fmt::format("says that the samples start at byte {}", offset),
           "the file is truncated or its header wrong; export it again");
    return static_cast<std::size_t>(offset);
  }

 private:
  void check_magic() const {
    const std::string_view magic = bytes_.substr(layout_.magic, 4);
    if (magic.starts_with("n+1") || magic.starts_with("n+2")) return;
    if (magic.starts_with("ni1") || magic.starts_with("ni2"))
      fail("header", "the samples are in another file", "save both as one .nii");
    fail("header", "is ANALYZE's, not NIfTI's", "save it as .nii");
  }
  std::string_view bytes_;
  NiftiLayout layout_{};
  bool big_endian_ = false;
};

NumberType number_type(const NiftiHeader& header) {
  static const std::map<int, NumberType> types = {{2, NumberType::u8},     {4, NumberType::i16},
                                                  {8, NumberType::i32},    {16, NumberType::f32},
                                                  {64, NumberType::f64},   {256, NumberType::i8},
                                                  {512, NumberType::u16},  {768, NumberType::u32},
                                                  {1024, NumberType::i64}, {1280, NumberType::u64}};
  const int code = header.short_at(header.at().datatype);
  const auto found = types.find(code);
  if (found == types.end())
    fail("header", fmt::format("samples of NIfTI's type {} are not read", code),
         "convert them to float");
  return found->second;
}

/// The axes' steps by the first of sform, qform and spacings that the header has.
void place(const NiftiHeader& header, Volume& volume) {
  const NiftiLayout& at = header.at();
  const std::size_t word = header.second() ? 8 : 4;
  kernel::Vec3 steps[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  double spacing[3];
  for (std::size_t k = 0; k < 3; ++k) spacing[k] = std::fabs(header.real(at.pixdim, k + 1));
  if (header.code_at(at.sform) > 0) {
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t k = 0; k < 3; ++k) steps[k][r] = header.real(at.rows + 4 * word * r, k);
      volume.origin[r] = header.real(at.rows + 4 * word * r, 3);
    }
  } else {
    double b = 0, c = 0, d = 0;
    if (header.code_at(at.qform) > 0) {
      b = header.real(at.quaternion, 0);
      c = header.real(at.quaternion, 1);
      d = header.real(at.quaternion, 2);
      for (std::size_t r = 0; r < 3; ++r) volume.origin[r] = header.real(at.shift, r);
    }
    const double a = std::sqrt(std::fmax(0, 1 - (b * b + c * c + d * d)));
    const double turn[3][3] = {
        {a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
        {2 * (b * c + a * d), a * a + c * c - b * b - d * d, 2 * (c * d - a * b)},
        {2 * (b * d - a * c), 2 * (c * d + a * b), a * a + d * d - b * b - c * c}};
    const double handed = header.real(at.pixdim, 0) < 0 ? -1 : 1;
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t r = 0; r < 3; ++r)
        steps[k][r] = spacing[k] * (k == 2 ? handed : 1) * turn[r][k];
  }
  for (std::size_t i = 0; i < volume.size.size(); ++i)
    volume.steps.push_back(i < 3 ? steps[i] : kernel::Vec3{});
}

/// x slope + intercept, which may not be a number of the samples' type.
void apply(double slope, double intercept, Volume& volume) {
  if (!(slope != 0) || !std::isfinite(slope) || !std::isfinite(intercept) ||
      (slope == 1 && intercept == 0))
    return;
  std::visit(
      [&](const auto& x) {
        std::vector<double> scaled(x.size());
        for (std::size_t i = 0; i < x.size(); ++i)
          scaled[i] = static_cast<double>(x[i]) * slope + intercept;
        volume.samples = std::move(scaled);
      },
      Samples(volume.samples));
  volume.warnings.push_back(fmt::format(
      "samples are scaled as the header says: times {:.6g} plus {:.6g}", slope, intercept));
}

}  // namespace

Volume read_nifti(std::string_view bytes, const VolumeRequest&) {
  const NiftiHeader header(bytes);
  const std::int64_t axes = header.dim(0);
  if (axes < 1 || axes > 7)
    fail("header", fmt::format("has {} dimensions", axes), "export the file again");
  Volume volume;
  for (std::size_t k = 1; k <= static_cast<std::size_t>(axes); ++k) {
    if (header.dim(k) < 1)
      fail("header", fmt::format("axis {} has the size {}", k, header.dim(k)),
           "export the file again");
    volume.size.push_back(static_cast<std::size_t>(header.dim(k)));
  }
  place(header, volume);
  const NumberType type = number_type(header);
  std::string_view data = bytes.substr(header.offset());
  const std::size_t expected = product(volume.size) * size_of(type);
  if (data.size() > expected) data = data.substr(0, expected);  // some programs append padding
  volume.samples = load_samples(type, data, volume.size, header.big_endian());
  const std::size_t word = header.second() ? 8 : 4;
  apply(header.real(header.at().slope), header.real(header.at().slope + word), volume);
  return volume;
}

}  // namespace crest::io
