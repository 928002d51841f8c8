# SPDX-License-Identifier: GPL-3.0-or-later
# Debian packages by CPack, one for each component; packaging/package makes them.

sonde_compress("${SONDE_CHANGELOG}" "${PROJECT_BINARY_DIR}/changelog.gz")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME sonde)
set(CPACK_PACKAGE_CONTACT "Sonde maintainers <maintainers@users.noreply.github.com>")
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_BINARY_DIR}/packages")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_COMPONENTS_ALL)

set(about "Sonde lets a person feel how two polygon soups touch: it finds the
smallest motion, turning included, that separates a probe from a fixed body,
and turns it into a force and a torque for 6-DoF haptic devices, a thousand
times a second.")

# sonde_package(COMPONENT NAME SUMMARY TEXT): the package NAME is made of a component.
function(sonde_package COMPONENT NAME SUMMARY TEXT)
  string(TOUPPER "${COMPONENT}" key)
  set(all ${CPACK_COMPONENTS_ALL} ${COMPONENT})
  set(CPACK_COMPONENTS_ALL "${all}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME "${NAME}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_DESCRIPTION "${SUMMARY}\n${about}\n.\n${TEXT}" PARENT_SCOPE)
  set(documents "${CMAKE_INSTALL_DATADIR}/doc/${NAME}")
  install(FILES "${SONDE_PACKAGING}/debian/copyright" "${PROJECT_BINARY_DIR}/changelog.gz"
          DESTINATION "${documents}" COMPONENT ${COMPONENT})
endfunction()

sonde_package(program sonde "penetration depth of two polygon soups, without a window"
              "This package has the headless program, example scenes, and the manual.")
sonde_package(library libsonde${SONDE_SOVERSION} "penetration depth of two polygon soups - library"
              "This package has the shared library.")
sonde_package(development libsonde-dev "penetration depth of two polygon soups - development files"
              "This package has the header, <sonde/sonde.hpp>, and what CMake and\npkg-config read.")
if(SONDE_BUILD_VIEW)
  sonde_package(view sonde-view "feel how two polygon soups touch: the desktop program"
                "This package has the desktop program.")
endif()

if(SONDE_BUILD_PYTHON)
  sonde_package(python python3-sonde "penetration depth of two polygon soups - Python module"
                "This package has the Python module, over NumPy arrays.")
endif()

set(same "(= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_VIEW_PACKAGE_DEPENDS "sonde ${same}") # its scenes and manual
set(CPACK_DEBIAN_VIEW_PACKAGE_SUGGESTS ffmpeg) # which makes films of pictures
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libsonde${SONDE_SOVERSION} ${same}, libeigen3-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
file(WRITE "${PROJECT_BINARY_DIR}/debian/shlibs"
     "libsonde ${SONDE_SOVERSION} libsonde${SONDE_SOVERSION} (= ${PROJECT_VERSION})\n")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA "${PROJECT_BINARY_DIR}/debian/shlibs"
                                               "${SONDE_PACKAGING}/debian/triggers")

if(SONDE_BUILD_PYTHON) # the compiled part is of one version of Python, whose name for it it has
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  math(EXPR next "${Python3_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "python3 (>= 3.${Python3_VERSION_MINOR}~), python3 (<< 3.${next}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS python3-matplotlib) # its example draws with that
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA "${SONDE_PACKAGING}/debian/python/postinst"
                                                "${SONDE_PACKAGING}/debian/python/prerm")
endif()

get_property(compressed GLOBAL PROPERTY SONDE_COMPRESSED)
add_custom_target(sonde_compressed ALL DEPENDS ${compressed})
# All that a package is made of, and nothing else.
add_custom_target(sonde_installed DEPENDS sonde sonde_shared sonde_pages sonde_compressed)
if(TARGET sonde_manual)
  add_dependencies(sonde_installed sonde_manual)
endif()
if(SONDE_BUILD_VIEW)
  add_dependencies(sonde_installed sonde-view)
endif()
if(SONDE_BUILD_PYTHON)
  add_dependencies(sonde_installed sonde_python)
endif()
include(CPack)
