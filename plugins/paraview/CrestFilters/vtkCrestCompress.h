// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkCrestCompress_h
#define vtkCrestCompress_h

#include "vtkCrestVectorAlgorithm.h"

/// crest compress: the field on fewer triangles with the same topological skeleton.
class VTKCRESTFILTERS_EXPORT vtkCrestCompress : public vtkCrestVectorAlgorithm {
 public:
  static vtkCrestCompress* New();
  vtkTypeMacro(vtkCrestCompress, vtkCrestVectorAlgorithm);

  /// Strong, original, relaxed.
  vtkSetMacro(Equivalence, int);
  /// Retrace, thesis.
  vtkSetMacro(Test, int);
  /// Length, error.
  vtkSetMacro(Priority, int);

 protected:
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void Work(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

 private:
  int Equivalence = 1, Test = 0, Priority = 0;
};

#endif
