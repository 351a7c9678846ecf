# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# The guide's command-line reference is what the program prints. Run by ctest: cmake -DPROGRAM=<hygroloom-cli> -DPAGE=<page> -P test_reference.cmake
execute_process(COMMAND ${PROGRAM} reference OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
file(READ ${PAGE} kept)
if(NOT printed STREQUAL kept)
  message(FATAL_ERROR "${PAGE} is out of date: run packaging/reference.sh with the build folder.")
endif()
