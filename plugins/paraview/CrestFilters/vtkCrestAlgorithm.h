// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkCrestAlgorithm_h
#define vtkCrestAlgorithm_h

#include <cstdint>
#include <string>
#include <vector>

#include "vtkCrestFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

/// What all filters of Crest share: threads, certificate, errors as messages, progress and abort,
/// and what happens where several processes hold parts of the input.
///
/// A filter overrides Work() and writes its outputs at the very end of it, so that after an error
/// or an abort they are empty. Every output of a work that was done gets the field arrays
/// `certified` (1: a certificate was made and leaves nothing undecided; where Verify is on, its
/// checker has accepted it) and `data_digest` (of the certificate's data; empty: none was made).
class VTKCRESTFILTERS_EXPORT vtkCrestAlgorithm : public vtkPolyDataAlgorithm {
 public:
  vtkTypeMacro(vtkCrestAlgorithm, vtkPolyDataAlgorithm);

  /// Where the certificate goes, on the machine that computes; empty: no file.
  vtkSetFilePathMacro(CertificateFile);
  /// Runs the checker on the certificate, too.
  vtkSetMacro(Verify, bool);
  /// 0: as many as the machine has.
  vtkSetMacro(Threads, int);

  vtkCrestAlgorithm(const vtkCrestAlgorithm&) = delete;
  void operator=(const vtkCrestAlgorithm&) = delete;

 protected:
  vtkCrestAlgorithm();
  ~vtkCrestAlgorithm() override;

  /// Throws: crest::kernel::InputError for bad input, whose line becomes the filter's message.
  virtual void Work(vtkInformationVector** inputs, vtkInformationVector* outputs) = 0;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
                  vtkInformationVector* outputs) final;

  /// Says what is done next, and how much of all (0 to 1) lies behind. Ends the work if the user
  /// asked for that.
  void Step(const char* next, double done);
  void Warn(const std::string& line);
  void Warn(const std::vector<std::string>& lines);

  /// Whether one is asked for.
  bool WantsCertificate() const;
  /// Writes and verifies the certificate, as far as that is asked for, and keeps what the outputs
  /// say about it. A checker that does not accept is an error, of the filter where `must_hold`,
  /// else a warning and there is no certificate (the checker is free to prove less than the
  /// algorithm).
  void Certify(const std::vector<std::uint8_t>& bytes, std::size_t undecided,
               bool must_hold = true);
  std::string DataDigest;

  /// The array chosen through SetInputArrayToProcess: its name (empty: none) and whether it is one
  /// of cells.
  std::string ChosenArray();
  bool ChoseCells();

 private:
  class Stopped {};
  /// Whether this process holds points of the input. Sources always do.
  bool HasWork(vtkInformationVector** inputs);
  /// Whether several processes hold some. All of them must ask.
  bool IsSpread(vtkInformationVector** inputs);
  void WriteFieldData(vtkInformationVector* outputs);

  char* CertificateFile = nullptr;
  bool Verify = false;
  int Threads = 0;
  bool Certified = false;
};

#endif
