// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkCrestModeSurface.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "algorithms/modes/certificate.hpp"
#include "algorithms/modes/curves_certificate.hpp"
#include "algorithms/modes/degenerate_curves.hpp"
#include "algorithms/modes/level_text.hpp"
#include "algorithms/modes/surface_geometry.hpp"
#include "certify/modes/encode.hpp"
#include "certify/modes_curves/encode.hpp"
#include "crest_parts.h"
#include "io/formats/vtk_input.hpp"
#include "io/modes/mode_writer.hpp"
#include "io/read/tet_reader.hpp"
#include "kernel/geometry/input_error.hpp"

vtkStandardNewMacro(vtkCrestModeSurface);

vtkCrestModeSurface::vtkCrestModeSurface() {
  this->SetNumberOfOutputPorts(2);
}

vtkCrestModeSurface::~vtkCrestModeSurface() {
  this->SetMode(nullptr);
  this->SetOrder(nullptr);
}

int vtkCrestModeSurface::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

namespace {

using namespace crest;

/// A level and, if only its sign is wanted, that sign.
struct Wanted {
  modes::Level level;
  int sign = 0;
  friend bool operator==(const Wanted& a, const Wanted& b) {
    return a.level.p == b.level.p && a.level.q == b.level.q && a.sign == b.sign;
  }
};

/// Different ones, in their order.
std::vector<Wanted> wanted_modes(std::string words, bool keep_sign, bool neutral) {
  std::replace(words.begin(), words.end(), ',', ' ');
  std::istringstream stream(words);
  std::vector<Wanted> all, different;
  for (std::string word; stream >> word;) try {
      const modes::SignedLevel parsed = modes::parse_level(word);
      all.push_back({parsed.level, keep_sign ? parsed.sign : 0});
    } catch (const std::invalid_argument& error) {
      throw kernel::InputError(std::string("Mode ") + error.what());
    }
  if (neutral) all.push_back({{0, 1}, 0});
  for (const Wanted& w : all)
    if (std::find(different.begin(), different.end(), w) == different.end()) different.push_back(w);
  return different;
}

}  // namespace

void vtkCrestModeSurface::AddCurves(const modes::ModeField& field, bool certify,
                                    io::ModeScene& scene) {
  this->Step("degenerate curves", 0.1);
  const auto& mesh = field.mesh;
  const modes::DegenerateCurves curves =
      modes::degenerate_curves(mesh.points(), mesh.tets(), field.tensors);
  if (certify)
    this->Certify(certify::encode(
                      modes::curves_certificate(mesh.points(), mesh.tets(), field.tensors, curves)),
                  curves.undecided.size(), false);
  if (!curves.undecided.empty())
    this->Warn(std::to_string(curves.undecided.size()) + " places are undecided");
  scene.curves = curves.curves;
}

void vtkCrestModeSurface::Work(vtkInformationVector** inputs, vtkInformationVector* outputs) {
  const std::vector<Wanted> wanted =
      wanted_modes(this->Mode ? this->Mode : "", this->Signed, this->Neutral);
  if (wanted.empty() && !this->Degenerate)
    throw kernel::InputError("Mode: none is given; give one, or Neutral, or Degenerate");
  this->Step("reading tensors", 0);
  io::TensorFile file =
      io::tensors_of_soup(io::soup_of(*vtkUnstructuredGrid::GetData(inputs[0])),
                          {this->ChosenArray(), this->Order ? this->Order : "", {}});
  this->Warn(file.warnings);
  if (file.max_asymmetry > 0)
    this->Warn("'" + file.field + "' is not symmetric: its symmetric part is taken");
  modes::ModeField field{std::move(file.mesh), std::move(file.tensors)};
  io::ModeScene scene;
  scene.min_magnitude = this->MinMagnitude;
  if (this->Degenerate) this->AddCurves(field, wanted.empty() && this->WantsCertificate(), scene);
  this->Step("looking for zeros", 0.2);
  const modes::ZeroSet zeros = modes::insert_zeros(field);
  const modes::ModeOptions options{this->MaxDepth, static_cast<std::uint64_t>(this->Budget),
                                   this->Deviation * modes::diagonal(field)};
  std::vector<certify::ModeLevel> records;
  std::size_t undecided = 0;
  for (const Wanted& w : wanted) {
    this->Step("extracting mode surfaces", 0.3);
    certify::ModeLevel record;
    modes::ModeResult result = this->WantsCertificate()
                                   ? modes::extract(field, w.level, options, record)
                                   : modes::extract(field, w.level, options);
    undecided += result.undecided.size();
    const bool known = std::any_of(records.begin(), records.end(), [&](const auto& r) {
      return r.numerator == record.numerator && r.denominator == record.denominator;
    });
    if (!known) records.push_back(std::move(record));
    if (w.sign != 0)
      std::erase_if(result.surfaces, [&](const auto& s) { return s.sign != w.sign; });
    std::move(result.surfaces.begin(), result.surfaces.end(), std::back_inserter(scene.surfaces));
  }
  if (undecided > 0) this->Warn(std::to_string(undecided) + " tetrahedra are undecided");
  if (!wanted.empty() && this->WantsCertificate()) {
    if (this->Degenerate)
      this->Warn("the certificate is about the surfaces; that of the curves: Degenerate alone");
    this->Step("composing the certificate", 0.7);
    this->Certify(certify::encode(modes::make_certificate(field, zeros, std::move(records))),
                  undecided);
  }
  this->Step("curvatures", 0.85);
  for (modes::ModeSurface& s : scene.surfaces) modes::add_geometry(field, s);
  scene.data_digest = this->DataDigest;
  this->Step("writing", 0.95);
  const auto whole = io::mode_poly_data(scene);
  take_rest(*whole, "tet", {-1}, *vtkPolyData::GetData(outputs, 0));
  take_part(*whole, "tet", {-1}, *vtkPolyData::GetData(outputs, 1));
}
