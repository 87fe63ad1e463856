// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkCrestExtremalSurface.h"

#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <optional>

#include "algorithms/extremal/extremal.hpp"
#include "algorithms/extremal/sampled_grid.hpp"
#include "certify/extremal/encode.hpp"
#include "crest_parts.h"
#include "io/extremal/extremal_writer.hpp"
#include "io/formats/volume.hpp"
#include "io/read/volume_reader.hpp"
#include "kernel/geometry/input_error.hpp"

vtkStandardNewMacro(vtkCrestExtremalSurface);

vtkCrestExtremalSurface::vtkCrestExtremalSurface() {
  this->SetNumberOfOutputPorts(2);
}

int vtkCrestExtremalSurface::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

void vtkCrestExtremalSurface::Work(vtkInformationVector** inputs, vtkInformationVector* outputs) {
  using namespace crest;
  this->Step("reading samples", 0);
  const io::VolumeFile file =
      io::grid_of_volume(io::volume_of(*vtkImageData::GetData(inputs[0]), this->ChosenArray()));
  this->Warn(file.warnings);
  extremal::Options options;
  options.definition =
      this->Hessian ? extremal::Definition::hessian : extremal::Definition::structure;
  options.side = this->Valley ? extremal::Side::valley : extremal::Side::ridge;
  options.sigma = this->Sigma;
  if (this->TensorSigma >= 0) options.tensor_sigma = this->TensorSigma;
  if (this->UseMinValue) options.min_value = this->MinValue;
  options.min_strength = this->MinStrength;
  options.critical = this->Critical;
  options.refine = this->Refine;
  std::optional<certify::ExtremalCertificate> certificate;
  if (this->WantsCertificate()) certificate.emplace();
  this->Step("extremal surface", 0.1);
  extremal::Result result = extremal::extract(extremal::volume_of(file.grid), options,
                                              certificate ? &*certificate : nullptr);
  extremal::move_to_world(file.grid, result);
  if (certificate) {
    this->Step("composing the certificate", 0.8);
    // What is proven with no margin here may be refused there.
    this->Certify(certify::encode(*certificate), result.undecided.size(), false);
  }
  if (!result.undecided.empty())
    this->Warn(std::to_string(result.undecided.size()) + " edges of the grid are undecided");
  this->Step("writing", 0.95);
  const auto whole = io::extremal_poly_data(result, this->DataDigest);
  take_part(*whole, "feature", {0}, *vtkPolyData::GetData(outputs, 0));
  take_rest(*whole, "feature", {0}, *vtkPolyData::GetData(outputs, 1));
}
