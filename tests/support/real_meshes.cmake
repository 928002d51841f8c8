# SPDX-License-Identifier: GPL-3.0-or-later
# Unpacks the real meshes of Debian's libcgal-demo into the build tree, and tells real_meshes.cpp
# where they are. Some installations leave doc folders out; the tests that need a mesh then fail.

set(SONDE_REAL_MESHES "${CMAKE_BINARY_DIR}/real_meshes/data/meshes")
if(NOT IS_DIRECTORY "${SONDE_REAL_MESHES}")
  file(GLOB archives "/usr/share/doc/libcgal*/data.tar.gz")
  if(archives)
    list(GET archives 0 archive)
    file(ARCHIVE_EXTRACT INPUT "${archive}" DESTINATION "${CMAKE_BINARY_DIR}/real_meshes"
         PATTERNS "data/meshes/*")
  else()
    message(WARNING "libcgal-demo's data.tar.gz is missing: tests on real meshes will fail")
  endif()
endif()
set_source_files_properties("${CMAKE_CURRENT_LIST_DIR}/real_meshes.cpp" PROPERTIES
  COMPILE_DEFINITIONS "SONDE_REAL_MESHES=\"${SONDE_REAL_MESHES}\"")
