// SPDX-License-Identifier: GPL-3.0-or-later
// PNG by VTK, of 8 or 16 bits; VTK puts the last row first.
#include <fmt/format.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPointData.h>

#include "io/formats/volume.hpp"
#include "io/formats/vtk_quiet.hpp"

namespace crest::io {
namespace {

/// zlib expands a byte to at most 1032; VTK allocates what the header announces.
void check_header(std::string_view bytes) {
  constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";
  constexpr std::size_t header = 33, expansion = 1032;
  if (!bytes.starts_with(signature) || bytes.size() < header || bytes.substr(12, 4) != "IHDR")
    fail("header", "is none of PNG", "save the image as PNG");
  const std::size_t width = load_number<std::uint32_t>(bytes.data() + 16, true);
  const std::size_t height = load_number<std::uint32_t>(bytes.data() + 20, true);
  // A sample has a bit at least, a pixel of VTK's up to four of 16.
  if (width == 0 || height == 0 || width > (std::size_t{1} << 30) ||
      height > (std::size_t{1} << 30) || width * height / 8 > expansion * bytes.size())
    fail("header",
         fmt::format("announces {} by {} pixels, more than the file holds", width, height),
         "the file is truncated or its header wrong; export it again");
}

/// Rows from the topmost on, colours without the opacity.
template <class Native>
Samples rows_of(const Native* from, std::size_t width, std::size_t height, std::size_t components,
                std::size_t colours) {
  std::vector<Native> samples;
  samples.reserve(width * height * colours);
  for (std::size_t y = height; y-- > 0;)
    for (std::size_t x = 0; x < width; ++x)
      for (std::size_t c = 0; c < colours; ++c)
        samples.push_back(from[(y * width + x) * components + c]);
  return samples;
}

}  // namespace

Volume read_png(std::string_view bytes, const VolumeRequest&) {
  check_header(bytes);
  const VtkQuiet quiet;
  vtkNew<vtkPNGReader> reader;
  reader->SetMemoryBuffer(bytes.data());
  reader->SetMemoryBufferLength(static_cast<vtkIdType>(bytes.size()));
  reader->Update();
  vtkImageData* data = reader->GetOutput();
  vtkDataArray* array = data ? data->GetPointData()->GetScalars() : nullptr;
  if (quiet.failed() || reader->GetErrorCode() != 0 || !array)
    fail("file", "cannot be read as PNG (truncated or damaged)", "export the image again");
  int extent[6];
  data->GetExtent(extent);
  const auto width = static_cast<std::size_t>(extent[1] - extent[0] + 1);
  const auto height = static_cast<std::size_t>(extent[3] - extent[2] + 1);
  const auto components = static_cast<std::size_t>(array->GetNumberOfComponents());
  if (array->GetNumberOfTuples() != static_cast<vtkIdType>(width * height))
    fail("file", "cannot be read as PNG (truncated or damaged)", "export the image again");
  const std::size_t colours = components < 3 ? 1 : 3;
  Volume image;
  if (array->GetDataType() == VTK_UNSIGNED_CHAR)
    set_image(image, width, height, colours,
              rows_of(static_cast<const std::uint8_t*>(array->GetVoidPointer(0)), width, height,
                      components, colours));
  else if (array->GetDataType() == VTK_UNSIGNED_SHORT)
    set_image(image, width, height, colours,
              rows_of(static_cast<const std::uint16_t*>(array->GetVoidPointer(0)), width, height,
                      components, colours));
  else
    fail("file", "has samples of an unknown type", "export the image again");
  if (components == 2 || components == 4)
    image.warnings.emplace_back("the image's opacity is passed over");
  return image;
}

}  // namespace crest::io
