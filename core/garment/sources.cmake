# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
embed_text(${CMAKE_SOURCE_DIR}/resources/body/sweat.json ${CMAKE_CURRENT_BINARY_DIR}/body_sweat_json.cpp body_sweat_json)
target_sources(hygroloom_core PRIVATE
  ${CMAKE_CURRENT_BINARY_DIR}/body_sweat_json.cpp
  garment/body.cpp
  garment/built_in.cpp
  garment/check_garment.cpp
  garment/drape.cpp
  garment/ears.cpp
  garment/fill.cpp
  garment/flat_islands.cpp
  garment/flat_scales.cpp
  garment/gltf_file.cpp
  garment/gltf_mesh.cpp
  garment/layers.cpp
  garment/mesh_builder.cpp
  garment/mesh_apart.cpp
  garment/mesh_bytes.cpp
  garment/obj_text.cpp
  garment/odd_shapes.cpp
  garment/outline.cpp
  garment/pattern_json.cpp
  garment/ply_mesh.cpp
  garment/read_pattern.cpp
  garment/stitches.cpp
  garment/sweat_table.cpp
  garment/thick_cloth.cpp
  garment/uv_mesh.cpp
)
