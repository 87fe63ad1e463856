// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/image_pieces.hpp"

#include <fmt/format.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>

#include <algorithm>

#include "io/formats/vtk_input.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {
namespace {

using kernel::GridBox;
using kernel::Index;

constexpr const char* kExportPieces = "export the volume again";

/// Of a piece or of the whole, in the numbers of the whole.
GridBox box_of(const Extent& extent, const Extent& whole) {
  GridBox box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] = static_cast<Index>(extent[2 * k] - whole[2 * k]);
    box.high[k] = static_cast<Index>(extent[2 * k + 1] - whole[2 * k]) + 1;
  }
  return box;
}

/// Not empty, within the whole, and with sizes that an int holds.
bool sound(const Extent& extent, const Extent& whole) {
  constexpr int most = 1 << 30;
  for (std::size_t k = 0; k < 6; k += 2) {
    if (extent[k] > extent[k + 1] || extent[k] < -most || extent[k + 1] > most) return false;
    if (extent[k] < whole[k] || extent[k + 1] > whole[k + 1]) return false;
  }
  return true;
}

GridBox common(const GridBox& a, const GridBox& b) {
  GridBox r;
  for (std::size_t k = 0; k < 3; ++k) {
    r.low[k] = std::max(a.low[k], b.low[k]);
    r.high[k] = std::max(std::min(a.high[k], b.high[k]), r.low[k]);
  }
  return r;
}

/// Calls `use` with the place in `from` and in `to` of each row of `part`, which lies in both.
template <class Use>
void for_each_row(const GridBox& part, const GridBox& from, const GridBox& to, const Use& use) {
  const auto place = [&](const GridBox& box, Index y, Index z) {
    const auto size = box.size();
    return (std::size_t{z - box.low[2]} * size[1] + (y - box.low[1])) * size[0] + part.low[0] -
           box.low[0];
  };
  for (Index z = part.low[2]; z < part.high[2]; ++z)
    for (Index y = part.low[1]; y < part.high[1]; ++y) use(place(from, y, z), place(to, y, z));
}

Samples empty_like(const Samples& samples) {
  return std::visit([](const auto& x) -> Samples { return std::decay_t<decltype(x)>(); }, samples);
}

/// Origin, spacing and directions.
std::array<double, 15> placement_of(vtkImageData& image) {
  std::array<double, 15> r;
  std::copy_n(image.GetOrigin(), 3, r.begin());
  std::copy_n(image.GetSpacing(), 3, r.begin() + 3);
  std::copy_n(image.GetDirectionMatrix()->GetData(), 9, r.begin() + 6);
  return r;
}

/// Of the samples of box `from` those in `part`, in its order.
Samples cut(const Samples& samples, const GridBox& from, const GridBox& part) {
  return std::visit(
      [&](const auto& x) -> Samples {
        std::decay_t<decltype(x)> r(part.nodes());
        for_each_row(part, from, part, [&](std::size_t at, std::size_t to) {
          std::copy_n(x.data() + at, part.size()[0], r.data() + to);
        });
        return r;
      },
      samples);
}

}  // namespace

ImagePieces::ImagePieces(std::string_view index, VolumeRequest request)
    : index_(parallel_index(index, "PImageData", ".vti")), request_(std::move(request)) {
  const Extent& whole = index_.whole;
  if (!sound(whole, whole)) fail("header", "WholeExtent is empty or too large", kExportPieces);
  for (std::size_t k = 0; k < index_.pieces.size(); ++k)
    if (!sound(index_.pieces[k].extent, whole))
      fail(fmt::format("piece {}", k), "its Extent is empty or not within the whole",
           kExportPieces);
  of_piece(0, [&](vtkImageData& image) {
    placement_ = placement_of(image);
    frame_ = volume_of(image, request_.field);
    const auto size = box_of(whole, whole).size();
    frame_.size.assign(size.begin(), size.end());
    image.TransformIndexToPhysicalPoint(whole[0], whole[2], whole[4], frame_.origin.data());
    frame_.samples = empty_like(frame_.samples);
  });
}

void ImagePieces::of_piece(std::size_t k, const std::function<void(vtkImageData&)>& use) const {
  const ParallelIndex::Piece& piece = index_.pieces[k];
  try {
    if (!request_.companion) fail("file", "is another file", "give the path, not the bytes");
    const auto image = read_image_data(request_.companion(piece.source), kExportPieces);
    if (!std::equal(piece.extent.begin(), piece.extent.end(), image->GetExtent()))
      fail("extent", "is not that of the piece", kExportPieces);
    use(*image);
  } catch (const kernel::InputError& error) {
    throw kernel::InputError(
        fmt::format("piece {} ('{}'): {}", k, one_line(piece.source), error.what()));
  }
}

Samples ImagePieces::read(const GridBox& box) const {
  // Memory for the box is asked for once the pieces' files have shown that they hold so much.
  std::vector<std::pair<GridBox, Samples>> parts;
  std::uint64_t nodes = 0;
  for (std::size_t k = 0; k < index_.pieces.size(); ++k) {
    const GridBox owned = box_of(index_.pieces[k].extent, index_.whole);
    const GridBox part = common(owned, box);
    if (part.nodes() == 0) continue;
    of_piece(k, [&](vtkImageData& image) {
      if (placement_of(image) != placement_)
        fail("header", "has another origin, spacing or direction than piece 0", kExportPieces);
      const Volume volume = volume_of(image, request_.field);
      if (volume.samples.index() != frame_.samples.index())
        fail("samples", "have another type than those of piece 0", kExportPieces);
      parts.emplace_back(part, cut(volume.samples, owned, part));
    });
    nodes += part.nodes();
  }
  const auto missing = [] {
    fail("pieces", "do not cover the whole extent", "export the volume again, with all pieces");
  };
  if (nodes < box.nodes()) missing();
  Samples result = frame_.samples;
  std::vector<bool> covered(box.nodes());
  std::visit(
      [&](auto& to) {
        to.resize(box.nodes());
        for (auto& [part, samples] : parts) {
          const auto& from = std::get<std::decay_t<decltype(to)>>(samples);
          for_each_row(part, part, box, [&](std::size_t at, std::size_t place) {
            const std::size_t width = part.size()[0];
            std::copy_n(from.data() + at, width, to.data() + place);
            std::fill_n(covered.begin() + static_cast<std::ptrdiff_t>(place), width, true);
          });
          samples = empty_like(samples);
        }
      },
      result);
  if (std::find(covered.begin(), covered.end(), false) != covered.end()) missing();
  return result;
}

Volume read_pvti(std::string_view bytes, const VolumeRequest& request) {
  const ImagePieces pieces(bytes, request);
  Volume volume = pieces.frame();
  GridBox whole;
  for (std::size_t k = 0; k < 3; ++k) whole.high[k] = static_cast<Index>(volume.size[k]);
  volume.samples = pieces.read(whole);
  return volume;
}

}  // namespace crest::io
