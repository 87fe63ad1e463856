// SPDX-License-Identifier: GPL-3.0-or-later
// Faulty volumes, images and points: each gives one line that names the file, the element and a
// remedy.
#include <catch2/catch.hpp>
#include <limits>

#include "io/read/point_reader.hpp"
#include "io/read/volume_reader.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/io/volume_bytes.hpp"

using namespace crest::tests;

namespace {

template <class Read>
void require_line(const Read& read, const std::string& name, const std::string& expected) {
  INFO(name << ": " << expected);
  try {
    read();
    FAIL_CHECK("no error");
  } catch (const crest::kernel::InputError& error) {
    const std::string line = error.what();
    INFO(line);
    CHECK(line.starts_with(name + ": "));
    CHECK(line.find(expected) != std::string::npos);
    CHECK(line.find("; ") != std::string::npos);
    CHECK(line.find('\n') == std::string::npos);
  }
}

struct Case {
  const char* name;
  std::string bytes;
  const char* expected;
};

const std::string kI16 = volume_samples<std::int16_t>();
const std::string kRaw = "endian: little\nencoding: raw";

std::string with_number(double special) {
  std::string bytes = volume_samples<double>();
  std::memcpy(bytes.data() + 8 * (1 + 4 * 2 + 20 * 3), &special, 8);
  return bytes;
}

std::string with_integer(std::int64_t special) {
  std::string bytes = volume_samples<std::int64_t>();
  std::memcpy(bytes.data() + 8 * 5, &special, 8);
  return bytes;
}

template <class Header, class Change>
std::string changed(Header header, const Change& change) {
  change(header);
  return header.bytes(kI16);
}

/// Of a VTI file, its whole extent and its piece's.
std::string with_extent(const std::string& extent) {
  std::string bytes = vti("Int16", volume_words());
  const std::string old = "0 3 0 4 0 5";
  for (std::size_t at = bytes.find(old); at != bytes.npos; at = bytes.find(old, at + extent.size()))
    bytes.replace(at, old.size(), extent);
  return bytes;
}

const Case kVolumes[] = {
    {"a.nrrd", "", "file: is empty"},
    {"a.nrrd", "NRRX", "does not start with 'NRRD000'"},
    {"a.nrrd", nrrd("short", kRaw, kI16.substr(1)),
     "there are 239 bytes, the header announces 240"},
    {"a.nrrd", nrrd("short", kRaw, kI16 + "x"), "there are 241 bytes"},
    {"a.nrrd", nrrd("short", kRaw, kI16, "400000000000 500000000 6"),
     "announces more samples than memory holds"},
    {"a.nrrd", nrrd("short", kRaw, kI16, "4 5"), "there are 2, not as many as the dimension"},
    {"a.nrrd", nrrd("short", kRaw, kI16, "4 5 x"), "'x' is no count"},
    {"a.nrrd", nrrd("half", kRaw, kI16), "the type 'half' is not read"},
    {"a.nrrd", nrrd("short", "endian: little\nencoding: bzip2", kI16),
     "the encoding 'bzip2' is not read"},
    {"a.nrrd", nrrd("short", "encoding: raw", kI16), "does not say which endian"},
    {"a.nrrd", nrrd("short", "endian: little\nencoding: gzip", "abcdef"), "are damaged or cut off"},
    {"a.nrrd", nrrd("short", "endian: little\nencoding: gzip", deflated(kI16, 31).substr(0, 60)),
     "are damaged or cut off"},
    {"a.nrrd", nrrd("short", "endian: little\nencoding: gzip", deflated(kI16 + kI16, 31)),
     "more than the 240 bytes"},
    {"a.nrrd", nrrd("short", "encoding: ascii", "1 2 3"), "the file ends before"},
    {"a.nrrd", nrrd("short", "encoding: ascii", volume_words() + "x").replace(60, 1, "x"),
     "header"},
    {"a.nrrd", nrrd("double", kRaw, with_number(std::numeric_limits<double>::quiet_NaN())),
     "voxel 1,2,3: is not a number"},
    {"a.nrrd", nrrd("double", kRaw, with_number(-HUGE_VAL)), "voxel 1,2,3: is infinite"},
    {"a.nrrd", nrrd("int64", kRaw, with_integer((std::int64_t{1} << 53) + 1)),
     "voxel 1,1,0: is an integer that a double"},
    {"a.nrrd", nrrd("short", kRaw, kI16.substr(0, 2 * 60), "3 4 5"), "3 x 4 x 5 are too few"},
    {"a.nrrd", nrrd("short", kRaw + "\nspacings: 1 0 1", kI16), "axis 1: has no spacing"},
    {"a.nrrd", nrrd("short", kRaw + "\nspace directions: (1,0,0) (1,0,0) (0,0,1)", kI16),
     "lie in a plane or a line"},
    {"a.nrrd", nrrd("short", kRaw + "\nspace directions: none (1,0,0) (0,1,0)", kI16),
     "axis 0: has no spacing: its samples are vectors"},
    {"a.nrrd", nrrd("short", kRaw + "\nspace directions: (1,0,0) (0,1,0)", kI16),
     "there are 2, the dimension is 3"},
    {"a.nhdr", nrrd("short", kRaw + "\ndata file: none.raw", ""), "several files are not read"},
    {"a.mha", meta_image("MET_SHORT", "", kI16.substr(2)),
     "there are 238 bytes, the header announces 240"},
    {"a.mha", meta_image("MET_HALF", "", kI16), "'MET_HALF' is not read"},
    {"a.mha", meta_image("MET_SHORT", "ElementNumberOfChannels = 3\n", kI16),
     "have 3 numbers each"},
    {"a.mha", meta_image("MET_SHORT", "BinaryData = False\n", kI16),
     "samples as text are not read"},
    {"a.mha", meta_image("MET_SHORT", "ElementSpacing = 1 2\n", kI16), "are no 3 numbers"},
    {"a.mhd", "NDims = 3\nDimSize = 4 5 6\n", "has no ElementDataFile"},
    {"a.mhd", "NDims = 3\nDimSize = 4 5 6.5\nElementType = MET_CHAR\nElementDataFile = LOCAL\n",
     "are no counts"},
    {"a.nii", "x", "is none of NIfTI"},
    {"a.nii", Nifti{}.bytes(kI16.substr(2)), "there are 238 bytes, the header announces 240"},
    {"a.nii", changed(Nifti{}, [](Nifti& n) { n.type = 128; }), "samples of NIfTI's type 128"},
    {"a.nii",
     changed(Nifti{},
             [](Nifti& n) {
               n.dimension[0] = 4;
               n.dimension[3] = 2;
               n.dimension[4] = 3;
             }),
     "4 x 5 x 2 x 3 are more than three axes"},
    {"a.nii", changed(Nifti{}, [](Nifti& n) { n.dimension[2] = -5; }), "axis 2 has the size -5"},
    {"a.nii", changed(Nifti{}, [](Nifti& n) { n.offset = 1e30f; }),
     "says that the samples start at byte"},
    {"a.nii", changed(Nifti{}, [](Nifti& n) { n.magic = "ni1"; }),
     "the samples are in another file"},
    {"a.nii", changed(Nifti{}, [](Nifti& n) { n.spacing[1] = HUGE_VALF; }),
     "its spacing is not finite"},
    {"a.nii.gz", deflated(Nifti{}.bytes(kI16), 31).substr(0, 100), "are damaged or cut off"},
    {"a.mrc", std::string(1000, 'x'), "the file ends in it"},
    {"a.mrc", std::string(2000, 'x'), "has no 'MAP '"},
    {"a.mrc", Mrc{}.bytes(kI16 + "xy"), "there are 242 bytes"},
    {"a.mrc", changed(Mrc{}, [](Mrc& m) { m.mode = 4; }), "samples of mode 4"},
    {"a.mrc", changed(Mrc{}, [](Mrc& m) { m.axes[0] = 2; }), "are not 1, 2 and 3 in some order"},
    {"a.mrc", changed(Mrc{}, [](Mrc& m) { m.extended = 1 << 30; }), "announces an extended header"},
    {"a.vti", "<VTKFile type=\"ImageData\">", "cannot be read as VTI"},
    {"a.vti", vti("Int16", "1 2 3"), "cannot be read as VTI"},
    {"a.vti", with_extent("0 3 0 4 0 99999999"), "more than the file holds"},
    {"a.vti", with_extent("0 3 0 4 5 0"), "is empty or more"},
    {"a.vtk",
     structured_points("ASCII", "VECTORS a short\n",
                       volume_words() + volume_words() + volume_words()),
     "no array has one number a point"},
    {"a.vtk", structured_points("ASCII", "SCALARS a short\nLOOKUP_TABLE default\n", "1 2 3"),
     "the file ends in it"},
    {"a.vtk", "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\n",
     "'POLYDATA' is no volume"},
    {"a.png", "P5\n", "is none of PNG"},
    {"a.pgm", "P5\n4 5\n255\nabc", "there are 3 bytes, the header announces 20"},
    {"a.pgm", "P5\n4 5\n70000\nabc", "the largest value '70000' is none"},
    {"a.pgm", "P2\n4 5\n255\n1 2 3", "the file ends before"},
    {"a.pgm", "P4\n4 5\nabc", "'P4' is not read"},
    {"a.inr", "INRIMAGE", "does not start with #INRIMAGE-4#{"},
    {"a.inr", "#INRIMAGE-4#{\nXDIM=4\n", "has no end ##}"},
    {"a.inr", "#INRIMAGE-4#{\n##}\n", "the file ends in it"},
    {"a.inr", inrimage("VDIM=3\n", kI16), "several samples a voxel"},
    {"a.inr", inrimage("XDIM=-4\n", kI16), "XDIM: -4 is no size"},
    {"a.inr", inrimage("CPU=vax\n", kI16), "'vax' is none of decm"},
    {"a.inr", inrimage("PIXSIZE=12 bits\n", kI16), "'signed fixed' of 12 bits is not read"},
    {"a.inr", inrimage("VX=x\n", kI16), "VX: 'x' is not a number"},
    {"a.inr", inrimage("XDIM\n", kI16), "'XDIM' is no KEY=VALUE"},
    {"a.inr", inrimage("", kI16 + "xy"), "there are 242 bytes"},
    {"a.cube", "x", "the file ends in it"},
    {"a.cube", "t\nt\nx 0 0 0\n", "'x' is not a number of atoms"},
    {"a.cube", "t\nt\n0 0 0\n", "header (line 3): lacks a coordinate"},
    {"a.cube", "t\nt\n0 0 0 0 2\n", "there are several a voxel"},
    {"a.cube", "t\nt\n0 0 0 0\n0 1 0 0\n", "an axis has no voxels"},
    {"a.cube", "t\nt\n7 0 0 0\n4 1 0 0\n4 0 1 0\n4 0 0 1\n", "ends in its atoms"},
    {"a.cube", "t\nt\n0 0 0 0\n9999 1 0 0\n4 0 1 0\n4 0 0 1\n1 2 3\n", "announces 159984"},
    {"a.cube", cube("0", "", "1 2 3 x "), "'x' is not a number"},
    {"a.cube", cube("0", "", "1 2 3 "), "there are more than the header announces"},
    {"a.cube", cube("-1", "1 0 0 0 0\n2 1 2\n", ""), "there are 2 orbitals"},
    {"a.tif", "II*", "convert it to PNG or PGM"},
    {"a", "x", "has no extension"},
    {"a.stl", "x", "the extension '.stl' are not read"},
    {"a.nrrd", "\x1f\x8b\x08", "name it .gz"},
};

const Case kPoints[] = {
    {"p.xyz", "1 2 3\n", "point 0 (line 1): has no normal; give each point a normal"},
    {"p.xyz", "1 2 3 0 0 1\n1 2 3 4 5\n", "point 1 (line 2): has 5 numbers, not 6"},
    {"p.pwn", "1 2 3 0 0 1 7\n", "has 7 numbers, not 6"},
    {"p.xyz", "1 2 3 0 0 x\n", "'x' is not a number"},
    {"p.xyz", "1,2,3,0,0,1\n", "separate numbers by blanks"},
    {"p.xyz", "1 2 nan 0 0 1\n", "point 0: is not finite"},
    {"p.xyz", "1 2 3 0 0 1\n1 2 3 0 inf 1\n", "point 1: its normal is not finite"},
    {"p.xyz", "1 2 3 0 0 0\n1 2 4 0 0 0\n", "points: all normals are zero"},
    {"p.xyz", "# nothing\n", "points: there are none"},
    {"p.pcd", "# .PCD v0.7\n", "PCD is not read"},
    {"p.obj", "v 0 0 0\nv 1 0 0\nvn 0 0 1\n", "points: have no normals"},
    {"p.ply",
     "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
     "property float z\nend_header\n0 0 0\n",
     "points: have no normals"},
    {"p.off", "OFF\n1 0 0\n0 0 0\n", "points: have no normals"},
};

}  // namespace

TEST_CASE("faulty volumes and images give one line", "[io]") {
  for (const Case& c : kVolumes)
    require_line([&] { crest::io::read_volume_bytes(c.name, c.bytes); }, c.name, c.expected);
}

TEST_CASE("faulty points give one line", "[io]") {
  for (const Case& c : kPoints)
    require_line([&] { crest::io::read_points_bytes(c.name, c.bytes); }, c.name, c.expected);
}
