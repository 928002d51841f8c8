# SPDX-License-Identifier: GPL-3.0-or-later
# Compiles engine/sonde.hpp by itself, with the project and Eigen on the include path, and refuses
# any header of the engine that shows what is inside and anything but Eigen and the compiler's own.
#   cmake -DCOMPILER=c++ -DPROJECT=folder -DEIGEN=folder -DWORK=folder -P face_header.cmake

cmake_minimum_required(VERSION 3.25)

set(allowed
    engine/base/error.hpp
    engine/base/phase_times.hpp
    engine/calibration/knob.hpp
    engine/geometry/face_offset.hpp
    engine/geometry/mass.hpp
    engine/geometry/model.hpp
    engine/geometry/pose.hpp
    engine/base/sentences.hpp
    engine/mending/repairs.hpp
    engine/haptics/coupling/coupling.hpp
    engine/penetration/search/pair.hpp
    engine/body/fingerprint.hpp
    engine/penetration/contact/separation.hpp
    engine/penetration/search/pose_seed.hpp
    engine/penetration/contact/clearance.hpp
    engine/penetration/search/static_options.hpp
    engine/queries/body_queries.hpp
    engine/queries/pair_queries.hpp
    engine/penetration/sensitivity/principal_stiffness.hpp
    engine/penetration/sensitivity/wrench_derivative.hpp
    engine/penetration/restricted/separate_within.hpp
    engine/penetration/search/pair_file.hpp
    engine/queries/pose_matrix.hpp
    engine/sonde.hpp)
set(source "${WORK}/face_alone.cpp")
set(deps "${WORK}/face_alone.d")
file(WRITE "${source}" [[
#include "engine/sonde.hpp"
template <class T>
concept Complete = requires { sizeof(T); };
static_assert(!Complete<sonde::Body> && !Complete<sonde::Sketches>, "opaque to programs outside");
int main() { return static_cast<int>(sonde::Separation{}.iterations); }
]])
execute_process(
  COMMAND "${COMPILER}" -std=c++20 -Wall -Wextra -Wconversion -Wpedantic -Werror -fsyntax-only -MD
          -MF "${deps}" "-I${PROJECT}" -isystem "${EIGEN}" "${source}"
  RESULT_VARIABLE result ERROR_VARIABLE errors)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "engine/sonde.hpp does not compile by itself:\n${errors}")
endif()

file(READ "${deps}" text)
string(REGEX MATCHALL "[^ \\\\\n]+\\.hpp|[^ \\\\\n]+/Eigen/[^ \\\\\n]+" headers "${text}")
set(eigen 0)
foreach(header IN LISTS headers)
  string(FIND "${header}" "${PROJECT}/" at)
  if(at EQUAL 0)
    file(RELATIVE_PATH name "${PROJECT}" "${header}")
    if(NOT name IN_LIST allowed)
      message(SEND_ERROR "engine/sonde.hpp includes ${name}")
    endif()
  elseif(header MATCHES "/Eigen/")
    set(eigen 1)
  else()
    message(SEND_ERROR "engine/sonde.hpp includes ${header}")
  endif()
endforeach()
foreach(library CGAL boost nlohmann hidapi gmp mpfr CLI vtk Qt)
  if(text MATCHES "/${library}[./]")
    message(SEND_ERROR "engine/sonde.hpp includes something of ${library}")
  endif()
endforeach()
if(NOT eigen)
  message(SEND_ERROR "the list of headers was not read")
endif()
