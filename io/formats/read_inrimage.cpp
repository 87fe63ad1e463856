// SPDX-License-Identifier: GPL-3.0-or-later
// INRIMAGE-4: a header of lines KEY=VALUE, filled up to a multiple of 256 bytes, then the samples.
#include <fmt/format.h>

#include <map>

#include "io/formats/text_scan.hpp"
#include "io/formats/volume.hpp"

namespace crest::io {
namespace {

constexpr const char* kCorrectInr = "correct the INRIMAGE header";

class InrHeader {
 public:
  explicit InrHeader(std::string_view bytes) {
    constexpr std::string_view first = "#INRIMAGE-4#{", last = "##}";
    if (!bytes.starts_with(first))
      fail("header", "does not start with #INRIMAGE-4#{", "save the volume as NRRD");
    const std::size_t end = bytes.find(last);
    if (end == std::string_view::npos) fail("header", "has no end ##}", kCorrectInr);
    constexpr std::size_t block = 256;
    size_ = (end + last.size() + block) / block * block;  // a line's end at least
    if (size_ > bytes.size()) fail("header", "the file ends in it", "export it again");
    TextScan scan(bytes.substr(first.size(), end - first.size()));
    while (scan.more()) {
      const std::string line(scan.rest_of_line());
      const std::size_t sign = line.find('=');
      if (sign == std::string::npos)
        fail("header", io::quoted(line) + " is no KEY=VALUE", kCorrectInr);
      values_[line.substr(0, sign)] = line.substr(sign + 1);
    }
  }
  std::size_t size() const { return size_; }
  std::string value(const std::string& key) const {
    const auto found = values_.find(key);
    return found == values_.end() ? std::string() : found->second;
  }
  /// The number that the value starts with.
  template <class Number>
  Number number(const std::string& key, Number otherwise) const {
    const std::string text = value(key);
    if (text.empty()) return otherwise;
    TextScan scan(text);
    Number x{};
    if (!scan.in_line() || !scan.take(x))
      fail(key, io::quoted(text) + " is not a number", kCorrectInr);
    return x;
  }

 private:
  std::map<std::string, std::string> values_;
  std::size_t size_ = 0;
};

NumberType number_type(const InrHeader& header) {
  static const std::map<std::pair<std::string, std::int64_t>, NumberType> types = {
      {{"unsigned fixed", 8}, NumberType::u8},   {{"signed fixed", 8}, NumberType::i8},
      {{"unsigned fixed", 16}, NumberType::u16}, {{"signed fixed", 16}, NumberType::i16},
      {{"unsigned fixed", 32}, NumberType::u32}, {{"signed fixed", 32}, NumberType::i32},
      {{"float", 32}, NumberType::f32},          {{"float", 64}, NumberType::f64}};
  const auto bits = header.number<std::int64_t>("PIXSIZE", 8);
  const auto found = types.find({header.value("TYPE"), bits});
  if (found == types.end())
    fail("TYPE", fmt::format("{} of {} bits is not read", io::quoted(header.value("TYPE")), bits),
         "convert the samples to float or unsigned fixed");
  return found->second;
}

bool is_big_endian(const InrHeader& header) {
  const std::string cpu = header.value("CPU");
  if (cpu == "sun" || cpu == "sgi") return true;
  if (cpu == "decm" || cpu == "alpha" || cpu == "pc") return false;
  fail("CPU", io::quoted(cpu) + " is none of decm, alpha, pc, sun, sgi", kCorrectInr);
}

}  // namespace

Volume read_inrimage(std::string_view bytes, const VolumeRequest&) {
  const InrHeader header(bytes);
  if (header.number<std::int64_t>("VDIM", 1) != 1)
    fail("VDIM", "there are several samples a voxel", "give one");
  Volume volume;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string axis(1, "XYZ"[k]);
    const auto size = header.number<std::int64_t>(axis + "DIM", 1);
    if (size < 1) fail(axis + "DIM", fmt::format("{} is no size", size), kCorrectInr);
    volume.size.push_back(static_cast<std::size_t>(size));
    kernel::Vec3 step{};
    step[k] = header.number<double>("V" + axis, 1);
    volume.steps.push_back(step);
    volume.origin[k] = header.number<double>("T" + axis, 0);
  }
  volume.samples = load_samples(number_type(header), bytes.substr(header.size()), volume.size,
                                is_big_endian(header));
  return volume;
}

}  // namespace crest::io
