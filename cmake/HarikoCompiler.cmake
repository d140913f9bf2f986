# One place for the flags of our own code.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

# Release keeps assertions (no NDEBUG): a wrong result is worse than a slow one. Bench drops those of the libraries.
set(CMAKE_CXX_FLAGS_RELEASE "-O2")
set(CMAKE_CXX_FLAGS_DEBUG "-O1 -g1 -fno-omit-frame-pointer")
set(CMAKE_CXX_FLAGS_BENCH "-O2 -g1 -DNDEBUG")
set(CMAKE_EXE_LINKER_FLAGS_BENCH "")

# Contracting a*b+c would make results depend on the machine: off, so that the same input gives the same output.
add_compile_options(-ffp-contract=off)

add_library(hariko_warnings INTERFACE)
target_compile_options(hariko_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow $<$<BOOL:${HARIKO_WERROR}>:-Werror>)
if(HARIKO_UNITY)
  # Files that are compiled together look like headers to the first of these, and hide constants of other files by their
  # parameters for the second, which GCC's -Wshadow does not mind.
  target_compile_options(hariko_warnings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>
    $<$<CXX_COMPILER_ID:Clang>:-Wno-shadow>)
endif()

# The checks left out are a sixth of the compile time, and what a null pointer does the address sanitizer tells as well.
set(HARIKO_UNDEFINED_BEHAVIOUR -fno-sanitize=null,alignment,object-size,vptr -fno-sanitize-recover=undefined)
if(HARIKO_SANITIZE)
  add_compile_options(-fsanitize=address,undefined ${HARIKO_UNDEFINED_BEHAVIOUR})
  add_link_options(-fsanitize=address,undefined)
endif()

# LLVM's linker takes a tenth of the usual one's time.
find_program(HARIKO_LLD ld.lld)
if(HARIKO_LLD)
  add_link_options(-fuse-ld=lld)
endif()

# ccache takes a precompiled header only where the compiler tells it what was in it (GCC) or leaves the time out of it
# (clang), and where it may overlook that macros and times of headers could matter. Paths below the checkout count
# relative to it. Whether warnings are errors does not matter to what is compiled; test.sh looks for repeated warnings.
# Headers are compared themselves (DEPEND) and not by what the preprocessor makes of them: after an update of the system
# that changes comments alone, a precompiled header of before would be taken, and the compiler refuses it.
# Compilers ask for much memory in small pieces, which large pages make faster by a twentieth (glibc from 2.35 on).
find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND}" -E env GLIBC_TUNABLES=glibc.malloc.hugetlb=1 "CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}" CCACHE_NOHASHDIR=1
    CCACHE_DEPEND=1 CCACHE_IGNOREOPTIONS=-Werror CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime "${CCACHE_PROGRAM}")
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options(-fpch-preprocess)
else()
  add_compile_options("SHELL:-Xclang -fno-pch-timestamp")
endif()

# A compiler takes 0.8 GB: as many at a time as there is memory for, and Ninja's own number at most.
cmake_host_system_information(RESULT HARIKO_MEMORY QUERY TOTAL_PHYSICAL_MEMORY)  # in MiB
cmake_host_system_information(RESULT HARIKO_CORES QUERY NUMBER_OF_LOGICAL_CORES)
math(EXPR HARIKO_COMPILES "${HARIKO_MEMORY} / 820")
math(EXPR HARIKO_MOST "${HARIKO_CORES} + 2")
if(HARIKO_COMPILES GREATER HARIKO_MOST)
  set(HARIKO_COMPILES ${HARIKO_MOST})
elseif(HARIKO_COMPILES LESS 1)
  set(HARIKO_COMPILES 1)
endif()
set_property(GLOBAL APPEND PROPERTY JOB_POOLS "compiles=${HARIKO_COMPILES}")
set(CMAKE_JOB_POOL_COMPILE compiles)
