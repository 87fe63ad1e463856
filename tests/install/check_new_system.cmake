# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -D SOURCE=.. -D BUILD=.. -D WORK=.. -D COMPILER=.. -P check_new_system.cmake
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
file(COPY ${SOURCE}/certify DESTINATION ${WORK}/tree)
set(kinds mesh tetrahedra grid field points)
foreach(kind ${kinds})
  run(${WORK}/tree/scripts/new-system.sh ${kind}_census --input ${kind})
endforeach()
run(${CMAKE_COMMAND} -S ${WORK}/tree -B ${WORK}/build -G Ninja -D CMAKE_CXX_COMPILER=${COMPILER})
file(READ ${WORK}/build/cli/command_table.cpp table)
file(READ ${WORK}/tree/certify/SPEC.md spec)
run(${CMAKE_COMMAND} --build ${WORK}/build --target help)
foreach(kind ${kinds})
  if(NOT output MATCHES "test_${kind}_census:" OR
     NOT output MATCHES "experiment_${kind}_census_table:")
    message(FATAL_ERROR "no target for the test or the experiment of ${kind}_census")
  endif()
  if(NOT table MATCHES "${kind}_census_command")
    message(FATAL_ERROR "the command is not in the table:\n${table}")
  endif()
  if(NOT spec MATCHES "[5-9]|[1-9][0-9] ${kind}-census . .${kind}_census/SPEC.md")
    message(FATAL_ERROR "the claim has no row in certify/SPEC.md:\n${spec}")
  endif()
endforeach()
# The skeletons' own files; all others are compiled already, into the libraries of this build.
set(compile ${COMPILER} -std=c++20 -O0 -Wall -Wextra -Wconversion -Werror -frounding-math
  -I ${WORK}/tree)
file(GLOB libraries ${BUILD}/algorithms/*.a ${BUILD}/certify/*.a ${BUILD}/kernel/*.a
  ${BUILD}/tests/libcrest_test_main.a)
file(GLOB sources ${WORK}/tree/algorithms/*_census/*.cpp ${WORK}/tree/certify/*_census/*.cpp)
file(GLOB programs ${WORK}/tree/cli/*_census_command.cpp ${WORK}/tree/experiments/*_census/*.cpp
  ${WORK}/tree/tests/*_census/*.cpp)
run(${compile} -fsyntax-only ${programs})
file(GLOB mesh_tests ${WORK}/tree/tests/mesh_census/*.cpp)
run(${compile} ${sources} ${WORK}/build/certify/claim_table_all.cpp ${mesh_tests}
  -o ${WORK}/test_mesh_census -Wl,--start-group ${libraries} -Wl,--end-group
  -ltbb -lfmt -lmpfr -lgmp -lcrypto)
run(${WORK}/test_mesh_census)
# A second run must not overwrite anything; without a known input there is nothing to make.
foreach(arguments "mesh_census;--input;mesh" "other_census" "other_census;--input;pictures")
  execute_process(COMMAND ${WORK}/tree/scripts/new-system.sh ${arguments} RESULT_VARIABLE code
    INPUT_FILE /dev/null OUTPUT_QUIET ERROR_QUIET)
  if(code EQUAL 0 OR EXISTS ${WORK}/tree/certify/other_census)
    message(FATAL_ERROR "new-system.sh ${arguments} made something")
  endif()
endforeach()
file(REMOVE_RECURSE ${WORK})
