// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkCrestAlgorithm.h"

#include <tbb/info.h>
#include <tbb/task_arena.h>
#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkMultiProcessController.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <new>
#include <stdexcept>

#include "certify/certificate.hpp"
#include "certify/verify.hpp"
#include "io/write/atomic_file.hpp"
#include "kernel/arithmetic/self_test.hpp"
#include "kernel/geometry/input_error.hpp"

namespace {

/// Messages name the command line's options; the properties have the same words: "--min-length" is
/// MinLength.
std::string in_properties(const std::string& message) {
  const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
  std::string text;
  for (std::size_t i = 0; i < message.size(); ++i) {
    const bool option = message.compare(i, 2, "--") == 0 && i + 2 < message.size() &&
                        is_letter(message[i + 2]) && (i == 0 || message[i - 1] == ' ');
    if (!option) {
      text += message[i];
      continue;
    }
    bool starts_word = true;
    for (i += 2; i < message.size() && (is_letter(message[i]) || message[i] == '-'); ++i) {
      if (message[i] != '-') text += static_cast<char>(message[i] - (starts_word ? 'a' - 'A' : 0));
      starts_word = message[i] == '-';
    }
    --i;
  }
  return text;
}

}  // namespace

vtkCrestAlgorithm::vtkCrestAlgorithm() = default;
vtkCrestAlgorithm::~vtkCrestAlgorithm() {
  this->SetCertificateFile(nullptr);
}

int vtkCrestAlgorithm::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                   vtkInformationVector* outputs) {
  this->DataDigest.clear();
  this->Certified = false;
  std::string error;
  try {
    if (this->IsSpread(inputs))
      throw crest::kernel::InputError(
          "input: several processes hold parts of it, and the parts' results are not those of the "
          "whole; put Aggregate Dataset with one target process before this filter");
    crest::kernel::require_sound_floating_point();
    const int most = tbb::info::default_concurrency();
    tbb::task_arena arena(this->Threads > 0 ? std::min(this->Threads, most) : most);
    if (this->HasWork(inputs)) {
      arena.execute([&] { this->Work(inputs, outputs); });
      this->WriteFieldData(outputs);
    }
  } catch (const Stopped&) {
  } catch (const crest::kernel::InputError& bad) {
    error = bad.what();
  } catch (const std::bad_alloc&) {
    error = "input: needs more memory than there is; give a smaller one";
  } catch (const std::exception& bug) {
    error = std::string("internal error: ") + bug.what();
  }
  if (!error.empty()) vtkErrorMacro(<< in_properties(error));
  this->SetProgressText(nullptr);
  return 1;
}

bool vtkCrestAlgorithm::HasWork(vtkInformationVector** inputs) {
  if (this->GetNumberOfInputPorts() == 0) return true;
  vtkDataObject* input = vtkDataObject::GetData(inputs[0]);
  return input && input->GetNumberOfElements(vtkDataObject::POINT) > 0;
}

bool vtkCrestAlgorithm::IsSpread(vtkInformationVector** inputs) {
  auto* controller = vtkMultiProcessController::GetGlobalController();
  if (!controller || controller->GetNumberOfProcesses() < 2 || this->GetNumberOfInputPorts() == 0)
    return false;
  const int holds = this->HasWork(inputs) ? 1 : 0;
  int holders = 0;
  controller->AllReduce(&holds, &holders, 1, vtkCommunicator::SUM_OP);
  return holders > 1;
}

void vtkCrestAlgorithm::WriteFieldData(vtkInformationVector* outputs) {
  for (int i = 0; i < outputs->GetNumberOfInformationObjects(); ++i) {
    vtkFieldData* fields = vtkDataObject::GetData(outputs, i)->GetFieldData();
    vtkNew<vtkStringArray> digest;
    digest->SetName("data_digest");
    digest->InsertNextValue(this->DataDigest);
    fields->AddArray(digest);
    vtkNew<vtkIntArray> certified;
    certified->SetName("certified");
    certified->InsertNextValue(this->Certified ? 1 : 0);
    fields->AddArray(certified);
  }
}

void vtkCrestAlgorithm::Step(const char* next, double done) {
  this->SetProgressText(next);
  this->UpdateProgress(done);
  if (this->GetAbortExecute()) throw Stopped();
}

void vtkCrestAlgorithm::Warn(const std::string& line) {
  vtkWarningMacro(<< in_properties(line));
}

void vtkCrestAlgorithm::Warn(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) this->Warn(line);
}

bool vtkCrestAlgorithm::WantsCertificate() const {
  return this->Verify || (this->CertificateFile && *this->CertificateFile);
}

void vtkCrestAlgorithm::Certify(const std::vector<std::uint8_t>& bytes, std::size_t undecided,
                                bool must_hold) {
  if (this->Verify || !must_hold) {
    this->Step("verifying the certificate", 0.9);
    const crest::certify::Verdict verdict = crest::certify::verify(bytes);
    if (!verdict.accepted && must_hold)
      throw std::runtime_error("the certificate's checker refuses it: " + verdict.reason);
    if (!verdict.accepted)
      return this->Warn("no certificate, its checker does not accept it: " + verdict.reason);
  }
  this->DataDigest = crest::certify::hex(crest::certify::data_digest(bytes));
  this->Certified = undecided == 0;
  if (this->CertificateFile && *this->CertificateFile)
    crest::io::write_atomically(this->CertificateFile,
                                {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

std::string vtkCrestAlgorithm::ChosenArray() {
  vtkInformation* array = this->GetInputArrayInformation(0);
  const char* name = array ? array->Get(vtkDataObject::FIELD_NAME()) : nullptr;
  return name ? name : "";
}

bool vtkCrestAlgorithm::ChoseCells() {
  vtkInformation* array = this->GetInputArrayInformation(0);
  return array && array->Has(vtkDataObject::FIELD_ASSOCIATION()) &&
         array->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::FIELD_ASSOCIATION_CELLS;
}
