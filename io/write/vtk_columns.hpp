// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Arrays of a VTK data set, filled row by row.
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkSmartPointer.h>

#include <map>
#include <string>
#include <vector>

namespace crest::io {

/// VTK arrays by name, in the order of their first use.
class Columns {
 public:
  void add(const char* name, int value) { column(name, ints_)->InsertNextValue(value); }
  void add(const char* name, double value) { column(name, doubles_)->InsertNextValue(value); }
  void move_to(vtkFieldData& data) {
    for (const auto& array : order_) data.AddArray(array);
  }

 private:
  template <class Array>
  Array* column(const char* name, std::map<std::string, vtkSmartPointer<Array>>& columns) {
    auto& array = columns[name];
    if (!array) {
      array = vtkSmartPointer<Array>::New();
      array->SetName(name);
      order_.push_back(array);
    }
    return array;
  }
  std::map<std::string, vtkSmartPointer<vtkIntArray>> ints_;
  std::map<std::string, vtkSmartPointer<vtkDoubleArray>> doubles_;
  std::vector<vtkSmartPointer<vtkAbstractArray>> order_;
};

}  // namespace crest::io
