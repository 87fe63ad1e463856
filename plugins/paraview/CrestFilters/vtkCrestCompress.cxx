// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkCrestCompress.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include "algorithms/vector_fields/certificate.hpp"
#include "certify/compression/encode.hpp"
#include "io/write/planar_field_writer.hpp"
#include "kernel/geometry/input_error.hpp"

vtkStandardNewMacro(vtkCrestCompress);

int vtkCrestCompress::FillOutputPortInformation(int, vtkInformation* info) {
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkUnstructuredGrid");
  return 1;
}

void vtkCrestCompress::Work(vtkInformationVector** inputs, vtkInformationVector* outputs) {
  using namespace crest;
  using namespace vector_fields;
  std::string name;
  const PlanarField field = this->Field(inputs, name);
  constexpr vector_fields::Equivalence notions[] = {vector_fields::Equivalence::strong,
                                                    vector_fields::Equivalence::original,
                                                    vector_fields::Equivalence::relaxed};
  constexpr CollapseTest tests[] = {CollapseTest::retrace, CollapseTest::thesis};
  constexpr CollapsePriority priorities[] = {CollapsePriority::length, CollapsePriority::error};
  CompressionOptions options;
  options.equivalence = notions[this->Equivalence];
  options.test = tests[this->Test];
  options.priority = priorities[this->Priority];
  this->Step("collapsing edges", 0.1);
  certify::CompressionCertificate record;
  const Compression result = compress(field, options, record);
  if (!result.same_skeleton)
    throw kernel::InputError("skeletons: those of the two fields are not proven equal (" +
                             result.difference + "); choose another Equivalence");
  if (this->WantsCertificate()) this->Certify(certify::encode(record), Undecided(result.before));
  this->Step("writing", 0.95);
  vtkUnstructuredGrid::GetData(outputs)->ShallowCopy(io::planar_field_grid(
      result.field.points, result.field.triangles, name, result.field.vectors));
}
