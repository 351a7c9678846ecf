# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# Programs that run on any Linux with glibc as new as the one they were built on: every other library travels in lib/, with its licence.
# The libraries have no search path of their own, so the programs' must also hold for them: DT_RPATH, not the DT_RUNPATH that is usual now.
target_link_options(hygroloom-cli PRIVATE -Wl,--disable-new-dtags)
set_target_properties(hygroloom-cli PROPERTIES INSTALL_RPATH "$ORIGIN/../lib:$ORIGIN/../lib/c++")
install(TARGETS hygroloom-cli RUNTIME_DEPENDENCY_SET bundled RUNTIME)
target_link_options(hygroloom-mesh PRIVATE -Wl,--disable-new-dtags)
set_target_properties(hygroloom-mesh PROPERTIES INSTALL_RPATH "$ORIGIN/..:$ORIGIN/../c++")
install(TARGETS hygroloom-mesh RUNTIME_DEPENDENCY_SET bundled RUNTIME DESTINATION lib/hygroloom)

# A desktop's own: what talks to its graphics driver and its fonts must be as new as they are.
set(desktops_own "")
if(HYGROLOOM_UI)
  set(desktops_own "^lib(GL|EGL|GLX|GLdispatch|OpenGL|GLESv2|drm|gbm|X11|X11-xcb|xcb|fontconfig|freetype)\\.so")
  find_package(Qt6 REQUIRED COMPONENTS Gui)
  target_link_options(hygroloom PRIVATE -Wl,--disable-new-dtags)
  set_target_properties(hygroloom PROPERTIES INSTALL_RPATH "$ORIGIN/../lib")
  install(TARGETS hygroloom RUNTIME_DEPENDENCY_SET bundled RUNTIME)
  install(PROGRAMS ${CMAKE_CURRENT_SOURCE_DIR}/hygroloom.sh DESTINATION . RENAME hygroloom)
  install(FILES ${CMAKE_CURRENT_SOURCE_DIR}/desktop/qt.conf DESTINATION bin)
  # Qt's own words, as those of file dialogs; the window's are in the program.
  set(words ${QT6_INSTALL_PREFIX}/${QT6_INSTALL_TRANSLATIONS})
  if(EXISTS ${words}/qtbase_de.qm)
    install(FILES ${words}/qtbase_de.qm DESTINATION translations)
  else()
    message(STATUS "qtbase_de.qm was not found (package qt6-translations-l10n): the bundle's file dialogs stay English.")
  endif()
  set(plugins platforms/QXcbIntegration platforms/QOffscreenIntegration xcbglintegrations/QXcbGlxIntegration xcbglintegrations/QXcbEglIntegration
    platforminputcontexts/QComposePlatformInputContext iconengines/QSvgIcon imageformats/QSvg)
  foreach(plugin IN LISTS plugins)
    cmake_path(GET plugin PARENT_PATH folder)
    cmake_path(GET plugin FILENAME name)
    find_package(Qt6${name}Plugin REQUIRED PATHS ${Qt6Gui_DIR})
    install(IMPORTED_RUNTIME_ARTIFACTS Qt6::${name}Plugin RUNTIME_DEPENDENCY_SET bundled LIBRARY DESTINATION plugins/${folder})
  endforeach()
endif()
install(RUNTIME_DEPENDENCY_SET bundled
  PRE_EXCLUDE_REGEXES "^ld-linux" "^lib(c|m|dl|rt|pthread|resolv|util|anl|mvec|cuda|nvidia-.*)\\.so" ${desktops_own}
  LIBRARY DESTINATION lib)
# Graphics drivers need the newer libstdc++, the desktop's or ours: it lies apart, and the window's starter looks.
install(CODE [[
  set(tree "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}")
  if(EXISTS ${tree}/bin/hygroloom)
    file(MAKE_DIRECTORY ${tree}/lib/c++)
    file(GLOB own "${tree}/lib/libstdc++.so*" "${tree}/lib/libgcc_s.so*")
    foreach(library IN LISTS own)
      get_filename_component(name ${library} NAME)
      file(RENAME ${library} ${tree}/lib/c++/${name})
    endforeach()
  endif()
]])

# Debian keeps the licence of each library with its package.
install(CODE [[
  file(GLOB libraries "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/lib/*.so*" "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/lib/c++/*.so*")
  foreach(library IN LISTS libraries)
    get_filename_component(name ${library} NAME)
    execute_process(COMMAND dpkg-query -S "*-linux-gnu/${name}" OUTPUT_VARIABLE owner ERROR_QUIET RESULT_VARIABLE failed)
    if(failed OR NOT owner MATCHES "^([^:,\n]+)" OR NOT EXISTS /usr/share/doc/${CMAKE_MATCH_1}/copyright)
      message(STATUS "No licence was found for ${name}.")
      continue()
    endif()
    configure_file(/usr/share/doc/${CMAKE_MATCH_1}/copyright
      "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/share/doc/hygroloom/libraries/${CMAKE_MATCH_1}" COPYONLY)
  endforeach()
]])
