// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkCrestSplineIsosurface.h"

#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cmath>

#include "algorithms/splines/isosurface.hpp"
#include "algorithms/splines/quadratic_certificate.hpp"
#include "io/formats/volume.hpp"
#include "io/read/volume_reader.hpp"
#include "io/splines/isosurface_writer.hpp"
#include "kernel/geometry/input_error.hpp"

vtkStandardNewMacro(vtkCrestSplineIsosurface);

int vtkCrestSplineIsosurface::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

void vtkCrestSplineIsosurface::Work(vtkInformationVector** inputs, vtkInformationVector* outputs) {
  using namespace crest;
  if (!std::isfinite(this->Isovalue))
    throw kernel::InputError("Isovalue: is not finite; give a number");
  this->Step("reading samples", 0);
  io::VolumeFile file =
      io::grid_of_volume(io::volume_of(*vtkImageData::GetData(inputs[0]), this->ChosenArray()));
  this->Warn(file.warnings);
  const splines::QuadraticSpline spline(
      std::move(file.grid), this->Extend ? splines::Border::extend : splines::Border::none);
  this->Step("isosurface", 0.1);
  const splines::Isosurface surface =
      splines::extract_isosurface(spline, this->Isovalue, this->MaxDepth);
  if (!surface.undecided.empty()) {
    this->Warn(std::to_string(surface.undecided.size()) +
               " tetrahedra are undecided: the isosurface touches a face or has no gradient there; "
               "no certificate; take another Isovalue close by");
  } else if (this->WantsCertificate()) {
    this->Step("composing the certificate", 0.7);
    this->Certify(certify::encode(splines::isosurface_certificate(spline, this->Isovalue, surface)),
                  0);
  }
  this->Step("writing", 0.95);
  vtkPolyData::GetData(outputs)->ShallowCopy(io::isosurface_poly_data(surface, this->DataDigest));
}
