// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write/formats.hpp"

// vtkSMPTools.h of VTK 9.1 is no C++20.
#include <SMP/Common/vtkSMPToolsAPI.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <stdexcept>

#include "io/formats/vtk_quiet.hpp"

namespace crest::io {

namespace {

template <class Writer, class Data>
std::string bytes_of(Data& data) {
  const VtkQuiet quiet;
  // In several threads it depends on them which of 0 and -0 is the least number of an array.
  vtk::detail::smp::vtkSMPToolsAPI::GetInstance().SetBackend("Sequential");
  vtkNew<Writer> writer;
  writer->SetInputData(&data);
  writer->WriteToOutputStringOn();
  // Never appended data: ParaView 5.11 with Debian 12's libexpat 2.5.0-1+deb12u5 reads none of it.
  writer->SetDataModeToBinary();
  writer->SetCompressorTypeToZLib();
  writer->SetByteOrderToLittleEndian();
  if (writer->Write() != 1 || quiet.failed()) throw std::runtime_error("VTK cannot write the data");
  return writer->GetOutputString();
}

}  // namespace

std::string vtp_bytes(vtkPolyData& data) {
  return bytes_of<vtkXMLPolyDataWriter>(data);
}

std::string vtu_bytes(vtkUnstructuredGrid& data) {
  return bytes_of<vtkXMLUnstructuredGridWriter>(data);
}

}  // namespace crest::io
