// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkCrestSplineIsosurface_h
#define vtkCrestSplineIsosurface_h

#include "vtkCrestAlgorithm.h"

/// crest spline --isovalue --mesh: a level set of the quadratic super spline of a volume.
class VTKCRESTFILTERS_EXPORT vtkCrestSplineIsosurface : public vtkCrestAlgorithm {
 public:
  static vtkCrestSplineIsosurface* New();
  vtkTypeMacro(vtkCrestSplineIsosurface, vtkCrestAlgorithm);

  vtkSetMacro(Isovalue, double);
  vtkSetMacro(MaxDepth, int);
  /// Adds a layer of samples around by linear extrapolation.
  vtkSetMacro(Extend, bool);

 protected:
  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Work(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

 private:
  double Isovalue = 0;
  int MaxDepth = 30;
  bool Extend = false;
};

#endif
