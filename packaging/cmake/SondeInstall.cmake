# SPDX-License-Identifier: GPL-3.0-or-later
# What is installed where, by components: program (sonde, its resources), view (sonde-view), library
# (libsonde.so), development (header, CMake and pkg-config files), python (the module).

include(CMakePackageConfigHelpers)
find_program(GZIP_PROGRAM gzip REQUIRED)
set(SONDE_PAGES_FOLDER "${PROJECT_BINARY_DIR}/pages") # app/CMakeLists.txt has them written
set(SONDE_MANUALS "${CMAKE_INSTALL_DATADIR}/man/man1")
set(SONDE_COMPLETIONS "${CMAKE_INSTALL_DATADIR}/bash-completion/completions")
set(SONDE_PACKAGING "${PROJECT_SOURCE_DIR}/packaging")

# The version is said in one place, project(); the changelog, which has the date, must agree.
set(SONDE_CHANGELOG "${SONDE_PACKAGING}/debian/changelog")
file(STRINGS "${SONDE_CHANGELOG}" first_line LIMIT_COUNT 1)
if(NOT first_line MATCHES "^sonde \\(${PROJECT_VERSION}\\) ")
  message(FATAL_ERROR "packaging/debian/changelog:1: \"${first_line}\" is not of version "
                      "${PROJECT_VERSION}, which project() in CMakeLists.txt says")
endif()
file(STRINGS "${SONDE_CHANGELOG}" signature REGEX "^ -- " LIMIT_COUNT 1)
if(NOT signature MATCHES ", ([0-9][0-9]) ([A-Z][a-z][a-z]) ([0-9][0-9][0-9][0-9]) ")
  message(FATAL_ERROR "packaging/debian/changelog: no date in \"${signature}\"")
endif()
set(months Jan Feb Mar Apr May Jun Jul Aug Sep Oct Nov Dec)
list(FIND months "${CMAKE_MATCH_2}" month)
math(EXPR month "100 + ${month} + 1") # for two digits
string(SUBSTRING "${month}" 1 2 month)
set(SONDE_RELEASE_DATE "${CMAKE_MATCH_3}-${month}-${CMAKE_MATCH_1}")

# A manual page or changelog, compressed as Debian wants it: without name and time.
function(sonde_compress INPUT OUTPUT)
  add_custom_command(OUTPUT "${OUTPUT}" DEPENDS "${INPUT}" VERBATIM
                     COMMAND sh -c "'${GZIP_PROGRAM}' -9nc '${INPUT}' > '${OUTPUT}'")
  set_property(GLOBAL APPEND PROPERTY SONDE_COMPRESSED "${OUTPUT}")
endfunction()

# -- program

install(TARGETS sonde RUNTIME COMPONENT program)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/resources/devices" "${PROJECT_SOURCE_DIR}/resources/docs"
                  "${PROJECT_SOURCE_DIR}/resources/scenes" "${PROJECT_SOURCE_DIR}/resources/models"
        DESTINATION "${CMAKE_INSTALL_DATADIR}/sonde" COMPONENT program PATTERN ".*" EXCLUDE)
install(FILES "${PROJECT_SOURCE_DIR}/resources/sonde-device.schema.json"
              "${PROJECT_SOURCE_DIR}/resources/sonde-scene.schema.json"
        DESTINATION "${CMAKE_INSTALL_DATADIR}/sonde" COMPONENT program)
# With the prefix /usr this is where udev looks.
install(FILES "${SONDE_PACKAGING}/70-sonde-devices.rules" DESTINATION lib/udev/rules.d
        COMPONENT program)
sonde_compress("${SONDE_PAGES_FOLDER}/sonde.1" "${PROJECT_BINARY_DIR}/pages/sonde.1.gz")
install(FILES "${PROJECT_BINARY_DIR}/pages/sonde.1.gz" DESTINATION "${SONDE_MANUALS}"
        COMPONENT program)
install(FILES "${SONDE_PAGES_FOLDER}/completions/sonde" DESTINATION "${SONDE_COMPLETIONS}"
        COMPONENT program)

# -- view

if(SONDE_BUILD_VIEW)
  install(TARGETS sonde-view RUNTIME COMPONENT view)
  sonde_compress("${SONDE_PAGES_FOLDER}/sonde-view.1" "${PROJECT_BINARY_DIR}/pages/sonde-view.1.gz")
  install(FILES "${PROJECT_BINARY_DIR}/pages/sonde-view.1.gz" DESTINATION "${SONDE_MANUALS}"
          COMPONENT view)
  install(FILES "${SONDE_PAGES_FOLDER}/completions/sonde-view"
          DESTINATION "${SONDE_COMPLETIONS}" COMPONENT view)
  install(FILES "${SONDE_PACKAGING}/desktop/org.sonde.View.desktop"
          DESTINATION "${CMAKE_INSTALL_DATADIR}/applications" COMPONENT view)
  configure_file("${SONDE_PACKAGING}/desktop/org.sonde.View.metainfo.xml.in"
                 "${PROJECT_BINARY_DIR}/desktop/org.sonde.View.metainfo.xml" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/desktop/org.sonde.View.metainfo.xml"
          DESTINATION "${CMAKE_INSTALL_DATADIR}/metainfo" COMPONENT view)
  install(FILES "${SONDE_PACKAGING}/desktop/sonde.xml"
          DESTINATION "${CMAKE_INSTALL_DATADIR}/mime/packages" COMPONENT view)
  install(DIRECTORY "${SONDE_PACKAGING}/desktop/hicolor"
          DESTINATION "${CMAKE_INSTALL_DATADIR}/icons" COMPONENT view)
endif()

# -- library and development

set(SONDE_CMAKE_FOLDER "${CMAKE_INSTALL_LIBDIR}/cmake/sonde")
install(TARGETS sonde_shared EXPORT sonde
        LIBRARY COMPONENT library NAMELINK_COMPONENT development
        INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
install(EXPORT sonde NAMESPACE sonde:: FILE sondeTargets.cmake DESTINATION "${SONDE_CMAKE_FOLDER}"
        COMPONENT development)
install(FILES "${SONDE_FACE_FOLDER}/sonde/sonde.hpp"
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/sonde" COMPONENT development)
configure_package_config_file("${SONDE_PACKAGING}/cmake/sondeConfig.cmake.in"
                              "${PROJECT_BINARY_DIR}/sondeConfig.cmake"
                              INSTALL_DESTINATION "${SONDE_CMAKE_FOLDER}"
                              NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
# Below 1.0 another minor version may be another face.
write_basic_package_version_file("${PROJECT_BINARY_DIR}/sondeConfigVersion.cmake"
                                 COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/sondeConfig.cmake"
              "${PROJECT_BINARY_DIR}/sondeConfigVersion.cmake"
        DESTINATION "${SONDE_CMAKE_FOLDER}" COMPONENT development)
# Relative to itself, so that all may be moved; but where the libraries have a place of their own.
if(IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}")
  set(SONDE_PC_PREFIX "${CMAKE_INSTALL_PREFIX}")
  set(SONDE_PC_LIBDIR "${CMAKE_INSTALL_LIBDIR}")
else()
  file(RELATIVE_PATH up "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
  set(SONDE_PC_PREFIX "\${pcfiledir}/${up}")
  set(SONDE_PC_LIBDIR "\${prefix}/${CMAKE_INSTALL_LIBDIR}")
endif()
configure_file("${SONDE_PACKAGING}/cmake/sonde.pc.in" "${PROJECT_BINARY_DIR}/sonde.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/sonde.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig"
        COMPONENT development)
install(FILES "${PROJECT_SOURCE_DIR}/tests/engine/depth_of_two_files.cpp"
        DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/libsonde-dev/examples" COMPONENT development)

# -- python

if(SONDE_BUILD_PYTHON)
  set(SONDE_PYTHON_PACKAGES "lib/python3/dist-packages/sonde")
  install(TARGETS sonde_python LIBRARY DESTINATION "${SONDE_PYTHON_PACKAGES}" COMPONENT python)
  install(FILES "${PROJECT_SOURCE_DIR}/app/python/package/__init__.py"
                "${PROJECT_SOURCE_DIR}/app/python/package/__init__.pyi"
                "${PROJECT_SOURCE_DIR}/app/python/package/poses.py"
                "${PROJECT_SOURCE_DIR}/app/python/package/py.typed"
          DESTINATION "${SONDE_PYTHON_PACKAGES}" COMPONENT python)
  install(FILES "${PROJECT_SOURCE_DIR}/app/python/depth_along_path.py"
                "${PROJECT_SOURCE_DIR}/app/python/gripper_clearance.py"
          DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/python3-sonde/examples" COMPONENT python)
endif()
