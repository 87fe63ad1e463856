// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// From the joined records of all pieces to the mesh and what is reported of it.
#include "algorithms/extremal/components.hpp"
#include "algorithms/extremal/records.hpp"

namespace crest::extremal {

class Assembly {
 public:
  /// `grid`: the whole one, refined.
  Assembly(const Grid& grid, const Options& options, Records records);

  const Grid& grid() const { return grid_; }
  const Options& options() const { return options_; }
  const Records& records() const { return records_; }

  /// `critical`: of all critical edges. Requires: it is among the meshes that the records are for.
  MeasuredMesh mesh(bool critical) const;
  Result result(MeasuredMesh mesh, const ValuesAt& values) const;
  Result result(bool critical, const ValuesAt& values) const {
    return result(mesh(critical), values);
  }
  /// Gives the cells away, of which the certificate has most.
  CellRecords take_cells() { return std::move(records_.cells); }
  /// Throws away what the meshes alone were made from.
  void drop_faces() {
    records_.faces = {};
    records_.sheets = {};
  }

 private:
  /// Of records, but for nodes and cells.
  Counts record_counts() const;
  Counts counts(const MeasuredMesh& mesh) const;

  Grid grid_;
  Options options_;
  Records records_;
  Clusters clusters_;
  Counts counts_;
};

}  // namespace crest::extremal
