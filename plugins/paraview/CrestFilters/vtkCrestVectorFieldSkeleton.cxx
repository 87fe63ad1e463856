// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkCrestVectorFieldSkeleton.h"

#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "algorithms/vector_fields/certificate.hpp"
#include "certify/skeleton/encode.hpp"
#include "crest_parts.h"
#include "io/vector_fields/skeleton_writer.hpp"

vtkStandardNewMacro(vtkCrestVectorFieldSkeleton);

vtkCrestVectorFieldSkeleton::vtkCrestVectorFieldSkeleton() {
  this->SetNumberOfOutputPorts(2);
}

void vtkCrestVectorFieldSkeleton::Work(vtkInformationVector** inputs,
                                       vtkInformationVector* outputs) {
  using namespace crest;
  std::string name;
  const vector_fields::PlanarField field = this->Field(inputs, name);
  this->Step("skeleton", 0.1);
  certify::SkeletonCertificate record;
  const vector_fields::Skeleton skeleton = vector_fields::extract_skeleton(field, record);
  const std::size_t undecided = Undecided(skeleton);
  if (undecided > 0) this->Warn(std::to_string(undecided) + " separatrices are undecided");
  if (this->WantsCertificate()) this->Certify(certify::encode(record), undecided);
  this->Step("writing", 0.95);
  const auto whole = io::skeleton_poly_data({&field, &skeleton, this->DataDigest});
  take_part(*whole, "type", {2, 3}, *vtkPolyData::GetData(outputs, 0));
  take_rest(*whole, "type", {2, 3}, *vtkPolyData::GetData(outputs, 1));
}
