# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
target_sources(hygroloom_core PRIVATE
  run/apart.cpp
  run/failover.cpp
  run/hdf5_file.cpp
  run/part_watch.cpp
  run/plan_run.cpp
  run/publisher.cpp
  run/recording.cpp
  run/runner.cpp
  run/session.cpp
  run/side_by_side.cpp
)
