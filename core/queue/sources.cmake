# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
target_sources(hygroloom_core PRIVATE
  queue/calibration_runs.cpp
  queue/card_runs.cpp
  queue/compared_runs.cpp
  queue/run_job.cpp
  queue/run_places.cpp
  queue/run_queue.cpp
)
