// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkCrestFeatureLines_h
#define vtkCrestFeatureLines_h

#include "vtkCrestMeshAlgorithm.h"

/// crest features. Outputs: 0 the lines (polylines), 1 the mesh with the label of each vertex and
/// the patch of each face.
class VTKCRESTFILTERS_EXPORT vtkCrestFeatureLines : public vtkCrestMeshAlgorithm {
 public:
  static vtkCrestFeatureLines* New();
  vtkTypeMacro(vtkCrestFeatureLines, vtkCrestMeshAlgorithm);

  /// What is followed: where max(|k1|, |k2|) is large; where an array is; sharp edges.
  enum Sources { Curvature, Array, Angles };
  vtkSetMacro(Source, int);
  /// "fit", or a method of crest curvature.
  vtkSetStringMacro(Method);
  vtkSetMacro(Rings, int);
  vtkSetMacro(Absolute, bool);
  /// The threshold: a gap near the quantile 0.85; the quantile Threshold; the number Value.
  enum Thresholds { Gap, Quantile, Number };
  vtkSetMacro(ThresholdMode, int);
  vtkSetMacro(Threshold, double);
  vtkSetMacro(Value, double);
  /// In degrees, a decimal, compared exactly.
  vtkSetStringMacro(Angle);
  /// Rings of the normals; 0: the edges themselves.
  vtkSetMacro(Over, int);
  vtkSetMacro(Dilate, double);
  vtkSetMacro(Erode, double);
  vtkSetMacro(Open, double);
  vtkSetMacro(Close, double);
  /// What these four count in: rings, Euclidean distance, paths along edges, geodesics.
  vtkSetMacro(Neighbourhood, int);
  vtkSetMacro(Prune, int);
  vtkSetMacro(MinPatch, int);
  vtkSetMacro(CloseBranches, int);

 protected:
  vtkCrestFeatureLines();
  ~vtkCrestFeatureLines() override;
  void Work(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

 private:
  void Region(const crest::io::MeshFile& file, vtkPolyData& lines);
  void SharpEdges(const crest::io::MeshFile& file, vtkPolyData& lines);
  std::vector<double> FieldOf(const crest::io::MeshFile& file);
  void CheckSizes() const;

  int Source = Curvature;
  char *Method = nullptr, *Angle = nullptr;
  int Rings = 0, Over = 0, ThresholdMode = Gap, Neighbourhood = 0;
  bool Absolute = false;
  double Threshold = 0.85, Value = 0, Dilate = 0, Erode = 0, Open = 0, Close = 0;
  int Prune = 0, MinPatch = 0, CloseBranches = 0;
};

#endif
