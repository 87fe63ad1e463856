// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Data sets in pieces, a file each, which several processes of ParaView read side by side.
#include <string>

class vtkPolyData;
class vtkUnstructuredGrid;

namespace crest::io {

/// Cells of each piece (the last has what is left) of so many: 50 000, or more where those were
/// more than 256 pieces. By the data alone: files are the same for any number of processes and
/// threads.
long long cells_a_piece(long long cells);

/// x.pvtp, and beside it x_0.vtp, x_1.vtp, ...: cells in their order, `most` a piece (0: as above),
/// with their points, ascending; points of no cell are in the first. A point on a border is in
/// several pieces, with one number of GlobalPointIds, its place in the whole. Texts of points and
/// cells are left out, those of the whole are in each piece. x.pvtp, which names
/// the others, is written last. Throws: as write_vtp() does.
void write_pvtp(const std::string& path, vtkPolyData& data, long long most = 0);
/// x.pvtu and x_0.vtu, ..., likewise.
void write_pvtu(const std::string& path, vtkUnstructuredGrid& data, long long most = 0);

}  // namespace crest::io
