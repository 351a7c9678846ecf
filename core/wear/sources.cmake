# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
target_sources(hygroloom_core PRIVATE
  wear/cells_vtk.cpp
  wear/fabric_cells.cpp
  wear/garment_files.cpp
  wear/garment_grid.cpp
  wear/garment_run.cpp
  wear/garment_scene.cpp
  wear/layer_joints.cpp
  wear/seam_joints.cpp
  wear/sewing.cpp
  wear/shown_cells.cpp
  wear/turned_panels.cpp
  wear/wear_layout.cpp
  wear/wear_layout_json.cpp
  wear/wear_map.cpp
  wear/wear_metrics.cpp
  wear/wear_outcomes.cpp
  wear/wear_recording.cpp
  wear/wear_report.cpp
  wear/wear_run.cpp
  wear/worn_candidate.cpp
)
