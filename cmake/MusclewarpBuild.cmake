# Helpers of this build: warnings, sanitizers, one call per library and test.
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
find_program(MUSCLEWARP_CCACHE ccache)
if(MUSCLEWARP_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # ccache takes no precompiled headers unless it is told to. What it keeps serves
  # every checkout, as paths are taken relative to its root.
  set(CMAKE_CXX_COMPILER_LAUNCHER
      ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros
      CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}
      ${MUSCLEWARP_CCACHE})
endif()
# Most of the time to compile a source goes into the headers of Eigen, CGAL,
# Ceres and GoogleTest, which up to eight sources then share.
if(MUSCLEWARP_UNITY_BUILD AND NOT DEFINED CMAKE_UNITY_BUILD)
  set(CMAKE_UNITY_BUILD ON)
  set(CMAKE_UNITY_BUILD_BATCH_SIZE 8)
endif()
# The libraries also go into modules of other languages, which are loaded.
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
include(GNUInstallDirs)
set(MUSCLEWARP_INSTALL_INCLUDEDIR ${CMAKE_INSTALL_INCLUDEDIR}/musclewarp)

# g++ 12 reports uninitialised values inside libstdc++ and Eigen that are none.
# clang++ suggests && for the & of boxes, which is there to save branches.
add_library(musclewarp_compile_options INTERFACE)
target_compile_options(
  musclewarp_compile_options
  INTERFACE -Wall -Wextra -Wshadow
            # Files in messages of glog are named alike in every checkout.
            -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=
            $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>
            $<$<CXX_COMPILER_ID:Clang>:-Wno-bitwise-instead-of-logical>)
if(MUSCLEWARP_WARNINGS_AS_ERRORS)
  target_compile_options(musclewarp_compile_options INTERFACE -Werror)
endif()
if(MUSCLEWARP_SANITIZE)
  # Without -fno-sanitize-recover undefined behaviour is only printed. The
  # checks left out cost half of the time to compile: a null pointer stops the
  # program anyway, Eigen asserts the alignment of its own types, nothing casts
  # between classes, and the address sanitizer sees what is read beyond an
  # object. Standard containers check their indices, as Eigen's do.
  add_compile_options(
    -fsanitize=address,undefined
    -fno-sanitize=null,alignment,vptr,object-size,pointer-overflow
    -fno-sanitize-recover=all -fno-omit-frame-pointer)
  # Eigen allocates in another way under a sanitizer, unless it is told that
  # malloc aligns; libceres, which is built without one, frees what we allocate.
  add_compile_definitions(_GLIBCXX_ASSERTIONS EIGEN_MALLOC_ALREADY_ALIGNED=1)
  add_link_options(-fsanitize=address,undefined)
endif()
if(MUSCLEWARP_SANITIZE_THREADS)
  add_compile_options(-fsanitize=thread -fno-omit-frame-pointer)
  add_link_options(-fsanitize=thread)
endif()
if(MUSCLEWARP_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

# The sanitizers leave what calls this function optimised: it computes so much
# that its tests would take longer than optimising it. All else compiles in half
# of the time without.
function(musclewarp_optimise_with_sanitizers TARGET)
  if(MUSCLEWARP_SANITIZE)
    target_compile_options(${TARGET} PRIVATE -O1)
  endif()
endfunction()

# For libraries that are LIGHT (below), and the programs.
function(musclewarp_optimise_lightly TARGET)
  target_compile_options(${TARGET} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# The sanitizers leave these sources alone, which hand meshes to CGAL and take
# them back: its templates take minutes to compile with them.
function(musclewarp_do_not_sanitize)
  if(MUSCLEWARP_SANITIZE)
    set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS
                                                   -fno-sanitize=all)
  endif()
endfunction()

# What most sources include, parsed once for all libraries and programs. Clang
# takes precompiled headers with the very same options alone, which those of the
# sanitizers are not.
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND NOT MUSCLEWARP_SANITIZE)
  set(MUSCLEWARP_PRECOMPILED_HEADERS
      <algorithm> <array> <cmath> <filesystem> <fstream> <functional> <iomanip>
      <iostream> <limits> <map> <memory> <numeric> <optional> <set> <sstream>
      <string> <string_view> <tuple> <utility> <vector> <Eigen/Dense>
      <Eigen/Sparse> <glog/logging.h>)
endif()
function(musclewarp_precompiled_headers TARGET)
  if(NOT MUSCLEWARP_PRECOMPILED_HEADERS)
    return()
  endif()
  if("${TARGET}" STREQUAL "musclewarp_base")
    target_precompile_headers(${TARGET} PRIVATE ${MUSCLEWARP_PRECOMPILED_HEADERS})
  else()
    target_precompile_headers(${TARGET} REUSE_FROM musclewarp_base)
  endif()
endfunction()

# musclewarp_library(<name> SOURCES ... LINK ...) makes the static library
# musclewarp_<name>, alias musclewarp::<name>. A folder has one, or two if a part
# of it needs more than the rest. Includes are written from the root:
# "musclewarp/<folder>/x.h" or "problems/<folder>/x.h". COMPUTES says that it is
# optimised with the sanitizers, too; LIGHT that it is compiled with -O1, as what
# it does takes a run no time to speak of.
function(musclewarp_library NAME)
  cmake_parse_arguments(ARG "COMPUTES;LIGHT" "" "SOURCES;LINK;PRIVATE_LINK" ${ARGN})
  add_library(musclewarp_${NAME} STATIC ${ARG_SOURCES})
  add_library(musclewarp::${NAME} ALIAS musclewarp_${NAME})
  target_include_directories(
    musclewarp_${NAME}
    PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
           $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
           $<INSTALL_INTERFACE:${MUSCLEWARP_INSTALL_INCLUDEDIR}>)
  target_compile_features(musclewarp_${NAME} PUBLIC cxx_std_17)
  target_link_libraries(musclewarp_${NAME} PUBLIC ${ARG_LINK})
  target_link_libraries(
    musclewarp_${NAME}
    PRIVATE $<BUILD_INTERFACE:musclewarp_compile_options> ${ARG_PRIVATE_LINK})
  if(ARG_COMPUTES)
    musclewarp_optimise_with_sanitizers(musclewarp_${NAME})
  endif()
  if(ARG_LIGHT)
    musclewarp_optimise_lightly(musclewarp_${NAME})
  endif()
  musclewarp_precompiled_headers(musclewarp_${NAME})
  set_target_properties(musclewarp_${NAME} PROPERTIES EXPORT_NAME ${NAME})
  set_property(GLOBAL APPEND PROPERTY MUSCLEWARP_LIBRARIES musclewarp_${NAME})
endfunction()

# musclewarp_test(<folder> SOURCES ... LINK ...): one test program per folder,
# every GoogleTest case a ctest case named <folder>/<suite>.<case> (with the
# sanitizers, the program is one ctest case, <folder>_test). The sources
# named *_data_test.cc need real data; their cases carry the label "data", all
# others the label "unit", unless RUNS_PROGRAMS says that they start programs of
# tools/. COMPUTES says that the tests compute so much themselves that they have
# to be optimised with the sanitizers, too. The target musclewarp_unit_tests
# builds what the label "unit" runs.
function(musclewarp_test NAME)
  cmake_parse_arguments(ARG "RUNS_PROGRAMS;COMPUTES" "" "SOURCES;LINK" ${ARGN})
  set(DATA_SOURCES ${ARG_SOURCES})
  list(FILTER DATA_SOURCES INCLUDE REGEX "_data_test\\.cc$")
  list(FILTER ARG_SOURCES EXCLUDE REGEX "_data_test\\.cc$")
  if(ARG_RUNS_PROGRAMS)
    _musclewarp_test_program(${NAME}_test "${ARG_SOURCES}" TIMEOUT 600)
  else()
    _musclewarp_test_program(${NAME}_test "${ARG_SOURCES}" TIMEOUT 600
                             LABELS unit)
    add_dependencies(musclewarp_unit_tests ${NAME}_test)
  endif()
  _musclewarp_test_program(${NAME}_data_test "${DATA_SOURCES}" TIMEOUT 1800
                           LABELS data)
endfunction()

# What the tests themselves compute is little, and they compile in two thirds of
# the time. The libraries are what the sanitizers watch: instrumented and
# optimised, the tests would take as long to compile as all that they test.
function(musclewarp_test_options TARGET)
  target_compile_options(${TARGET} PRIVATE $<$<CONFIG:Release>:-O1>)
  if(MUSCLEWARP_SANITIZE)
    target_compile_options(${TARGET} PRIVATE -fno-sanitize=all)
  endif()
  if(ARG_COMPUTES)
    musclewarp_optimise_with_sanitizers(${TARGET})
  endif()
  # Precompiled headers are read only where these options are the same.
  set_target_properties(${TARGET} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
endfunction()

# Uses NAME and ARG_LINK of musclewarp_test; the rest are test properties.
function(_musclewarp_test_program PROGRAM SOURCES)
  if(NOT SOURCES)
    return()
  endif()
  add_executable(${PROGRAM} ${SOURCES})
  target_link_libraries(
    ${PROGRAM} PRIVATE musclewarp_test_support musclewarp_compile_options
                       ${ARG_LINK})
  musclewarp_test_options(${PROGRAM})
  if(NOT (MUSCLEWARP_SANITIZE AND ARG_COMPUTES))
    target_precompile_headers(${PROGRAM} REUSE_FROM musclewarp_test_support)
  endif()
  if(MUSCLEWARP_SANITIZE)
    # A process for every case would take longer to start than most cases run.
    add_test(NAME ${PROGRAM} COMMAND ${PROGRAM} --gtest_brief=1)
    set_tests_properties(${PROGRAM} PROPERTIES ${ARGN})
    return()
  endif()
  gtest_discover_tests(
    ${PROGRAM}
    TEST_PREFIX ${NAME}/
    DISCOVERY_TIMEOUT 60
    PROPERTIES ${ARGN})
endfunction()
