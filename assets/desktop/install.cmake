# What `cmake --install` places, in the standard layout, and the Debian package that `cpack` makes of it.
include(GNUInstallDirs)
install(TARGETS shading-sandbox)
install(FILES assets/desktop/shading-sandbox.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
foreach(size 48 128 256)
  install(FILES assets/desktop/icon-${size}.png RENAME shading-sandbox.png
          DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/${size}x${size}/apps)
endforeach()
install(FILES assets/desktop/completion.bash RENAME shading-sandbox
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES assets/desktop/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR})

# The manual is the program's own --help, asked at the time of installing. It may be installed without.
find_program(HELP2MAN help2man)
if(HELP2MAN)
  install(CODE "execute_process(
    COMMAND \"${CMAKE_CURRENT_SOURCE_DIR}/assets/desktop/man_pages.sh\" \"$<TARGET_FILE:shading-sandbox>\"
            \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_MANDIR}/man1\"
    COMMAND_ERROR_IS_FATAL ANY)")
else()
  message(STATUS "No help2man: cmake --install places no manual pages")
endif()

set(SANDBOX_MAINTAINER "Shading Sandbox maintainers <maintainers@shading-sandbox.example>" CACHE STRING "Who answers for the package")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "Shading Sandbox maintainers")
set(CPACK_PACKAGE_CONTACT "${SANDBOX_MAINTAINER}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "shows what lighting choices do and what they cost")
set(CPACK_PACKAGE_DESCRIPTION
"Per vertex or per pixel, Phong or Blinn-Phong, directional, point and spot
lights, side by side under one camera. Well-known mistakes are switches. Every
picture comes with the exact GLSL that drew it and with its error against a
double-precision reference. For teaching and studying shading; no GPU needed.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
    WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION education)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# What is opened by name at run time: the window's library, its way to X, the driver, the window's font.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libglfw3 | libglfw3-wayland") # a server needs no window
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libgl1, libgl1-mesa-dri, libegl-mesa0, fonts-dejavu-core")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "fonts-noto-cjk") # the window in Chinese

set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_SOURCE_DIR}/assets/desktop/debian_files.cmake)
include(CPack)
