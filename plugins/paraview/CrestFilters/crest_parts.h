// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef crest_parts_h
#define crest_parts_h

// Parts of what the command line writes into one file, a part an output.
#include <initializer_list>

class vtkPolyData;

/// The cells of `whole` whose number in `array` is one of these, with their points and all arrays,
/// into the empty `part`; points in the order of `whole`.
void take_part(vtkPolyData& whole, const char* array, std::initializer_list<int> values,
               vtkPolyData& part);
/// The others.
void take_rest(vtkPolyData& whole, const char* array, std::initializer_list<int> values,
               vtkPolyData& part);

#endif
