# SPDX-License-Identifier: GPL-3.0-or-later
"""Docstrings, options, other packages, installing."""

import ast
import doctest
import inspect
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import crest
from conftest import program
from crest import _crest

ROOT = Path(__file__).resolve().parents[3]
FUNCTIONS = [name for name in crest.__all__ if inspect.isfunction(getattr(crest, name))]
CLASSES = [name for name in crest.__all__ if inspect.isclass(getattr(crest, name))]


@pytest.mark.parametrize("name", FUNCTIONS)
def test_examples_of_docstrings(name, here):
    function = getattr(crest, name)
    (test,) = doctest.DocTestFinder(recurse=False).find(function, name)
    assert test.examples, f"{name} has no example"
    assert doctest.DocTestRunner().run(test).failed == 0


SHARED = {"V", "F", "threads", "progress", "picture", "view", "up", "volume", "spacing", "origin",
          "directions", "border", "certificate", "isovalue", "weld", "split", "outward", "path"}


def test_everything_is_documented():
    assert len(FUNCTIONS) > 20
    for name in FUNCTIONS:
        words = inspect.getdoc(getattr(crest, name))
        for option in inspect.signature(getattr(crest, name)).parameters:
            # Or where the text sends the reader.
            elsewhere = option in SHARED and re.search(r"as for \w+\(\)", words)
            assert re.search(rf"\b{option}\b", words) or elsewhere, f"{name}: {option}"
    for name in CLASSES:
        assert inspect.getdoc(getattr(crest, name)), name


def test_stub_is_the_modules():
    """_crest.pyi names what the module has, with its parameters, and everything has type hints."""
    stub = ast.parse((Path(crest.__file__).parent / "_crest.pyi").read_text())
    stated = {node.name: node for node in stub.body if hasattr(node, "name")}
    assert set(stated) == {name for name in vars(_crest) if not name.startswith("__")}
    for name, node in stated.items():
        if isinstance(node, ast.FunctionDef):
            said = re.match(r"\w+\((.*)\) ->", getattr(_crest, name).__doc__)[1]
            assert [a.arg for a in node.args.args] == re.findall(r"(\w+): ", said), name
    for name in FUNCTIONS:
        signature = inspect.signature(getattr(crest, name))
        assert signature.return_annotation is not inspect.Signature.empty, name
        for parameter in signature.parameters.values():
            assert parameter.annotation is not inspect.Parameter.empty, f"{name}: {parameter}"


# The command of each function, with what only files and pictures need, and what arrays are instead.
COMMANDS = {
    "ridges": ("ridges", set()), "smooth_ridges": ("ridges", set()),
    "curvature": ("curvature", set()), "feature_lines": ("features", set()),
    "reeb_graph": ("reeb", {"values", "midside"}), "modes": ("modes", {"tensors"}),
    "extremal": ("extremal", {"volume", "spacing", "origin", "directions"}),
    "extremal_points": ("extremal", {"points", "normals"}), "skeleton": ("skeleton", {"vectors"}),
    "compress": ("compress", {"vectors"}), "lineart": ("lineart", {"title"}),
    "spline_isosurface": ("spline", {"volume", "spacing", "origin", "directions"}),
    "spline_samples": ("spline", {"points", "values"}), "strips": ("strips", set()),
    "encode": ("encode", {"point_data", "cell_data", "corner_data"}), "decode": ("decode", {"stream"}),
}
ALWAYS = {"V", "F", "T", "threads", "progress", "certificate"}


@pytest.mark.parametrize("name", COMMANDS)
def test_options_are_the_command_lines(name):
    command, own = COMMANDS[name]
    words = program("crest", command, "--help")
    known = {option.replace("-", "_") for option in re.findall(r"(?:^|[\s,])--?([a-z][a-z-]*)", words)}
    for option, parameter in inspect.signature(getattr(crest, name)).parameters.items():
        if option in ALWAYS | own:
            continue
        assert option in known, f"{name}: {option}"
        stated = re.search(rf"--?{option.replace('_', '-')}\b(?:(?!\n  -).)*?default:? ([\d.]+(?:\^\d+)?)",
                           words, re.DOTALL)
        if stated and isinstance(parameter.default, (int, float)) and not isinstance(
                parameter.default, bool):
            base, _, power = stated[1].rstrip(".").partition("^")
            assert float(base) ** float(power or 1) == parameter.default, f"{name}: {option}"


def test_all_commands_are_here():
    words = program("crest", "--help")
    commands = set(re.findall(r"^  ([a-z]+)  ", words, re.MULTILINE)) - {"clean", "sample"}
    assert commands and commands <= {command for command, _ in COMMANDS.values()}


def test_results_for_other_packages(here, tmp_path, monkeypatch):
    graph = crest.ridges(*crest.read_mesh("ellipsoid.off"))
    graph.save(tmp_path / "graph.npz")
    assert (np.load(tmp_path / "graph.npz")["points"] == graph.geometry.points).all()
    graph.save(tmp_path / "graph.crest")
    assert (tmp_path / "graph.crest").read_bytes() == graph.certificate
    for package, method in (("vtkmodules", "to_vtk"), ("pyvista", "to_pyvista"),
                            ("meshio", "to_meshio")):
        with monkeypatch.context() as without:
            for name in [n for n in sys.modules if n.split(".")[0] == package]:
                without.delitem(sys.modules, name)
            without.setitem(sys.modules, package, None)
            with pytest.raises(ImportError, match="needs the package"):
                getattr(graph, method)()


def test_vtk(here):
    pytest.importorskip("vtkmodules")
    for result in (crest.ridges(*crest.read_mesh("ellipsoid.off")),
                   crest.strips(*crest.read_mesh("ellipsoid.off"))):
        g, data = result.geometry, result.to_vtk()
        assert data.GetNumberOfPoints() == len(g.points)
        assert data.GetNumberOfCells() == sum(
            map(len, (g.vertices, g.lines, g.polygons, g.strips)))
        assert data.GetCellData().GetNumberOfArrays() == len(g.cell_data)


def test_meshio(here, tmp_path):
    meshio = pytest.importorskip("meshio")
    V, F = crest.read_mesh("ellipsoid.off")
    mesh = crest.strips(V, F).to_meshio()
    found = {tuple(sorted(t)) for t in mesh.get_cells_type("triangle")}
    assert found == {tuple(sorted(t)) for t in F}
    curvature = crest.curvature(V, F)
    curvature.save(tmp_path / "curvature.vtu")
    again = meshio.read(tmp_path / "curvature.vtu")
    assert (again.points == V).all() and (again.point_data["k1"] == curvature.k1).all()
    ridges = crest.ridges(V, F)
    segments = ridges.to_meshio().get_cells_type("line")
    assert len(segments) == sum(len(line) - 1 for line in ridges.lines())


def test_ridges_are_consistent(here):
    V, F = crest.read_mesh("ellipsoid.off")
    graph = crest.ridges(V, F)
    assert graph.offsets[-1] == len(graph.points) == len(graph.type) == len(graph.k1)
    assert len(graph.offsets) - 1 == len(graph.colour) == len(graph.loop) == len(graph.length)
    assert graph.index_sum == graph.umbilics.index.sum() == graph.euler_characteristic == 2
    # The centre of its face.
    assert np.allclose(graph.umbilics.points, V[F[graph.umbilics.face]].mean(axis=1))
    assert (np.diff(graph.colour) >= 0).all()


def build():
    return os.environ["CREST_BUILD"]


def python(folder, words, **keywords):
    environment = {**os.environ, "PYTHONPATH": str(folder)}
    return subprocess.run([sys.executable, "-B", "-c", words], env=environment, check=True,
                          capture_output=True, text=True, **keywords).stdout


TRY = "import crest; print(crest.__file__, crest.verify(b'').reason != '', crest.__version__)"


def test_cmake_install(tmp_path):
    subprocess.run(["cmake", "--install", build(), "--component", "python", "--prefix", tmp_path],
                   check=True, capture_output=True)
    folder = tmp_path / "lib" / "python{}.{}".format(*sys.version_info) / "dist-packages"
    said = python(folder, TRY, cwd=tmp_path)
    assert said.startswith(str(folder)) and "True" in said
    assert (folder / "crest" / "py.typed").exists() and (folder / "crest" / "_crest.pyi").exists()


def test_wheel(tmp_path):
    """By pip, without a network."""
    pip = [sys.executable, "-m", "pip", "-q", "--disable-pip-version-check"]
    options = ["--no-index"]
    subprocess.run([*pip, "wheel", ROOT, *options, "-w", tmp_path], check=True, capture_output=True)
    (wheel,) = tmp_path.glob("crest-*.whl")
    subprocess.run([*pip, "install", wheel, *options, "--target", tmp_path / "site"], check=True,
                   capture_output=True)
    said = python(tmp_path / "site", TRY, cwd=tmp_path)
    assert said.startswith(str(tmp_path / "site")) and "True" in said
