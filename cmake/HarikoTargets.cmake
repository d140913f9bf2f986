# What nearly every file includes, compiled once for libraries and once for test programs, whose flags differ.
# The fuzzer build goes without: it shows where a file of core/ relies on what only this includes.
set(HARIKO_PRECOMPILE OFF)
if(NOT HARIKO_FUZZ)
  set(HARIKO_PRECOMPILE ON)
endif()
set(HARIKO_PRECOMPILED_SOURCE "${CMAKE_CURRENT_BINARY_DIR}/precompiled.cpp")
file(CONFIGURE OUTPUT "${HARIKO_PRECOMPILED_SOURCE}" CONTENT "")
if(HARIKO_PRECOMPILE)
  # GCC 12 takes concatenated strings and small vectors for overflows; in a precompiled header its mark of a
  # library's own code, which silences that, is lost.
  target_compile_options(hariko_warnings INTERFACE -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow)
  add_library(hariko_precompiled OBJECT "${HARIKO_PRECOMPILED_SOURCE}")
  target_link_libraries(hariko_precompiled PRIVATE Eigen3::Eigen hariko_warnings)
  target_precompile_headers(hariko_precompiled PRIVATE "${PROJECT_SOURCE_DIR}/cmake/precompiled.hpp")
endif()
# Tests are two fifths of what is compiled and little of what runs long: they build faster with fewer optimisations.
add_library(hariko_test_options INTERFACE)
target_compile_options(hariko_test_options INTERFACE $<$<CONFIG:Release>:-O1 -g0>)

if(HARIKO_PRECOMPILE AND HARIKO_TESTS)
  add_executable(hariko_precompiled_tests "${HARIKO_PRECOMPILED_SOURCE}")
  target_link_libraries(hariko_precompiled_tests PRIVATE Eigen3::Eigen GTest::gtest_main hariko_warnings
    hariko_test_options)
  target_precompile_headers(hariko_precompiled_tests PRIVATE "${PROJECT_SOURCE_DIR}/cmake/precompiled.hpp"
    <gtest/gtest.h>)
endif()

# hariko_library(NAME FOLDERS folder... LINKS target...): a static library of every .cpp in the current folder and in
# the folders given, not below.
function(hariko_library NAME)
  cmake_parse_arguments(ARG "" "" "FOLDERS;LINKS;PRIVATE_LINKS" ${ARGN})
  set(SOURCES)
  foreach(FOLDER . ${ARG_FOLDERS})
    file(GLOB FOUND CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/${FOLDER}/*.cpp"
      "${CMAKE_CURRENT_SOURCE_DIR}/${FOLDER}/*.hpp")
    list(APPEND SOURCES ${FOUND})
  endforeach()
  add_library(${NAME} STATIC ${SOURCES})
  set_target_properties(${NAME} PROPERTIES LINKER_LANGUAGE CXX)
  target_include_directories(${NAME} PUBLIC "${PROJECT_SOURCE_DIR}")
  target_link_libraries(${NAME} PUBLIC ${ARG_LINKS} PRIVATE ${ARG_PRIVATE_LINKS} hariko_warnings)
  if(HARIKO_PRECOMPILE)
    target_precompile_headers(${NAME} REUSE_FROM hariko_precompiled)
  endif()
endfunction()

# hariko_test(NAME LABEL core|window LINKS target...): a GoogleTest program of every .cpp in the current folder.
function(hariko_test NAME)
  cmake_parse_arguments(ARG "" "LABEL;TIMEOUT" "LINKS" ${ARGN})
  if(NOT ARG_LABEL)
    set(ARG_LABEL core)
  endif()
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 600)
  endif()
  file(GLOB SOURCES CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.cpp")
  add_executable(${NAME} ${SOURCES})
  target_include_directories(${NAME} PRIVATE "${PROJECT_SOURCE_DIR}")
  target_compile_definitions(${NAME} PRIVATE HARIKO_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_link_libraries(${NAME} PRIVATE ${ARG_LINKS} GTest::gtest_main hariko_warnings hariko_test_options)
  if(HARIKO_PRECOMPILE)
    target_precompile_headers(${NAME} REUSE_FROM hariko_precompiled_tests)
  endif()
  gtest_discover_tests(${NAME} DISCOVERY_MODE PRE_TEST
    PROPERTIES LABELS ${ARG_LABEL} TIMEOUT ${ARG_TIMEOUT})
endfunction()
