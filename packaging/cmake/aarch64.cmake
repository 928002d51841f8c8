# SPDX-License-Identifier: GPL-3.0-or-later
# 64-bit ARM, by Debian's compiler for it and its libraries of that architecture.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64)
set(ENV{PKG_CONFIG_LIBDIR} /usr/lib/aarch64-linux-gnu/pkgconfig:/usr/share/pkgconfig)
# Headers alone, whose CMake files are in the folder of this computer's own architecture.
set(CGAL_DIR /usr/lib/x86_64-linux-gnu/cmake/CGAL)
# What is found below /usr/lib of this computer's own architecture does not link.
set(CMAKE_IGNORE_PATH /usr/lib/x86_64-linux-gnu /usr/lib/x86_64-linux-gnu/cmake)
