// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// An array of a file whose numbers are made when the file has come to it, and dropped behind it.
#include <vtkDoubleArray.h>

#include <functional>

namespace crest::io {

/// Has a name and components from the start, values between make() and drop(). For the writers of
/// io/write/formats.hpp alone: elsewhere it is empty.
class LateArray : public vtkDoubleArray {
 public:
  static LateArray* New();
  /// Rows that it will have.
  vtkIdType rows = 0;
  /// Writes the values of all rows.
  std::function<void(double*)> fill;

  void make() {
    SetNumberOfTuples(rows);
    fill(GetPointer(0));
  }
  void drop() { Initialize(); }
};

}  // namespace crest::io
