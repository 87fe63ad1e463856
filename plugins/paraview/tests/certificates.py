# SPDX-License-Identifier: GPL-3.0-or-later
"""Every filter's certificate is the command line's, byte for byte, and accepted; counts are those of
its files."""
import os
import subprocess
import unittest

import support
from paraview import simple
from support import cells, crest, field, fetch, opened, path

ELLIPSOID = ("ellipsoid.vtp", "ellipsoid", "--parameters", "1,1.5,2", "--rotate", "--vertices", "1200")
HANDLES = ("handles.vtp", "handles", "--parameters", "2", "--vertices", "1500")
NOISY = ("noisy.vtp", "ellipsoid", "--noise", "0.05", "--seed", "7", "--vertices", "1500")
BLEND = ("blend.vtp", "blend", "--vertices", "1500")
TWIST = ("twist.vtu", "block-twist", "--vertices", "700")
SHEET = ("moebius.vti", "moebius-sheet", "--nodes", "24")
SHELL = ("shell.vti", "sphere-shell", "--nodes", "24")
LATTICE = ("lattice.vtu", "lattice", "--seed", "5", "--parameters", "16,1")


class Certificates(unittest.TestCase):
    def same(self, filter, command, code=0, certified="1"):
        """Runs both; the filter's outputs speak of the certificate."""
        plugin, program = self.id() + ".plugin", self.id() + ".program"
        filter.CertificateFile = path(plugin)
        filter.Verify = 1
        filter.UpdatePipeline()
        crest(*command, "-o", self.id() + ".vtp", "--certificate", program, code=code)
        self.assertEqual(support.digest(plugin), support.digest(program))
        verdict = subprocess.run([support.VERIFY, path(plugin)], capture_output=True, text=True)
        self.assertEqual(verdict.returncode, 0, verdict.stdout + verdict.stderr)
        for port in range(filter.GetNumberOfOutputPorts()):
            self.assertEqual(field(filter, "certified", port), certified)
        file = simple.XMLPolyDataReader(FileName=[path(self.id() + ".vtp")])
        self.assertEqual(field(filter, "data_digest"), field(file, "data_digest"))
        return fetch(file)

    def same_arrays(self, filter, port, file):
        """The names of the file's arrays are the output's."""
        output = fetch(filter, port)
        for of in ("GetPointData", "GetCellData"):
            wanted, got = getattr(file, of)(), getattr(output, of)()
            names = {wanted.GetArrayName(i) for i in range(wanted.GetNumberOfArrays())}
            self.assertEqual(names - {got.GetArrayName(i) for i in range(got.GetNumberOfArrays())}, set())

    def test_ridges(self):
        ridges = simple.CrestRidges(Input=opened(*ELLIPSOID))
        file = self.same(ridges, ("ridges", "ellipsoid.vtp"))
        self.assertEqual(cells(ridges, 0), file.GetNumberOfLines())
        self.assertEqual(cells(ridges, 1), file.GetNumberOfVerts())
        self.same_arrays(ridges, 0, file)
        mesh = fetch(ridges, 2)
        self.assertEqual(mesh.GetNumberOfPoints(), fetch(ridges.Input).GetNumberOfPoints())
        self.assertTrue(mesh.GetPointData().HasArray("d1"))

    def test_ridges_auto(self):
        ridges = simple.CrestRidges(Input=opened(*NOISY), SupportMode="Auto (noise)", Keep="Salient")
        file = self.same(ridges, ("ridges", "noisy.vtp", "--scale", "auto", "--salient"))
        self.assertEqual(cells(ridges, 0), file.GetNumberOfLines())

    def test_ridges_radius(self):
        ridges = simple.CrestRidges(Input=opened(*BLEND), SupportMode="Radius", SupportRadius=0.25,
                                    CrestOnly=1, MinLength=0.1)
        file = self.same(ridges, ("ridges", "blend.vtp", "--scale", "0.25", "--crest-only",
                                  "--min-length", "0.1"))
        self.assertEqual(cells(ridges, 0), file.GetNumberOfLines())

    def test_reeb(self):
        reeb = simple.CrestReebGraph(Input=opened(*HANDLES), Expression="x + 0.3*y + 0.1*z", Levels=[0.5])
        file = self.same(reeb, ("reeb", "handles.vtp", "--expression", "x + 0.3*y + 0.1*z", "--level", "0.5",
                                "--segmentation"))
        self.assertEqual(cells(reeb, 0) + cells(reeb, 2), file.GetNumberOfLines())
        self.assertEqual(cells(reeb, 1), file.GetNumberOfVerts())
        self.assertEqual(cells(reeb, 3), file.GetNumberOfPolys())
        self.same_arrays(reeb, 0, file)

    def test_reeb_of_array(self):
        calculator = simple.Calculator(Input=opened(*HANDLES), ResultArrayName="height", Function="coordsX")
        stored = simple.SaveData(path("height.vtp"), proxy=calculator)
        reader = simple.XMLPolyDataReader(FileName=[path("height.vtp")])
        reeb = simple.CrestReebGraph(Input=reader, Field=["POINTS", "height"], Persistence=0.1, CancelLoops=1)
        file = self.same(reeb, ("reeb", "height.vtp", "--field", "height", "--persistence", "0.1",
                                "--cancel-loops"))
        self.assertEqual(cells(reeb, 0), file.GetNumberOfLines())
        self.assertEqual(cells(reeb, 1), file.GetNumberOfVerts())

    def test_features(self):
        features = simple.CrestFeatureLines(Input=opened(*BLEND), Prune=2)
        file = self.same(features, ("features", "blend.vtp", "--prune", "2"))
        self.assertEqual(cells(features, 0), file.GetNumberOfLines() + file.GetNumberOfVerts())
        self.assertEqual(cells(features, 1), file.GetNumberOfPolys())
        self.same_arrays(features, 0, file)

    def test_sharp_edges(self):
        features = simple.CrestFeatureLines(Input=opened(*ELLIPSOID), Source="Angle", Angle="10", Prune=2)
        file = self.same(features, ("features", "ellipsoid.vtp", "--angle", "10", "--prune", "2"))
        self.assertEqual(cells(features, 0), file.GetNumberOfLines() + file.GetNumberOfVerts())

    def test_modes(self):
        modes = simple.CrestModeSurface(Input=opened(*TWIST), Mode="0.5", Neutral=1)
        file = self.same(modes, ("modes", "twist.vtu", "--mode", "0.5", "--neutral"))
        self.assertEqual(cells(modes, 0), file.GetNumberOfPolys())
        self.assertGreater(cells(modes, 0), 0)
        self.same_arrays(modes, 0, file)

    def test_degenerate_curves(self):
        modes = simple.CrestModeSurface(Input=opened(*TWIST), Mode="", Degenerate=1)
        file = self.same(modes, ("modes", "twist.vtu", "--degenerate"))
        self.assertEqual(cells(modes, 1), file.GetNumberOfLines())
        self.assertGreater(cells(modes, 1), 0)

    def test_extremal(self):
        surface = simple.CrestExtremalSurface(Input=opened(*SHEET), UseMinValue=1, MinValue=0.4)
        file = self.same(surface, ("extremal", "moebius.vti", "--ridge", "--min-value", "0.4"))
        self.assertEqual(cells(surface, 0), file.GetNumberOfPolys())
        self.same_arrays(surface, 0, file)

    def test_isosurface(self):
        surface = simple.CrestSplineIsosurface(Input=opened(*SHEET), Isovalue=0.4)
        name = self.id()
        surface.CertificateFile = path(name + ".plugin")
        surface.UpdatePipeline()
        crest("spline", "moebius.vti", "--isovalue", "0.4", "--mesh", name + ".vtp", "--certificate",
              name + ".program")
        self.assertEqual(support.digest(name + ".plugin"), support.digest(name + ".program"))
        self.assertEqual(cells(surface), cells(simple.XMLPolyDataReader(FileName=[path(name + ".vtp")])))

    def test_skeleton(self):
        skeleton = simple.CrestVectorFieldSkeleton(Input=opened(*LATTICE))
        file = self.same(skeleton, ("skeleton", "lattice.vtu"))
        self.assertEqual(cells(skeleton, 0), file.GetNumberOfLines())
        self.assertEqual(cells(skeleton, 1), file.GetNumberOfVerts())

    def test_compress(self):
        small = simple.CrestCompress(Input=opened(*LATTICE), Verify=1)
        name = self.id()
        small.CertificateFile = path(name + ".plugin")
        small.UpdatePipeline()
        crest("compress", "lattice.vtu", "-o", name + ".vtu", "--certificate", name + ".program")
        self.assertEqual(support.digest(name + ".plugin"), support.digest(name + ".program"))
        self.assertEqual(cells(small), cells(simple.XMLUnstructuredGridReader(FileName=[path(name + ".vtu")])))

    def test_smooth_ridges(self):
        ridges = simple.CrestSmoothRidges(Surface="x^2 + y^2/2.25 + z^2/4 - 1", Box=[-3, 3, -3, 3, -3, 3])
        file = self.same(ridges, ("ridges", "--surface", "x^2 + y^2/2.25 + z^2/4 - 1", "--box=-3,3"))
        self.assertEqual(cells(ridges, 0), file.GetNumberOfLines())
        self.assertEqual(cells(ridges, 1), file.GetNumberOfVerts())
        self.same_arrays(ridges, 0, file)

    def test_smooth_patch(self):
        z = "u^2 + 0.5*v^2 + 0.2*u^3 + 0.3*u*v^2 + 0.1*v^3"
        ridges = simple.CrestSmoothRidges(Parametric="X, Y, Z over Domain", X="u", Y="v", Z=z,
                                          Domain="-0.5,0.6,-0.5,0.6")
        self.same(ridges, ("ridges", "--param", "u; v; " + z, "--domain=-0.5,0.6,-0.5,0.6"))

    def test_quads(self):
        """Polygons are cut as the command line cuts them."""
        points = [(x, y, 0.1 * x * x - 0.07 * y * y + 0.02 * x * y) for y in range(9) for x in range(9)]
        with open(path("quads.vtk"), "w") as f:
            f.write("# vtk DataFile Version 3.0\nq\nASCII\nDATASET POLYDATA\nPOINTS 81 double\n")
            f.writelines("%r %r %r\n" % p for p in points)
            f.write("POLYGONS 64 320\n")
            f.writelines("4 %d %d %d %d\n" % (i, i + 1, i + 10, i + 9)
                         for i in range(72) if i % 9 < 8)
        ridges = simple.CrestRidges(Input=simple.LegacyVTKReader(FileNames=[path("quads.vtk")]))
        self.same(ridges, ("ridges", "quads.vtk"))
        self.assertEqual(cells(ridges, 2), 128)

    def test_curvature(self):
        """Estimates: no certificate, but the same numbers."""
        curvature = simple.CrestCurvature(Input=opened(*ELLIPSOID), Method="jet")
        crest("curvature", "ellipsoid.vtp", "--method", "jet", "-o", "jet.vtp")
        file = fetch(simple.XMLPolyDataReader(FileName=[path("jet.vtp")]))
        self.same_arrays(curvature, 0, file)
        wanted, got = (data.GetPointData().GetArray("k1") for data in (file, fetch(curvature)))
        self.assertEqual([wanted.GetValue(i) for i in range(wanted.GetNumberOfValues())],
                         [got.GetValue(i) for i in range(got.GetNumberOfValues())])
        self.assertEqual(field(curvature, "certified"), "0")


if __name__ == "__main__":
    support.main()
