// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkCrestRidges_h
#define vtkCrestRidges_h

#include "vtkCrestMeshAlgorithm.h"

/// crest ridges of a mesh. Outputs: 0 ridges (polylines), 1 umbilics (vertices), 2 the mesh with
/// k1, k2, d1, d2.
class VTKCRESTFILTERS_EXPORT vtkCrestRidges : public vtkCrestMeshAlgorithm {
 public:
  static vtkCrestRidges* New();
  vtkTypeMacro(vtkCrestRidges, vtkCrestMeshAlgorithm);

  /// What a fit's support is: 30 points; chosen by what is salient; SupportRadius; Rings.
  enum SupportModes { Points, Auto, Radius, ByRings };
  vtkSetMacro(SupportMode, int);
  vtkSetMacro(SupportRadius, double);
  vtkSetMacro(Rings, int);
  vtkSetMacro(Smooth, int);
  vtkSetMacro(UmbilicPatch, double);
  vtkSetMacro(Significance, double);
  vtkSetMacro(MinWeight, double);
  vtkSetMacro(MinSharpness, double);
  vtkSetMacro(MinStrength, double);
  vtkSetMacro(MinLength, double);
  vtkSetMacro(CrestOnly, bool);
  /// What is kept: all ridges, the significant pieces, the salient ones.
  vtkSetMacro(Keep, int);

 protected:
  vtkCrestRidges();
  void Work(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

 private:
  int SupportMode = Points;
  double SupportRadius = 0;
  int Rings = 3, Smooth = 0;
  double UmbilicPatch = 3, Significance = 4, MinWeight = 1.5;
  double MinSharpness = 0, MinStrength = 0, MinLength = 0;
  bool CrestOnly = false;
  int Keep = 0;
};

#endif
