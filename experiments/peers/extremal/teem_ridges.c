/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Ridge surfaces of a volume by Teem's seek, as columns of a table (README.md beside this file):
     teem_ridges VOLUME.nrrd TYPE STRENGTH EVAL-DIFF RUNS
   TYPE: RidgeSurface or RidgeSurfaceT (Schultz, Theisel, Seidel 2010). Prints triangles, edges with 1,
   3, and 4 or more triangles after points nearer than 1e-5 are welded, least processor seconds. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <teem/gage.h>
#include <teem/limn.h>
#include <teem/seek.h>
#include <time.h>

static void fail(const char* key) {
  char* words = key ? biffGetDone(key) : NULL;
  fprintf(stderr, "teem_ridges: %s\n", words ? words : "bad arguments");
  exit(3);
}

static limnPolyData* ridges(const Nrrd* volume, int type, double strength, double eval_diff,
                            double* seconds) {
  const double none[NRRD_KERNEL_PARMS_NUM] = {0};
  const clock_t start = clock();
  limnPolyData* mesh = limnPolyDataNew();
  gageContext* gage = gageContextNew();
  gagePerVolume* values = gagePerVolumeNew(gage, volume, gageKindScl);
  seekContext* seek = seekContextNew();
  if (!values || gagePerVolumeAttach(gage, values) ||
      gageKernelSet(gage, gageKernel00, nrrdKernelBSpline3, none) ||
      gageKernelSet(gage, gageKernel11, nrrdKernelBSpline3D, none) ||
      gageKernelSet(gage, gageKernel22, nrrdKernelBSpline3DD, none) ||
      gageQueryItemOn(gage, values, gageSclGradVec) ||
      gageQueryItemOn(gage, values, gageSclHessEval) ||
      gageQueryItemOn(gage, values, gageSclHessEvec) ||
      gageQueryItemOn(gage, values, gageSclHessian) ||
      gageQueryItemOn(gage, values, gageSclHessEval2) || gageUpdate(gage))
    fail(GAGE);
  if (seekDataSet(seek, NULL, gage, 0) || seekTypeSet(seek, type) ||
      seekItemGradientSet(seek, gageSclGradVec) ||
      seekItemEigensystemSet(seek, gageSclHessEval, gageSclHessEvec) ||
      seekItemHessSet(seek, gageSclHessian) || seekItemStrengthSet(seek, gageSclHessEval2) ||
      seekStrengthUseSet(seek, 1) || seekStrengthSet(seek, -1, strength) ||
      seekEvalDiffThreshSet(seek, eval_diff) || seekUpdate(seek) || seekExtract(seek, mesh))
    fail(SEEK);
  *seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
  seekContextNix(seek);
  gageContextNix(gage);
  return mesh;
}

struct Point {
  double x[3];
  unsigned id;
};
struct Edge {
  unsigned low, high;
};
static int by_place(const void* a, const void* b) {
  return memcmp(((const struct Point*)a)->x, ((const struct Point*)b)->x, sizeof(double[3]));
}
static int by_ends(const void* a, const void* b) {
  const struct Edge *p = a, *q = b;
  if (p->low != q->low) return p->low < q->low ? -1 : 1;
  return p->high < q->high ? -1 : p->high > q->high;
}

/* Numbers points alike that round to one multiple of 1e-5. */
static unsigned* weld(const limnPolyData* mesh) {
  const unsigned n = mesh->xyzwNum;
  struct Point* points = malloc((n + 1) * sizeof *points);
  unsigned* number = malloc((n + 1) * sizeof *number);
  for (unsigned i = 0; i < n; ++i) {
    for (int k = 0; k < 3; ++k)
      points[i].x[k] = floor(mesh->xyzw[4 * i + k] / mesh->xyzw[4 * i + 3] * 1e5 + 0.5) + 0.0;
    points[i].id = i;
  }
  qsort(points, n, sizeof *points, by_place);
  for (unsigned i = 0; i < n; ++i)
    number[points[i].id] =
        i > 0 && by_place(points + i, points + i - 1) == 0 ? number[points[i - 1].id] : points[i].id;
  free(points);
  return number;
}

static void count_edges(const limnPolyData* mesh, size_t valence[4]) {
  unsigned* number = weld(mesh);
  struct Edge* edges = malloc((mesh->indxNum + 1) * sizeof *edges);
  size_t count = 0;
  for (unsigned i = 0; i + 2 < mesh->indxNum; i += 3) {
    unsigned v[3];
    for (int k = 0; k < 3; ++k) v[k] = number[mesh->indx[i + k]];
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) continue; /* nothing after the welding */
    for (int k = 0; k < 3; ++k) {
      const unsigned a = v[k], b = v[(k + 1) % 3];
      edges[count].low = a < b ? a : b;
      edges[count++].high = a < b ? b : a;
    }
  }
  qsort(edges, count, sizeof *edges, by_ends);
  for (size_t i = 0, end; i < count; i = end) {
    for (end = i; end < count && by_ends(edges + i, edges + end) == 0;) ++end;
    ++valence[end - i < 4 ? end - i - 1 : 3];
  }
  free(edges);
  free(number);
}

int main(int argc, char** argv) {
  if (argc != 6) fail(NULL);
  Nrrd* volume = nrrdNew();
  if (nrrdLoad(volume, argv[1], NULL)) fail(NRRD);
  const int type = airEnumVal(seekType, argv[2]), runs = atoi(argv[5]);
  if (type == airEnumUnknown(seekType) || runs < 1) fail(NULL);
  limnPolyData* mesh = NULL;
  double least = HUGE_VAL;
  for (int i = 0; i < runs; ++i) {
    double seconds;
    if (mesh) limnPolyDataNix(mesh);
    mesh = ridges(volume, type, atof(argv[3]), atof(argv[4]), &seconds);
    if (seconds < least) least = seconds;
  }
  size_t valence[4] = {0};
  count_edges(mesh, valence);
  printf("%u %zu %zu %zu %.3f\n", mesh->indxNum / 3, valence[0], valence[2], valence[3], least);
  limnPolyDataNix(mesh);
  nrrdNuke(volume);
  return 0;
}
