# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
target_sources(hygroloom_core PRIVATE
  run/apart.cpp
  run/course.cpp
  run/failover.cpp
  run/frame_changes.cpp
  run/hdf5_blocks.cpp
  run/hdf5_driver.cpp
  run/hdf5_file.cpp
  run/hdf5_messages.cpp
  run/hdf5_packed.cpp
  run/hdf5_reader.cpp
  run/learned_times.cpp
  run/part_watch.cpp
  run/plan_run.cpp
  run/publisher.cpp
  run/recording.cpp
  run/recording_source.cpp
  run/recording_target.cpp
  run/recording_writer.cpp
  run/redo_log.cpp
  run/runner.cpp
  run/session.cpp
  run/side_by_side.cpp
)
