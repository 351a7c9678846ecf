# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
target_sources(hygroloom_core PRIVATE
  run/apart.cpp
  run/course.cpp
  run/database.cpp
  run/failover.cpp
  run/frame_changes.cpp
  run/learned_times.cpp
  run/packed_numbers.cpp
  run/part_watch.cpp
  run/plan_run.cpp
  run/publisher.cpp
  run/recording.cpp
  run/recording_head.cpp
  run/recording_source.cpp
  run/recording_target.cpp
  run/recording_writer.cpp
  run/run_file_reader.cpp
  run/run_file_writer.cpp
  run/run_tables.cpp
  run/runner.cpp
  run/session.cpp
  run/wal_pages.cpp
  run/writer_lock.cpp
)
