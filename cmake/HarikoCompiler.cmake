# One place for the flags of our own code.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

# Release keeps assertions (no NDEBUG): a wrong result is worse than a slow one. Bench drops those of the libraries.
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -g1")
set(CMAKE_CXX_FLAGS_DEBUG "-O1 -g1 -fno-omit-frame-pointer")
set(CMAKE_CXX_FLAGS_BENCH "-O2 -g1 -DNDEBUG")
set(CMAKE_EXE_LINKER_FLAGS_BENCH "")
set(CMAKE_CXX_FLAGS_FUZZ "-O1 -g1 -fno-omit-frame-pointer")
set(CMAKE_EXE_LINKER_FLAGS_FUZZ "")

# Contracting a*b+c would make results depend on the machine: off, so that the same input gives the same output.
add_compile_options(-ffp-contract=off)

add_library(hariko_warnings INTERFACE)
target_compile_options(hariko_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Werror)
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
if(HARIKO_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link,address,undefined ${HARIKO_UNDEFINED_BEHAVIOUR})
  add_link_options(-fsanitize=address,undefined)
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CCACHE_PROGRAM}")
endif()
