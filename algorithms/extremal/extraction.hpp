// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// All that one run decides: what the result and the certificate are made from.
#include "algorithms/extremal/components.hpp"

namespace crest::extremal {

class Extraction {
 public:
  Extraction(Fields fields, const Options& options);
  Extraction(const Extraction&) = delete;  // Its parts refer to each other.
  Extraction& operator=(const Extraction&) = delete;

  const Options& options() const { return options_; }
  const Fields& fields() const { return fields_; }
  const Nodes& nodes() const { return nodes_; }
  const Cells& cells() const { return cells_; }
  const Edges& edges() const { return edges_; }
  const Faces& faces() const { return faces_; }
  const Clusters& clusters() const { return clusters_; }

  /// `critical`: of all critical edges.
  MeasuredMesh mesh(bool critical) const;
  Result result(const MeasuredMesh& mesh) const;

 private:
  Counts counts(const MeasuredMesh& mesh) const;

  Options options_;
  Fields fields_;
  Nodes nodes_;
  Cells cells_;
  Edges edges_;
  Faces faces_;
  Clusters clusters_;
};

}  // namespace crest::extremal
