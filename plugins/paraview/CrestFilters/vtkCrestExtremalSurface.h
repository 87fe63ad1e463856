// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkCrestExtremalSurface_h
#define vtkCrestExtremalSurface_h

#include "vtkCrestAlgorithm.h"

/// crest extremal of volumes and images. Outputs: 0 the surface (of images the curves), 1 the edges
/// with another number of faces than two, with the reason.
class VTKCRESTFILTERS_EXPORT vtkCrestExtremalSurface : public vtkCrestAlgorithm {
 public:
  static vtkCrestExtremalSurface* New();
  vtkTypeMacro(vtkCrestExtremalSurface, vtkCrestAlgorithm);

  /// Where the value is least, not largest.
  vtkSetMacro(Valley, bool);
  /// The dominant eigenvector of the Hessian, not of the structure tensor.
  vtkSetMacro(Hessian, bool);
  vtkSetMacro(Sigma, double);
  /// Negative: Sigma.
  vtkSetMacro(TensorSigma, double);
  vtkSetMacro(UseMinValue, bool);
  vtkSetMacro(MinValue, double);
  vtkSetMacro(MinStrength, double);
  vtkSetMacro(Refine, int);
  vtkSetMacro(Critical, bool);

 protected:
  vtkCrestExtremalSurface();
  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Work(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

 private:
  bool Valley = false, Hessian = false, UseMinValue = false, Critical = false;
  double Sigma = 1, TensorSigma = -1, MinValue = 0, MinStrength = 0;
  int Refine = 0;
};

#endif
