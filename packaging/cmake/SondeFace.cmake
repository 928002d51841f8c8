# SPDX-License-Identifier: GPL-3.0-or-later
# The library for programs outside: the header <sonde/sonde.hpp>, which is engine/sonde.hpp and what
# it includes of the engine in one file, and libsonde.so, which shows the names of that header and no
# more.

set(SONDE_FACE_FOLDER "${PROJECT_BINARY_DIR}/include")
set(sonde_face_seen)
set(sonde_face_system)
set(sonde_face_text)

# Appends a header of the engine to sonde_face_text, whole, after those that it includes, each once.
function(sonde_face_append HEADER)
  if(HEADER IN_LIST sonde_face_seen)
    return()
  endif()
  list(APPEND sonde_face_seen "${HEADER}")
  set(file "${PROJECT_SOURCE_DIR}/${HEADER}")
  set_property(DIRECTORY "${PROJECT_SOURCE_DIR}" APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
  file(READ "${file}" text)
  string(REGEX MATCHALL "\n#include [<\"][^>\"]+" includes "${text}")
  foreach(include IN LISTS includes)
    string(REGEX REPLACE "\n#include [<\"]" "" name "${include}")
    if(include MATCHES "\"")
      sonde_face_append("${name}")
    else()
      list(APPEND sonde_face_system "${name}")
    endif()
  endforeach()
  string(REGEX REPLACE "\n#(include|pragma)[^\n]*" "" text "${text}")
  string(REGEX REPLACE "^// SPDX[^\n]*\n+" "" text "${text}")
  set(sonde_face_seen "${sonde_face_seen}" PARENT_SCOPE)
  set(sonde_face_system "${sonde_face_system}" PARENT_SCOPE)
  set(sonde_face_text "${sonde_face_text}\n${text}" PARENT_SCOPE)
endfunction()

sonde_face_append(engine/sonde.hpp)
list(REMOVE_DUPLICATES sonde_face_system)
list(SORT sonde_face_system)
list(TRANSFORM sonde_face_system REPLACE "(.+)" "#include <\\1>")
list(JOIN sonde_face_system "\n" sonde_face_system)
configure_file("${CMAKE_CURRENT_LIST_DIR}/sonde.hpp.in"
               "${SONDE_FACE_FOLDER}/sonde/sonde.hpp" @ONLY)

get_target_property(sonde_engine_target sonde::engine ALIASED_TARGET)
target_include_directories(${sonde_engine_target}
                           INTERFACE "$<BUILD_INTERFACE:${SONDE_FACE_FOLDER}>")
target_compile_features(${sonde_engine_target} INTERFACE cxx_std_20)

# sonde.cpp is compiled again, to be seen, and so that its names are in the library at all; the rest
# comes from the engine: what else the face declares (engine/CMakeLists.txt) by that it is needed.
add_library(sonde_shared SHARED "${PROJECT_SOURCE_DIR}/engine/sonde.cpp"
                                $<TARGET_OBJECTS:sonde_engine_penetration_search>
                                $<TARGET_OBJECTS:sonde_engine_penetration_sensitivity>
                                $<TARGET_OBJECTS:sonde_engine_penetration_restricted>
                                $<TARGET_OBJECTS:sonde_engine_queries>)
# Below 1.0 each minor version may change the face, from then on each major one.
set(SONDE_SOVERSION ${PROJECT_VERSION_MAJOR})
if(PROJECT_VERSION_MAJOR EQUAL 0)
  set(SONDE_SOVERSION 0.${PROJECT_VERSION_MINOR})
endif()
set(sonde_map "${PROJECT_SOURCE_DIR}/packaging/sonde.map")
set_target_properties(sonde_shared PROPERTIES
  OUTPUT_NAME sonde EXPORT_NAME engine VERSION ${PROJECT_VERSION} SOVERSION ${SONDE_SOVERSION}
  LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/lib" CXX_VISIBILITY_PRESET default
  LINK_DEPENDS "${sonde_map}")
if(NOT SONDE_INSTALL)
  set_target_properties(sonde_shared PROPERTIES EXCLUDE_FROM_ALL ON)
endif()
target_compile_features(sonde_shared PUBLIC cxx_std_20)
target_link_libraries(sonde_shared PRIVATE sonde::engine sonde_options)
target_link_options(sonde_shared PRIVATE "-Wl,--version-script=${sonde_map}"
                                         -Wl,--gc-sections -Wl,--as-needed)
