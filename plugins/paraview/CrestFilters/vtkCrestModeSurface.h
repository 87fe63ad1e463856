// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkCrestModeSurface_h
#define vtkCrestModeSurface_h

#include "vtkCrestAlgorithm.h"

namespace crest {  // VTK's parser knows no nested names
namespace io {
struct ModeScene;
}
namespace modes {
struct ModeField;
}
}  // namespace crest

/// crest modes. Outputs: 0 mode and neutral surfaces, 1 degenerate curves.
class VTKCRESTFILTERS_EXPORT vtkCrestModeSurface : public vtkCrestAlgorithm {
 public:
  static vtkCrestModeSurface* New();
  vtkTypeMacro(vtkCrestModeSurface, vtkCrestAlgorithm);

  /// Levels as the command line has them: decimals or fractions p/q, with commas between.
  vtkSetStringMacro(Mode);
  vtkSetMacro(Neutral, bool);
  vtkSetMacro(Degenerate, bool);
  /// Of each level that of its sign alone.
  vtkSetMacro(Signed, bool);
  /// Of tensors with 6 components; empty: VTK's.
  vtkSetStringMacro(Order);
  vtkSetMacro(MaxDepth, int);
  vtkSetMacro(Budget, int);
  vtkSetMacro(Deviation, double);
  vtkSetMacro(MinMagnitude, double);

 protected:
  vtkCrestModeSurface();
  ~vtkCrestModeSurface() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Work(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

 private:
  void AddCurves(const crest::modes::ModeField& field, bool certify, crest::io::ModeScene& scene);

  char *Mode = nullptr, *Order = nullptr;
  bool Neutral = false, Degenerate = false, Signed = false;
  int MaxDepth = 40, Budget = 100'000;
  double Deviation = 0, MinMagnitude = 0;
};

#endif
