#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# certificates.sh FOLDER: a certificate or more of every claim, made by the crest of PATH.
set -eu
cd "$1"
make() {
  crest "$@" --quiet >/dev/null
}
make sample ellipsoid --parameters 1,1.5,2 --rotate --vertices 1200 -o ellipsoid.off
make sample blend --vertices 1500 -o blend.ply
make sample torus --rotate --vertices 800 -o torus.off
make sample handles --parameters 2 --vertices 1500 -o handles.off
make sample plane --vertices 200 -o plane.off
make sample moebius-sheet --nodes 24 -o moebius.nrrd
make sample sphere-shell --nodes 24 -o shell.vti
make sample block-twist --vertices 700 -o twist.vtu
make sample lattice --seed 5 --parameters 16,1 -o lattice.vtu
# Numbers of a generator of Lehmer's.
awk 'function draw() { state = state * 48271 % 2147483647; return state / 2147483648 }
  BEGIN { state = 20041; print "x,y,z,value"
    for (i = 0; i < 600; ++i) { x = draw(); y = draw(); z = draw(); printf "%.17g,%.17g,%.17g,%.17g\n", x, y, z, x * y - z * z * z * z * x } }' \
  >samples.csv

make ridges ellipsoid.off --certificate ridges-mesh.crest
make ridges torus.off --certificate ridges-mesh-torus.crest
make features blend.ply --threshold 0.8 --prune 3 --certificate features-mesh.crest
make features handles.off --angle 25 --certificate sharp-edges.crest
make reeb handles.off --expression x --linear --certificate reeb-linear.crest
make reeb ellipsoid.off --expression 'x*x - y*z' --certificate reeb.crest
make reeb plane.off --expression 'x*y' --certificate reeb-ties.crest
make ridges --param 'u; v; u^2 + 0.5*v^2 + 0.2*u^3 + 0.3*u*v^2 + 0.1*v^3' --domain '-0.5,0.6,-0.5,0.6' \
  --certificate ridges-smooth-param.crest
make ridges --surface 'x^2 + y^2/2.25 + z^2/4 - 1' --box '-3,3' --certificate ridges-smooth.crest
make modes twist.vtu --mode 0.6 --neutral --certificate modes.crest
make modes twist.vtu --degenerate --certificate modes-curves.crest
make extremal moebius.nrrd --ridge --min-value 0.4 --certificate extremal.crest
make skeleton lattice.vtu --certificate skeleton.crest
make compress lattice.vtu -o compressed.vtu --certificate compression.crest
make spline moebius.nrrd --isovalue 0.4 --picture rays.png --size 96 --certificate spline-rays.crest
make spline shell.vti --border extend --isovalue 0.31 --mesh shell.ply --certificate spline-isosurface.crest
make spline samples.csv --smoothness local -n 3,4,5 --box 0,1 -o cubic.vti --certificate spline-cubic.crest
make encode ellipsoid.off -o ellipsoid.cmc --certificate coding.crest
make lineart torus.off --style contours --camera 1,0.5,2,0,0,0 -o torus.svg --certificate lineart.crest
