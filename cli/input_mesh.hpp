// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// `crest-verify --input`: the mesh of a file, its tensors or vectors, from the program `crest`.
#include <stdexcept>
#include <string>
#include <vector>

#include "certify/certificate.hpp"
#include "certify/container/verdict.hpp"

namespace crest::cli {

/// The file cannot be read as a mesh: `crest` has said why, or is not there (then what() says so).
class InputUnreadable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Runs `crest clean FILE ARGUMENTS`, from the folder of this program, else from those of PATH.
/// Nothing that reads mesh files is part of the checker: it compares its certificate with what
/// `crest` takes for the mesh. Throws: InputUnreadable, std::runtime_error for a temporary folder
/// that cannot be made.
certify::InputMesh input_mesh(const std::string& file, const std::vector<std::string>& arguments);

/// The digest of the data section that `crest modes` makes of a file of tensors (claims modes and
/// modes-curves, which have the same). Throws as input_mesh.
certify::Digest input_tensors(const std::string& file, const std::vector<std::string>& arguments);

/// The same of `crest skeleton` and a file of vectors (claims skeleton and compression).
certify::Digest input_vectors(const std::string& file, const std::vector<std::string>& arguments);

}  // namespace crest::cli
