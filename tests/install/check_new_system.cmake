# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -D SOURCE=.. -D WORK=.. -D COMPILER=.. -P check_new_system.cmake
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT code EQUAL 0)
    string(JOIN " " line ${ARGN})
    message(FATAL_ERROR "${line}\nexit code ${code}\n${text}")
  endif()
  set(output "${text}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
foreach(part algorithms cli cmake experiments io kernel scripts tests CMakeLists.txt
             CMakePresets.json README.md references.bib)
  file(COPY ${SOURCE}/${part} DESTINATION ${WORK}/tree)
endforeach()
# The skeleton's test links nothing of claim 4, whose sources take minutes to compile: the table of
# claims is made without it.
file(COPY ${SOURCE}/certify DESTINATION ${WORK}/tree)
file(GLOB sources ${WORK}/tree/certify/ridges_smooth/*.cpp)
file(REMOVE ${sources})
run(${WORK}/tree/scripts/new-system.sh shape_census)
run(${CMAKE_COMMAND} -S ${WORK}/tree -B ${WORK}/build -G Ninja -D CMAKE_BUILD_TYPE=Debug
  -D CMAKE_CXX_FLAGS=-O0 -D CMAKE_CXX_COMPILER=${COMPILER})
# Its library and test, its command and its experiment; nothing of the other systems.
run(${CMAKE_COMMAND} --build ${WORK}/build --target test_shape_census
  cli/CMakeFiles/crest.dir/shape_census_command.cpp.o
  experiments/CMakeFiles/experiment_shape_census_table.dir/shape_census/shape_census_table.cpp.o)
run(${WORK}/build/tests/test_shape_census)
file(READ ${WORK}/build/cli/command_table.cpp table)
if(NOT table MATCHES "shape_census_command")
  message(FATAL_ERROR "the command is not in the table:\n${table}")
endif()
# A second run must not overwrite anything.
execute_process(COMMAND ${WORK}/tree/scripts/new-system.sh shape_census RESULT_VARIABLE code
  OUTPUT_QUIET ERROR_QUIET)
if(code EQUAL 0)
  message(FATAL_ERROR "new-system.sh overwrote an existing system")
endif()
file(REMOVE_RECURSE ${WORK})
