// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkCrestVectorAlgorithm_h
#define vtkCrestVectorAlgorithm_h

#include "vtkCrestAlgorithm.h"

namespace crest {  // VTK's parser knows no nested names
namespace vector_fields {
struct PlanarField;
struct Skeleton;
}  // namespace vector_fields
}  // namespace crest

/// Filters whose input is a plane vector field: meshes and grids of one layer.
class VTKCRESTFILTERS_EXPORT vtkCrestVectorAlgorithm : public vtkCrestAlgorithm {
 public:
  vtkTypeMacro(vtkCrestVectorAlgorithm, vtkCrestAlgorithm);

  /// How cells of grids are split: along the diagonal that rises, that falls, the shorter one.
  vtkSetMacro(Diagonal, int);
  /// The layer of a grid with several; negative: the only one.
  vtkSetMacro(Slice, int);

 protected:
  int FillInputPortInformation(int port, vtkInformation* info) override;
  /// The field and its array's name.
  crest::vector_fields::PlanarField Field(vtkInformationVector** inputs, std::string& name);
  /// Separatrices whose ends are not decided.
  static std::size_t Undecided(const crest::vector_fields::Skeleton& skeleton);

 private:
  int Diagonal = 0, Slice = -1;
};

#endif
