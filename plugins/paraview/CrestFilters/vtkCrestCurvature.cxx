// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkCrestCurvature.h"

#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "algorithms/curvature/curvature.hpp"
#include "io/curvature/curvature_writer.hpp"
#include "io/read/mesh_reader.hpp"
#include "kernel/geometry/input_error.hpp"

vtkStandardNewMacro(vtkCrestCurvature);

vtkCrestCurvature::vtkCrestCurvature() {
  this->SetMethod("ne");
}

vtkCrestCurvature::~vtkCrestCurvature() {
  this->SetMethod(nullptr);
}

void vtkCrestCurvature::Work(vtkInformationVector** inputs, vtkInformationVector* outputs) {
  using namespace crest;
  using curvature::Method;
  const std::string name = this->Method ? this->Method : "";
  const auto method = curvature::method_of(name);
  if (!method) throw kernel::InputError("Method: there is none '" + name + "'; choose another");
  io::MeshRequest request;
  request.normals = *method == Method::np || (this->Normals && *method != Method::ne);
  const io::MeshFile file = this->Mesh(inputs, request);
  curvature::Options options;
  options.method = *method;
  options.normals = file.normals;
  options.degree = this->Degree;
  options.rings = this->Rings;
  this->Step("estimating curvatures", 0.2);
  const curvature::Result result = curvature::estimate(file.mesh, options);
  if (result.undetermined > 0)
    this->Warn(std::to_string(result.undetermined) +
               " vertices have no finite estimate and are zero");
  this->Step("writing", 0.9);
  const auto mesh =
      io::curvature_poly_data(file.mesh, result, std::vector<curvature::CornerCurvatures>{});
  PassArrays(InputSurface(inputs), file.numbers, *mesh);
  vtkPolyData::GetData(outputs)->ShallowCopy(mesh);
}
