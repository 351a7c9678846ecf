# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# Writes what software centres show, with the guide's pictures if they have an address on the web.
function(write_metainfo pictures file)
  set(screenshots "")
  if(pictures)
    set(screenshots "  <screenshots>\n")
    set(type " type=\"default\"")
    foreach(picture "simulate=The drop on the cloth, the water on both faces and the course of a run" "design=Weave, yarns and the fabric in 3D"
        "compare=Four fabrics side by side")
      string(REGEX MATCH "^([a-z]+)=(.*)$" picture "${picture}")
      string(APPEND screenshots "    <screenshot${type}>\n      <caption>${CMAKE_MATCH_2}</caption>\n"
        "      <image type=\"source\" width=\"1280\" height=\"800\">${pictures}/${CMAKE_MATCH_1}.png</image>\n    </screenshot>\n")
      set(type "")
    endforeach()
    string(APPEND screenshots "  </screenshots>\n")
  endif()
  configure_file(${CMAKE_CURRENT_SOURCE_DIR}/desktop/org.hygroloom.Hygroloom.metainfo.xml.in ${file} @ONLY)
endfunction()
