# The Debian package that CPack makes of what is installed (`./dev package`).

# A version that is not out yet sorts before it, and later sources after earlier ones.
set(LIMN_PACKAGE_VERSION ${PROJECT_VERSION})
file(STRINGS ${CMAKE_SOURCE_DIR}/CHANGELOG.md unreleased REGEX "^## ${PROJECT_VERSION} \\(unreleased\\)$")
if(unreleased)
  string(TIMESTAMP day "%Y%m%d" UTC)
  string(APPEND LIMN_PACKAGE_VERSION "~git${day}")
endif()
string(APPEND LIMN_PACKAGE_VERSION "-1")

# Who answers for the package: whoever makes it, as Debian's own tools ask, otherwise who wrote the last commit.
set(maintainer "")
if(DEFINED ENV{DEBEMAIL} AND DEFINED ENV{DEBFULLNAME})
  set(maintainer "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
elseif(GIT)
  execute_process(COMMAND ${GIT} -C ${CMAKE_SOURCE_DIR} log -1 "--format=%an <%ae>" OUTPUT_VARIABLE maintainer
                  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
if(NOT maintainer)
  set(maintainer "The one who built it <root@localhost>")
endif()

# Both change logs as Debian's policy wants them: the user's words, and the package's own.
string(TIMESTAMP LIMN_PACKAGE_DATE "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file(${CMAKE_CURRENT_LIST_DIR}/changelog.Debian.in changelog.Debian @ONLY)
set(logs ${CMAKE_CURRENT_BINARY_DIR}/changelog.gz)
if(LIMN_DEBIAN)
  list(APPEND logs ${CMAKE_CURRENT_BINARY_DIR}/changelog.Debian.gz)
  install(FILES lintian-overrides DESTINATION share/lintian/overrides RENAME limn)
endif()
add_custom_command(OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/changelog.gz VERBATIM
  DEPENDS ${CMAKE_SOURCE_DIR}/CHANGELOG.md
  COMMAND gzip -9nc ${CMAKE_SOURCE_DIR}/CHANGELOG.md > ${CMAKE_CURRENT_BINARY_DIR}/changelog.gz)
add_custom_command(OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/changelog.Debian.gz VERBATIM
  DEPENDS ${CMAKE_CURRENT_BINARY_DIR}/changelog.Debian
  COMMAND gzip -9nkf ${CMAKE_CURRENT_BINARY_DIR}/changelog.Debian)
add_custom_target(limn_change_logs ALL DEPENDS ${logs})
add_dependencies(limn limn_change_logs)
install(FILES ${logs} DESTINATION share/doc/limn)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME limn)
set(CPACK_PACKAGE_VENDOR "The Limn developers")
set(CPACK_PACKAGE_CONTACT "${maintainer}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "CT and MR volumes shown with editable transfer functions")
set(CPACK_PACKAGE_DESCRIPTION
"Limn shows CT and MR volumes in three dimensions. A transfer function is
shaped over the histogram, and classic and gradient-enhanced Blinn-Phong
shading are seen side by side, with one camera and one curve.
.
It opens DICOM, NIfTI, NRRD, MetaImage, VTK, TIFF stacks and InVesalius
projects, says how far a picture lies from the exact one, and makes figures,
turntables and meshes, also from the command line and without a display. It
works without a graphics card.
.
Limn is not a medical device and not for diagnosis.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_VERSION ${LIMN_PACKAGE_VERSION})
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# What is loaded while it runs, and so is seen by no linker: OpenGL, for a window and without one, and its drivers.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libegl1, libgl1")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS libgl1-mesa-dri)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "ffmpeg, invesalius-examples, qt6-wayland")
if(LIMN_HOMEPAGE)
  set(CPACK_DEBIAN_PACKAGE_HOMEPAGE ${LIMN_HOMEPAGE})
endif()
set(CPACK_OUTPUT_CONFIG_FILE ${CMAKE_BINARY_DIR}/CPackConfig.cmake)
include(CPack)
