// SPDX-License-Identifier: GPL-3.0-or-later
// Time a voxel, certificate on: sheets at several sizes, the shared MRI and iguana, one thread.
#include <fmt/format.h>
#include <sys/resource.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "certify/extremal/encode.hpp"
#include "certify/verify.hpp"
#include "experiments/000-extremal/inputs.hpp"
#include "experiments/processor_time.hpp"
#include "experiments/program.hpp"
#include "io/read/volume_reader.hpp"

namespace crest::experiments {
namespace {

double median(std::vector<double> x) {
  std::sort(x.begin(), x.end());
  return x[x.size() / 2];
}

void row(const std::string& name, const extremal::Volume& volume, double min_value, int runs) {
  const double voxels = static_cast<double>(volume.size[0]) * volume.size[1] * volume.size[2];
  std::vector<double> extraction, encoding, checking;
  std::size_t bytes = 0, active = 0;
  bool accepted = true;
  for (int i = 0; i < runs; ++i) {
    certify::ExtremalCertificate certificate;
    double before = processor_seconds();
    const auto r = extremal::extract(volume, ridge_options(false, min_value), &certificate);
    extraction.push_back(processor_seconds() - before);
    active = r.counts.empty + r.counts.regular + r.counts.cone;
    before = processor_seconds();
    const auto encoded = certify::encode(certificate);
    encoding.push_back(processor_seconds() - before);
    bytes = encoded.size();
    before = processor_seconds();
    accepted = accepted && certify::verify(encoded).accepted;
    checking.push_back(processor_seconds() - before);
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  fmt::print(
      "| {} | {} x {} x {} | {:.1f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {} | {:.1f} | {:.0f} |\n",
      name, volume.size[0], volume.size[1], volume.size[2],
      100 * static_cast<double>(active) / voxels, median(extraction),
      1e6 * median(extraction) / voxels, 1e6 * median(encoding) / voxels,
      median(checking) / median(extraction), accepted ? "accepted" : "REJECTED",
      static_cast<double>(bytes) / 1e6, static_cast<double>(usage.ru_maxrss) / 1e3);
  std::fflush(stdout);
}

}  // namespace
}  // namespace crest::experiments

int main(int argc, char** argv) {
  using namespace crest;
  std::vector<int> sizes{64, 128, 256};
  std::string folder = "../shared/data/volumes", only;
  int runs = 3;
  experiments::Program program("Time a voxel, one thread, certificate on.");
  program.list("--nodes", sizes, "of the phantoms");
  program.option("--data", folder, "the shared volumes, unpacked");
  program.option("--only", only, "one row's name");
  program.option("--runs", runs, "of which the median is taken", {1, 99});
  return program.run(argc, argv, [&] {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    fmt::print(
        "One thread, processor time, structure, sigma 1, medians of {} runs; the memory is the "
        "process's peak so far\n\n"
        "| data | size | active cells, % | s | us/voxel | encoding, us/voxel | checker / "
        "extraction | checker | certificate, MB | peak, MB |\n"
        "|---|---|---|---|---|---|---|---|---|---|\n",
        runs);
    for (const char* name : {"sphere-shell", "junction"})
      for (const int n : sizes)
        if (only.empty() || only == name)
          experiments::row(name, experiments::phantom(name, static_cast<std::size_t>(n)), 0.4,
                           runs);
    for (const auto& [file, min_value] :
         {std::pair("mri_head_256.nrrd", 60.0), std::pair("iguana_ct.nii.gz", 60.0)}) {
      if (!only.empty() && only != file) continue;
      for (const auto& path : {std::filesystem::path(folder) / file,
                               std::filesystem::path(folder) / "unpacked" / file})
        if (std::filesystem::exists(path))
          experiments::row(file, experiments::volume_of(io::read_volume(path.string()).grid),
                           min_value, runs);
    }
    return 0;
  });
}
