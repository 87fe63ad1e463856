# SPDX-License-Identifier: GPL-3.0-or-later
"""The scripts of examples/python run, and draw what is stored beside them."""

import base64
import re
import runpy
import shutil
from pathlib import Path

import numpy as np
import pytest

from conftest import program

EXAMPLES = Path(__file__).resolve().parents[3] / "examples" / "python"
HORSE = EXAMPLES.parents[1].parent / "shared" / "data" / "meshes" / "horse.ply"


def run(name, capsys, *arguments):
    main = runpy.run_path(str(EXAMPLES / (name + ".py")))["main"]
    main(*map(str, arguments))
    return capsys.readouterr().out


def pixels(png, folder):
    image = pytest.importorskip("vtkmodules.vtkIOImage").vtkPNGReader()
    path = folder / "pixels.png"
    path.write_bytes(png)
    image.SetFileName(str(path))
    image.Update()
    support = pytest.importorskip("vtkmodules.util.numpy_support")
    return support.vtk_to_numpy(image.GetOutput().GetPointData().GetScalars()).astype(int)


def same(picture):
    """Pixels may differ by one level: NumPy's random numbers do in the last bit, by machine."""
    made, stored = picture.read_bytes(), (EXAMPLES / picture.name).read_bytes()
    if picture.suffix != ".svg":
        assert made == stored
        return
    embedded = re.compile(rb"base64,([^\"]*)")
    assert embedded.sub(b"", made) == embedded.sub(b"", stored)
    for a, b in zip(embedded.findall(made), embedded.findall(stored)):
        a, b = (pixels(base64.b64decode(x), picture.parent) for x in (a, b))
        assert a.shape == b.shape and np.abs(a - b).max() <= 1
        assert (a != b).mean() < 1e-4


def test_crest_lines(here, tmp_path, capsys):
    words = run("crest_lines", capsys, "blend.ply", tmp_path / "lines.png")
    assert "whose indices sum to 2\n" in words and words.endswith("accepted\n")
    assert (tmp_path / "lines.png").stat().st_size > 1000


@pytest.mark.skipif(not HORSE.exists(), reason="no shared meshes")
def test_crest_lines_of_a_scan(here, tmp_path, capsys):
    words = run("crest_lines", capsys, HORSE, tmp_path / "crest_lines.png")
    assert words.endswith("accepted\n")
    same(tmp_path / "crest_lines.png")


def test_proven_ridges(here, tmp_path, capsys):
    words = run("proven_ridges", capsys, tmp_path / "proven_ridges.png")
    assert words.startswith("proven\n") and words.count("umbilic of index +0.5") == 4
    same(tmp_path / "proven_ridges.png")


def test_persistence(here, tmp_path, capsys):
    words = run("persistence", capsys, "blend.ply", tmp_path / "persistence.svg")
    nodes = [int(line.split()[1]) for line in words.splitlines()[1:-1]]
    assert nodes == sorted(nodes, reverse=True) and nodes[0] > 10 * nodes[-1]
    same(tmp_path / "persistence.svg")


def test_compare_estimators(here, tmp_path, capsys):
    program("crest", "sample", "ellipsoid", "--parameters", "1,1.5,2", "--vertices", "1200", "-o",
            tmp_path / "plain.off", "--quiet")
    words = run("compare_estimators", capsys, tmp_path / "plain.off",
                tmp_path / "compare_estimators.png")
    medians = [float(line.split()[1].rstrip("%")) for line in words.splitlines()[1:]]
    assert len(medians) == 6 and medians[4] == min(medians) < 1  # jet
    same(tmp_path / "compare_estimators.png")


def test_verify_certificate(here, tmp_path, capsys):
    program("crest", "features", "cube.off", "--angle", "60", "--certificate", tmp_path / "c.crest",
            "--quiet")
    words = run("verify_certificate", capsys, tmp_path / "c.crest", "cube.off",
                tmp_path / "verify_certificate.svg")
    assert "accepted\nwith one bit changed: " in words and not words.endswith(": accepted\n")
    same(tmp_path / "verify_certificate.svg")
