// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkCrestReebGraph_h
#define vtkCrestReebGraph_h

#include "vtkCrestMeshAlgorithm.h"

/// crest reeb. Outputs: 0 arcs (polylines), 1 critical points (vertices), 2 level lines, 3 the
/// monotone tiles with the arc of each.
class VTKCRESTFILTERS_EXPORT vtkCrestReebGraph : public vtkCrestMeshAlgorithm {
 public:
  static vtkCrestReebGraph* New();
  vtkTypeMacro(vtkCrestReebGraph, vtkCrestMeshAlgorithm);

  /// In x, y, z, instead of the array; empty: the array.
  vtkSetStringMacro(Expression);
  /// Ignores values in the middle of edges.
  vtkSetMacro(Linear, bool);
  /// Contracts arcs between equal values.
  vtkSetMacro(Contract, bool);
  /// Cancels leaves up to this difference of values; negative: none.
  vtkSetMacro(Persistence, double);
  vtkSetMacro(CancelLoops, bool);
  void AddLevel(double level);
  void ClearLevels();

 protected:
  vtkCrestReebGraph();
  ~vtkCrestReebGraph() override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  void Work(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

 private:
  char* Expression = nullptr;
  bool Linear = false, Contract = false, CancelLoops = false;
  double Persistence = -1;
  std::vector<double> Levels;
};

#endif
