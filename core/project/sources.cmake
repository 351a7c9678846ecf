# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
embed_text(${CMAKE_SOURCE_DIR}/resources/library/fabrics.json ${CMAKE_CURRENT_BINARY_DIR}/library_fabrics_json.cpp library_fabrics_json)
embed_text(${CMAKE_SOURCE_DIR}/resources/library/finishes.json ${CMAKE_CURRENT_BINARY_DIR}/library_finishes_json.cpp library_finishes_json)
embed_text(${CMAKE_SOURCE_DIR}/resources/schema/hygroloom-project-1.in.json ${CMAKE_CURRENT_BINARY_DIR}/project_schema_json.cpp project_schema_json)
target_sources(hygroloom_core PRIVATE
  ${CMAKE_CURRENT_BINARY_DIR}/project_schema_json.cpp
  ${CMAKE_CURRENT_BINARY_DIR}/library_fabrics_json.cpp
  ${CMAKE_CURRENT_BINARY_DIR}/library_finishes_json.cpp
  project/atomic_file.cpp
  project/cache_folder.cpp
  project/curve_file.cpp
  project/draft_json.cpp
  project/garment_json.cpp
  project/gltf_file.cpp
  project/json_reader.cpp
  project/leftovers.cpp
  project/library.cpp
  project/mesh_file.cpp
  project/migrations.cpp
  project/output_file.cpp
  project/polygon_file.cpp
  project/project_file.cpp
  project/project_read.cpp
  project/project_schema.cpp
  project/project_value.cpp
  project/project_write.cpp
  project/scene_file.cpp
  project/texture_files.cpp
  project/texture_material.cpp
  project/weave_json.cpp
  project/weave_picture.cpp
  project/wear_json.cpp
  project/wet_look.cpp
  project/wif_draft.cpp
  project/wif_file.cpp
  project/wif_import.cpp
  project/wif_write.cpp
  project/yarn_json.cpp
  project/yarn_table.cpp
  project/yarn_update.cpp
)
