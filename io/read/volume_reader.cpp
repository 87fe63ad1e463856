// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read/volume_reader.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>

#include "io/read/volume_frame.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::io {
namespace {

using kernel::Vec3;
using kernel::operator*;
using kernel::operator-;
using kernel::cross;
using kernel::dot;
using Reader = Volume (*)(std::string_view, const VolumeRequest&);

/// Without ".gz".
std::string without_gz(const std::string& path) {
  return lower_extension(path) == ".gz" ? path.substr(0, path.size() - 3) : path;
}

Reader reader_of(const std::string& extension) {
  static const std::map<std::string, Reader> readers = {
      {".nrrd", read_nrrd},      {".nhdr", read_nrrd}, {".mha", read_meta_image},
      {".mhd", read_meta_image}, {".vti", read_vti},   {".vtk", read_structured_points},
      {".nii", read_nifti},      {".map", read_mrc},   {".mrc", read_mrc},
      {".ccp4", read_mrc},       {".cube", read_cube}, {".inr", read_inrimage},
      {".pvti", read_pvti},      {".png", read_png},   {".pgm", read_pnm},
      {".ppm", read_pnm},        {".pnm", read_pnm}};
  const auto found = readers.find(extension);
  return found == readers.end() ? nullptr : found->second;
}

[[noreturn]] void refuse(const std::string& extension) {
  static const std::map<std::string, const char*> remedies = {
      {".tif", "convert it to PNG or PGM (a stack: to NRRD)"},
      {".tiff", "convert it to PNG or PGM (a stack: to NRRD)"},
      {".jpg", "convert it to PNG"},
      {".jpeg", "convert it to PNG"},
      {".raw", "give --raw NX,NY,NZ,TYPE"},
      {".img", "convert both files to one .nii"},
      {".hdr", "convert both files to one .nii"},
      {".mif", "convert it to NIfTI (mrconvert)"},
      {".xz", "unpack it (xz -dk)"}};
  const auto found = remedies.find(extension);
  fail("file",
       extension.empty() ? "has no extension"
                         : "volumes of the extension '" + extension + "' are not read",
       found != remedies.end()
           ? found->second
           : "use .nrrd .mha .mhd .vti .pvti .vtk .nii .nii.gz .mrc .map .cube .inr "
             ".png or .pgm, or --raw NX,NY,NZ,TYPE");
}

/// Leaves out axes of one sample, those of space being two or three.
void take_axes(const Volume& volume, kernel::SampledGrid& grid) {
  std::size_t axes = 0;
  std::string all;
  for (std::size_t i = 0; i < volume.size.size(); ++i)
    all += fmt::format("{}{}", i == 0 ? "" : " x ", volume.size[i]);
  for (std::size_t i = 0; i < volume.size.size(); ++i) {
    if (volume.size[i] == 1) continue;
    if (axes == 3)
      fail("samples",
           fmt::format("{} are more than three axes: vectors, colours or several times", all),
           "give one number a node, a volume a file");
    grid.size[axes] = volume.size[i];
    const Vec3& step = volume.steps[i];
    grid.spacing[axes] = std::sqrt(dot(step, step));
    if (!(grid.spacing[axes] > 0 && std::isfinite(grid.spacing[axes])))
      fail(fmt::format("axis {}", i),
           grid.spacing[axes] == 0 ? "has no spacing: its samples are vectors, colours or the like"
                                   : "its spacing is not finite",
           "give one number a node; correct the header");
    grid.directions[axes] = (1 / grid.spacing[axes]) * step;
    ++axes;
  }
  for (std::size_t k = 0; k < 2; ++k)
    if (grid.size[k] < 4)
      fail("samples", fmt::format("{} are too few: an axis has fewer than 4", all),
           "give a larger volume or image");
  if (axes == 3 && grid.size[2] < 4)
    fail("samples", fmt::format("{} are too few: an axis has fewer than 4", all),
         "give a larger volume or one slice");
  grid.origin = volume.origin;
  for (const double x : grid.origin)
    if (!std::isfinite(x)) fail("origin", "is not finite", "correct the header");
}

/// Turns axes that are not at right angles by as little as makes them so.
void square(kernel::SampledGrid& grid, std::vector<std::string>& warnings) {
  auto& d = grid.directions;
  if (grid.dimension() == 2) d[2] = cross(d[0], d[1]);
  double skew = 0;
  for (const auto& [i, k] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
    const double c = dot(d[static_cast<std::size_t>(i)], d[static_cast<std::size_t>(k)]);
    if (std::fabs(c) > std::fabs(skew)) skew = c;
  }
  if (skew == 0) return;
  d[1] = d[1] - dot(d[0], d[1]) * d[0];
  const double length = std::sqrt(dot(d[1], d[1]));
  Vec3 normal = cross(d[0], d[1]);
  const double height = std::fabs(dot(normal, d[2]));
  constexpr double flat = 1e-6;  // of unit vectors: such axes are a mistake in the header
  if (!(length > flat && height > flat * length))
    fail("axes", "lie in a plane or a line", "correct the header");
  d[1] = (1 / length) * d[1];
  normal = cross(d[0], d[1]);
  d[2] = dot(normal, d[2]) < 0 ? Vec3(-1.0 * normal) : normal;
  constexpr double rounding = 1e-4;  // of headers in single precision: decides on the warning alone
  if (std::fabs(skew) > rounding)
    warnings.push_back(fmt::format(
        "the axes make an angle of {:.4g} degrees: they are taken as if at right angles",
        std::acos(std::fmin(1, std::fmax(-1, skew))) * 180 / std::numbers::pi));
}

}  // namespace

VolumeFile grid_of_volume(Volume volume) {
  VolumeFile file = frame_of(volume);
  file.grid.samples = std::move(volume.samples);
  kernel::GridBox whole;
  for (std::size_t k = 0; k < 3; ++k) whole.high[k] = static_cast<kernel::Index>(file.grid.size[k]);
  check_samples(file.grid.samples, file.grid.dimension(), whole);
  return file;
}

namespace {

VolumeFile from_bytes(const std::string& name, std::string_view bytes, const VolumeSource& source,
                      const VolumeRequest& request) {
  if (bytes.empty()) fail("file", "is empty", "export it again");
  if (!source.raw.empty()) return grid_of_volume(read_raw(bytes, source.raw));
  const std::string plain = without_gz(name);
  const Reader reader = reader_of(lower_extension(plain));
  if (!reader) refuse(lower_extension(plain));
  std::string unpacked;
  constexpr std::string_view gzip = "\x1f\x8b";
  if (bytes.starts_with(gzip) && (plain.size() < name.size() || reader == read_nifti)) {
    unpacked = inflated(bytes);
    bytes = unpacked;
  }
  if (bytes.starts_with(gzip)) fail("file", "is compressed by gzip", "name it .gz");
  return grid_of_volume(reader(bytes, request));
}

}  // namespace

VolumeFile frame_of(const Volume& volume) {
  VolumeFile file;
  file.warnings = volume.warnings;
  take_axes(volume, file.grid);
  square(file.grid, file.warnings);
  return file;
}

void check_samples(const Samples& all, int dimension, const kernel::GridBox& box) {
  const std::size_t nx = box.size()[0], ny = box.size()[1];
  const auto name = [&](std::size_t i) {
    const std::size_t x = box.low[0] + i % nx, y = box.low[1] + i / nx % ny,
                      z = box.low[2] + i / (nx * ny);
    return dimension == 2 ? fmt::format("pixel {},{}", x, y)
                          : fmt::format("voxel {},{},{}", x, y, z);
  };
  std::visit(
      [&](const auto& samples) {
        using Native = typename std::decay_t<decltype(samples)>::value_type;
        for (std::size_t i = 0; i < samples.size(); ++i) {
          if constexpr (std::is_floating_point_v<Native>) {
            if (!std::isfinite(samples[i]))
              fail(name(i), std::isnan(samples[i]) ? "is not a number" : "is infinite",
                   "replace such samples");
          } else if constexpr (sizeof(Native) == 8) {
            constexpr std::int64_t largest = std::int64_t{1} << 53;
            if (!(std::cmp_less_equal(samples[i], largest) &&
                  std::cmp_greater_equal(samples[i], -largest)))
              fail(name(i), "is an integer that a double does not hold",
                   "save the samples as double");
          }
        }
      },
      all);
}

bool is_volume_name(const std::string& path) {
  return reader_of(lower_extension(without_gz(path))) != nullptr;
}

std::function<FileBytes(const std::string&)> companions_of(const std::string& path) {
  return [path](const std::string& name) {
    const auto place = std::filesystem::path(path).parent_path() / name;
    try {
      return load(place.string());
    } catch (const kernel::InputError& error) {
      fail("samples", fmt::format("the file '{}' that the header names: {}", name, error.what()),
           "put it beside the header");
    }
  };
}

VolumeFile read_volume(const std::string& path, const VolumeSource& source) {
  VolumeFile file;
  read_named(path, [&] {
    const VolumeRequest request{.field = source.field, .companion = companions_of(path)};
    if (source.raw.empty() && !is_volume_name(path)) refuse(lower_extension(path));
    file = from_bytes(path, load(path), source, request);
  });
  return file;
}

VolumeFile read_volume_bytes(const std::string& name, std::string_view bytes,
                             const VolumeSource& source) {
  VolumeFile file;
  read_named(name, [&] { file = from_bytes(name, bytes, source, {.field = source.field}); });
  return file;
}

}  // namespace crest::io
