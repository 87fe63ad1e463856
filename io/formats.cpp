// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats.hpp"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <filesystem>
#include <stdexcept>

#include "io/vtk_quiet.hpp"

namespace crest::io {

std::string vtp_bytes(vtkPolyData& data) {
  const VtkQuiet quiet;
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(&data);
  writer->WriteToOutputStringOn();
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToNone();
  writer->SetByteOrderToLittleEndian();
  if (writer->Write() != 1 || quiet.failed()) throw std::runtime_error("VTK cannot write the data");
  return writer->GetOutputString();
}

std::string lower_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return extension;
}

}  // namespace crest::io
