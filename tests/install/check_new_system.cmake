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
run(${WORK}/tree/scripts/new-system.sh shape_census --input mesh)
run(${WORK}/tree/scripts/new-system.sh field_census --input field)
run(${CMAKE_COMMAND} -S ${WORK}/tree -B ${WORK}/build -G Ninja -D CMAKE_BUILD_TYPE=Debug
  -D CMAKE_CXX_FLAGS=-O0 -D CMAKE_CXX_COMPILER=${COMPILER})
# Their libraries, rooms and tests, commands and experiments; nothing of the other systems.
run(${CMAKE_COMMAND} --build ${WORK}/build --target test_shape_census test_field_census
  cli/CMakeFiles/crest.dir/shape_census_command.cpp.o
  cli/CMakeFiles/crest.dir/field_census_command.cpp.o
  experiments/CMakeFiles/experiment_shape_census_table.dir/shape_census/shape_census_table.cpp.o)
file(READ ${WORK}/build/cli/command_table.cpp table)
file(READ ${WORK}/tree/certify/SPEC.md spec)
foreach(name shape field)
  run(${WORK}/build/tests/test_${name}_census)
  if(NOT table MATCHES "${name}_census_command")
    message(FATAL_ERROR "the command is not in the table:\n${table}")
  endif()
  if(NOT spec MATCHES "[5-9] ${name}-census . .${name}_census/SPEC.md")
    message(FATAL_ERROR "the claim has no row in certify/SPEC.md:\n${spec}")
  endif()
endforeach()
# A second run must not overwrite anything; without a known input there is nothing to make.
foreach(arguments "shape_census;--input;mesh" "other_census" "other_census;--input;pictures")
  execute_process(COMMAND ${WORK}/tree/scripts/new-system.sh ${arguments} RESULT_VARIABLE code
    INPUT_FILE /dev/null OUTPUT_QUIET ERROR_QUIET)
  if(code EQUAL 0 OR EXISTS ${WORK}/tree/certify/other_census)
    message(FATAL_ERROR "new-system.sh ${arguments} made something")
  endif()
endforeach()
file(REMOVE_RECURSE ${WORK})
