# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
target_sources(hygroloom_core PRIVATE
  project/atomic_file.cpp
  project/curve_file.cpp
  project/draft_json.cpp
  project/gltf_file.cpp
  project/json_reader.cpp
  project/mesh_file.cpp
  project/migrations.cpp
  project/output_file.cpp
  project/polygon_file.cpp
  project/project_file.cpp
  project/project_read.cpp
  project/project_value.cpp
  project/project_write.cpp
  project/scene_file.cpp
  project/weave_picture.cpp
  project/wif_draft.cpp
  project/wif_file.cpp
  project/wif_import.cpp
  project/wif_write.cpp
)
