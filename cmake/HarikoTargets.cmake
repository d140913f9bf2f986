# Precompiled headers: of libraries alone, for the lowest folders; of the core's meshes and surfaces, of documents, of
# the interface, for what stands on these; and the last two with GoogleTest, as the tests' flags differ. The benchmarks'
# build goes without, and compiles every file alone: it shows where a file relies on what only others include.
set(HARIKO_PRECOMPILE ON)
if(HARIKO_BENCH)
  set(HARIKO_PRECOMPILE OFF)
endif()
if(HARIKO_PRECOMPILE AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC takes concatenated strings and small vectors for overflows; in a precompiled header its mark of a library's own
  # code, which silences that, is lost.
  target_compile_options(hariko_warnings INTERFACE -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow)
endif()
set(HARIKO_PRECOMPILED_SOURCE "${CMAKE_CURRENT_BINARY_DIR}/precompiled.cpp")
file(CONFIGURE OUTPUT "${HARIKO_PRECOMPILED_SOURCE}" CONTENT "")

# hariko_precompiled(NAME HEADERS header... LINKS target...): the target hariko_precompiled_NAME, for others to reuse.
function(hariko_precompiled NAME)
  cmake_parse_arguments(ARG "" "" "HEADERS;LINKS" ${ARGN})
  if(HARIKO_PRECOMPILE)
    add_library(hariko_precompiled_${NAME} OBJECT "${HARIKO_PRECOMPILED_SOURCE}")
    target_include_directories(hariko_precompiled_${NAME} PRIVATE "${PROJECT_SOURCE_DIR}")
    target_link_libraries(hariko_precompiled_${NAME} PRIVATE Eigen3::Eigen ${ARG_LINKS} hariko_warnings)
    target_precompile_headers(hariko_precompiled_${NAME} PRIVATE ${ARG_HEADERS})
  endif()
endfunction()

# Tests are two fifths of what is compiled and little of what runs long: optimising them is more than half of their
# compile time, and saves less when they run, but for a few (hariko_test_program keeps the code they test as it is);
# checks for undefined behaviour, which are for the code they test, are a third in the sanitizer build.
add_library(hariko_test_options INTERFACE)
target_compile_options(hariko_test_options INTERFACE $<$<CONFIG:Release>:-O0 -g0>
  $<$<BOOL:${HARIKO_SANITIZE}>:-fno-sanitize=undefined>)

set(HARIKO_INTERFACE_LIBRARIES hariko_cad_kernel hariko_render imgui::imgui)
# Code that stands on the interface's header waits for people and for the core, and inlines less, which saves a fifth of
# its compile time.
add_library(hariko_interface_options INTERFACE)
target_compile_options(hariko_interface_options INTERFACE $<$<CONFIG:Release,Bench>:-Os>)
hariko_precompiled(libraries HEADERS "${PROJECT_SOURCE_DIR}/cmake/precompiled.hpp")
hariko_precompiled(core HEADERS "${PROJECT_SOURCE_DIR}/cmake/precompiled_core.hpp")
hariko_precompiled(document HEADERS "${PROJECT_SOURCE_DIR}/cmake/precompiled_document.hpp")
if(HARIKO_WINDOW)
  hariko_precompiled(interface HEADERS "${PROJECT_SOURCE_DIR}/cmake/precompiled_interface.hpp"
    LINKS ${HARIKO_INTERFACE_LIBRARIES} hariko_interface_options)
endif()
if(HARIKO_TESTS)
  hariko_precompiled(document_tests HEADERS "${PROJECT_SOURCE_DIR}/cmake/precompiled_document.hpp" <gtest/gtest.h>
    LINKS GTest::gtest_main hariko_test_options)
  if(HARIKO_WINDOW)
    hariko_precompiled(interface_tests HEADERS "${PROJECT_SOURCE_DIR}/cmake/precompiled_interface.hpp" <gtest/gtest.h>
      LINKS ${HARIKO_INTERFACE_LIBRARIES} GTest::gtest_main hariko_test_options)
  endif()
endif()

# Precompiled header that a target begins with.
function(hariko_precompile NAME PRECOMPILED)
  if(HARIKO_PRECOMPILE)
    target_precompile_headers(${NAME} REUSE_FROM hariko_precompiled_${PRECOMPILED})
  endif()
endfunction()

# Files that are compiled together share what they include and instantiate, and also their unnamed namespaces: names in
# them have to differ within a batch. hariko_unity(NAME): batches of a target's files, as few as there can be of at most
# HARIKO_BATCH bytes and equally large, so that none takes long after an edit.
set(HARIKO_BATCH 96000)
function(hariko_unity NAME)
  if(NOT HARIKO_UNITY)
    return()
  endif()
  get_target_property(SOURCES ${NAME} SOURCES)
  list(FILTER SOURCES INCLUDE REGEX "\\.cpp$")
  set(TOTAL 0)
  foreach(SOURCE ${SOURCES})
    file(SIZE "${SOURCE}" BYTES)
    math(EXPR TOTAL "${TOTAL} + ${BYTES}")
  endforeach()
  math(EXPR BATCHES "(${TOTAL} + ${HARIKO_BATCH} - 1) / ${HARIKO_BATCH}")
  set(BEFORE 0)
  foreach(SOURCE ${SOURCES})
    math(EXPR BATCH "${BATCHES} * ${BEFORE} / ${TOTAL} + 1")
    set_source_files_properties("${SOURCE}" PROPERTIES UNITY_GROUP "batch_${BATCH}")
    file(SIZE "${SOURCE}" BYTES)
    math(EXPR BEFORE "${BEFORE} + ${BYTES}")
  endforeach()
  set_target_properties(${NAME} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()

# hariko_library(NAME PRECOMPILED header FOLDERS folder... LINKS target...): a static library of every .cpp in the current
# folder and in the folders given, not below, that begins with one of the precompiled headers above (core if not said).
function(hariko_library NAME)
  cmake_parse_arguments(ARG "" "PRECOMPILED" "FOLDERS;LINKS;PRIVATE_LINKS" ${ARGN})
  if(NOT ARG_PRECOMPILED)
    set(ARG_PRECOMPILED core)
  endif()
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
  if(ARG_PRECOMPILED STREQUAL "interface")
    target_link_libraries(${NAME} PRIVATE hariko_interface_options)
  endif()
  hariko_precompile(${NAME} ${ARG_PRECOMPILED})
  hariko_unity(${NAME})
endfunction()

# hariko_test(NAME PROGRAM core|app|window LINKS target...): the GoogleTest files of the current folder, as a part of one
# of three test programs; `ctest -R SUITE` chooses among the tests of all. INTERFACE: nearly all of them include the
# editor. OPTIMISED: they compare millions of points themselves.
function(hariko_test NAME)
  cmake_parse_arguments(ARG "INTERFACE;OPTIMISED" "PROGRAM" "LINKS" ${ARGN})
  file(GLOB SOURCES CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.cpp")
  add_library(${NAME} OBJECT ${SOURCES})
  target_include_directories(${NAME} PRIVATE "${PROJECT_SOURCE_DIR}")
  target_link_libraries(${NAME} PUBLIC ${ARG_LINKS} Eigen3::Eigen GTest::gtest_main hariko_test_places
    PRIVATE hariko_warnings)
  if(ARG_OPTIMISED)
    hariko_precompile(${NAME} document)
  else()
    target_link_libraries(${NAME} PRIVATE hariko_test_options)
    if(ARG_INTERFACE)
      hariko_precompile(${NAME} interface_tests)
    else()
      hariko_precompile(${NAME} document_tests)
    endif()
  endif()
  hariko_unity(${NAME})
  set_property(GLOBAL APPEND PROPERTY HARIKO_${ARG_PROGRAM}_TESTS ${NAME})
endfunction()

# Static libraries of ours that targets link, directly or not, into the variable RESULT.
function(hariko_linked_libraries RESULT)
  set(TO_VISIT ${ARGN})
  set(VISITED)
  set(LIBRARIES)
  while(TO_VISIT)
    list(POP_FRONT TO_VISIT NAME)
    if(NOT TARGET "${NAME}" OR NAME IN_LIST VISITED)
      continue()
    endif()
    list(APPEND VISITED ${NAME})
    get_target_property(IMPORTED ${NAME} IMPORTED)
    if(IMPORTED)
      continue()
    endif()
    get_target_property(KIND ${NAME} TYPE)
    if(KIND STREQUAL "STATIC_LIBRARY")
      list(APPEND LIBRARIES ${NAME})
    endif()
    foreach(PROPERTY LINK_LIBRARIES INTERFACE_LINK_LIBRARIES)
      get_target_property(LINKED ${NAME} ${PROPERTY})
      if(LINKED)
        list(APPEND TO_VISIT ${LINKED})
      endif()
    endforeach()
  endwhile()
  set(${RESULT} ${LIBRARIES} PARENT_SCOPE)
endfunction()

# hariko_test_program(PROGRAM LABEL TIMEOUT): the program of the folders that named it, after all of them. Of an inline
# function that tests and libraries both contain, the linker takes the copy that it meets first: the libraries, whole,
# come before the tests, so that what is tested is the code that is shipped, at its speed.
function(hariko_test_program PROGRAM LABEL TIMEOUT)
  get_property(PARTS GLOBAL PROPERTY HARIKO_${PROGRAM}_TESTS)
  if(PARTS)
    add_executable(${PROGRAM}_tests)
    target_link_libraries(${PROGRAM}_tests PRIVATE ${PARTS})
    hariko_linked_libraries(LIBRARIES ${PARTS})
    list(TRANSFORM LIBRARIES REPLACE "(.+)" "$<TARGET_FILE:\\1>" OUTPUT_VARIABLE ARCHIVES)
    target_link_options(${PROGRAM}_tests PRIVATE -Wl,--whole-archive ${ARCHIVES} -Wl,--no-whole-archive)
    gtest_discover_tests(${PROGRAM}_tests DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60
      PROPERTIES LABELS ${LABEL} TIMEOUT ${TIMEOUT})
  endif()
endfunction()
