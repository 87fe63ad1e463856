// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a .vtp says of the certificate it belongs to: its bytes are compressed.
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include <string>

#include "io/formats/vtk_quiet.hpp"

namespace crest::tests {

inline std::string digest_in_vtp(const std::string& path) {
  const io::VtkQuiet quiet;
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  auto* text = vtkStringArray::SafeDownCast(
      reader->GetOutput()->GetFieldData()->GetAbstractArray("data_digest"));
  return text && text->GetNumberOfValues() == 1 ? text->GetValue(0) : "";
}

}  // namespace crest::tests
