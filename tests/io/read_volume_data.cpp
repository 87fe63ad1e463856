// SPDX-License-Identifier: GPL-3.0-or-later
// Every volume and point set of the data set, with the sizes and ranges of its table, or one line.
#include <catch2/catch.hpp>
#include <filesystem>

#include "io/read/point_reader.hpp"
#include "io/read/volume_reader.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/support/shared_data.hpp"

namespace {

struct Expected {
  const char* file;
  std::array<std::size_t, 3> size;
  double low, high;   ///< to 1e-3
  const char* words;  ///< in a warning, or in the error if the size is 0
};

const Expected kExpected[] = {
    {"EMD-3001.map", {73, 43, 25}, -0.3681, 0.7216, "angle of 94.33 degrees"},
    {"FLAIR.nrrd", {124, 160, 140}, 0, 255, ""},
    {"HeadMRVolume.mhd", {48, 62, 42}, 0, 255, ""},
    {"HeadMRVolume.raw", {0, 0, 0}, 0, 0, "give --raw NX,NY,NZ,TYPE"},
    {"aquarius-A2.nrrd.xz", {120, 120, 120}, 0, 255, ""},
    {"avf_float_32.nrrd", {74, 93, 20}, 0, 2509.89, ""},
    {"bolt.nrrd", {70, 123, 66}, 0, 255, ""},
    {"bucky_32.nrrd", {32, 32, 32}, 0, 255, ""},
    {"chris_PD.nii.gz", {191, 256, 54}, 0, 252, ""},
    {"eun_brain.nii.gz", {256, 190, 151}, 0, 180, ""},
    {"headsq_quarter.nrrd.xz", {64, 64, 93}, 0, 3926, ""},
    {"hydrogen_64.nrrd.xz", {64, 64, 64}, 0, 1, ""},
    {"hydrogen_64.vti", {64, 64, 64}, 0, 1, ""},
    {"iguana_ct.nii.gz", {210, 256, 179}, 0, 229, ""},
    {"ironProt.vtk", {68, 68, 68}, 0, 255, ""},
    {"isabel_windspeed_30.nrrd.xz", {125, 125, 25}, 0, 78.6594, ""},
    {"m4_TotalDensity.cube", {31, 22, 25}, 0, 0.4928, ""},
    {"male_head.nrrd.xz", {256, 256, 128}, 1, 254, ""},
    {"mri_head_256.nrrd.xz", {256, 256, 256}, 0, 242, ""},
    {"neghip.nrrd", {66, 66, 66}, 0, 255, ""},
    {"nut.nrrd", {68, 41, 59}, 0, 255, ""},
    {"skull_2.9.inr", {64, 64, 64}, 0.0, 5.429, ""},
    {"stent_ct.nrrd.xz", {128, 128, 256}, 0, 2000, ""},
};

/// The file itself, or its unpacked copy in the build directory.
std::string unpacked(const std::string& path) {
  if (!path.ends_with(".xz")) return path;
  const auto folder = std::filesystem::path(CREST_BINARY_DIR) / "unpacked";
  std::filesystem::create_directories(folder);
  const std::string copy = (folder / std::filesystem::path(path).stem()).string();
  REQUIRE(std::system(("xz -dc '" + path + "' > '" + copy + "'").c_str()) == 0);
  return copy;
}

std::string error_of(const std::function<void()>& read) {
  try {
    read();
  } catch (const crest::kernel::InputError& error) {
    return error.what();
  }
  return "no error";
}

void check(const Expected& expected, const std::string& path) {
  INFO(path);
  const std::string words = expected.words;
  if (expected.size[0] == 0) {
    CHECK(error_of([&] { crest::io::read_volume(path); }).find(words) != std::string::npos);
    return;
  }
  const auto file = crest::io::read_volume(path);
  CHECK(file.grid.size == expected.size);
  double low = file.grid.at(0), high = low;
  std::visit(
      [&](const auto& x) {
        const auto [least, most] = std::minmax_element(x.begin(), x.end());
        low = static_cast<double>(*least);
        high = static_cast<double>(*most);
      },
      file.grid.samples);
  CHECK(low == Approx(expected.low).margin(1e-3));
  CHECK(high == Approx(expected.high).margin(1e-3));
  CHECK(file.warnings.empty() == words.empty());
  if (!words.empty()) CHECK(file.warnings.at(0).find(words) != std::string::npos);
}

}  // namespace

TEST_CASE("every volume of the data set gives its samples or one clear line", "[io]") {
  for (const Expected& expected : kExpected) {
    const auto path = crest::tests::shared_data(std::string("volumes/") + expected.file);
    if (!path) return;
    check(expected, unpacked(*path));
  }
  const auto vectors = crest::tests::shared_data("tensors/dti_V1.nii.gz");
  if (!vectors) return;
  CHECK(error_of([&] {
          crest::io::read_volume(*vectors);
        }).find("84 x 92 x 56 x 3 are more than three axes") != std::string::npos);
}

TEST_CASE("every point set of the data set gives points with normals or one clear line", "[io]") {
  struct Points {
    const char* file;
    std::size_t count;
    const char* words;
  };
  for (const Points& expected :
       {Points{"b9_training.ply", 0, "have no normals"}, Points{"ball.ply", 31374, ""},
        Points{"before_upsample.xyz", 850, ""}, Points{"biwi_face.pcd", 0, "PCD is not read"},
        Points{"cube.pwn", 50000, ""}, Points{"fin90_with_PCA_normals.xyz", 757, ""},
        Points{"hippo1.ply", 6104, ""}, Points{"kitten.xyz", 5210, ""}, Points{"oni.pwn", 1435, ""},
        Points{"point_set_2.xyz", 3634, ""}, Points{"point_set_3.xyz", 8075, ""},
        Points{"points_cloudcompare.xyz", 0, "has 7 numbers, not 6"},
        Points{"radar.xyz", 0, "has no normal"}, Points{"sphere_1k.xyz", 1050, ""}}) {
    const auto path = crest::tests::shared_data(std::string("points/") + expected.file);
    if (!path) return;
    INFO(*path);
    if (expected.count == 0)
      CHECK(error_of([&] { crest::io::read_points(*path); }).find(expected.words) !=
            std::string::npos);
    else
      CHECK(crest::io::read_points(*path).points.size() == expected.count);
  }
}
