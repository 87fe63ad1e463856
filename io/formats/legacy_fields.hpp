// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The fields of VTK's legacy files.
#include "io/formats/legacy_source.hpp"
#include "io/formats/readers.hpp"

namespace crest::io {

class LegacyFields {
 public:
  LegacyFields(LegacySource& source, const FieldRequest& request)
      : source_(source), request_(request) {}

  /// Reads the section if it is one of fields. Throws: kernel::InputError.
  bool read_section();
  /// Hands over the fields. Throws if they announced another number of points or cells.
  void finish(Soup& soup);
  /// Those of the points of what has no cells. Throws if they announced another number.
  std::vector<Field> finish_points(std::size_t points);

 private:
  struct Owner {
    bool announced = false;
    std::size_t count = 0;
    std::vector<Field> fields;
  };

  static std::vector<Field> taken(const char* section, Owner& owner, std::size_t count);
  void read_scalars();
  void read_field_array();
  void read_values(const std::string& name, std::size_t components, LegacyType type);

  LegacySource& source_;
  const FieldRequest& request_;
  Owner points_, cells_;
  Owner* owner_ = nullptr;  ///< of the fields that follow
};

}  // namespace crest::io
