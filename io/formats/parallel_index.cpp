// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/parallel_index.hpp"

#include <fmt/format.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <set>

#include "io/formats/files.hpp"
#include "io/formats/vtk_quiet.hpp"

namespace crest::io {
namespace {

constexpr const char* kWriteAgain = "write the files again";

Extent extent_of(vtkXMLDataElement& element, const char* attribute, const std::string& name) {
  Extent extent{};
  if (element.GetVectorAttribute(attribute, 6, extent.data()) != 6)
    fail(name, fmt::format("has no {} of six integers", attribute), kWriteAgain);
  return extent;
}

}  // namespace

ParallelIndex parallel_index(std::string_view bytes, const char* type,
                             const std::string& extension) {
  const VtkQuiet quiet;
  const auto file = vtkSmartPointer<vtkXMLDataElement>::Take(
      vtkXMLUtilities::ReadElementFromString(std::string(bytes).c_str()));
  vtkXMLDataElement* root = file ? file->FindNestedElementWithName(type) : nullptr;
  if (!root || quiet.failed())
    fail("file", fmt::format("is not XML of VTK with {} in it", type), kWriteAgain);
  ParallelIndex index;
  const bool image = extension == ".vti";
  if (image) index.whole = extent_of(*root, "WholeExtent", "header");
  std::set<std::string> known;
  for (int i = 0; i < root->GetNumberOfNestedElements(); ++i) {
    vtkXMLDataElement& element = *root->GetNestedElement(i);
    if (std::string_view(element.GetName()) != "Piece") continue;
    const std::string name = fmt::format("piece {}", index.pieces.size());
    const char* source = element.GetAttribute("Source");
    if (!source || lower_extension(source) != extension)
      fail(name, fmt::format("names no {} file", extension), kWriteAgain);
    if (!known.insert(source).second)
      fail(name, fmt::format("names '{}' again", one_line(source)), kWriteAgain);
    ParallelIndex::Piece& piece = index.pieces.emplace_back();
    piece.source = source;
    if (image) piece.extent = extent_of(element, "Extent", name);
  }
  if (index.pieces.empty()) fail("file", "names no pieces", kWriteAgain);
  return index;
}

}  // namespace crest::io
