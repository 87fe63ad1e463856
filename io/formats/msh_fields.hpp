// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The fields of a Gmsh file, each of one time step.
#include <set>
#include <string>
#include <vector>

#include "io/formats/msh_source.hpp"
#include "io/formats/readers.hpp"

namespace crest::io {

class MshFields {
 public:
  MshFields(MshSource& source, const FieldRequest& request) : source_(source), request_(request) {}

  /// Reads a $NodeData or $ElementData, whose values are kept if they were asked for and no other
  /// step is meant.
  void read_section();
  /// Whether there are fields of nodes or elements.
  bool any(bool of_nodes) const;
  /// The fields of nodes or elements; tells the soup which step was taken where there are several.
  /// Throws for a value of a node or element that is not there, and if no field has the step that
  /// is asked for.
  std::vector<Field> take(bool of_nodes, const TagTable& tags, std::size_t count, Soup& soup);

 private:
  struct Data {
    std::string name;
    bool of_nodes = true, needed = false;
    bool several = false;  ///< steps, of which this is the last
    std::int64_t step = 0;
    std::size_t components = 1;
    std::vector<std::int64_t> tags;
    std::vector<double> values;
  };

  Data read_head(std::int64_t& count);
  void read_values(Data& data, std::int64_t count);
  /// Whether data of this step is to be kept; drops those before it that are not.
  bool supersedes(Data& data);
  void require_step() const;

  MshSource& source_;
  const FieldRequest& request_;
  std::vector<Data> data_;
  std::set<std::int64_t> steps_;  ///< of fields that are asked for
};

}  // namespace crest::io
