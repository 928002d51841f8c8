# SPDX-License-Identifier: GPL-3.0-or-later
# Debian's hardening=+all (dpkg-buildflags), as the interface target sonde_hardening, and code that
# can be loaded anywhere. tests/packaging/hardening.sh looks at what came of it.

include(CheckPIESupported)
check_pie_supported(LANGUAGES CXX)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
# With hidden symbols position-independent code calls within itself as directly as any other; what
# the shared library shows is said in packaging/sonde.map.
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)

add_library(sonde_hardening INTERFACE)
target_compile_options(sonde_hardening INTERFACE -fstack-protector-strong -Wformat
                                                 -Werror=format-security)
if(WIN32) # where what the checks call is in a library of its own
  target_link_options(sonde_hardening INTERFACE -Wl,--dynamicbase -Wl,--nxcompat
                                                -Wl,--high-entropy-va -fstack-protector-strong)
else()
  target_link_options(sonde_hardening INTERFACE -Wl,-z,relro -Wl,-z,now)
endif()
# The checked functions of libc need the optimiser, and hide from the sanitizers what they look at.
if(NOT SONDE_SANITIZE AND NOT "${CMAKE_CXX_FLAGS}" MATCHES "_FORTIFY_SOURCE")
  target_compile_options(sonde_hardening
                         INTERFACE $<$<NOT:$<CONFIG:Debug>>:-U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2>)
endif()
