# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -D SOURCE=.. -D TO=.. [-D IO=ON] -P public_headers.cmake
# Copies the public headers and all that they include, and nothing else, to TO/crest and writes
# their includes with that prefix. Public are of each system its call (NAME.hpp) and its
# certificate, and those listed here; io's need VTK.
cmake_minimum_required(VERSION 3.25)
set(public
  algorithms/curvature/focal.hpp
  algorithms/feature_lines/sharp_edges.hpp
  algorithms/reeb/contour_tree.hpp
  algorithms/reeb/contours.hpp
  algorithms/reeb/contraction.hpp
  algorithms/reeb/merge_trees.hpp
  algorithms/reeb/persistence.hpp
  algorithms/reeb/reeb_graph.hpp
  algorithms/reeb/segmentation.hpp
  algorithms/reeb/tile_complex.hpp
  algorithms/ridges/auto_scale.hpp
  algorithms/ridges/salience.hpp
  algorithms/smooth_ridges/surface.hpp
  algorithms/sampling/plain_surfaces.hpp
  algorithms/splines/quadratic_certificate.hpp
  certify/certificate.hpp
  certify/verify.hpp
  kernel/arithmetic/self_test.hpp
  kernel/geometry/input_error.hpp)
if(IO)
  list(APPEND public io/read/mesh_reader.hpp io/read/point_reader.hpp io/read/quadratic_reader.hpp
    io/read/volume_reader.hpp)
  file(GLOB writers RELATIVE ${SOURCE} ${SOURCE}/io/*/*_writer.hpp ${SOURCE}/io/*/*_picture.hpp)
  list(APPEND public ${writers})
endif()
set(internal algorithms/smooth_ridges/certificate.hpp)  # its call returns the certificate
file(GLOB encoders RELATIVE ${SOURCE} ${SOURCE}/certify/*/encode.hpp)
list(APPEND public ${encoders})
file(GLOB systems RELATIVE ${SOURCE} ${SOURCE}/algorithms/*)
foreach(system ${systems})
  get_filename_component(name ${system} NAME)
  foreach(header ${system}/${name}.hpp ${system}/certificate.hpp)
    if(EXISTS ${SOURCE}/${header} AND NOT header IN_LIST internal)
      list(APPEND public ${header})
    endif()
  endforeach()
endforeach()

file(REMOVE_RECURSE ${TO}/crest)
set(copied)
while(public)
  list(POP_FRONT public header)
  if(header IN_LIST copied)
    continue()
  endif()
  list(APPEND copied ${header})
  file(READ ${SOURCE}/${header} text)
  string(REGEX MATCHALL "#include \"[^\"]+\"" includes "${text}")
  foreach(include ${includes})
    string(REGEX REPLACE "#include \"(.*)\"" "\\1" include "${include}")
    list(APPEND public ${include})
  endforeach()
  string(REPLACE "#include \"" "#include \"crest/" text "${text}")
  file(WRITE ${TO}/crest/${header} "${text}")
endwhile()
