// SPDX-License-Identifier: GPL-3.0-or-later
// MetaImage: .mha, and .mhd with the samples in a file of their own; raw or compressed by zlib.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "io/formats/text_scan.hpp"
#include "io/formats/volume.hpp"

namespace crest::io {
namespace {

constexpr const char* kCorrectMeta = "correct the MetaImage header";

/// The lines "KEY = VALUE", the last of which is ElementDataFile.
class MetaHeader {
 public:
  explicit MetaHeader(std::string_view bytes) : scan_(bytes) {
    while (scan_.more()) {
      const std::string key(scan_.word().substr(0, 60));
      if (!scan_.in_line() || !scan_.take('='))
        fail(fmt::format("header (line {})", scan_.line()),
             io::quoted(key) + " is followed by no '='", kCorrectMeta);
      scan_.in_line();
      values_[key] = std::string(scan_.rest_of_line());
      scan_.next_line();
      if (key == "ElementDataFile") {
        size_ = scan_.position();
        return;
      }
    }
    fail("header", "has no ElementDataFile", kCorrectMeta);
  }
  std::size_t size() const { return size_; }
  bool has(const char* key) const { return values_.count(key) > 0; }
  std::string value(const char* key) const {
    const auto found = values_.find(key);
    return found == values_.end() ? std::string() : found->second;
  }
  bool is_true(const char* key) const { return value(key) == "True" || value(key) == "true"; }
  std::vector<double> numbers(const char* key, std::size_t count, double otherwise) const {
    std::vector<double> result(count, otherwise);
    if (!has(key)) return result;
    const std::string text = value(key);
    TextScan scan(text);
    for (double& x : result)
      if (!scan.in_line() || !scan.take(x))
        fail(key, fmt::format("{} are no {} numbers", io::quoted(text), count), kCorrectMeta);
    return result;
  }

 private:
  TextScan scan_;
  std::map<std::string, std::string> values_;
  std::size_t size_ = 0;
};

NumberType number_type(const MetaHeader& header) {
  static const std::map<std::string, NumberType> types = {
      {"MET_CHAR", NumberType::i8},       {"MET_UCHAR", NumberType::u8},
      {"MET_SHORT", NumberType::i16},     {"MET_USHORT", NumberType::u16},
      {"MET_INT", NumberType::i32},       {"MET_UINT", NumberType::u32},
      {"MET_LONG", NumberType::i32},      {"MET_ULONG", NumberType::u32},
      {"MET_LONG_LONG", NumberType::i64}, {"MET_ULONG_LONG", NumberType::u64},
      {"MET_FLOAT", NumberType::f32},     {"MET_DOUBLE", NumberType::f64}};
  const auto found = types.find(header.value("ElementType"));
  if (found == types.end())
    fail("ElementType", io::quoted(header.value("ElementType")) + " is not read",
         "convert the samples to MET_UCHAR, MET_SHORT or MET_FLOAT");
  return found->second;
}

void place(const MetaHeader& header, std::size_t axes, Volume& volume) {
  const char* const spacings = header.has("ElementSpacing") ? "ElementSpacing" : "ElementSize";
  const auto spacing = header.numbers(spacings, axes, 1);
  const char* origin_key = "Offset";
  for (const char* key : {"Position", "Origin"})
    if (header.has(key)) origin_key = key;
  const auto origin = header.numbers(origin_key, axes, 0);
  const char* matrix_key = "TransformMatrix";
  for (const char* key : {"Rotation", "Orientation"})
    if (header.has(key)) matrix_key = key;
  std::vector<double> matrix = header.numbers(matrix_key, axes * axes, 0);
  if (!header.has(matrix_key))
    for (std::size_t i = 0; i < axes; ++i) matrix[i * axes + i] = 1;
  for (std::size_t i = 0; i < axes; ++i) {
    kernel::Vec3 step{};
    for (std::size_t k = 0; k < std::min<std::size_t>(axes, 3); ++k)
      step[k] = spacing[i] * matrix[i * axes + k];
    volume.steps.push_back(step);
    if (i < 3) volume.origin[i] = origin[i];
  }
}

}  // namespace

Volume read_meta_image(std::string_view bytes, const VolumeRequest& request) {
  const MetaHeader header(bytes);
  const auto dimension = header.numbers("NDims", 1, 0)[0];
  if (!(dimension == 2 || dimension == 3 || dimension == 4))
    fail("NDims", io::quoted(header.value("NDims")) + " is not 2 or 3",
         "give a volume or an image");
  const auto axes = static_cast<std::size_t>(dimension);
  if (!header.has("DimSize")) fail("header", "has no DimSize", kCorrectMeta);
  Volume volume;
  for (const double n : header.numbers("DimSize", axes, 0)) {
    if (!(n >= 1 && n < 1e15) || n != std::floor(n))
      fail("DimSize", io::quoted(header.value("DimSize")) + " are no counts", kCorrectMeta);
    volume.size.push_back(static_cast<std::size_t>(n));
  }
  const double channels = header.numbers("ElementNumberOfChannels", 1, 1)[0];
  if (channels != 1)
    fail("samples", fmt::format("have {} numbers each", channels), "give one number a sample");
  place(header, axes, volume);
  const NumberType type = number_type(header);
  if (header.has("BinaryData") && !header.is_true("BinaryData"))
    fail("BinaryData", "samples as text are not read", "save the file in binary");
  const std::string name = header.value("ElementDataFile");
  std::string_view data = bytes.substr(header.size());
  FileBytes other(0);
  if (name != "LOCAL" && name != "Local" && name != "local") {
    if (name.starts_with("LIST") || name.find('%') != name.npos || !request.companion)
      fail("ElementDataFile", "several files are not read", "save the volume as one .mha");
    other = request.companion(name);
    data = other;
  }
  const bool big_endian =
      header.is_true("BinaryDataByteOrderMSB") || header.is_true("ElementByteOrderMSB");
  if (header.is_true("CompressedData"))
    volume.samples = load_samples(type, inflated(data, product(volume.size) * size_of(type)),
                                  volume.size, big_endian);
  else
    volume.samples = load_samples(type, data, volume.size, big_endian);
  return volume;
}

}  // namespace crest::io
