# SPDX-License-Identifier: GPL-3.0-or-later
# One library a folder, with the flags every part of Crest is built with.

# FMA contraction breaks error bounds and determinism (docs/conventions.md).
add_library(crest_flags INTERFACE)
target_compile_options(crest_flags INTERFACE
  -Wall -Wextra -Wconversion -Werror -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")  # lanes have GCC's ivdep, and bits instead of branches
  target_compile_options(crest_flags INTERFACE
    -Wno-unknown-pragmas -Wno-unknown-warning-option -Wno-bitwise-instead-of-logical)
endif()
add_library(Crest::flags ALIAS crest_flags)

# Interval arithmetic changes the rounding mode: no constant folding across it.
add_library(crest_rounding INTERFACE)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(crest_rounding INTERFACE -frounding-math)
else()
  target_compile_options(crest_rounding INTERFACE -frounding-math -Wno-overriding-t-option)
endif()

# Headers of other projects that most files of a target read, read once. Files still include what
# they use: -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON must build too.
function(crest_precompile target)
  list(TRANSFORM ARGN PREPEND "<")
  list(TRANSFORM ARGN APPEND ">")
  target_precompile_headers(${target} PRIVATE ${ARGN})
endfunction()

# crest_precompiled(<name> LINK ... HEADERS ...): nothing but headers, for crest_reuse_precompiled.
function(crest_precompiled name)
  cmake_parse_arguments(ARG "" "" "LINK;HEADERS" ${ARGN})
  file(CONFIGURE OUTPUT headers.cpp CONTENT "")
  add_library(${name} OBJECT ${CMAKE_CURRENT_BINARY_DIR}/headers.cpp)
  target_link_libraries(${name} PRIVATE ${ARG_LINK})
  crest_precompile(${name} ${ARG_HEADERS})
endfunction()

# The headers that <owner> precompiles, for a target with the same flags: gcc reads them with the
# flags of the unit that wrote them, and other ones (rounding!) would be lost without a word.
function(crest_reuse_precompiled target owner)
  foreach(name ${target} ${owner})
    get_target_property(libraries ${name} LINK_LIBRARIES)
    get_target_property(options ${name} COMPILE_OPTIONS)
    string(REGEX MATCHALL "crest_flags|crest_rounding" flags_${name} "${libraries}")
    list(SORT flags_${name})
    list(APPEND flags_${name} ${options})
  endforeach()
  if(NOT flags_${target} STREQUAL flags_${owner})
    message(FATAL_ERROR "${target} and ${owner} have different flags: ${flags_${target}}; ${flags_${owner}}")
  endif()
  target_precompile_headers(${target} REUSE_FROM ${owner})
  # False alarms of gcc 12 in a precompiled std::string (its bug 105651).
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
endfunction()

# Headers, templates above all, are most of the cost of a file: files of a target compiled several at
# a time cost half. Every file must build alone too, as in the preset "dev".
function(crest_together target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${CREST_TOGETHER} UNITY_BUILD_BATCH_SIZE 8)
endfunction()

# crest_library(<name> SOURCES ... LINK ... [ROUNDING])
function(crest_library name)
  cmake_parse_arguments(ARG "ROUNDING" "" "SOURCES;LINK" ${ARGN})
  add_library(crest_${name} STATIC ${ARG_SOURCES})
  add_library(Crest::${name} ALIAS crest_${name})
  target_include_directories(crest_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(crest_${name} PUBLIC cxx_std_20)
  target_link_libraries(crest_${name} PUBLIC ${ARG_LINK} PRIVATE $<BUILD_INTERFACE:crest_flags>)
  if(ARG_ROUNDING)
    target_link_libraries(crest_${name} PRIVATE $<BUILD_INTERFACE:crest_rounding>)
  endif()
  set_property(GLOBAL APPEND PROPERTY CREST_LIBRARIES crest_${name})
endfunction()

function(crest_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_LINK} crest_flags)
endfunction()
