# SPDX-License-Identifier: GPL-3.0-or-later
# 64-bit Windows, by Debian's mingw-w64 compiler and zlib for it, into one file that needs no other
# library. Libraries that are headers alone are those of this computer, below a folder of links:
# beside them in /usr/include are the headers of its C library.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
set(CMAKE_CROSSCOMPILING_EMULATOR wine)
# A function's stack is aligned to 16 bytes on Windows, and g++ takes it to be aligned to as many as
# a vector has (its bug 54412): the assembler writes moves that need no alignment. Large sources
# have more sections than the object format counts to without being told.
set(CMAKE_CXX_FLAGS_INIT "-Wa,-muse-unaligned-vector-move -Wa,-mbig-obj")
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)

set(headers "${CMAKE_BINARY_DIR}/headers")
foreach(link include/boost include/CGAL include/CLI include/eigen3 include/nlohmann
             share/eigen3 share/cmake/CLI11 share/cmake/nlohmann_json)
  get_filename_component(folder "${headers}/${link}" DIRECTORY)
  file(MAKE_DIRECTORY "${folder}" "${headers}/lib/cmake")
  file(CREATE_LINK "/usr/${link}" "${headers}/${link}" SYMBOLIC)
endforeach()
file(CREATE_LINK /usr/lib/x86_64-linux-gnu/cmake/CGAL "${headers}/lib/cmake/CGAL" SYMBOLIC)
set(CGAL_DIR "${headers}/lib/cmake/CGAL")
set(ZLIB_LIBRARY /usr/x86_64-w64-mingw32/lib/libz.a) # not the DLL
set(Boost_NO_BOOST_CMAKE ON) # which names /usr/include
set(CMAKE_FIND_ROOT_PATH /usr/x86_64-w64-mingw32 "${headers}")
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
