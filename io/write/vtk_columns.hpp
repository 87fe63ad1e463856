// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Arrays of a VTK data set, filled row by row.
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace crest::io {

/// VTK arrays by name, in the order of their first use. Cost: constant if each row names them in
/// the same order.
class Columns {
 public:
  void add(const char* name, int value) {
    column<vtkIntArray>(name, VTK_INT).InsertNextValue(value);
  }
  void add(const char* name, double value) {
    column<vtkDoubleArray>(name, VTK_DOUBLE).InsertNextValue(value);
  }
  void add(const char* name, const std::string& text) {
    column<vtkStringArray>(name, VTK_STRING).InsertNextValue(text);
  }
  /// The rows of others with the same columns, after those here.
  void append(const Columns& others) {
    for (const auto& from : others.order_) {
      vtkAbstractArray* to = find(from->GetName());
      if (!to) order_.emplace_back(to = from->NewInstance())->Delete();
      to->SetName(from->GetName());
      to->InsertTuples(to->GetNumberOfTuples(), from->GetNumberOfTuples(), 0, from);
    }
  }
  void move_to(vtkFieldData& data) {
    for (const auto& array : order_) data.AddArray(array);
  }
  const std::vector<vtkSmartPointer<vtkAbstractArray>>& arrays() const { return order_; }

 private:
  vtkAbstractArray* find(std::string_view name) {
    for (std::size_t tried = 0; tried < order_.size(); ++tried) {
      vtkAbstractArray* array = order_[next_++ % order_.size()];
      if (name == array->GetName()) return array;
    }
    return nullptr;
  }
  template <class Array>
  Array& column(const char* name, int type) {
    vtkAbstractArray* array = find(name);
    if (!array) {
      array = order_.emplace_back(vtkSmartPointer<Array>::New());
      array->SetName(name);
    }
    if (array->GetDataType() != type)
      throw std::logic_error(std::string("column of two types: ") + name);
    return static_cast<Array&>(*array);
  }
  std::vector<vtkSmartPointer<vtkAbstractArray>> order_;
  std::size_t next_ = 0;
};

}  // namespace crest::io
