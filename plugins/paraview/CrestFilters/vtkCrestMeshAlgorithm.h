// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkCrestMeshAlgorithm_h
#define vtkCrestMeshAlgorithm_h

#include "vtkCrestAlgorithm.h"

namespace crest {  // VTK's parser knows no nested names
namespace io {
struct CleanOptions;
struct FileNumbers;
struct MeshFile;
struct MeshRequest;
struct Soup;
}  // namespace io
}  // namespace crest
class vtkDataSetAttributes;
class vtkPointSet;

/// Filters whose input is a surface, as polygonal data or the faces of an unstructured grid,
/// cleaned as the command line cleans files (docs/conventions.md): one warning a step.
class VTKCRESTFILTERS_EXPORT vtkCrestMeshAlgorithm : public vtkCrestAlgorithm {
 public:
  vtkTypeMacro(vtkCrestMeshAlgorithm, vtkCrestAlgorithm);

  /// Vertices within this distance become one; 0: equal ones; negative: none.
  vtkSetMacro(Weld, double);
  /// Cuts at edges of three or more faces, and one-sided parts open.
  vtkSetMacro(Split, bool);
  /// Turns closed parts of negative volume.
  vtkSetMacro(Outward, bool);

 protected:
  int FillInputPortInformation(int port, vtkInformation* info) override;
  static vtkPointSet& InputSurface(vtkInformationVector** inputs);
  crest::io::CleanOptions Cleaning() const;
  /// The input as a mesh; says what was cleaned.
  crest::io::MeshFile Mesh(vtkInformationVector** inputs, crest::io::MeshRequest request);
  /// Copies the input's arrays to the cleaned mesh, whose points and faces `numbers` names.
  static void PassArrays(vtkPointSet& input, const crest::io::FileNumbers& numbers,
                         vtkPolyData& mesh);

 private:
  double Weld = -1;
  bool Split = false, Outward = false;
};

#endif
