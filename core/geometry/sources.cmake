# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
target_sources(hygroloom_core PRIVATE
  geometry/face_angles.cpp
  geometry/fibre_tube.cpp
  geometry/fibres.cpp
  geometry/measured_geometry.cpp
  geometry/mesh.cpp
  geometry/mesh_stream.cpp
  geometry/textile.cpp
  geometry/top_view.cpp
)
