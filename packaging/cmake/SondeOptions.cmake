# SPDX-License-Identifier: GPL-3.0-or-later
# What every target of the project is compiled with, as the interface target sonde_options.

add_library(sonde_options INTERFACE)
target_compile_features(sonde_options INTERFACE cxx_std_20)
# Without contraction a*b+c rounds twice on every machine: the same input gives the same bits. Nobody
# reads errno or the floating-point flags: a square root is one instruction, many at a time.
target_compile_options(sonde_options INTERFACE -Wall -Wextra -Wconversion -ffp-contract=off
                                               -fno-math-errno -fno-trapping-math)
# Eigen contracts by intrinsics where the processor that is compiled for has FMA, and sums in another
# order where it has AVX. With -march=native and on ARM it is therefore told of neither. On x86 the
# compiler is kept from FMA as well: g++ 12 contracts what it joins into alternating sums, whatever
# -ffp-contract says. AVX and AVX2 it still uses. engine/geometry/same_bits.cpp refuses the rest.
include(CheckCXXSourceCompiles)
check_cxx_source_compiles("
#if defined __AVX__ || defined __FMA__
#error wide
#endif
int main() {}" SONDE_X86_BASELINE)
if(NOT SONDE_X86_BASELINE)
  target_compile_options(sonde_options INTERFACE -mno-avx512f -mno-fma -U__AVX__ -U__AVX2__)
endif()
check_cxx_source_compiles("
#ifdef __ARM_FEATURE_FMA
#error wide
#endif
int main() {}" SONDE_ARM_WITHOUT_FMA)
if(NOT SONDE_ARM_WITHOUT_FMA)
  target_compile_options(sonde_options INTERFACE -U__ARM_FEATURE_FMA)
endif()
# Sources that are compiled together are taken for headers, whose types must be the same everywhere.
if(CMAKE_UNITY_BUILD)
  target_compile_options(sonde_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endif()
# g++ is asked about conversions; clang counts changes of sign among them.
target_compile_options(sonde_options INTERFACE $<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion>)
if(SONDE_WARNINGS_AS_ERRORS)
  target_compile_options(sonde_options INTERFACE -Werror)
endif()
target_link_libraries(sonde_options INTERFACE sonde_hardening)
if(SONDE_SANITIZE)
  target_compile_options(sonde_options INTERFACE -fsanitize=${SONDE_SANITIZE}
                                                 -fno-omit-frame-pointer)
  # g++ with a sanitizer takes some of the standard library's own for uninitialized (std::regex).
  target_compile_options(
    sonde_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-error=maybe-uninitialized>)
  # Where a pointer steps down through an array of known size (ordering::sort of a triangle's three
  # edges), g++ 12 takes an element for one without room. What lies outside is address's to find.
  target_compile_options(sonde_options
                         INTERFACE $<$<CXX_COMPILER_ID:GNU>:-fno-sanitize=object-size>)
  target_link_options(sonde_options INTERFACE -fsanitize=${SONDE_SANITIZE})
endif()
if(SONDE_FUZZ)
  target_compile_options(sonde_options INTERFACE -fsanitize=fuzzer-no-link)
endif()
