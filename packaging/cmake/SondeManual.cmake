# SPDX-License-Identifier: GPL-3.0-or-later
# sonde_manual: the pages of resources/docs as a site, with a search, in manual/ of the build folder.
# F1 and a reader of the sources see the same Markdown.

find_program(SPHINX_BUILD sphinx-build)
if(NOT SPHINX_BUILD)
  message(STATUS "no site of the manual: sphinx-build is missing, packaging/deps installs it")
  return()
endif()
set(SONDE_MANUAL_FOLDER "${PROJECT_BINARY_DIR}/manual")
file(GLOB_RECURSE pages CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/resources/docs/*")
# A link that leads nowhere is a warning of Sphinx's, and so an error. It is made afresh each time,
# since a page that is gone would stay.
add_custom_command(OUTPUT "${SONDE_MANUAL_FOLDER}/index.html"
                   COMMAND "${CMAKE_COMMAND}" -E rm -rf "${SONDE_MANUAL_FOLDER}"
                   COMMAND "${SPHINX_BUILD}" -q -W --keep-going -b html
                           -c "${PROJECT_SOURCE_DIR}/packaging/manual"
                           -d "${PROJECT_BINARY_DIR}/manual-doctrees"
                           -D "release=${PROJECT_VERSION}" -D "version=${PROJECT_VERSION}"
                           "${PROJECT_SOURCE_DIR}/resources/docs" "${SONDE_MANUAL_FOLDER}"
                   DEPENDS ${pages} "${PROJECT_SOURCE_DIR}/packaging/manual/conf.py"
                   COMMENT "Writing the manual's site" VERBATIM)
add_custom_target(sonde_manual ALL DEPENDS "${SONDE_MANUAL_FOLDER}/index.html")
install(DIRECTORY "${SONDE_MANUAL_FOLDER}/" DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/sonde/html"
        COMPONENT program PATTERN ".*" EXCLUDE PATTERN "objects.inv" EXCLUDE)
