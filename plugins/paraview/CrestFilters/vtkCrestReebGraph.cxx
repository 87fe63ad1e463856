// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkCrestReebGraph.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>

#include "algorithms/reeb/certificate.hpp"
#include "algorithms/reeb/labelled_graph.hpp"
#include "algorithms/reeb/reeb_graph.hpp"
#include "certify/reeb/encode.hpp"
#include "crest_parts.h"
#include "io/formats/vtk_input.hpp"
#include "io/read/quadratic_reader.hpp"
#include "io/reeb/reeb_writer.hpp"
#include "kernel/geometry/input_error.hpp"

vtkStandardNewMacro(vtkCrestReebGraph);

vtkCrestReebGraph::vtkCrestReebGraph() {
  this->SetNumberOfOutputPorts(4);
}

vtkCrestReebGraph::~vtkCrestReebGraph() {
  this->SetExpression(nullptr);
}

void vtkCrestReebGraph::AddLevel(double level) {
  this->Levels.push_back(level);
  this->Modified();
}

void vtkCrestReebGraph::ClearLevels() {
  this->Levels.clear();
  this->Modified();
}

int vtkCrestReebGraph::FillOutputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 3 ? "vtkUnstructuredGrid" : "vtkPolyData");
  return 1;
}

namespace {

using namespace crest;
using kernel::Index;

io::FunctionSource source_of(const char* expression, io::FunctionSource source) {
  if (!expression || !*expression) return source;
  try {
    source.expression = kernel::Expression::parse(expression, {"x", "y", "z"});
  } catch (const kernel::ExpressionError& error) {
    throw kernel::InputError(std::string("Expression: ") + error.what());
  }
  return source;
}

}  // namespace

void vtkCrestReebGraph::Work(vtkInformationVector** inputs, vtkInformationVector* outputs) {
  this->Step("cleaning the surface", 0);
  const io::FunctionSource source =
      source_of(this->Expression, {this->ChosenArray(), {}, this->Linear, this->Cleaning(), {}});
  for (const double level : this->Levels)
    if (!std::isfinite(level)) throw kernel::InputError("Levels: one is not finite; repair it");
  const io::QuadraticFile file =
      io::quadratic_mesh_of_soup(io::soup_of(InputSurface(inputs)), source);
  this->Warn(file.warnings);
  this->Step("tessellating", 0.1);
  const reeb::TileComplex tiles = reeb::tessellate(file.mesh);
  this->Step("joining contours into the graph", 0.4);
  const reeb::ReebGraph graph = reeb::reeb_graph(reeb::ordered(tiles));
  if (this->WantsCertificate()) {
    this->Step("composing the certificate", 0.6);
    this->Certify(certify::encode(reeb::make_certificate(file.mesh, tiles, graph)), 0);
  }
  this->Step("placing nodes and labelling", 0.8);
  const std::vector<reeb::NodePlace> places = reeb::node_places(file.mesh, tiles);
  reeb::LabelledGraph shown{graph, {}, {}};
  reeb::label(tiles, true, shown);
  std::vector<double> values;
  for (const reeb::NodePlace& place : places) values.push_back(place.value);
  reeb::Simplification wanted{this->Contract, {}, this->CancelLoops};
  if (this->Persistence >= 0) wanted.persistence = this->Persistence;
  if (wanted.wanted()) reeb::simplify(tiles, values, wanted, shown);
  std::vector<io::LevelLines> levels;
  for (const double level : this->Levels)
    levels.push_back({level, reeb::contours(file.mesh, tiles, level)});
  this->Step("writing", 0.95);
  const std::vector<Index> no_tiles;
  const std::vector<io::TreeLines> no_trees;
  const auto scene = [&](const std::vector<Index>& arc_of_tile) {
    return io::ReebScene{file.mesh,   tiles,    places, shown.graph,      shown.arc_of_node,
                         arc_of_tile, no_trees, levels, this->DataDigest, file.numbers.faces};
  };
  const auto lines = io::reeb_poly_data(scene(no_tiles));
  take_part(*lines, "kind", {1}, *vtkPolyData::GetData(outputs, 0));
  take_part(*lines, "kind", {0}, *vtkPolyData::GetData(outputs, 1));
  take_part(*lines, "kind", {2}, *vtkPolyData::GetData(outputs, 2));
  vtkUnstructuredGrid::GetData(outputs, 3)->ShallowCopy(io::reeb_tiles(scene(shown.arc_of_tile)));
}
