// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The public calls of splines (theory and limits: README.md beside this file): quadratic ones of
// volumes, with rays and meshes of their isosurfaces; cubic ones of scattered samples.
#include "algorithms/splines/cubic_evaluate.hpp"
#include "algorithms/splines/cubic_fit.hpp"
#include "algorithms/splines/isosurface.hpp"
#include "algorithms/splines/quadratic.hpp"
#include "algorithms/splines/rays.hpp"
