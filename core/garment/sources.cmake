# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
embed_text(${CMAKE_SOURCE_DIR}/resources/body/sweat.json ${CMAKE_CURRENT_BINARY_DIR}/body_sweat_json.cpp body_sweat_json)
target_sources(hygroloom_core PRIVATE
  ${CMAKE_CURRENT_BINARY_DIR}/body_sweat_json.cpp
  garment/body.cpp
  garment/built_in.cpp
  garment/check_garment.cpp
  garment/drape.cpp
  garment/fill.cpp
  garment/flat_islands.cpp
  garment/layers.cpp
  garment/mesh_file_in.cpp
  garment/obj_text.cpp
  garment/outline.cpp
  garment/pattern_json.cpp
  garment/read_pattern.cpp
  garment/stitches.cpp
  garment/sweat_table.cpp
  garment/uv_mesh.cpp
)
