# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# A command line that runs on any Linux with glibc as new as the one it was built on: every other library travels in lib/, with its licence.
# The libraries have no search path of their own, so the program's must also hold for them: DT_RPATH, not the DT_RUNPATH that is usual now.
target_link_options(hygroloom-cli PRIVATE -Wl,--disable-new-dtags)
set_target_properties(hygroloom-cli PROPERTIES INSTALL_RPATH "$ORIGIN/../lib")

install(TARGETS hygroloom-cli RUNTIME_DEPENDENCY_SET bundled RUNTIME)
install(RUNTIME_DEPENDENCY_SET bundled
  PRE_EXCLUDE_REGEXES "^ld-linux" "^lib(c|m|dl|rt|pthread|resolv|util|anl|mvec|cuda|nvidia-.*)\\.so"
  LIBRARY DESTINATION lib)

# Debian keeps the licence of each library with its package.
install(CODE [[
  file(GLOB libraries "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/lib/*.so*")
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
