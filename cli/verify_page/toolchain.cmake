# SPDX-License-Identifier: GPL-3.0-or-later
# Debian's clang for WebAssembly over the C and C++ libraries of Debian's emscripten.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CREST_SYSROOT /usr/share/emscripten/cache/sysroot)
set(CMAKE_CXX_COMPILER clang++-14)
set(CMAKE_CXX_COMPILER_TARGET wasm32-unknown-emscripten)
set(CMAKE_SYSROOT ${CREST_SYSROOT})
set(CMAKE_AR llvm-ar-14)
set(CMAKE_RANLIB llvm-ranlib-14)
# The libraries' second ABI, and the instructions that every browser with exceptions has.
set(CMAKE_CXX_FLAGS_INIT "-iwithsysroot /include/compat -D_LIBCPP_ABI_VERSION=2 -fwasm-exceptions -msign-ext -mbulk-memory -mnontrapping-fptoint -msimd128")
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
