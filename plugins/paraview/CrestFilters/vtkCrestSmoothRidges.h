// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkCrestSmoothRidges_h
#define vtkCrestSmoothRidges_h

#include "vtkCrestAlgorithm.h"

/// crest ridges --surface, --param: a source. Outputs: 0 ridges (polylines), 1 umbilics, turning
/// and purple points, undecided cells (vertices), 2 the triangulation.
class VTKCRESTFILTERS_EXPORT vtkCrestSmoothRidges : public vtkCrestAlgorithm {
 public:
  static vtkCrestSmoothRidges* New();
  vtkTypeMacro(vtkCrestSmoothRidges, vtkCrestAlgorithm);

  /// F(x, y, z) = 0 in a box, or (X, Y, Z)(u, v) over a domain.
  vtkSetMacro(Parametric, bool);
  vtkSetStringMacro(Surface);
  vtkSetVector6Macro(Box, double);
  vtkSetStringMacro(X);
  vtkSetStringMacro(Y);
  vtkSetStringMacro(Z);
  /// u0, u1, v0, v1 with commas between: constants like 2*pi are allowed.
  vtkSetStringMacro(Domain);
  vtkSetMacro(PeriodicU, bool);
  vtkSetMacro(PeriodicV, bool);
  /// 0: 1500, or 400 of a parametrisation.
  vtkSetMacro(StartFaces, int);
  vtkSetMacro(MaxDepth, int);
  vtkSetMacro(Budget, int);
  /// Stops after so long, with what is proven by then; 0: never.
  vtkSetMacro(Seconds, double);

 protected:
  vtkCrestSmoothRidges();
  ~vtkCrestSmoothRidges() override;
  void Work(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

 private:
  bool Parametric = false, PeriodicU = false, PeriodicV = false;
  char *Surface = nullptr, *X = nullptr, *Y = nullptr, *Z = nullptr, *Domain = nullptr;
  double Box[6] = {-3, 3, -3, 3, -3, 3};
  int StartFaces = 0, MaxDepth = 60, Budget = 2'000'000;
  double Seconds = 0;
};

#endif
