# SPDX-License-Identifier: GPL-3.0-or-later
"""Several processes: mpirun -np 2 pvbatch ranks.py. A part of the mesh on each is refused; all of it on
one, or brought to one, gives the certificate of one process."""
import unittest

import support
from certificates import ELLIPSOID
from paraview import servermanager, simple
from support import Messages, cells, crest, fetch, opened, path

RANKS = servermanager.vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()


class Ranks(unittest.TestCase):
    def same(self, ridges, program):
        ridges.CertificateFile = path(self.id())
        messages = Messages.of_update(ridges)
        self.assertEqual(messages.errors, [])
        self.assertEqual(support.digest(self.id()), support.digest(program))

    def setUp(self):
        self.assertGreater(RANKS, 1)
        self.input = opened(*ELLIPSOID)
        crest("ridges", "ellipsoid.vtp", "--certificate", "one")

    def test_whole_on_one(self):
        self.same(simple.CrestRidges(Input=self.input), "one")

    def test_parts_are_refused(self):
        parts = simple.Sphere(ThetaResolution=40, PhiResolution=40)
        for filter in (simple.CrestRidges(Input=parts), simple.CrestReebGraph(Input=parts, Expression="x"),
                       simple.CrestFeatureLines(Input=parts)):
            messages = Messages.of_update(filter)
            self.assertEqual(len(messages.errors), 1)
            self.assertIn("several processes hold parts", messages.errors[0])
            self.assertEqual(cells(filter), 0)
        wavelet = simple.Wavelet(WholeExtent=[-8, 8, -8, 8, -8, 8])
        for filter in (simple.CrestExtremalSurface(Input=wavelet), simple.CrestSplineIsosurface(Input=wavelet)):
            messages = Messages.of_update(filter)
            self.assertEqual(len(messages.errors), 1)
            self.assertEqual(cells(filter), 0)

    def test_brought_to_one(self):
        parts = simple.Sphere(ThetaResolution=40, PhiResolution=40)
        whole = simple.AggregateDataset(Input=parts, NumberOfTargetProcesses=1)
        reeb = simple.CrestReebGraph(Input=whole, Expression="x", Weld=1e-6)
        messages = Messages.of_update(reeb)
        self.assertEqual(messages.errors, [])
        self.assertEqual(cells(reeb, 0), 1)

    def test_source(self):
        """A source works on one process alone."""
        ridges = simple.CrestSmoothRidges(Surface="x^2 + y^2/2.25 + z^2/4 - 1")
        crest("ridges", "--surface", "x^2 + y^2/2.25 + z^2/4 - 1", "--box=-3,3", "-o", "smooth.vtp",
              "--certificate", "smooth")
        self.same(ridges, "smooth")
        file = simple.XMLPolyDataReader(FileName=[path("smooth.vtp")])
        self.assertEqual(cells(ridges), fetch(file).GetNumberOfLines())


if __name__ == "__main__":
    support.main()
