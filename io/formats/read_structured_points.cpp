// SPDX-License-Identifier: GPL-3.0-or-later
// Volumes in VTK's legacy files: DATASET STRUCTURED_POINTS. Own code: as read_vtk.cpp.
#include <fmt/format.h>

#include "io/formats/legacy_fields.hpp"
#include "io/formats/volume_field.hpp"

namespace crest::io {
namespace {

constexpr const char* kExportVolume = "export the volume again";

class StructuredPoints {
 public:
  StructuredPoints(std::string_view bytes, const VolumeRequest& request)
      : request_(request), source_(bytes), fields_(source_, all_) {}

  Volume read() {
    while (source_.next_section())
      if (!read_geometry() && !fields_.read_section())
        fail(source_.where(), "is an unknown keyword", kExportVolume);
    if (volume_.size.empty()) fail("header", "has no DIMENSIONS", kExportVolume);
    for (std::size_t k = 0; k < 3; ++k) volume_.steps.emplace_back()[k] = spacing_[k];
    const std::vector<Field> fields = fields_.finish_points(product(volume_.size));
    volume_.samples = narrowed(chosen_field(fields, request_.field, "").numbers);
    return std::move(volume_);
  }

 private:
  bool read_geometry() {
    const std::string& section = source_.section();
    if (section == "dataset") {
      const std::string_view kind = source_.take_word();
      if (!is_keyword(kind, "structured_points"))
        fail(source_.where(), fmt::format("{} is no volume", io::quoted(kind)),
             "convert it to STRUCTURED_POINTS");
    } else if (section == "dimensions") {
      volume_.size.clear();
      for (int k = 0; k < 3; ++k) volume_.size.push_back(source_.take_count());
    } else if (section == "origin") {
      volume_.origin = take_vector();
    } else if (section == "spacing" || section == "aspect_ratio") {
      spacing_ = take_vector();
    } else if (section == "metadata") {
      source_.skip_block();
    } else {
      return false;
    }
    return true;
  }
  kernel::Vec3 take_vector() {
    kernel::Vec3 v{};
    for (double& x : v) x = source_.take_real();
    return v;
  }

  const VolumeRequest& request_;
  FieldRequest all_{.wanted = true};
  LegacySource source_;
  LegacyFields fields_;
  kernel::Vec3 spacing_{1, 1, 1};
  Volume volume_;
};

}  // namespace

Volume read_structured_points(std::string_view bytes, const VolumeRequest& request) {
  return StructuredPoints(bytes, request).read();
}

}  // namespace crest::io
