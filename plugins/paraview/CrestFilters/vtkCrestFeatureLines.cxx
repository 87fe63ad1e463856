// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkCrestFeatureLines.h"

#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "algorithms/curvature/curvature.hpp"
#include "algorithms/feature_lines/certificate.hpp"
#include "algorithms/feature_lines/feature_lines.hpp"
#include "algorithms/feature_lines/sharp_edges.hpp"
#include "algorithms/ridges/ridges.hpp"
#include "certify/features_mesh/encode.hpp"
#include "certify/sharp_edges/encode.hpp"
#include "crest_parts.h"
#include "io/features/feature_writer.hpp"
#include "io/read/mesh_reader.hpp"
#include "kernel/geometry/input_error.hpp"

vtkStandardNewMacro(vtkCrestFeatureLines);

vtkCrestFeatureLines::vtkCrestFeatureLines() {
  this->SetNumberOfOutputPorts(2);
  this->SetMethod("fit");
  this->SetAngle("30");
}

vtkCrestFeatureLines::~vtkCrestFeatureLines() {
  this->SetMethod(nullptr);
  this->SetAngle(nullptr);
}

namespace {

using namespace crest;

kernel::DecimalAngle angle_of(const char* text) {
  try {
    return kernel::DecimalAngle(text ? text : "");
  } catch (const std::invalid_argument& error) {
    throw kernel::InputError(std::string("Angle: ") + (text ? text : "") + " " + error.what());
  }
}

template <class Graph>
void fill(const io::MeshFile& file, const Graph& graph, const std::vector<double>& field,
          const std::string& digest, vtkPolyData& whole) {
  whole.ShallowCopy(io::feature_poly_data(file.mesh, graph, field, digest));
}

}  // namespace

std::vector<double> vtkCrestFeatureLines::FieldOf(const io::MeshFile& file) {
  if (this->Source == Angles)
    return feature_lines::vertex_angles(file.mesh, static_cast<kernel::Index>(this->Over));
  std::vector<double> field;
  if (this->Source == Array) {
    field = file.values;
    if (this->Absolute)
      for (double& x : field) x = std::fabs(x);
    return field;
  }
  const auto larger = [&](double k1, double k2) {
    field.push_back(std::max(std::fabs(k1), std::fabs(k2)));
  };
  const std::string method = this->Method ? this->Method : "fit";
  if (method == "fit") {
    ridges::FitOptions options;
    options.rings = this->Rings;
    for (const kernel::MongeForm& form : ridges::fit_monge_forms(file.mesh, options).forms)
      larger(form.k1, form.k2);
    return field;
  }
  curvature::Options options;
  const auto known = curvature::method_of(method);
  if (!known || *known == curvature::Method::np)
    throw kernel::InputError("Method: '" + method +
                             "' is none that needs no normals; give fit or one of Crest Curvature");
  options.method = *known;
  if (this->Rings > 0) options.rings = this->Rings;
  const curvature::Result result = curvature::estimate(file.mesh, options);
  if (result.undetermined > 0)
    this->Warn(std::to_string(result.undetermined) +
               " vertices have no finite curvature; it is zero there");
  for (const auto& c : result.vertices) larger(c.k1, c.k2);
  return field;
}

void vtkCrestFeatureLines::CheckSizes() const {
  for (const double size : {this->Dilate, this->Erode, this->Open, this->Close})
    if (!(size >= 0 && std::isfinite(size)) ||
        (this->Neighbourhood == 0 && size != std::floor(size)))
      throw kernel::InputError(
          "Dilate, Erode, Open, Close: one is no whole number of rings; give one, or choose "
          "lengths "
          "with Neighbourhood");
}

void vtkCrestFeatureLines::Region(const io::MeshFile& file, vtkPolyData& whole) {
  this->CheckSizes();
  this->Step("fitting curvatures", 0.1);
  const std::vector<double> field = this->FieldOf(file);
  feature_lines::Options options;
  options.seek_gap = this->ThresholdMode == Gap;
  if (this->ThresholdMode == Quantile) options.quantile = this->Threshold;
  if (this->ThresholdMode == Number) options.value = this->Value;
  if (this->Source == Angles) options.value = angle_of(this->Angle).degrees();
  options.neighbourhood = static_cast<feature_lines::Neighbourhood>(this->Neighbourhood);
  options.dilate = this->Dilate;
  options.erode = this->Erode;
  options.open = this->Open;
  options.close = this->Close;
  options.prune = static_cast<kernel::Index>(this->Prune);
  options.min_patch = static_cast<kernel::Index>(this->MinPatch);
  options.close_branches = static_cast<kernel::Index>(this->CloseBranches);
  this->Step("thinning", 0.5);
  const auto lines = feature_lines::extract_feature_lines(file.mesh, field, options);
  this->Certify(certify::encode(feature_lines::make_certificate(file.mesh, lines.thinning)), 0);
  fill(file, lines.graph, field, this->DataDigest, whole);
}

void vtkCrestFeatureLines::SharpEdges(const io::MeshFile& file, vtkPolyData& whole) {
  const kernel::DecimalAngle angle = angle_of(this->Angle);
  this->Step("comparing angles", 0.3);
  const auto lines = feature_lines::extract_sharp_lines(
      file.mesh, angle,
      {static_cast<kernel::Index>(this->Prune), static_cast<kernel::Index>(this->CloseBranches)});
  if (lines.ties > 0)
    this->Warn("edges of exactly " + std::string(this->Angle) + " degrees (" +
               std::to_string(lines.ties) + ") are not above it; a smaller Angle marks them");
  this->Certify(certify::encode(feature_lines::make_certificate(file.mesh, angle, lines)), 0);
  fill(file, lines.graph, feature_lines::vertex_angles(file.mesh, 0), this->DataDigest, whole);
}

void vtkCrestFeatureLines::Work(vtkInformationVector** inputs, vtkInformationVector* outputs) {
  io::MeshRequest request;
  if (this->Source == Array) request.field = this->ChosenArray();
  const io::MeshFile file = this->Mesh(inputs, request);
  vtkNew<vtkPolyData> whole;
  if (this->Source == Angles && this->Over == 0)
    this->SharpEdges(file, *whole);
  else
    this->Region(file, *whole);
  this->Step("writing", 0.95);
  take_rest(*whole, "kind", {0}, *vtkPolyData::GetData(outputs, 0));
  vtkPolyData& mesh = *vtkPolyData::GetData(outputs, 1);
  take_part(*whole, "kind", {0}, mesh);
  PassArrays(InputSurface(inputs), file.numbers, mesh);
}
