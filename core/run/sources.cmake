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

# What the numbers of runs follow from: a kept run holds for this code.
set(answers_files ${CMAKE_SOURCE_DIR}/resources/materials/*)
foreach(room physics design garment geometry room plan scene solver solver/steps run wear)
  list(APPEND answers_files ${CMAKE_CURRENT_SOURCE_DIR}/${room}/*.h ${CMAKE_CURRENT_SOURCE_DIR}/${room}/*.cpp)
endforeach()
foreach(name enclosing_circle laboratory management metrics moisture_tester outcomes stain_shape) # the rest of it are words and pictures
  list(APPEND answers_files ${CMAKE_CURRENT_SOURCE_DIR}/analysis/${name}*.h ${CMAKE_CURRENT_SOURCE_DIR}/analysis/${name}*.cpp)
endforeach()
list(APPEND answers_files ${CMAKE_CURRENT_SOURCE_DIR}/base/random.h ${CMAKE_SOURCE_DIR}/gpu/*.cu ${CMAKE_SOURCE_DIR}/gpu/*.cuh)
file(GLOB answers_files CONFIGURE_DEPENDS ${answers_files})
code_digest(${CMAKE_CURRENT_BINARY_DIR}/answers_code.cpp answers_code ${answers_files})
target_sources(hygroloom_core PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/answers_code.cpp)
set_source_files_properties(${CMAKE_CURRENT_BINARY_DIR}/answers_code.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
