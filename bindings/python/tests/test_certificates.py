# SPDX-License-Identifier: GPL-3.0-or-later
"""Every system's certificate has the bytes of the program's, and its files have, too."""

import threading

import numpy as np
import pytest

import crest
from conftest import program


def vectors(path):
    return crest.read_vectors(path)


def volume(f):
    return lambda **k: f(crest.read_volume("moebius.nrrd"), **k)


# The command line, and the same call; then whether -o of the one is save() of the other.
CASES = {
    "ridges": (["ridges", "ellipsoid.off"],
               lambda: crest.ridges(*crest.read_mesh("ellipsoid.off")), "-o"),
    "ridges scale": (["ridges", "ellipsoid.off", "--scale", "0.6", "--smooth", "2", "--salient"],
                     lambda: crest.ridges(*crest.read_mesh("ellipsoid.off"), scale=0.6, smooth=2,
                                          salient=True), "-o"),
    "ridges auto": (["ridges", "blend.ply", "--scale", "auto", "--crest-only", "--min-length", "0.1"],
                    lambda: crest.ridges(*crest.read_mesh("blend.ply"), scale="auto",
                                         crest_only=True, min_length=0.1), "-o"),
    "ridges open": (["ridges", "patch.ply", "--rings", "2", "--order", "3", "--significance", "0",
                     "--umbilic-patch", "2"],
                    lambda: crest.ridges(*crest.read_mesh("patch.ply"), rings=2, order=3,
                                         significance=0, umbilic_patch=2), "-o"),
    "smooth": (["ridges", "--surface", "x^2 + y^2/2.25 + z^2/4 - 1", "--box=-3,3"],
               lambda: crest.smooth_ridges(surface="x^2 + y^2/2.25 + z^2/4 - 1", box=(-3, 3)), "-o"),
    "smooth param": (["ridges", "--param", "u; v; u^2 + 0.5*v^2 + 0.2*u^3 + 0.3*u*v^2 + 0.1*v^3",
                      "--domain=-0.5,0.6,-0.5,0.6"],
                     lambda: crest.smooth_ridges(
                         param=("u", "v", "u^2 + 0.5*v^2 + 0.2*u^3 + 0.3*u*v^2 + 0.1*v^3"),
                         domain=("-0.5", 0.6, "-0.5", 0.6)), "-o"),
    "features angle": (["features", "cube.off", "--angle", "60"],
                       lambda: crest.feature_lines(*crest.read_mesh("cube.off"), angle=60), "-o"),
    "features over": (["features", "blend.ply", "--angle", "10.5", "--over", "2", "--prune", "3"],
                      lambda: crest.feature_lines(*crest.read_mesh("blend.ply"), angle="10.5",
                                                  over=2, prune=3), "-o"),
    "features": (["features", "blend.ply", "--threshold", "0.8", "--close", "1", "--prune", "3",
                  "--min-patch", "4", "--close-branches", "4"],
                 lambda: crest.feature_lines(*crest.read_mesh("blend.ply"), threshold=0.8, close=1,
                                             prune=3, min_patch=4, close_branches=4), "-o"),
    "features method": (["features", "ellipsoid.off", "--method", "normal-cycle", "--rings", "2",
                         "--dilate", "0.1", "--neighbourhood", "geodesic"],
                        lambda: crest.feature_lines(*crest.read_mesh("ellipsoid.off"),
                                                    method="normal-cycle", rings=2, dilate=0.1,
                                                    neighbourhood="geodesic"), "-o"),
    "features field": (["features", "field.vtp", "--field", "H", "--absolute", "--value", "1.2"],
                       lambda: crest.feature_lines(*crest.read_field("field.vtp", "H"),
                                                   absolute=True, value=1.2), "-o"),
    "reeb": (["reeb", "field.vtp", "--field", "k1", "--level", "-0.9"],
             lambda: crest.reeb_graph(*crest.read_field("field.vtp", "k1"), level=[-0.9]), "-o"),
    "reeb trees": (["reeb", "field.vtp", "--field", "k1", "--join-tree", "--split-tree",
                    "--contour-tree"],
                   lambda: crest.reeb_graph(*crest.read_field("field.vtp", "k1"), join_tree=True,
                                            split_tree=True, contour_tree=True), "-o"),
    "reeb simple": (["reeb", "field.vtp", "--field", "k1", "--contract", "--persistence", "0.2",
                     "--cancel-loops", "--segmentation"],
                    lambda: crest.reeb_graph(*crest.read_field("field.vtp", "k1"), contract=True,
                                             persistence=0.2, cancel_loops=True, segmentation=True),
                    "-o"),
    "modes": (["modes", "stress.vtu", "--tensor", "stress", "--mode", "0.5", "--neutral"],
              lambda: crest.modes(*crest.read_tensors("stress.vtu", "stress"), mode=0.5,
                                  neutral=True), "-o"),
    "modes fraction": (["modes", "stress.vtu", "--tensor", "stress", "--mode", "-1/3", "--signed",
                        "--deviation", "0.01", "--min-magnitude", "0.1"],
                       lambda: crest.modes(*crest.read_tensors("stress.vtu", "stress"), mode="-1/3",
                                           signed=True, deviation=0.01, min_magnitude=0.1), "-o"),
    "modes curves": (["modes", "stress.vtu", "--tensor", "stress", "--degenerate"],
                     lambda: crest.modes(*crest.read_tensors("stress.vtu", "stress"),
                                         degenerate=True), "-o"),
    "extremal": (["extremal", "moebius.nrrd", "--ridge", "--min-value", "0.4"],
                 lambda: crest.extremal(**volume_arguments(), ridge=True, min_value=0.4), "-o"),
    "extremal valley": (["extremal", "moebius.nrrd", "--valley", "--definition", "hessian",
                         "--sigma", "1.5", "--critical", "--refine", "1"],
                        lambda: crest.extremal(**volume_arguments(), valley=True,
                                               definition="hessian", sigma=1.5, critical=True,
                                               refine=1), "-o"),
    "skeleton": (["skeleton", "lattice.vtu"], lambda: crest.skeleton(*vectors("lattice.vtu")), "-o"),
    "compress": (["compress", "lattice.vtu", "--equivalence", "relaxed", "--priority", "error"],
                 lambda: crest.compress(*vectors("lattice.vtu"), equivalence="relaxed",
                                        priority="error"), None),
    "skeleton simplify": (["skeleton", "lattice.vtu", "--simplify", "0.3", "--laplacian", "cotan"],
                          lambda: crest.skeleton(*vectors("lattice.vtu"), simplify=0.3,
                                                 laplacian="cotan"), "-o"),
    "compress simplify": (["compress", "lattice.vtu", "--simplify", "0.3"],
                          lambda: crest.compress(*vectors("lattice.vtu"), simplify=0.3), None),
    "spline mesh": (["spline", "moebius.nrrd", "--isovalue", "0.4"],
                    lambda: crest.spline_isosurface(isovalue=0.4, **volume_arguments()), "--mesh"),
    "encode": (["encode", "ellipsoid.off"],
               lambda: crest.encode(*crest.read_mesh("ellipsoid.off")), "-o .cmc"),
    "encode rounded": (["encode", "blend.ply", "--tolerance", "0.001", "--method", "valence",
                        "--keep-order"],
                       lambda: crest.encode(*crest.read_mesh("blend.ply"), tolerance=0.001,
                                            method="valence", keep_order=True), "-o .cmc"),
    "lineart": (["lineart", "ellipsoid.off", "--width", "40"],
                lambda: crest.lineart(*crest.read_mesh("ellipsoid.off"), width=40,
                                      title="ellipsoid.off"), "-o .svg"),
    "lineart contours": (["lineart", "blend.ply", "--style", "contours", "--camera", "3,2,4,0,0,0",
                          "--perspective", "40", "--crease", "none"],
                         lambda: crest.lineart(*crest.read_mesh("blend.ply"), style="contours",
                                               camera=(3, 2, 4, 0, 0, 0), perspective=40,
                                               crease=None), "-o"),
}


def volume_arguments():
    read = crest.read_volume("moebius.nrrd")
    return {"volume": read.samples, **read.frame()}


@pytest.mark.parametrize("name", CASES)
def test_bytes_are_the_programs(name, here, tmp_path):
    command, call, output = CASES[name]
    options = ["--certificate", tmp_path / "program.crest", "--quiet"]
    extension = ".vtp"
    if output:
        option, _, other = output.partition(" ")
        extension = other or extension
        options += [option, tmp_path / ("program" + extension)]
    program("crest", *command, *options, codes=(0, 1))
    result = call()
    assert result.certified
    assert result.certificate == (tmp_path / "program.crest").read_bytes()
    assert crest.verify(result.certificate)
    if output:
        result.save(tmp_path / ("python" + extension))
        assert ((tmp_path / ("python" + extension)).read_bytes()
                == (tmp_path / ("program" + extension)).read_bytes())


def test_files_without_certificates(here, tmp_path):
    """Curvature, strips, surfaces of points."""
    mesh = crest.read_mesh("ellipsoid.off")
    for words, result in (
            (["curvature", "ellipsoid.off", "--method", "cf"], crest.curvature(*mesh, method="cf")),
            (["curvature", "ellipsoid.off"], crest.curvature(*mesh)),
            (["strips", "ellipsoid.off", "--no-swaps"], crest.strips(*mesh, no_swaps=True)),
            (["extremal", "strip.xyz", "--surface", "--radius", "0.15", "--depth", "5"],
             crest.extremal_points(*crest.read_points("strip.xyz"), radius=0.15, depth=5))):
        program("crest", *words, "-o", tmp_path / "program.vtp", "--quiet")
        result.save(tmp_path / "python.vtp")
        assert (tmp_path / "python.vtp").read_bytes() == (tmp_path / "program.vtp").read_bytes()
        assert not result.certified


def test_rays_and_samples(here, tmp_path):
    rng = np.random.default_rng(3)
    rays = np.concatenate([np.full((20, 3), -3.0), rng.random((20, 3)) + 0.5], axis=1)
    np.savetxt(tmp_path / "rays.csv", rays, "%.17g", ",", header="ox,oy,oz,dx,dy,dz", comments="")
    program("crest", "spline", "moebius.nrrd", "--isovalue", "0.4", "--rays", tmp_path / "rays.csv",
            "--hits", tmp_path / "hits.csv", "--certificate", tmp_path / "rays.crest", "--quiet")
    hits = crest.spline_rays(isovalue=0.4, rays=rays, **volume_arguments())
    assert hits.certificate == (tmp_path / "rays.crest").read_bytes()
    points = rng.random((300, 3))
    table = np.column_stack([points, np.sin(points).sum(axis=1)])
    np.savetxt(tmp_path / "table.csv", table, "%.17g", ",", header="x,y,z,value", comments="")
    program("crest", "spline", tmp_path / "table.csv", "--certificate", tmp_path / "cubic.crest",
            "-n", "2", "--quiet")
    spline = crest.spline_samples(points, table[:, 3], n=2)
    assert spline.certificate == (tmp_path / "cubic.crest").read_bytes()


PICTURES = {
    "ridges ellipsoid.off": lambda **k: crest.ridges(*crest.read_mesh("ellipsoid.off"), **k),
    "ridges patch.ply --significance 0":
        lambda **k: crest.ridges(*crest.read_mesh("patch.ply"), significance=0, **k),
    "curvature blend.ply --colour k1":
        lambda **k: crest.curvature(*crest.read_mesh("blend.ply"), colour="k1", **k),
    "features cube.off --angle 60":
        lambda **k: crest.feature_lines(*crest.read_mesh("cube.off"), angle=60, **k),
    "reeb field.vtp --field k1": lambda **k: crest.reeb_graph(*crest.read_field("field.vtp", "k1"), **k),
}


@pytest.mark.parametrize("command", PICTURES)
def test_pictures_are_the_programs(command, here, tmp_path):
    program("crest", *command.split(), "--picture", tmp_path / "program.png", "--view=1,2,-1",
            "--quiet")
    PICTURES[command](picture=tmp_path / "python.png", view=(1, 2, -1))
    assert (tmp_path / "python.png").read_bytes() == (tmp_path / "program.png").read_bytes()
    with pytest.raises(crest.InputError):
        PICTURES[command](picture=tmp_path / "python.jpg")


def test_orders_and_types_of_arrays(here):
    V, F = crest.read_mesh("ellipsoid.off")
    expected = crest.ridges(V, F).certificate
    strided = np.zeros((len(V), 7))
    strided[:, ::3] = V
    views = [np.asfortranarray(V), strided[:, ::3], V[::-1][::-1], V.tolist(),
             V.astype(V.dtype.newbyteorder())]
    for given in views:
        assert crest.ridges(given, F).certificate == expected
    for kind in (np.int32, np.uint32, np.uint64, np.uint16, np.dtype(">i4")):
        assert crest.ridges(V, np.asfortranarray(F.astype(kind))).certificate == expected
    assert crest.ridges(V, F.tolist()).certificate == expected
    single = V.astype(np.float32)
    assert (crest.ridges(single, F).certificate
            == crest.ridges(single.astype(np.float64), F).certificate != expected)


def test_threads(here):
    V, F = crest.read_mesh("blend.ply")
    expected = crest.ridges(V, F, threads=1).certificate
    found = []

    def work(threads):
        found.append(crest.ridges(V, F, threads=threads).certificate)

    workers = [threading.Thread(target=work, args=(n,)) for n in (0, 1, 2, 5)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert found == 4 * [expected]


def test_verify(here, tmp_path):
    V, F = crest.read_mesh("ellipsoid.off")
    certificate = crest.ridges(V, F).certificate
    for given in (certificate, bytearray(certificate), memoryview(certificate),
                  np.frombuffer(certificate, np.uint8)):
        verdict = crest.verify(given, mesh=(V, F))
        assert verdict and verdict.accepted and len(verdict.claims) > 1 and verdict.reason == ""
    (tmp_path / "c.crest").write_bytes(certificate)
    verdict = crest.verify(certificate)
    said = program("crest-verify", tmp_path / "c.crest").splitlines()
    assert said == [*verdict.claims, "data digest: " + verdict.data_digest, "ACCEPTED"]
    assert crest.verify(certificate, arithmetic="mpfr")
    moved = V.copy()
    moved[7, 1] += 1e-9
    assert not crest.verify(certificate, mesh=(moved, F))
    rng = np.random.default_rng(5)
    for at in rng.integers(0, len(certificate), 25):
        broken = bytearray(certificate)
        broken[at] ^= 1 << int(rng.integers(8))
        verdict = crest.verify(broken)
        assert not verdict and verdict.reason
    for end in (0, 1, 40, len(certificate) - 1):
        assert not crest.verify(certificate[:end])
