// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkCrestRidges.h"

#include <vtkDoubleArray.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "algorithms/curvature/curvature.hpp"
#include "algorithms/ridges/auto_scale.hpp"
#include "algorithms/ridges/certificate.hpp"
#include "algorithms/ridges/ridges.hpp"
#include "crest_parts.h"
#include "io/read/mesh_reader.hpp"
#include "io/ridges/ridge_writer.hpp"
#include "io/write/poly_data.hpp"
#include "kernel/geometry/input_error.hpp"

vtkStandardNewMacro(vtkCrestRidges);

vtkCrestRidges::vtkCrestRidges() {
  this->SetNumberOfOutputPorts(3);
}

namespace {

/// Triangles with the principal curvatures and directions of the fits.
vtkSmartPointer<vtkPolyData> with_curvatures(const crest::kernel::TriangleMesh& mesh,
                                             const crest::ridges::FitResult& fit) {
  crest::io::PolyData data;
  data.add_points(mesh.points());
  for (const auto& [a, b, c] : mesh.faces()) data.add_triangle(a, b, c);
  const auto vectors = [](const char* name) {
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    array->SetName(name);
    array->SetNumberOfComponents(3);
    return array;
  };
  const auto d1 = vectors("d1"), d2 = vectors("d2");
  for (const crest::kernel::MongeForm& form : fit.forms) {
    data.point_rows().add("k1", form.k1);
    data.point_rows().add("k2", form.k2);
    d1->InsertNextTuple(form.d1.data());
    d2->InsertNextTuple(crest::kernel::minimal_direction(form).data());
  }
  data.add_point_array(d1);
  data.add_point_array(d2);
  return data.data();
}

}  // namespace

void vtkCrestRidges::Work(vtkInformationVector** inputs, vtkInformationVector* outputs) {
  using namespace crest;
  const io::MeshFile file = this->Mesh(inputs, {});
  ridges::FitOptions fitting;
  fitting.smooth = this->Smooth;
  fitting.errors = this->Significance > 0;
  if (this->SupportMode == ByRings) fitting.rings = this->Rings;
  if (this->SupportMode == Radius) {
    fitting.scale = this->SupportRadius;
    if (!(fitting.scale > 0))
      throw kernel::InputError("SupportRadius: is not above 0; give a length of the input's units");
  }
  const ridges::GraphOptions graph_options{this->UmbilicPatch};
  const ridges::SalienceOptions salience{this->Significance, this->MinWeight};
  if (!fitting.errors && (this->SupportMode == Auto || this->Keep != 0))
    throw kernel::InputError(
        "Significance: is 0, so that nothing is salient; give a number above it");
  if (this->SupportMode == Auto) {
    this->Step("choosing the fits' support", 0.02);
    fitting.min_points = ridges::choose_support(file.mesh, fitting, graph_options, salience).points;
  }
  this->Step("fitting Monge forms", 0.3);
  const ridges::FitResult fit = ridges::fit_monge_forms(file.mesh, fitting);
  this->Step("extracting ridges and umbilics", 0.5);
  ridges::CertifiedRidges certified =
      ridges::extract_certified(file.mesh, fit.forms, graph_options);
  if (fitting.errors) {
    this->Step("measuring salience", 0.7);
    ridges::mark_salience(file.mesh, fit, certified.graph, salience);
  }
  this->Step("filtering", 0.85);
  ridges::filter(certified.graph, {this->MinSharpness, this->MinStrength, this->MinLength,
                                   this->CrestOnly, this->Keep});
  this->Certify(certified.certificate, 0);
  this->Step("writing", 0.95);
  const auto lines = io::ridge_poly_data(file.mesh, fit, certified.graph, this->DataDigest);
  take_part(*lines, "umbilic", {-1}, *vtkPolyData::GetData(outputs, 0));
  take_rest(*lines, "umbilic", {-1}, *vtkPolyData::GetData(outputs, 1));
  const auto mesh = with_curvatures(file.mesh, fit);
  PassArrays(InputSurface(inputs), file.numbers, *mesh);
  vtkPolyData::GetData(outputs, 2)->ShallowCopy(mesh);
}
