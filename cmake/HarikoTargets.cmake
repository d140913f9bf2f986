# Precompiled headers of what nearly every file includes, one for libraries and one for test programs: flags differ.
# The benchmarks' build goes without, and compiles every file alone: it shows where a file relies on what only others
# include.
set(HARIKO_PRECOMPILE ON)
if(HARIKO_BENCH)
  set(HARIKO_PRECOMPILE OFF)
endif()
set(HARIKO_PRECOMPILED_SOURCE "${CMAKE_CURRENT_BINARY_DIR}/precompiled.cpp")
file(CONFIGURE OUTPUT "${HARIKO_PRECOMPILED_SOURCE}" CONTENT "")
if(HARIKO_PRECOMPILE)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # GCC takes concatenated strings and small vectors for overflows; in a precompiled header its mark of a
    # library's own code, which silences that, is lost.
    target_compile_options(hariko_warnings INTERFACE -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow)
  endif()
  add_library(hariko_precompiled OBJECT "${HARIKO_PRECOMPILED_SOURCE}")
  target_link_libraries(hariko_precompiled PRIVATE Eigen3::Eigen hariko_warnings)
  target_precompile_headers(hariko_precompiled PRIVATE "${PROJECT_SOURCE_DIR}/cmake/precompiled.hpp")
endif()
# Tests are two fifths of what is compiled and little of what runs long: they build faster with fewer optimisations,
# and in the sanitizer build without the checks for undefined behaviour, which are for the code they test and a third
# of their compile time.
add_library(hariko_test_options INTERFACE)
target_compile_options(hariko_test_options INTERFACE $<$<CONFIG:Release>:-O1 -g0>
  $<$<BOOL:${HARIKO_SANITIZE}>:-fno-sanitize=undefined>)

# The same for what uses the interface.
if(HARIKO_PRECOMPILE AND HARIKO_WINDOW)
  add_library(hariko_precompiled_interface OBJECT "${HARIKO_PRECOMPILED_SOURCE}")
  target_include_directories(hariko_precompiled_interface PRIVATE "${PROJECT_SOURCE_DIR}")
  target_link_libraries(hariko_precompiled_interface PRIVATE hariko_cad_kernel hariko_render imgui::imgui hariko_warnings)
  target_precompile_headers(hariko_precompiled_interface PRIVATE "${PROJECT_SOURCE_DIR}/cmake/precompiled_interface.hpp")
endif()

if(HARIKO_PRECOMPILE AND HARIKO_TESTS)
  add_library(hariko_precompiled_tests OBJECT "${HARIKO_PRECOMPILED_SOURCE}")
  target_link_libraries(hariko_precompiled_tests PRIVATE Eigen3::Eigen GTest::gtest_main hariko_warnings
    hariko_test_options)
  target_precompile_headers(hariko_precompiled_tests PRIVATE "${PROJECT_SOURCE_DIR}/cmake/precompiled.hpp"
    <gtest/gtest.h>)
  if(TARGET hariko_precompiled_interface)
    add_library(hariko_precompiled_interface_tests OBJECT "${HARIKO_PRECOMPILED_SOURCE}")
    target_include_directories(hariko_precompiled_interface_tests PRIVATE "${PROJECT_SOURCE_DIR}")
    target_link_libraries(hariko_precompiled_interface_tests PRIVATE hariko_cad_kernel hariko_render imgui::imgui
      GTest::gtest_main hariko_warnings hariko_test_options)
    target_precompile_headers(hariko_precompiled_interface_tests PRIVATE
      "${PROJECT_SOURCE_DIR}/cmake/precompiled_interface.hpp" <gtest/gtest.h>)
  endif()
endif()

# Precompiled header that a target begins with: that of the interface where it is asked for and there.
function(hariko_precompile NAME USUAL INTERFACE)
  if(INTERFACE AND TARGET hariko_precompiled_interface)
    string(REPLACE hariko_precompiled hariko_precompiled_interface USUAL ${USUAL})
  endif()
  if(HARIKO_PRECOMPILE)
    target_precompile_headers(${NAME} REUSE_FROM ${USUAL})
  endif()
endfunction()

# Files that are compiled together share what they include and instantiate, and also their unnamed namespaces: names in
# them have to differ within a batch.
function(hariko_unity NAME)
  if(HARIKO_UNITY)
    set_target_properties(${NAME} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  endif()
endfunction()

# hariko_unity_folder(FOLDER sources...): batches of this folder alone, for targets of several.
function(hariko_unity_folder FOLDER)
  list(FILTER ARGN INCLUDE REGEX "\\.cpp$")
  set(NUMBER 0)
  foreach(SOURCE ${ARGN})
    math(EXPR BATCH "${NUMBER} / 8")
    string(MAKE_C_IDENTIFIER "folder_${FOLDER}_${BATCH}" GROUP)
    set_source_files_properties("${SOURCE}" PROPERTIES UNITY_GROUP "${GROUP}")
    math(EXPR NUMBER "${NUMBER} + 1")
  endforeach()
endfunction()

# hariko_library(NAME FOLDERS folder... LINKS target...): a static library of every .cpp in the current folder and in
# the folders given, not below. INTERFACE: nearly all of them include the editor.
function(hariko_library NAME)
  cmake_parse_arguments(ARG "INTERFACE" "" "FOLDERS;LINKS;PRIVATE_LINKS" ${ARGN})
  set(SOURCES)
  foreach(FOLDER . ${ARG_FOLDERS})
    file(GLOB FOUND CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/${FOLDER}/*.cpp"
      "${CMAKE_CURRENT_SOURCE_DIR}/${FOLDER}/*.hpp")
    list(APPEND SOURCES ${FOUND})
    if(ARG_FOLDERS)
      hariko_unity_folder("${FOLDER}" ${FOUND})
    endif()
  endforeach()
  add_library(${NAME} STATIC ${SOURCES})
  set_target_properties(${NAME} PROPERTIES LINKER_LANGUAGE CXX)
  target_include_directories(${NAME} PUBLIC "${PROJECT_SOURCE_DIR}")
  target_link_libraries(${NAME} PUBLIC ${ARG_LINKS} PRIVATE ${ARG_PRIVATE_LINKS} hariko_warnings)
  hariko_precompile(${NAME} hariko_precompiled "${ARG_INTERFACE}")
  hariko_unity(${NAME})
  if(ARG_FOLDERS)
    set_target_properties(${NAME} PROPERTIES UNITY_BUILD_MODE GROUP)
  endif()
endfunction()

# hariko_test(NAME PROGRAM core|app|window LINKS target...): the GoogleTest files of the current folder, as a part of one
# of three test programs; `ctest -R SUITE` chooses among the tests of all.
function(hariko_test NAME)
  cmake_parse_arguments(ARG "INTERFACE" "PROGRAM" "LINKS" ${ARGN})
  file(GLOB SOURCES CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.cpp")
  add_library(${NAME} OBJECT ${SOURCES})
  target_include_directories(${NAME} PRIVATE "${PROJECT_SOURCE_DIR}")
  target_link_libraries(${NAME} PUBLIC ${ARG_LINKS} Eigen3::Eigen GTest::gtest_main hariko_test_places PRIVATE hariko_warnings
    hariko_test_options)
  hariko_precompile(${NAME} hariko_precompiled_tests "${ARG_INTERFACE}")
  hariko_unity(${NAME})
  set_property(GLOBAL APPEND PROPERTY HARIKO_${ARG_PROGRAM}_TESTS ${NAME})
endfunction()

# hariko_test_program(PROGRAM LABEL TIMEOUT): the program of the folders that named it, after all of them.
function(hariko_test_program PROGRAM LABEL TIMEOUT)
  get_property(PARTS GLOBAL PROPERTY HARIKO_${PROGRAM}_TESTS)
  if(PARTS)
    add_executable(${PROGRAM}_tests)
    target_link_libraries(${PROGRAM}_tests PRIVATE ${PARTS})
    gtest_discover_tests(${PROGRAM}_tests DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60
      PROPERTIES LABELS ${LABEL} TIMEOUT ${TIMEOUT})
  endif()
endfunction()
