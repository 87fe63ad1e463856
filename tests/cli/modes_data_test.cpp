// SPDX-License-Identifier: GPL-3.0-or-later
// Every file of the shared tensors gives an accepted certificate or one clear line.
#include <catch2/catch.hpp>

#include "tests/cli/run_crest.hpp"
#include "tests/support/shared_data.hpp"

using namespace crest::tests;

namespace {

struct Answer {
  const char* file;
  const char* words = nullptr;  ///< of the error; nothing: it is certified
  const char* options = "";
};

constexpr Answer kAnswers[] = {{"a_grid_stress.vtk"},
                               {"bunny_stress.vtk"},
                               {"notch_stress_fixed.vtk"},
                               {"mesh.frd", nullptr, " --tensor STRESS"},
                               {"mesh.frd", "choose one with --tensor"},
                               {"dipy_small_64D_dti.nrrd"},
                               {"helix-DTI.nrrd"},
                               {"mrtrix_brain_dti.nrrd"},
                               {"a_grid.vtk", "the file has no array of points"},
                               {"dti_FA.nii.gz", "is packed; unpack it"},
                               {"dti_V1.nii.gz", "is packed; unpack it"},
                               {"hand_stress.vtk.xz", "is packed; unpack it"},
                               {"tetmeshes/bar-2523.msh", "the file has no array of points"},
                               {"tetmeshes/bunny.mesh", "the file has no array of points"},
                               {"tetmeshes/cow_head.msh", "the file has no array of points"},
                               {"tetmeshes/hammer.msh", "the file has no array of points"},
                               {"tetmeshes/hand.mesh", "the file has no array of points"},
                               {"tetmeshes/hollowCat7.5K.msh.xz", "is packed; unpack it"},
                               {"tetmeshes/sphere1K.msh", "the file has no array of points"}};

}  // namespace

TEST_CASE("crest modes: the shared tensors, certified or refused in one line") {
  const auto shared = shared_data("tensors");
  if (!shared) return;
  const TemporaryFolder folder;
  for (const Answer& answer : kAnswers) {
    INFO(answer.file);
    const auto run =
        run_crest("crest modes '" + *shared + "/" + answer.file + "' --mode 0.9" + answer.options +
                      " --certificate a.crest --report a.json --quiet",
                  folder.path());
    INFO(run.err);
    CHECK(run.exit_code == (answer.words ? 3 : 0));
    if (answer.words) {
      CHECK(is_one_line(run.err));
      CHECK(run.err.find(answer.words) != std::string::npos);
      continue;
    }
    const auto report = read_json(folder / "a.json");
    CHECK(report["certificate"]["certified"] == true);
    for (const auto& surface : report["surfaces"]) CHECK(surface["watertight"] == true);
    CHECK(run_crest("crest-verify a.crest", folder.path()).exit_code == 0);
  }
}
