// SPDX-License-Identifier: GPL-3.0-or-later
// One volume in every format: the samples in their own type, and where they stand.
#include <catch2/catch.hpp>

#include "io/read/volume_reader.hpp"
#include "io/write/volume_writer.hpp"
#include "tests/io/volume_bytes.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace crest::tests;
using crest::io::read_volume_bytes;
using crest::kernel::dot;
using crest::kernel::SampledGrid;
using crest::kernel::SampleType;
using crest::kernel::Vec3;

namespace {

void check_values(const SampledGrid& grid, double slope = 1, double intercept = 0) {
  REQUIRE(grid.size == std::array<std::size_t, 3>{4, 5, 6});
  REQUIRE(std::visit([](const auto& x) { return x.size(); }, grid.samples) == 120);
  std::size_t i = 0, wrong = 0;
  for (std::size_t z = 0; z < 6; ++z)
    for (std::size_t y = 0; y < 5; ++y)
      for (std::size_t x = 0; x < 4; ++x)
        wrong += grid.at(i++) != slope * volume_value(x, y, z) + intercept ? 1 : 0;
  CHECK(wrong == 0);
}

SampledGrid read(const std::string& name, const std::string& bytes) {
  return read_volume_bytes(name, bytes).grid;
}

bool near(const Vec3& a, const Vec3& b, double error) {
  for (std::size_t k = 0; k < 3; ++k)
    if (!(std::fabs(a[k] - b[k]) <= error)) return false;
  return true;
}

}  // namespace

TEST_CASE("NRRD: types, byte orders, encodings, spacings and directions", "[io]") {
  const auto i16 = volume_samples<std::int16_t>();
  const SampledGrid raw =
      read("v.nrrd", nrrd("short", "endian: little\nencoding: raw\nspacings: 2 3 4", i16));
  check_values(raw);
  CHECK(raw.type() == SampleType::i16);
  CHECK(raw.spacing == Vec3{2, 3, 4});
  check_values(read(
      "v.nrrd", nrrd("int16_t", "endian: big\nencoding: raw", volume_samples<std::int16_t>(true))));
  check_values(read("v.nrrd", nrrd("double", "endian: little\nencoding: gzip",
                                   deflated(volume_samples<double>(), 31))));
  check_values(read("v.nrrd", nrrd("int", "encoding: ascii", volume_words())));
  const SampledGrid turned =
      read("v.nrrd", nrrd("float",
                          "endian: little\nencoding: raw\nspace: left-posterior-superior\n"
                          "space directions: (0,2,0) (-3,0,0) (0,0,4)\nspace origin: (1,2,3)",
                          volume_samples<float>()));
  check_values(turned);
  CHECK(turned.type() == SampleType::f32);
  CHECK(turned.spacing == Vec3{2, 3, 4});
  CHECK(turned.to_world({2, 3, 4}) == Vec3{-2, 4, 7});
}

TEST_CASE("MetaImage: local and apart, compressed, turned", "[io]") {
  const auto i16 = volume_samples<std::int16_t>();
  const SampledGrid local =
      read("v.mha", meta_image("MET_SHORT", "ElementSpacing = 2 3 4\nOffset = 1 2 3\n", i16));
  check_values(local);
  CHECK(local.spacing == Vec3{2, 3, 4});
  CHECK(local.origin == Vec3{1, 2, 3});
  check_values(read("v.mha", meta_image("MET_FLOAT", "BinaryDataByteOrderMSB = True\n",
                                        volume_samples<float>(true))));
  check_values(read("v.mha", meta_image("MET_INT", "CompressedData = True\n",
                                        deflated(volume_samples<std::int32_t>(), 15))));
  const SampledGrid turned = read(
      "v.mha", meta_image("MET_SHORT",
                          "TransformMatrix = 0 1 0 -1 0 0 0 0 1\nElementSpacing = 2 3 4\n", i16));
  CHECK(turned.to_world({2, 3, 4}) == Vec3{-3, 2, 4});
  const TemporaryFolder folder;
  write_text(folder / "v.raw", i16);
  write_text(folder / "v.mhd",
             "NDims = 3\nDimSize = 4 5 6\nElementType = MET_SHORT\nElementDataFile = v.raw\n");
  check_values(crest::io::read_volume(folder / "v.mhd").grid);
}

TEST_CASE("NIfTI: slope and intercept, sform, qform, byte orders, gzip", "[io]") {
  const auto i16 = volume_samples<std::int16_t>();
  const SampledGrid plain = read("v.nii", Nifti{}.bytes(i16));
  check_values(plain);
  CHECK(plain.type() == SampleType::i16);
  CHECK(plain.spacing == Vec3{2, 3, 4});
  Nifti scaled;
  scaled.slope = 0.5;
  scaled.intercept = -2;
  const auto file = read_volume_bytes("v.nii.gz", deflated(scaled.bytes(i16), 31));
  check_values(file.grid, 0.5, -2);
  CHECK(file.grid.type() == SampleType::f64);
  REQUIRE(file.warnings.size() == 1);
  CHECK(file.warnings[0].find("times 0.5 plus -2") != std::string::npos);
  Nifti big;
  big.big_endian = true;
  check_values(read("v.nii", big.bytes(volume_samples<std::int16_t>(true))));
  Nifti rows;
  rows.sform = 1;
  const float matrix[12] = {0, -3, 0, 1, 2, 0, 0, 2, 0, 0, 4, 3};
  std::copy(matrix, matrix + 12, rows.rows);
  const SampledGrid turned = read("v.nii", rows.bytes(i16));
  CHECK(turned.spacing == Vec3{2, 3, 4});
  CHECK(turned.to_world({2, 3, 4}) == Vec3{-2, 4, 7});
  Nifti quaternion;  // a quarter turn about z
  quaternion.qform = 1;
  quaternion.quaternion[2] = static_cast<float>(std::sqrt(0.5));
  CHECK(near(read("v.nii", quaternion.bytes(i16)).to_world({2, 3, 4}), {-3, 2, 4}, 1e-6));
}

TEST_CASE("MRC: axes in any order, cells off right angles, byte orders", "[io]") {
  const auto i16 = volume_samples<std::int16_t>();
  const SampledGrid plain = read("v.mrc", Mrc{}.bytes(i16));
  check_values(plain);
  CHECK(plain.spacing == Vec3{2, 3, 4});
  Mrc big;
  big.big_endian = true;
  check_values(read("v.map", big.bytes(volume_samples<std::int16_t>(true))));
  // Columns along z, rows along x, sections along y.
  Mrc turned;
  turned.axes[0] = 3;
  turned.axes[1] = 1;
  turned.axes[2] = 2;
  turned.start[0] = 10;
  const SampledGrid grid = read("v.map", turned.bytes(i16));
  check_values(grid);
  CHECK(near(grid.spacing, {4, 2, 3}, 1e-12));
  CHECK(near(grid.origin, {0, 0, 40}, 1e-12));
  CHECK(near(grid.direction_to_world({4, 2, 3}), {2, 3, 4}, 1e-12));
  Mrc skew;
  skew.angles[1] = 94.3f;
  const auto file = read_volume_bytes("v.ccp4", skew.bytes(i16));
  REQUIRE(file.warnings.size() == 1);
  CHECK(file.warnings[0].find("angle of 94.3 degrees") != std::string::npos);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(dot(file.grid.directions[i], file.grid.directions[k]) == Approx(i == k).margin(1e-14));
}

TEST_CASE("Gaussian cubes: the last axis the fastest, atoms, one orbital", "[io]") {
  for (const SampledGrid& grid :
       {read("v.cube", cube("0", "", "")), read("v.cube", cube("1", "8 8.0 1 2 3\n", "")),
        read("v.cube", cube("-1", "8 8.0 1 2 3\n1 7\n", ""))}) {
    REQUIRE(grid.size == std::array<std::size_t, 3>{6, 5, 4});
    CHECK(grid.spacing == Vec3{4, 3, 2});
    CHECK(grid.to_world({20, 6, 2}) == Vec3{3, 8, 23});
    std::size_t i = 0, wrong = 0;
    for (std::size_t x = 0; x < 4; ++x)
      for (std::size_t y = 0; y < 5; ++y)
        for (std::size_t z = 0; z < 6; ++z) wrong += grid.at(i++) != volume_value(x, y, z) ? 1 : 0;
    CHECK(wrong == 0);
  }
}

TEST_CASE("INRIMAGE: types, byte orders, spacings, longer headers", "[io]") {
  const SampledGrid plain = read("v.inr", inrimage("", volume_samples<std::int16_t>()));
  check_values(plain);
  CHECK(plain.type() == SampleType::i16);
  CHECK(plain.spacing == Vec3{2, 3, 4});
  check_values(read("v.inr", inrimage("CPU=sun\n", volume_samples<std::int16_t>(true))));
  const std::string f64 = inrimage("TYPE=float\nPIXSIZE=64 bits\nTX=7\n", volume_samples<double>());
  check_values(read("v.inr.gz", deflated(f64, 31)));
  CHECK(read("v.inr", f64).origin == Vec3{7, 0, 0});
  std::string longer = inrimage("", volume_samples<std::int16_t>());
  longer.insert(14, std::string(256, '\n'));
  check_values(read("v.inr", longer));
}

TEST_CASE("VTI and legacy VTK: spacings, origins, one of several arrays", "[io]") {
  for (const SampledGrid& grid :
       {read("v.vti", vti("Int16", volume_words())),
        read("v.vtk", structured_points("ASCII", "SCALARS a short 1\nLOOKUP_TABLE default\n",
                                        volume_words())),
        read("v.vtk", structured_points("BINARY", "SCALARS a short\nLOOKUP_TABLE default\n",
                                        volume_samples<std::int16_t>(true)))}) {
    check_values(grid);
    CHECK(grid.type() == SampleType::i16);
    CHECK(grid.spacing == Vec3{2, 3, 4});
    CHECK(grid.origin == Vec3{1, 2, 3});
  }
  std::string zeros;
  for (int i = 0; i < 120; ++i) zeros += "0 ";
  const std::string two =
      vti("Float64", volume_words(),
          "<DataArray type=\"Int8\" Name=\"b\" format=\"ascii\">" + zeros + "</DataArray>");
  CHECK_THROWS_WITH(read("v.vti", two),
                    Catch::Contains("'b' (1), 'a' (1)") && Catch::Contains("--field"));
  check_values(read_volume_bytes("v.vti", two, {.field = "a", .raw = {}}).grid);
}

TEST_CASE("raw samples, whatever the file's name", "[io]") {
  const auto file =
      read_volume_bytes("v.bin", volume_samples<float>(), {.field = {}, .raw = "4,5,6,float"});
  check_values(file.grid);
  for (const std::string shape :
       {"4,5,float", "4,5,6,half", "4,5,6,float,1", "0,5,6,float", "4 x 5"})
    CHECK_THROWS_WITH(read_volume_bytes("v.bin", "abcd", {.field = {}, .raw = shape}),
                      Catch::Contains("is no NX,NY,NZ,TYPE"));
  CHECK_THROWS_WITH(
      read_volume_bytes("v.bin", volume_samples<float>(), {.field = {}, .raw = "4,5,7,float"}),
      Catch::Contains("there are 480 bytes, the header announces 560"));
}

TEST_CASE("images: rows from the topmost, 16 bits, text, colours, one slice", "[io]") {
  std::string bytes8, bytes16, text, colours;
  for (int i = 0; i < 20; ++i) {
    put(bytes8, static_cast<std::uint8_t>(i));
    put(bytes16, static_cast<std::uint16_t>(1000 * i), true);
    text += std::to_string(1000 * i) + "\n";
    for (const int c : {0, 100, 200}) put(colours, static_cast<std::uint8_t>(i + c));
  }
  const SampledGrid eight = read("i.pgm", "P5 # so\n4 5\n255\n" + bytes8);
  const SampledGrid sixteen = read("i.pgm", "P5\n4 5\n65535\n" + bytes16);
  const SampledGrid words = read("i.pgm", "P2\n4 5\n65535\n" + text);
  const auto rgb = read_volume_bytes("i.ppm", "P6\n4 5\n255\n" + colours);
  const SampledGrid slice = read("s.nrrd", nrrd("uint8", "encoding: raw", bytes8, "4 5 1"));
  CHECK(eight.type() == SampleType::u8);
  CHECK(sixteen.type() == SampleType::u16);
  CHECK(words.type() == SampleType::u16);
  REQUIRE(rgb.warnings.size() == 1);
  CHECK(rgb.warnings[0].find("luminance") != std::string::npos);
  for (const auto* image : {&eight, &sixteen, &words, &rgb.grid, &slice}) {
    CHECK(image->dimension() == 2);
    CHECK(image->size == std::array<std::size_t, 3>{4, 5, 1});
  }
  for (std::size_t i = 0; i < 20; ++i) {
    const auto x = static_cast<double>(i);
    CHECK(eight.at(i) == x);
    CHECK(sixteen.at(i) == 1000 * x);
    CHECK(words.at(i) == 1000 * x);
    CHECK(slice.at(i) == x);
    CHECK(rgb.grid.at(i) == Approx(0.7152 * 100 + 0.0722 * 200 + x));
  }
  // As VTK has images: y points up, the last row at 0.
  CHECK(eight.to_world({0, 0, 0}) == Vec3{0, 4, 0});
  CHECK(eight.to_world({3, 4, 0}) == Vec3{3, 0, 0});
}

namespace {

std::string png_chunk(const std::string& type, const std::string& data) {
  std::string bytes;
  put(bytes, static_cast<std::uint32_t>(data.size()), true);
  bytes += type + data;
  put(bytes,
      static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>((type + data).data()),
                                       static_cast<uInt>(data.size() + 4))),
      true);
  return bytes;
}

/// 4 x 5 pixels; `rows`: of `step` bytes a pixel, each filtered in another way.
std::string png(int depth, int type, const std::string& rows, std::size_t step,
                const std::string& palette = "") {
  std::string header, filtered;
  for (const std::uint32_t x : {4u, 5u}) put(header, x, true);
  for (const int x : {depth, type, 0, 0, 0}) header += static_cast<char>(x);
  const std::size_t row = rows.size() / 5;
  for (std::size_t y = 0; y < 5; ++y) {
    filtered += static_cast<char>(y);  // none, left, up, mean, Paeth
    for (std::size_t x = 0; x < row; ++x) {
      const auto at = [&](std::size_t dx, std::size_t dy) {
        return x < dx || y < dy ? 0 : static_cast<unsigned char>(rows[(y - dy) * row + x - dx]);
      };
      const int left = at(step, 0), up = at(0, 1), corner = at(step, 1);
      const int p = left + up - corner, a = std::abs(p - left), b = std::abs(p - up),
                c = std::abs(p - corner);
      const int guess[] = {0, left, up, (left + up) / 2,
                           a <= b && a <= c ? left
                           : b <= c         ? up
                                            : corner};
      filtered += static_cast<char>(at(0, 0) - guess[y]);
    }
  }
  return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", header) +
         (palette.empty() ? "" : png_chunk("PLTE", palette)) +
         png_chunk("IDAT", deflated(filtered, 15)) + png_chunk("IEND", "");
}

}  // namespace

TEST_CASE("PNG: every filter, 1 to 16 bits, palettes, opacity", "[io]") {
  std::string grey, wide, rgba, indices, bits, palette;
  for (int i = 0; i < 20; ++i) {
    put(grey, static_cast<std::uint8_t>(37 * i));
    put(wide, static_cast<std::uint16_t>(3301 * i), true);
    for (const int c : {7 * i, 7 * i, 7 * i, 255 - i}) put(rgba, static_cast<std::uint8_t>(c));
    put(indices, static_cast<std::uint8_t>(19 - i));
    for (int c = 0; c < 3; ++c) put(palette, static_cast<std::uint8_t>(11 * i));
  }
  for (int y = 0; y < 5; ++y) bits += static_cast<char>(0xa0 >> (y % 2));  // 1010 and 0101
  const SampledGrid a = read("i.png", png(8, 0, grey, 1)), b = read("i.png", png(16, 0, wide, 2)),
                    d = read("i.png", png(8, 3, indices, 1, palette)),
                    e = read("i.png", png(1, 0, bits, 1));
  const auto c = read_volume_bytes("i.png", png(8, 6, rgba, 4));
  CHECK(c.warnings == std::vector<std::string>{"the image's opacity is passed over"});
  CHECK(b.type() == SampleType::u16);
  for (std::size_t i = 0; i < 20; ++i) {
    CHECK(a.at(i) == static_cast<double>(37 * i % 256));
    CHECK(b.at(i) == static_cast<double>(3301 * i % 65536));
    CHECK(c.grid.at(i) == static_cast<double>(7 * i));
    CHECK(d.at(i) == static_cast<double>(11 * (19 - i)));
    CHECK(e.at(i) == static_cast<double>((i % 4 + i / 4 + 1) % 2));
  }
}

TEST_CASE("what is written as a volume or as points is read again", "[io]") {
  const TemporaryFolder folder;
  SampledGrid grid = read("v.nrrd", nrrd("float",
                                         "endian: little\nencoding: raw\nspace directions: "
                                         "(0,2,0) (-3,0,0) (0,0,4)\nspace origin: (1,2,3)",
                                         volume_samples<float>()));
  for (const std::string name : {"v.nrrd", "v.vti"}) {
    INFO(name);
    crest::io::write_volume(folder / name, grid);
    const auto again = crest::io::read_volume(folder / name);
    check_values(again.grid);
    CHECK(again.grid.type() == SampleType::f32);
    CHECK(again.grid.spacing == grid.spacing);
    CHECK(again.grid.origin == grid.origin);
    CHECK(again.grid.directions == grid.directions);
    CHECK(again.warnings.empty());
  }
}
