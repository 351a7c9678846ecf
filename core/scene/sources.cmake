# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
target_sources(hygroloom_core PRIVATE
  scene/check_scene.cpp
  scene/coarse_scene.cpp
  scene/liquid_bodies.cpp
  scene/liquid_points.cpp
  scene/scene.cpp
  scene/shown_quantity.cpp
  scene/skin.cpp
  scene/suction.cpp
  scene/unevenness.cpp
  scene/wet_cloth.cpp
)
