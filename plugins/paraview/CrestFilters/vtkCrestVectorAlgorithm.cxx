// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkCrestVectorAlgorithm.h"

#include <vtkDataSet.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

#include "algorithms/vector_fields/planar_field.hpp"
#include "algorithms/vector_fields/skeleton_result.hpp"
#include "io/formats/vtk_input.hpp"
#include "io/read/planar_field_reader.hpp"

int vtkCrestVectorAlgorithm::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  for (const char* type :
       {"vtkUnstructuredGrid", "vtkImageData", "vtkRectilinearGrid", "vtkStructuredGrid"})
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), type);
  return 1;
}

crest::vector_fields::PlanarField vtkCrestVectorAlgorithm::Field(vtkInformationVector** inputs,
                                                                 std::string& name) {
  using namespace crest;
  this->Step("reading vectors", 0);
  io::VectorRequest request;
  request.field = this->ChosenArray();
  request.cell_to_point = this->ChoseCells();
  request.diagonal = static_cast<io::Diagonal>(this->Diagonal);
  if (this->Slice >= 0) request.slice = this->Slice;
  vtkDataSet& input = *vtkDataSet::GetData(inputs[0]);
  auto* points = vtkPointSet::SafeDownCast(&input);
  const bool mesh = vtkPolyData::SafeDownCast(points) || vtkUnstructuredGrid::SafeDownCast(points);
  io::PlanarFieldFile file = mesh ? io::planar_field_of_soup(io::soup_of(*points), request)
                                  : io::planar_field_of_grid(input, request);
  this->Warn(file.warnings);
  name = file.field;
  return {std::move(file.points), std::move(file.vectors), std::move(file.triangles)};
}

std::size_t vtkCrestVectorAlgorithm::Undecided(const crest::vector_fields::Skeleton& skeleton) {
  using namespace crest::vector_fields;
  return static_cast<std::size_t>(
      std::count_if(skeleton.separatrices.begin(), skeleton.separatrices.end(),
                    [](const Separatrix& s) { return s.end == EndKind::undecided; }));
}
