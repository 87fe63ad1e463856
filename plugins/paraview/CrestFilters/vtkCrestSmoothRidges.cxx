// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkCrestSmoothRidges.h"

#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <atomic>
#include <chrono>
#include <sstream>
#include <stdexcept>

#include "algorithms/smooth_ridges/smooth_ridges.hpp"
#include "algorithms/smooth_ridges/surface.hpp"
#include "certify/ridges_smooth/encode.hpp"
#include "crest_parts.h"
#include "io/ridges/smooth_ridge_writer.hpp"
#include "kernel/geometry/input_error.hpp"

vtkStandardNewMacro(vtkCrestSmoothRidges);

vtkCrestSmoothRidges::vtkCrestSmoothRidges() {
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(3);
}

vtkCrestSmoothRidges::~vtkCrestSmoothRidges() {
  this->SetSurface(nullptr);
  this->SetX(nullptr);
  this->SetY(nullptr);
  this->SetZ(nullptr);
  this->SetDomain(nullptr);
}

namespace {

std::string text_of(const char* text) {
  return text ? text : "";
}

std::array<std::string, 4> domain_of(const char* text) {
  std::array<std::string, 4> parts;
  std::istringstream stream(text_of(text));
  std::size_t count = 0;
  for (std::string part; std::getline(stream, part, ','); ++count)
    if (count < parts.size()) parts[count] = part;
  if (count != parts.size())
    throw crest::kernel::InputError("Domain: " + std::to_string(count) +
                                    " expressions; give 4: u0,u1,v0,v1");
  return parts;
}

}  // namespace

void vtkCrestSmoothRidges::Work(vtkInformationVector**, vtkInformationVector* outputs) {
  using namespace crest;
  const auto surface = [&] {
    try {
      return this->Parametric ? smooth_ridges::Surface::parametric(
                                    {text_of(this->X), text_of(this->Y), text_of(this->Z)},
                                    domain_of(this->Domain), {this->PeriodicU, this->PeriodicV})
                              : smooth_ridges::Surface::implicit(text_of(this->Surface),
                                                                 std::to_array(this->Box));
    } catch (const kernel::InputError&) {
      throw;
    } catch (const kernel::ExpressionError& error) {
      throw kernel::InputError(std::string("Surface: ") + error.what());
    } catch (const std::invalid_argument& error) {
      throw kernel::InputError(std::string("Surface: ") + error.what());
    }
  }();
  smooth_ridges::Options options;
  if (this->StartFaces > 0) options.start_faces = this->StartFaces;
  options.refinement.max_depth = this->MaxDepth;
  options.refinement.max_faces = static_cast<std::size_t>(this->Budget);
  // Asked by several threads, while progress, which may end the work, is told by this one.
  std::atomic<bool> aborted = false;
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  options.refinement.progress = [&](int, std::size_t faces, std::size_t left) {
    const double done = faces > 0 ? 1 - static_cast<double>(left) / static_cast<double>(faces) : 0;
    this->UpdateProgress(0.9 * done);
    if (this->GetAbortExecute()) aborted = true;
  };
  options.stop = [&] {
    return aborted ||
           (this->Seconds > 0 &&
            std::chrono::duration<double>(Clock::now() - start).count() >= this->Seconds);
  };
  this->Step("triangulating and proving", 0);
  const smooth_ridges::SmoothRidges result = smooth_ridges::smooth_ridges(surface, options);
  this->Step("composing the certificate", 0.9);  // ends here if the user asked for that
  if (result.certified)
    this->Certify(certify::encode(result.certificate), 0);
  else
    this->Warn("not certified: " + std::to_string(result.undecided.size()) +
               " cells are undecided; counts are of a partial result");
  const auto whole = io::smooth_ridge_poly_data(result, this->DataDigest);
  take_part(*whole, "kind", {-1}, *vtkPolyData::GetData(outputs, 0));
  take_rest(*whole, "kind", {-1}, *vtkPolyData::GetData(outputs, 1));
  vtkPolyData::GetData(outputs, 2)
      ->ShallowCopy(io::smooth_mesh_poly_data(result, this->DataDigest));
}
