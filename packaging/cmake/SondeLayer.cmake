# SPDX-License-Identifier: GPL-3.0-or-later

# sonde_layer(FOLDER [SEES folder...] [LIBRARIES target...] [CGAL source...]
#             [REST folder])
#
# The sources of one folder, below the calling one, as a target of its own, sonde_TOP_FOLDER.
#   SEES       the folders beside it whose headers it may include, declared before it: there are no
#              circles. What those see, it sees too.
#   LIBRARIES  of others, for it and for what sees it.
#   CGAL       its sources that need CGAL, which exports -frounding-math and takes long to compile:
#              they are a target apart, and its headers stay out of ours.
#   REST       a folder whose sources it takes, but for those whose names are among its own.
# An #include of any other folder does not build (packaging/check-includes).
function(sonde_layer FOLDER)
  cmake_parse_arguments(ARG "" "REST" "SEES;LIBRARIES;CGAL" ${ARGN})
  get_filename_component(top "${CMAKE_CURRENT_SOURCE_DIR}" NAME)
  string(MAKE_C_IDENTIFIER "sonde_${top}_${FOLDER}" target)
  set(sees "${top}/${FOLDER}")
  set(seen "")
  foreach(folder IN LISTS ARG_SEES)
    string(MAKE_C_IDENTIFIER "sonde_${top}_${folder}" other)
    if(NOT TARGET ${other})
      message(FATAL_ERROR "${top}/${FOLDER} sees ${top}/${folder}, which is not declared before it")
    endif()
    get_target_property(more ${other} SONDE_SEES)
    list(APPEND sees ${more})
    list(APPEND seen ${other})
  endforeach()
  list(REMOVE_DUPLICATES sees)

  file(GLOB sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/${FOLDER}/*.cpp"
                                      "${CMAKE_CURRENT_SOURCE_DIR}/${FOLDER}/*.hpp")
  if(ARG_REST)
    file(GLOB rest CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/${ARG_REST}/*.cpp")
    foreach(source IN LISTS rest)
      get_filename_component(name "${source}" NAME)
      if(NOT "${CMAKE_CURRENT_SOURCE_DIR}/${FOLDER}/${name}" IN_LIST sources)
        list(APPEND sources "${source}")
      endif()
    endforeach()
  endif()
  set(checked "${CMAKE_CURRENT_BINARY_DIR}/${target}.checked")
  set(check "${PROJECT_SOURCE_DIR}/packaging/check-includes")
  list(JOIN sees ":" colons)
  add_custom_command(OUTPUT "${checked}"
                     COMMAND "${check}" ${top} ${colons} ${sources}
                     COMMAND "${CMAKE_COMMAND}" -E touch "${checked}"
                     DEPENDS "${check}" ${sources} COMMENT "Includes of ${top}/${FOLDER}" VERBATIM)
  # A target apart: as a source of the layer, the check would wait for all that the layer sees.
  add_custom_target(${target}_includes DEPENDS "${checked}")

  list(TRANSFORM ARG_CGAL PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/${FOLDER}/")
  if(ARG_CGAL)
    list(REMOVE_ITEM sources ${ARG_CGAL})
    add_library(${target}_cgal OBJECT ${ARG_CGAL})
    add_dependencies(${target}_cgal ${target}_includes)
    target_link_libraries(${target}_cgal PRIVATE sonde_options CGAL::CGAL ${seen})
    target_include_directories(${target}_cgal PRIVATE "${PROJECT_SOURCE_DIR}")
    set_property(DIRECTORY APPEND PROPERTY SONDE_LAYERS ${target}_cgal)
  endif()
  add_library(${target} OBJECT ${sources})
  add_dependencies(${target} ${target}_includes)
  # LINKER_LANGUAGE: a folder may hold headers alone.
  set_target_properties(${target} PROPERTIES SONDE_SEES "${sees}" LINKER_LANGUAGE CXX)
  target_link_libraries(${target} PUBLIC ${seen} ${ARG_LIBRARIES} PRIVATE sonde_options)
  target_include_directories(${target} PUBLIC "${PROJECT_SOURCE_DIR}")
  if(top STREQUAL engine)
    target_compile_options(${target} PRIVATE ${SONDE_ENGINE_OPTIONS})
    if(ARG_CGAL)
      target_compile_options(${target}_cgal PRIVATE ${SONDE_ENGINE_OPTIONS})
    endif()
  endif()
  set_property(DIRECTORY APPEND PROPERTY SONDE_LAYERS ${target})
  set_property(DIRECTORY APPEND PROPERTY SONDE_LAYER_FOLDERS ${FOLDER})
endfunction()

# Sets LAYERS to the targets of the calling folder's layers and OBJECTS to what they compile to. A
# source below it that is in no layer is an error.
function(sonde_layers LAYERS OBJECTS)
  get_property(layers DIRECTORY PROPERTY SONDE_LAYERS)
  get_property(folders DIRECTORY PROPERTY SONDE_LAYER_FOLDERS)
  file(GLOB_RECURSE all CONFIGURE_DEPENDS RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" "*.cpp")
  foreach(file IN LISTS all)
    get_filename_component(folder "${file}" DIRECTORY)
    string(REGEX REPLACE "/.*" "" first "${folder}")
    if(folder IN_LIST SONDE_LAYERS_BEYOND OR first IN_LIST SONDE_LAYERS_BEYOND)
      continue()
    endif()
    if(folder AND NOT folder IN_LIST folders)
      message(FATAL_ERROR "${CMAKE_CURRENT_SOURCE_DIR}/${file} is in no layer: name its folder in "
                          "${CMAKE_CURRENT_LIST_FILE}")
    endif()
  endforeach()
  list(TRANSFORM layers REPLACE "(.+)" "$<TARGET_OBJECTS:\\1>" OUTPUT_VARIABLE objects)
  set(${LAYERS} ${layers} PARENT_SCOPE)
  set(${OBJECTS} ${objects} PARENT_SCOPE)
endfunction()
