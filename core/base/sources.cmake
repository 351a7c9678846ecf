# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
target_sources(hygroloom_core PRIVATE
  base/csv_table.cpp
  base/free_memory.cpp
  base/message.cpp
  base/shipped_file.cpp
  base/student.cpp
  base/trade_units.cpp
  base/utf8.cpp
  base/version.cpp
  base/words.cpp
)
# Sanitizers watch memory by operators of their own.
if(NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  target_sources(hygroloom_core PRIVATE base/large_blocks.cpp)
endif()
