# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -D BUILD=.. -D WORK=.. -D GENERATOR=.. -D COMPILER=.. -D FLAGS=.. -P check_package.cmake
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT code EQUAL 0)
    string(JOIN " " line ${ARGN})
    message(FATAL_ERROR "${line}\nexit code ${code}\n${text}")
  endif()
  set(output "${text}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
set(examples ${CMAKE_CURRENT_LIST_DIR}/../../examples)
run(${CMAKE_COMMAND} -S ${examples} -B ${WORK}/build -G ${GENERATOR}
  -D CMAKE_PREFIX_PATH=${WORK}/prefix -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_FLAGS=${FLAGS}
  -D CMAKE_BUILD_TYPE=Debug)
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${CMAKE_CTEST_COMMAND} --test-dir ${WORK}/build --verbose)
if(NOT output MATCHES "Euler characteristic 2, index sum 2")
  message(FATAL_ERROR "unexpected answer: ${output}")
endif()

# Nothing but what the public headers need, each under the prefix.
file(GLOB_RECURSE headers ${WORK}/prefix/include/*.hpp)
foreach(header ${headers})
  file(STRINGS ${header} bare REGEX "#include \"")
  list(FILTER bare EXCLUDE REGEX "#include \"crest/")
  if(bare OR NOT header MATCHES "/include/crest/")
    message(FATAL_ERROR "${header} is without the prefix, or includes so: ${bare}")
  endif()
endforeach()
list(FILTER headers INCLUDE REGEX "algorithms/smooth_ridges/umbilics|certify/second|smooth_ridges/face_lanes")
if(headers)
  message(FATAL_ERROR "internal headers are installed: ${headers}")
endif()

# The same program by pkg-config, without CMake.
file(GLOB_RECURSE pc ${WORK}/prefix/crest.pc)
get_filename_component(folder "${pc}" DIRECTORY)
run(sh -c "PKG_CONFIG_PATH=${folder} pkg-config --cflags --libs crest")
string(REPLACE "\n" "" flags "${output}")
run(sh -c
  "${COMPILER} ${FLAGS} ${examples}/ridges.cpp -o ${WORK}/by_pkg_config ${flags}")
run(${WORK}/by_pkg_config)
if(NOT output MATCHES "Euler characteristic 2, index sum 2")
  message(FATAL_ERROR "unexpected answer: ${output}")
endif()

# What comes with the programs.
file(GLOB programs RELATIVE ${WORK}/prefix/bin ${WORK}/prefix/bin/*)
foreach(program ${programs})
  if(NOT EXISTS ${WORK}/prefix/share/man/man1/${program}.1)
    message(FATAL_ERROR "${program} has no man page")
  endif()
endforeach()
if(EXISTS ${WORK}/prefix/bin/crest)
  file(READ ${WORK}/prefix/share/man/man1/crest-ridges.1 page)
  if(NOT page MATCHES "certificate FILE.*EXAMPLES")
    message(FATAL_ERROR "the page of crest ridges lacks options or examples")
  endif()
  file(WRITE ${WORK}/complete.sh [=[
. "$1"
COMP_WORDS=(crest rid); COMP_CWORD=1; _crest; echo "${COMPREPLY[*]}"
COMP_WORDS=(crest ridges --certif); COMP_CWORD=2; _crest; echo "${COMPREPLY[*]}"
]=])
  run(bash ${WORK}/complete.sh ${WORK}/prefix/share/bash-completion/completions/crest)
  if(NOT output MATCHES "ridges.*--certificate")
    message(FATAL_ERROR "completion gives ${output}")
  endif()
  file(GLOB licence ${WORK}/prefix/share/doc/*/LICENSE)
  if(NOT licence)
    message(FATAL_ERROR "the licence is not installed")
  endif()
endif()
file(REMOVE_RECURSE ${WORK})
