# Installed files and the Debian package. Nothing installed holds an absolute path: the program finds its
# data from where it lies, so a prefix can be moved.
include(GNUInstallDirs)

set(HARIKO_DESKTOP "${PROJECT_SOURCE_DIR}/assets/desktop")

# The build folder has the data where an installed program has them, one folder up from its own.
set(HARIKO_BUILD_DATA "${CMAKE_BINARY_DIR}/share/hariko")
file(MAKE_DIRECTORY "${HARIKO_BUILD_DATA}" "${HARIKO_PICTURES}")
foreach(FOLDER languages samples)
  file(RELATIVE_PATH TARGET "${HARIKO_BUILD_DATA}" "${PROJECT_SOURCE_DIR}/assets/${FOLDER}")
  file(CREATE_LINK "${TARGET}" "${HARIKO_BUILD_DATA}/${FOLDER}" SYMBOLIC)
endforeach()
file(CREATE_LINK ../../assets/samples-pictures "${HARIKO_BUILD_DATA}/pictures" SYMBOLIC)
file(RELATIVE_PATH TARGET "${CMAKE_BINARY_DIR}/share" "${PROJECT_SOURCE_DIR}/assets/icons")
file(CREATE_LINK "${TARGET}" "${CMAKE_BINARY_DIR}/share/icons" SYMBOLIC)

# CMake's targets of OpenCASCADE and others name more libraries than the program uses: each would be loaded at the start
# and be a package to install.
target_link_options(hariko PRIVATE LINKER:--as-needed)

set(CMAKE_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
  WORLD_READ WORLD_EXECUTE)
install(TARGETS hariko RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
install(DIRECTORY assets/languages assets/samples DESTINATION "${CMAKE_INSTALL_DATADIR}/hariko")
install(DIRECTORY "${HARIKO_PICTURES}/" DESTINATION "${CMAKE_INSTALL_DATADIR}/hariko/pictures" FILES_MATCHING
  PATTERN "*.png")
install(DIRECTORY assets/icons/hicolor DESTINATION "${CMAKE_INSTALL_DATADIR}/icons")
install(FILES "${HARIKO_DESKTOP}/hariko.desktop" DESTINATION "${CMAKE_INSTALL_DATADIR}/applications")
install(FILES "${HARIKO_DESKTOP}/local.hariko.Hariko.metainfo.xml" DESTINATION "${CMAKE_INSTALL_DATADIR}/metainfo")
install(FILES "${HARIKO_DESKTOP}/hariko.xml" DESTINATION "${CMAKE_INSTALL_DATADIR}/mime/packages")
install(FILES "${HARIKO_DESKTOP}/hariko.thumbnailer" DESTINATION "${CMAKE_INSTALL_DATADIR}/thumbnailers")
install(FILES "${HARIKO_DESKTOP}/hariko.bash-completion" DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions"
  RENAME hariko)
install(FILES README.md "${HARIKO_DESKTOP}/copyright" DESTINATION "${CMAKE_INSTALL_DOCDIR}")
install(DIRECTORY docs DESTINATION "${CMAKE_INSTALL_DOCDIR}")

# hariko_install_compressed(SOURCE FOLDER): as SOURCE.gz, without the time in it, as packages want manual pages.
function(hariko_install_compressed SOURCE FOLDER)
  cmake_path(GET SOURCE FILENAME NAME)
  set(COMPRESSED "${CMAKE_BINARY_DIR}/package/${NAME}.gz")
  install(CODE "execute_process(COMMAND gzip -9nc [==[${SOURCE}]==] OUTPUT_FILE [==[${COMPRESSED}]==]
    COMMAND_ERROR_IS_FATAL ANY)")
  install(FILES "${COMPRESSED}" DESTINATION "${FOLDER}")
endfunction()
file(MAKE_DIRECTORY "${CMAKE_BINARY_DIR}/package")
hariko_install_compressed("${HARIKO_DESKTOP}/hariko.1" "${CMAKE_INSTALL_MANDIR}/man1")

# The name of the release, "deb12": a package of one release does not install on another. Debian's unstable has no number.
set(HARIKO_RELEASE "")
if(EXISTS /etc/os-release)
  file(STRINGS /etc/os-release HARIKO_OS_RELEASE REGEX "^(ID|VERSION_ID)=")
  string(REPLACE "\"" "" HARIKO_OS_RELEASE "${HARIKO_OS_RELEASE}")
  if(HARIKO_OS_RELEASE MATCHES "(^|;)VERSION_ID=([0-9.]+)")
    set(HARIKO_RELEASE_NUMBER "${CMAKE_MATCH_2}")
    if(HARIKO_OS_RELEASE MATCHES "(^|;)ID=debian")
      set(HARIKO_RELEASE "~deb${HARIKO_RELEASE_NUMBER}")
    elseif(HARIKO_OS_RELEASE MATCHES "(^|;)ID=([a-z]+)")
      set(HARIKO_RELEASE "~${CMAKE_MATCH_2}${HARIKO_RELEASE_NUMBER}")
    endif()
  endif()
endif()
set(HARIKO_PACKAGE_VERSION "${PROJECT_VERSION}${HARIKO_RELEASE}")
configure_file("${HARIKO_DESKTOP}/changelog.in" "${CMAKE_BINARY_DIR}/package/changelog" @ONLY)
hariko_install_compressed("${CMAKE_BINARY_DIR}/package/changelog" "${CMAKE_INSTALL_DOCDIR}")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME hariko)
set(CPACK_PACKAGE_VENDOR "")
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS "${CMAKE_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS}")
set(CPACK_DEBIAN_PACKAGE_VERSION "${HARIKO_PACKAGE_VERSION}")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "Hariko developers")
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "modeler for free-form shapes")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Hariko (paper stretched over a form) is a desktop modeler for designers. You
give it a rough polyhedron; it stretches a smooth surface over it at once, and
follows while you drag. Tensions pull it flat or to a point, creases make it
sharp.
.
There are three more ways in: solids that are placed in space get one smooth
surface round them, sections along a path become a subdivision surface, and
outlines with normals are filled.
.
Surfaces are judged by zebra stripes and curvature maps, and written as
triangles within a tolerance (OBJ, STL, 3MF, PLY, glTF, OFF), as spline faces
for CAD (STEP, IGES), and as paper models to print, cut out and glue. The same
program does all of it from the command line, without a display.")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Libraries loaded at run time: OpenGL with its software renderer, what GLFW 3.3 asks X for; and fonts.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libgl1, libegl1, libgl1-mesa-dri, libxcursor1, libxext6, libxi6, libxinerama1, libxrandr2, \
libxrender1, libx11-xcb1, fonts-inter, fonts-font-awesome")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "fonts-noto-cjk")
set(CPACK_VERBATIM_VARIABLES ON)
include(CPack)

# All that goes into the package, and the package.
add_custom_target(hariko_package COMMAND "${CMAKE_CPACK_COMMAND}" -G DEB WORKING_DIRECTORY "${CMAKE_BINARY_DIR}"
  USES_TERMINAL VERBATIM)
add_dependencies(hariko_package hariko)
if(TARGET hariko_sample_pictures)
  add_dependencies(hariko_package hariko_sample_pictures)
endif()
