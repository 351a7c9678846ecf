# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
target_sources(hygroloom_core PRIVATE
  room/conduction.cpp
  room/drawn_layer.cpp
  room/kept_tables.cpp
  room/room_details.cpp
  room/room_flow.cpp
  room/room_menisci.cpp
  room/room_tables.cpp
  room/stokes.cpp
  room/voxels.cpp
  room/woven_cell.cpp
  room/yarn_stations.cpp
)

# Tables that were kept hold for the code that found them.
include(code_digest.cmake)
file(GLOB room_files CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/room/*.h ${CMAKE_CURRENT_SOURCE_DIR}/room/*.cpp)
code_digest(${CMAKE_CURRENT_BINARY_DIR}/room_code.cpp room_code
  ${room_files} ${CMAKE_CURRENT_SOURCE_DIR}/geometry/textile.h ${CMAKE_CURRENT_SOURCE_DIR}/physics/between_yarns.h)
target_sources(hygroloom_core PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/room_code.cpp)
set_source_files_properties(${CMAKE_CURRENT_BINARY_DIR}/room_code.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)

# Sparse equations, compiled alone at full optimization.
set_source_files_properties(room/conduction.cpp room/drawn_layer.cpp room/room_flow.cpp room/room_menisci.cpp room/stokes.cpp room/yarn_stations.cpp PROPERTIES
  SKIP_UNITY_BUILD_INCLUSION ON COMPILE_OPTIONS "$<$<CONFIG:Release>:-O3>")
