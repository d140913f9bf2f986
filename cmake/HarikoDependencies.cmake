# Libraries from the distribution; nothing is vendored.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(TBB REQUIRED)
# The CMake package of libzip asks for its command line tools, too.
pkg_check_modules(libzip REQUIRED IMPORTED_TARGET libzip)
find_package(EXPAT REQUIRED)
# Newer versions count in 64 bits and warn of the functions that do not.
include(CheckCXXSymbolExists)
set(CMAKE_REQUIRED_LIBRARIES EXPAT::EXPAT)
check_cxx_symbol_exists(XML_GetCurrentByteIndex64 expat.h HARIKO_EXPAT_64)
unset(CMAKE_REQUIRED_LIBRARIES)
pkg_check_modules(muparser REQUIRED IMPORTED_TARGET muparser)

# OpenSubdiv's own CMake package names static libraries that Debian does not ship, so it is looked up by hand.
find_path(OSD_INCLUDE opensubdiv/version.h REQUIRED)
find_library(OSD_CPU_LIB osdCPU REQUIRED)
add_library(osd::cpu UNKNOWN IMPORTED)
set_target_properties(osd::cpu PROPERTIES IMPORTED_LOCATION "${OSD_CPU_LIB}"
  INTERFACE_INCLUDE_DIRECTORIES "${OSD_INCLUDE}")

# STEP and IGES: opencascade::exchange, where it is installed. The package is complete only with all of these
# components, and takes a version for exactly that one.
set(HARIKO_OPENCASCADE OFF)
if(HARIKO_CAD)
  find_package(OpenCASCADE QUIET COMPONENTS FoundationClasses ModelingData ModelingAlgorithms Visualization
    ApplicationFramework DataExchange)
  if(OpenCASCADE_FOUND AND TARGET TKDESTEP)  # since 7.8
    set(HARIKO_EXCHANGE_KITS TKDESTEP TKDEIGES TKDE)
  else()
    set(HARIKO_EXCHANGE_KITS TKXDESTEP TKXDEIGES TKSTEP TKSTEP209 TKSTEPAttr TKSTEPBase TKIGES)
  endif()
  list(GET HARIKO_EXCHANGE_KITS 0 HARIKO_STEP_KIT)
  if(OpenCASCADE_FOUND AND TARGET ${HARIKO_STEP_KIT} AND OpenCASCADE_VERSION VERSION_GREATER_EQUAL 7.6)
    set(HARIKO_OPENCASCADE ON)
    message(STATUS "OpenCASCADE ${OpenCASCADE_VERSION}: the program reads and writes STEP and IGES")
    add_library(opencascade::exchange INTERFACE IMPORTED)
    target_include_directories(opencascade::exchange SYSTEM INTERFACE "${OpenCASCADE_INCLUDE_DIR}")
    target_link_libraries(opencascade::exchange INTERFACE ${HARIKO_EXCHANGE_KITS} TKXCAF TKLCAF TKCAF TKCDF TKXSBase
      TKShHealing TKMesh TKPrim TKTopAlgo TKGeomAlgo TKBRep TKGeomBase TKG3d TKG2d TKMath TKernel)
  elseif(OpenCASCADE_FOUND)
    message(STATUS "OpenCASCADE ${OpenCASCADE_VERSION} is too old or lacks STEP (7.6 is needed): "
      "the program will not read and write STEP and IGES")
  else()
    message(STATUS "OpenCASCADE was not found: the program will not read and write STEP and IGES "
      "(scripts/dependencies.sh cad installs it on Debian and Ubuntu)")
  endif()
endif()

if(HARIKO_WINDOW)
  find_package(glfw3 3.3 REQUIRED)
  find_package(X11 REQUIRED)
  find_package(glm REQUIRED)
  find_package(PNG REQUIRED)
  find_package(JPEG REQUIRED)
  find_package(Freetype REQUIRED)
  find_package(CLI11 REQUIRED)
  # WebP pictures: the library, where it is installed.
  pkg_check_modules(webp QUIET IMPORTED_TARGET libwebp)
  set(HARIKO_WEBP OFF)
  if(webp_FOUND)
    set(HARIKO_WEBP ON)
    message(STATUS "libwebp ${webp_VERSION}: the program reads WebP pictures")
  else()
    message(STATUS "libwebp was not found: the program will not read WebP pictures "
      "(scripts/dependencies.sh webp installs it on Debian and Ubuntu)")
  endif()
  # 3D mice: the library, where it is installed, talks to a daemon that may run or not.
  find_path(SPNAV_INCLUDE spnav.h)
  find_library(SPNAV_LIB spnav)
  set(HARIKO_SPACENAV OFF)
  if(SPNAV_INCLUDE AND SPNAV_LIB)
    set(HARIKO_SPACENAV ON)
    message(STATUS "libspnav: the program hears 3D mice")
  else()
    message(STATUS "libspnav was not found: the program will not hear 3D mice "
      "(scripts/dependencies.sh spacenav installs it on Debian and Ubuntu)")
  endif()
  pkg_check_modules(epoxy REQUIRED IMPORTED_TARGET epoxy)
  pkg_check_modules(fontconfig REQUIRED IMPORTED_TARGET fontconfig)
  # imgui.pc does not name FreeType, and the static library needs its link order: an own target.
  pkg_check_modules(IMGUI REQUIRED imgui)
  find_library(IMGUI_LIB imgui REQUIRED)
  find_library(STB_LIB stb REQUIRED)
  add_library(imgui::imgui STATIC IMPORTED)
  set_target_properties(imgui::imgui PROPERTIES IMPORTED_LOCATION "${IMGUI_LIB}"
    INTERFACE_INCLUDE_DIRECTORIES "${IMGUI_INCLUDE_DIRS}"
    INTERFACE_LINK_LIBRARIES "${STB_LIB};Freetype::Freetype;glfw;${CMAKE_DL_LIBS}")
endif()
if(HARIKO_TESTS)
  find_package(GTest REQUIRED)
endif()
if(HARIKO_BENCH)
  find_package(benchmark REQUIRED)
endif()
