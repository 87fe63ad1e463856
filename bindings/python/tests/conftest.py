# SPDX-License-Identifier: GPL-3.0-or-later
"""Inputs that `crest sample` makes, and the programs whose bytes the package's must be."""

import os
import subprocess
from pathlib import Path

import pytest

PROGRAMS = Path(os.environ["CREST_PROGRAMS"])

SAMPLES = {
    "ellipsoid.off": ["ellipsoid", "--parameters", "1,1.5,2", "--rotate", "--vertices", "1200"],
    "blend.ply": ["blend", "--vertices", "1500"],
    "torus.off": ["torus", "--vertices", "800"],
    "patch.ply": ["umbilic-patch", "--vertices", "900"],
    "moebius.nrrd": ["moebius-sheet", "--nodes", "24"],
    "strip.xyz": ["moebius-points", "--vertices", "800"],
    "stress.vtu": ["block-twist", "--vertices", "700"],
    "lattice.vtu": ["lattice", "--seed", "5", "--parameters", "16,1"],
}

CUBE = """OFF
8 12 0
0 0 0
1 0 0
1 1 0
0 1 0
0 0 1
1 0 1
1 1 1
0 1 1
3 0 2 1
3 0 3 2
3 4 5 6
3 4 6 7
3 0 1 5
3 0 5 4
3 1 2 6
3 1 6 5
3 2 3 7
3 2 7 6
3 3 0 4
3 3 4 7
"""


def program(name, *arguments, codes=(0,)):
    """Runs crest or crest-verify."""
    done = subprocess.run([PROGRAMS / name, *map(str, arguments)], capture_output=True, text=True)
    assert done.returncode in codes, done.stdout + done.stderr
    return done.stdout


@pytest.fixture(scope="session")
def samples(tmp_path_factory):
    """A folder with the files of SAMPLES, cube.off and field.vtp."""
    folder = tmp_path_factory.mktemp("samples")
    for name, arguments in SAMPLES.items():
        program("crest", "sample", *arguments, "-o", folder / name, "--quiet")
    (folder / "cube.off").write_text(CUBE)
    program("crest", "curvature", folder / "ellipsoid.off", "-o", folder / "field.vtp", "--quiet")
    return folder


@pytest.fixture
def here(samples, monkeypatch):
    """The folder of samples as the working folder."""
    monkeypatch.chdir(samples)
    return samples
