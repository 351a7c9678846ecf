# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# embed_text(input output name): turns a text file into a source that defines `extern const char name[]` in namespace hygroloom.
# Done at configure time, and again whenever the input changes. In pieces, because compilers limit the length of one literal.
function(embed_text input output name)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${input})
  file(READ ${input} rest)
  set(pieces "")
  while(NOT rest STREQUAL "")
    string(SUBSTRING "${rest}" 0 8000 piece)
    string(APPEND pieces "    R\"embedded(${piece})embedded\"\n")
    string(LENGTH "${rest}" length)
    if(length GREATER 8000)
      string(SUBSTRING "${rest}" 8000 -1 rest)
    else()
      set(rest "")
    endif()
  endwhile()
  get_filename_component(file ${input} NAME)
  file(CONFIGURE OUTPUT ${output} @ONLY CONTENT
"// Made from ${file}; change that instead.
namespace hygroloom {
extern const char ${name}[];
const char ${name}[] =
@pieces@;
} // namespace hygroloom
")
endfunction()
