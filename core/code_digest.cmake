# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# code_digest(output name files...): a source that defines `extern const char name[]` in namespace hygroloom, the digest of the files. Made
# anew whenever one of them changes. As a script it writes the source: cmake -DOUTPUT= -DNAME= -DFILES= -P code_digest.cmake
if(CMAKE_SCRIPT_MODE_FILE)
  set(digests "")
  foreach(file IN LISTS FILES)
    file(SHA256 ${file} digest)
    string(APPEND digests ${digest})
  endforeach()
  string(SHA256 all "${digests}")
  file(WRITE ${OUTPUT} "namespace hygroloom {\nextern const char ${NAME}[];\nconst char ${NAME}[] = \"${all}\";\n} // namespace hygroloom\n")
  return()
endif()

function(code_digest output name)
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DNAME=${name} "-DFILES=${ARGN}" -P ${CMAKE_CURRENT_FUNCTION_LIST_FILE}
    DEPENDS ${ARGN} ${CMAKE_CURRENT_FUNCTION_LIST_FILE} VERBATIM COMMENT "Digesting the code behind ${name}")
endfunction()
