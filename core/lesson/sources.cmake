# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
target_sources(hygroloom_core PRIVATE
  lesson/lesson.cpp
  lesson/lesson_goal.cpp
  lesson/lesson_table.cpp
  lesson/running_cloth.cpp
  lesson/water_shares.cpp
)
