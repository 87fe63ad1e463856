#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs every command on inputs of `crest sample` and prints the sha256 of all that comes out: files,
# certificates, reports (without versions, times, memory) and the terminal's lines (without times).
# A change that is meant to change outputs makes outputs.sha256 anew and says why:
#   mkdir /tmp/outputs && cd /tmp/outputs && PATH=BUILD/cli:$PATH sh REPOSITORY/tests/cli/outputs.sh \
#     >REPOSITORY/tests/cli/outputs.sha256
set -eu
export LC_ALL=C
number=0
# run CODE COMMAND...: what the command says goes to a file of its own.
run() {
  expected=$1
  shift
  number=$((number + 1))
  code=0
  "$@" --threads 2 >"$number.txt" 2>&1 || code=$?
  if [ "$code" -ne "$expected" ]; then
    echo "exit code $code instead of $expected: $*" >&2
    cat "$number.txt" >&2
    exit 1
  fi
}
sample() {
  run 0 crest sample "$@"
}

sample ellipsoid --parameters 1,1.5,2 --rotate --vertices 1200 -o ellipsoid.off --report ellipsoid.json
sample ellipsoid --noise 0.05 --seed 7 --vertices 1500 -o noisy.obj
sample blend --vertices 1500 -o blend.ply
sample torus --rotate --vertices 800 -o torus.vtp --report torus.json
sample handles --parameters 2 --vertices 1500 -o handles.off
sample sphere --vertices 400 -o sphere.obj
sample umbilic-patch --vertices 900 -o patch.ply
sample plane --vertices 200 -o plane.off
sample moebius-sheet --nodes 24 -o moebius.nrrd --report moebius.json
sample sphere-shell --nodes 24 -o shell.vti
sample hemisphere-points --vertices 500 --noise 0.01 -o points.xyz
sample block-twist --vertices 700 -o twist.vtu --report twist.json
sample lattice --seed 5 --parameters 16,1 -o lattice.vtu --report lattice.json

run 0 crest ridges ellipsoid.off -o r1.vtp --picture r1.svg --certificate r1.crest --report r1.json --cite
run 0 crest ridges noisy.obj --scale auto -o r2.obj --certificate r2.crest --report r2.json
run 0 crest ridges blend.ply --smooth 3 --crest-only --min-length 0.02 -o r3.ply --picture r3.png --report r3.json
run 0 crest ridges patch.ply --rings 2 --order 3 -o r4.vtp --certificate r4.crest --report r4.json
run 0 crest ridges torus.vtp -o r5.vtp --certificate r5.crest --report r5.json

run 0 crest spline moebius.nrrd --isovalue 0.4 --picture q1.png --size 96 --certificate q1.crest \
  -o q1.vti --report q1.json --cite
run 0 crest spline q1.vti --isovalue 0.4 --picture q2.svg --size 64 --mesh q2.vtp --report q2.json
run 0 crest spline shell.vti --border extend --isovalue 0.31 --mesh q3.ply --certificate q3.crest --report q3.json

run 0 crest curvature ellipsoid.off --corners -o c1.vtp --focal c1-focal.vtp --picture c1.svg --report c1.json --cite
run 0 crest curvature ellipsoid.off --method cf --reference ellipsoid --parameters 1,1.5,2 --rotate \
  -o c2.ply --focal-picture c2.svg --report c2.json
run 0 crest curvature torus.vtp --method normal-cycle -o c3.vtu --picture c3.png --colour K --report c3.json

run 0 crest features blend.ply --threshold 0.8 --close 1 --prune 3 --min-patch 4 --close-branches 4 \
  -o f1.vtp --picture f1.svg --certificate f1.crest --report f1.json --cite
run 0 crest features c1.vtp --field H --absolute -o f2.obj --picture f2.png --certificate f2.crest --report f2.json

run 0 crest features handles.off --angle 25 --prune 2 --close-branches 2 -o f3.vtp --patches f3-patches.ply \
  --picture f3.png --certificate f3.crest --report f3.json --cite
run 0 crest features noisy.obj --angle 20 --over 2 --prune 3 -o f4.obj --patches f4-patches.vtp --report f4.json

run 0 crest reeb handles.off --expression x --linear --persistence 0.05 --cancel-loops -o g1.vtp \
  --picture g1.svg --certificate g1.crest --report g1.json --cite
run 0 crest reeb ellipsoid.off --expression 'x*x - y*z' --join-tree --split-tree --contour-tree --level 0.1 \
  -o g2.vtp --certificate g2.crest --report g2.json
run 0 crest reeb sphere.obj --expression 'x^3 - 3*x*y^2 + 0.2*z' --contract --segmentation -o g3.vtu \
  --picture g3.png --certificate g3.crest --report g3.json
run 0 crest reeb c1.vtp --field K --level -0.5 --level 0 -o g4.vtp --report g4.json
run 0 crest reeb plane.off --expression 'x*y' -o g5.vtp --certificate g5.crest --report g5.json

run 0 crest ridges --param 'u; v; u^2 + 0.5*v^2 + 0.2*u^3 + 0.3*u*v^2 + 0.1*v^3' --domain '-0.5,0.6,-0.5,0.6' \
  -o s1.vtp --mesh s1-mesh.vtp --picture s1.svg --certificate s1.crest --report s1.json --cite
run 0 crest ridges --surface 'x^2 + y^2/2.25 + z^2/4 - 1' --box '-3,3' -o s2.obj --mesh s2-mesh.off \
  --certificate s2.crest --report s2.json
run 4 crest ridges --surface 'x^2 + y^2 + z^2 - 1' --box '-2,2' --start-faces 50 --max-depth 1 -o s3.vtp \
  --mesh s3-mesh.ply --picture s3.png --certificate s3.crest --report s3.json

run 0 crest extremal moebius.nrrd --ridge --min-value 0.4 -o e1.vtp --picture e1.svg --certificate e1.crest \
  --report e1.json --cite
run 0 crest extremal shell.vti --valley --definition hessian --critical -o e2.ply --picture e2.png --report e2.json
run 0 crest extremal shell.vti --ridge --sigma 1.5 --min-value 0.3 -o e3.obj --report e3.json

run 0 crest extremal points.xyz --surface --radius 0.25 --depth 5 -o e4.vtp --picture e4.png --report e4.json

run 0 crest modes twist.vtu --mode 0.6 --neutral -o m1.vtp --picture m1.png --certificate m1.crest \
  --report m1.json --cite
run 0 crest modes twist.vtu --degenerate -o m2.vtp --certificate m2.crest --report m2.json

run 0 crest skeleton lattice.vtu -o k1.vtp --picture k1.png --certificate k1.crest --report k1.json --cite
run 0 crest compress lattice.vtu -o k2.vtu --certificate k2.crest --report k2.json --cite
run 0 crest compress lattice.vtu --equivalence relaxed --test thesis -o k3.vtu --report k3.json

# 600 samples of a function on numbers of a generator of Lehmer's.
awk 'function draw() { state = state * 48271 % 2147483647; return state / 2147483648 }
  BEGIN { state = 20041; print "x,y,z,value"
    for (i = 0; i < 600; ++i) { x = draw(); y = draw(); z = draw(); printf "%.17g,%.17g,%.17g,%.17g\n", x, y, z, x * y - z * z * z * z * x } }' \
  >samples.csv
run 0 crest spline samples.csv -o p1.vti --certificate p1.crest --report p1.json --evaluate samples.csv \
  --values p1.csv --cite
run 0 crest spline samples.csv --smoothness local -n 3,4,5 --box 0,1 -o p2.vti --certificate p2.crest --report p2.json
run 0 crest spline samples.csv --smoothness sequential -o p3.vti --report p3.json
run 0 crest spline p1.vti --evaluate samples.csv --values p4.csv --report p4.json
run 0 crest lineart c1.vtp --style contours --camera 1,0.5,2,0,0,0 -o l1.svg --certificate l1.crest --report l1.json --cite
run 0 crest lineart sphere.obj -o l2.svg --save-sidecar l2-sidecar.json --report l2.json
run 0 crest encode ellipsoid.off -o z1.cmc --certificate z1.crest --report z1.json --permutation z1.txt --cite
run 0 crest decode z1.cmc -o z1.ply --report z1d.json
run 0 crest encode noisy.obj --tolerance 0.001 --keep-order --method valence -o z2.cmc --report z2.json
run 0 crest decode z2.cmc -o z2.off
run 0 crest encode blend.ply --connectivity-only --method zigzag -o z3.cmc
run 0 crest strips ellipsoid.off -o t1.vtp --picture t1.png --index-buffer t1.bin --report t1.json --cite
run 0 crest strips torus.vtp --tree --no-swaps -o t2.vtp --report t2.json

for report in *.json; do
  sed -E -i '/^  "(crest|peak_rss_bytes)": /d; /^  "seconds": /,/^  }/s/: [0-9].*[0-9]/: 0/' "$report"
done
sed -E -i '/^(time|certificate): /d' ./*.txt
sha256sum -- *
