// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkCrestCurvature_h
#define vtkCrestCurvature_h

#include "vtkCrestMeshAlgorithm.h"

/// crest curvature: the mesh with its curvatures. Estimates, without a certificate.
class VTKCRESTFILTERS_EXPORT vtkCrestCurvature : public vtkCrestMeshAlgorithm {
 public:
  static vtkCrestCurvature* New();
  vtkTypeMacro(vtkCrestCurvature, vtkCrestMeshAlgorithm);

  /// A name as the command line has it.
  vtkSetStringMacro(Method);
  /// Takes the input's normals.
  vtkSetMacro(Normals, bool);
  vtkSetMacro(Degree, int);
  vtkSetMacro(Rings, int);

 protected:
  vtkCrestCurvature();
  ~vtkCrestCurvature() override;
  void Work(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

 private:
  char* Method = nullptr;
  bool Normals = false;
  int Degree = 4, Rings = 1;
};

#endif
