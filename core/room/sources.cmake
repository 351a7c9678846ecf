# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
target_sources(hygroloom_core PRIVATE
  room/drawn_layer.cpp
  room/room_details.cpp
  room/room_flow.cpp
  room/room_menisci.cpp
  room/room_tables.cpp
  room/stokes.cpp
  room/voxels.cpp
  room/woven_cell.cpp
  room/yarn_stations.cpp
)

# Sparse equations, compiled alone at full optimization.
set_source_files_properties(room/drawn_layer.cpp room/room_flow.cpp room/room_menisci.cpp room/stokes.cpp room/yarn_stations.cpp PROPERTIES
  SKIP_UNITY_BUILD_INCLUSION ON COMPILE_OPTIONS "$<$<CONFIG:Release>:-O3>")
