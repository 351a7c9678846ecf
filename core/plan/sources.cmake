# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
embed_text(${CMAKE_SOURCE_DIR}/resources/tradeoff/measured.csv ${CMAKE_CURRENT_BINARY_DIR}/measured_scenes_csv.cpp measured_scenes_csv)
target_sources(hygroloom_core PRIVATE
  ${CMAKE_CURRENT_BINARY_DIR}/measured_scenes_csv.cpp
  plan/bounds.cpp
  plan/bundling.cpp
  plan/cap_room.cpp
  plan/expectation.cpp
  plan/expectations_together.cpp
  plan/fidelity.cpp
  plan/fidelity_choice.cpp
  plan/frame_times.cpp
  plan/idle_keys.cpp
  plan/measured_scenes.cpp
  plan/model_plan.cpp
  plan/parts.cpp
  plan/plan_json.cpp
  plan/planning.cpp
  plan/rough_work.cpp
  plan/supply.cpp
  plan/switched_part.cpp
)
