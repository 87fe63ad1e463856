// SPDX-License-Identifier: GPL-3.0-or-later
// Gaussian cube files: text, the last axis the fastest, in the unit that the file is in.
#include <fmt/format.h>

#include "io/formats/text_scan.hpp"
#include "io/formats/volume.hpp"

namespace crest::io {
namespace {

/// The next number of the header, which a line has in its place.
template <class Number>
Number take_number(TextScan& scan, const char* what) {
  Number x{};
  const bool given = scan.in_line();
  const std::string word = io::quoted(scan.peek());
  if (!given || !scan.take(x))
    fail(fmt::format("header (line {})", scan.line()),
         given ? fmt::format("{} is not {}", word, what) : fmt::format("lacks {}", what),
         "export the cube file again");
  return x;
}

kernel::Vec3 take_vector(TextScan& scan) {
  kernel::Vec3 v;
  for (double& x : v) x = take_number<double>(scan, "a coordinate");
  return v;
}

/// Behind the atoms of a file of orbitals: how many, and which.
void take_orbitals(TextScan& scan) {
  if (!scan.more()) fail("header", "the file ends in it", "export the cube file again");
  const auto count = take_number<std::int64_t>(scan, "a number of orbitals");
  if (count != 1)
    fail("samples", fmt::format("there are {} orbitals", count), "export one orbital a file");
  take_number<std::int64_t>(scan, "an orbital");
  scan.next_line();
}

std::vector<double> take_samples(TextScan& scan, std::size_t count) {
  if (count > (scan.room() + 1) / 2)
    fail("samples", fmt::format("the header announces {}, the file ends before", count),
         "the file is truncated or its header wrong; export it again");
  std::vector<double> samples(count);
  for (double& x : samples) {
    if (!scan.more()) fail("samples", "the file ends in them", "export the cube file again");
    if (!scan.take(x))
      fail(fmt::format("samples (line {})", scan.line()),
           fmt::format("{} is not a number", io::quoted(scan.peek())), "correct it");
  }
  if (scan.more())
    fail(fmt::format("samples (line {})", scan.line()), "there are more than the header announces",
         "export the cube file again");
  return samples;
}

}  // namespace

Volume read_cube(std::string_view bytes, const VolumeRequest&) {
  TextScan scan(check_text(bytes));
  for (int comment = 0; comment < 2; ++comment)
    if (!scan.next_line()) fail("header", "the file ends in it", "export the cube file again");
  const auto atoms = take_number<std::int64_t>(scan, "a number of atoms");
  Volume volume;
  volume.origin = take_vector(scan);
  if (scan.in_line() && take_number<std::int64_t>(scan, "a number of values") != 1)
    fail("samples", "there are several a voxel", "export one a file");
  for (int axis = 0; axis < 3; ++axis) {
    scan.next_line();
    // Negative: lengths are in another unit, which is taken as it is.
    const auto size = take_number<std::int64_t>(scan, "a number of voxels");
    if (size == 0) fail("header", "an axis has no voxels", "export the cube file again");
    volume.size.insert(volume.size.begin(), static_cast<std::size_t>(size < 0 ? -size : size));
    volume.steps.insert(volume.steps.begin(), take_vector(scan));
  }
  scan.next_line();
  for (std::int64_t atom = 0; atom < (atoms < 0 ? -atoms : atoms); ++atom)
    if (!scan.next_line()) fail("header", "the file ends in its atoms", "export the file again");
  if (atoms < 0) take_orbitals(scan);
  volume.samples = take_samples(scan, product(volume.size));
  return volume;
}

}  // namespace crest::io
