// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkCrestMeshAlgorithm.h"

#include <vtkCellData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>

#include "io/formats/vtk_input.hpp"
#include "io/read/mesh_reader.hpp"

int vtkCrestMeshAlgorithm::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

vtkPointSet& vtkCrestMeshAlgorithm::InputSurface(vtkInformationVector** inputs) {
  return *vtkPointSet::GetData(inputs[0]);
}

crest::io::CleanOptions vtkCrestMeshAlgorithm::Cleaning() const {
  crest::io::CleanOptions options{{}, this->Split, this->Outward};
  if (this->Weld >= 0) options.weld = this->Weld;
  return options;
}

crest::io::MeshFile vtkCrestMeshAlgorithm::Mesh(vtkInformationVector** inputs,
                                                crest::io::MeshRequest request) {
  this->Step("cleaning the mesh", 0);
  request.clean = this->Cleaning();
  crest::io::MeshFile file =
      crest::io::mesh_of_soup(crest::io::soup_of(InputSurface(inputs)), request);
  this->Warn(file.warnings);
  return file;
}

namespace {

void pass(vtkDataSetAttributes& from, const std::vector<std::int64_t>& numbers,
          vtkDataSetAttributes& to) {
  vtkNew<vtkPointData> copied;  // beside the arrays that are there
  copied->CopyAllOn();
  copied->CopyAllocate(&from, static_cast<vtkIdType>(numbers.size()));
  for (std::size_t i = 0; i < numbers.size(); ++i)
    copied->CopyData(&from, numbers[i], static_cast<vtkIdType>(i));
  for (int i = 0; i < copied->GetNumberOfArrays(); ++i)
    if (const char* name = copied->GetArrayName(i); !name || !to.HasArray(name))
      to.AddArray(copied->GetAbstractArray(i));
}

}  // namespace

void vtkCrestMeshAlgorithm::PassArrays(vtkPointSet& input, const crest::io::FileNumbers& numbers,
                                       vtkPolyData& mesh) {
  pass(*input.GetPointData(), numbers.vertices, *mesh.GetPointData());
  pass(*input.GetCellData(), numbers.faces, *mesh.GetCellData());
}
