// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// VTK makes room for as many corners as the last offset of cells says, whatever the file holds.
#include <vtkDataArray.h>
#include <vtkXMLDataElement.h>

#include <string_view>

namespace crest::io {

/// zlib shrinks 1032 times at most, and a corner has four bytes.
constexpr double kCornersAByte = 258;

/// A reader of VTP or VTU that gives up where cells' offsets end beyond `most`.
template <class Reader>
class BoundedReader : public Reader {
 public:
  static BoundedReader* New() {
    auto* const reader = new BoundedReader;
    reader->InitializeObjectBase();
    return reader;
  }
  double most = 0;

 protected:
  int ReadArrayValues(vtkXMLDataElement* element, vtkIdType at, vtkAbstractArray* array,
                      vtkIdType start, vtkIdType count, typename Reader::FieldType type) override {
    const int done = Reader::ReadArrayValues(element, at, array, start, count, type);
    auto* const values = vtkDataArray::SafeDownCast(array);
    const vtkIdType end = at + count;
    if (!done || !is_offsets(*element) || !values || count == 0 ||
        end > values->GetNumberOfTuples())
      return done;
    const double last = values->GetComponent(end - 1, 0);
    if (last >= 0 && last <= most) return done;
    this->DataError = 1;
    vtkErrorMacro("the cells have " << last << " corners, more than the file holds");
    return 0;
  }

 private:
  /// Of cells: fields of points and of cells may have any name.
  static bool is_offsets(vtkXMLDataElement& element) {
    const char* const name = element.GetAttribute("Name");
    vtkXMLDataElement* const parent = element.GetParent();
    const std::string_view place = parent && parent->GetName() ? parent->GetName() : "";
    return name && std::string_view(name) == "offsets" && place != "PointData" &&
           place != "CellData";
  }
};

}  // namespace crest::io
