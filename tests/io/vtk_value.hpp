// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Numbers of VTK's arrays.
#include <vtkDataArray.h>
#include <vtkFieldData.h>

#include <catch2/catch.hpp>

namespace crest::tests {

/// The number of that name. Requires: one component.
inline double vtk_value(vtkFieldData* data, const char* name, vtkIdType i) {
  auto* array = vtkDataArray::SafeDownCast(data->GetAbstractArray(name));
  INFO(name);
  REQUIRE(array != nullptr);
  REQUIRE(i < array->GetNumberOfTuples());
  return array->GetTuple1(i);
}

}  // namespace crest::tests
