// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Texts among the fields of a model's file.
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

#include <string>

namespace crest::io {

inline constexpr const char* kModelRemedy = "save the model again with crest spline -o";

inline void add_text(vtkFieldData& to, const char* name, const std::string& text) {
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  array->InsertNextValue(text);
  to.AddArray(array);
}

/// Empty where there is none.
inline std::string text_of(vtkFieldData& from, const char* name) {
  auto* array = vtkStringArray::SafeDownCast(from.GetAbstractArray(name));
  return array && array->GetNumberOfValues() == 1 ? std::string(array->GetValue(0)) : std::string();
}

}  // namespace crest::io
