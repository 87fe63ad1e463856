// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkCrestVectorFieldSkeleton_h
#define vtkCrestVectorFieldSkeleton_h

#include "vtkCrestVectorAlgorithm.h"

/// crest skeleton. Outputs: 0 separatrices and closed orbits (polylines), 1 critical points and
/// switch points (vertices).
class VTKCRESTFILTERS_EXPORT vtkCrestVectorFieldSkeleton : public vtkCrestVectorAlgorithm {
 public:
  static vtkCrestVectorFieldSkeleton* New();
  vtkTypeMacro(vtkCrestVectorFieldSkeleton, vtkCrestVectorAlgorithm);

 protected:
  vtkCrestVectorFieldSkeleton();
  void Work(vtkInformationVector** inputs, vtkInformationVector* outputs) override;
};

#endif
