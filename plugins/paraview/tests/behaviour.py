# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors, warnings, empty inputs, abort, chosen arrays, colours: how the filters behave."""
import os
import struct
import unittest

import support
from certificates import BLEND, ELLIPSOID, HANDLES, LATTICE, SHEET, TWIST
from paraview import simple
from support import Messages, cells, fetch, opened, path


def polygons(name, points, faces):
    """A surface as a legacy file."""
    numbers = [number for face in faces for number in (len(face), *face)]
    with open(path(name), "wb") as f:
        f.write(b"# vtk DataFile Version 3.0\nq\nBINARY\nDATASET POLYDATA\nPOINTS %d double\n" % len(points))
        f.write(b"".join(struct.pack(">3d", *p) for p in points))
        f.write(b"\nPOLYGONS %d %d\n" % (len(faces), len(numbers)))
        f.write(struct.pack(">%di" % len(numbers), *numbers) + b"\n")
    return simple.LegacyVTKReader(FileNames=[path(name)])


class Behaviour(unittest.TestCase):
    def setUp(self):
        if os.path.exists(path(self.id())):
            os.remove(path(self.id()))

    def refused(self, filter, *words):
        """One message of one line with these words, in the words of the properties; no output."""
        certificate = path(self.id())
        filter.CertificateFile = certificate
        messages = Messages.of_update(filter)
        self.assertEqual(len(messages.errors), 1, messages.errors)
        line = messages.errors[0].split("): ", 1)[1].strip()
        self.assertNotIn("\n", line)
        self.assertNotIn("--", line)
        for word in words:
            self.assertIn(word, line)
        for port in range(filter.GetNumberOfOutputPorts()):
            self.assertEqual(cells(filter, port), 0)
        self.assertFalse(os.path.exists(certificate))

    def test_edge_of_three_faces(self):
        book = polygons("book.vtk", [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (0, -1, 0)],
                        [(0, 1, 2), (0, 1, 3), (0, 1, 4)])
        self.refused(simple.CrestRidges(Input=book), "edge", "Split")

    def test_mended_by_property(self):
        book = polygons("book.vtk", [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (0, -1, 0)],
                        [(0, 1, 2), (0, 1, 3), (0, 1, 4)])
        reeb = simple.CrestReebGraph(Input=book, Expression="x + 2*y + 3*z", Split=1)
        messages = Messages.of_update(reeb)
        self.assertEqual(messages.errors, [])
        self.assertTrue(any("cut the surface" in line for line in messages.warnings), messages.warnings)
        self.assertGreater(cells(reeb), 0)

    def test_not_finite(self):
        bad = polygons("nan.vtk", [(0, 0, 0), (1, 0, 0), (0, float("nan"), 0)], [(0, 1, 2)])
        self.refused(simple.CrestFeatureLines(Input=bad), "vertex 2", "is not a number")

    def test_words_of_properties(self):
        self.refused(simple.CrestRidges(Input=opened(*ELLIPSOID), SupportMode="Radius", SupportRadius=0),
                     "SupportRadius")
        for word in ("1", "2", "1/0", "half", "0.123456789123"):
            self.refused(simple.CrestModeSurface(Input=opened(*TWIST), Mode=word), "Mode " + word)
        self.refused(simple.CrestModeSurface(Input=opened(*TWIST), Mode=""), "Mode")
        self.refused(simple.CrestReebGraph(Input=opened(*HANDLES), Expression="x +"), "Expression")
        self.refused(simple.CrestFeatureLines(Input=opened(*BLEND), Source="Angle", Angle="steep"), "Angle")
        self.refused(simple.CrestSmoothRidges(Surface="x^2 + w"), "Surface")

    def test_no_such_array(self):
        self.refused(simple.CrestReebGraph(Input=opened(*HANDLES), Field=["POINTS", "nothing"]),
                     "nothing", "does not exist")
        self.refused(simple.CrestVectorFieldSkeleton(Input=opened(*LATTICE), Vectors=["POINTS", "nothing"]),
                     "nothing", "flow")

    def test_place_that_cannot_be_written(self):
        ridges = simple.CrestRidges(Input=opened(*ELLIPSOID), CertificateFile=path("no/such/folder/x"))
        messages = Messages.of_update(ridges)
        self.assertEqual(len(messages.errors), 1, messages.errors)
        self.assertEqual(cells(ridges), 0)

    def test_errors_pass(self):
        """A filter that failed works again once the property is mended."""
        reeb = simple.CrestReebGraph(Input=opened(*HANDLES), Expression="x +")
        self.assertEqual(len(Messages.of_update(reeb).errors), 1)
        reeb.Expression = "x"
        self.assertEqual(Messages.of_update(reeb).errors, [])
        self.assertGreater(cells(reeb), 0)

    def test_empty_input(self):
        """Nothing gives nothing, without a message."""
        nothing = simple.Threshold(Input=opened(*TWIST), Scalars=["POINTS", "stress"], LowerThreshold=1e9,
                                   UpperThreshold=2e9)
        surface = simple.ExtractSurface(Input=nothing)
        for filter in (simple.CrestModeSurface(Input=nothing), simple.CrestRidges(Input=surface),
                       simple.CrestReebGraph(Input=surface, Expression="x")):
            messages = Messages.of_update(filter)
            self.assertEqual(messages.errors + messages.warnings, [])
            self.assertEqual(cells(filter), 0)

    def test_points_without_faces(self):
        cloud = polygons("cloud.vtk", [(0, 0, 0), (1, 0, 0), (0, 1, 0)], [])
        self.refused(simple.CrestRidges(Input=cloud), "face")

    def test_abort(self):
        """At the next step the work ends, without outputs, certificate or message; then it can be done."""
        for make in (lambda: simple.CrestRidges(Input=opened(*ELLIPSOID)),
                     lambda: simple.CrestReebGraph(Input=opened(*HANDLES), Expression="x"),
                     lambda: simple.CrestModeSurface(Input=opened(*TWIST)),
                     lambda: simple.CrestExtremalSurface(Input=opened(*SHEET)),
                     lambda: simple.CrestVectorFieldSkeleton(Input=opened(*LATTICE)),
                     lambda: simple.CrestSmoothRidges()):
            filter = make()
            filter.CertificateFile = path(self.id())
            algorithm = filter.GetClientSideObject()
            steps = []

            def stop(caller, event):
                steps.append(caller.GetProgress())
                if caller.GetProgress() > 0:
                    caller.SetAbortExecute(1)
            observer = algorithm.AddObserver("ProgressEvent", stop)
            messages = Messages(filter)
            filter.UpdatePipeline()
            self.assertGreater(len(steps), 1, filter)
            self.assertEqual(messages.errors, [])
            self.assertEqual(cells(filter), 0)
            self.assertFalse(os.path.exists(path(self.id())))
            filter.CertificateFile = ""
            algorithm.RemoveObserver(observer)
            algorithm.SetAbortExecute(0)
            algorithm.Modified()
            filter.UpdatePipeline()
            self.assertGreater(fetch(filter).GetNumberOfPoints(), 0, filter)

    def test_threads(self):
        """The certificate does not depend on them."""
        bytes_of = set()
        for threads in (1, 2, 5):
            ridges = simple.CrestRidges(Input=opened(*ELLIPSOID), Threads=threads,
                                        CertificateFile=path(f"threads{threads}"))
            ridges.UpdatePipeline()
            bytes_of.add(support.digest(f"threads{threads}"))
        self.assertEqual(len(bytes_of), 1)

    def test_passes_arrays(self):
        """The meshes that come out keep the input's arrays."""
        input = simple.Calculator(Input=opened(*ELLIPSOID), ResultArrayName="height", Function="coordsZ")
        for filter, port in ((simple.CrestRidges(Input=input), 2), (simple.CrestCurvature(Input=input), 0),
                             (simple.CrestFeatureLines(Input=input), 1)):
            filter.UpdatePipeline()
            mesh = fetch(filter, port)
            height = mesh.GetPointData().GetArray("height")
            self.assertEqual([height.GetValue(v) for v in range(mesh.GetNumberOfPoints())],
                             [mesh.GetPoint(v)[2] for v in range(mesh.GetNumberOfPoints())])


if __name__ == "__main__":
    support.main()
