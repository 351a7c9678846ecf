# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# The measured scenes, one after the other, as one JSON list.
file(GLOB measured_scenes CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/resources/tradeoff/*.json)
set(measured "")
foreach(scene IN LISTS measured_scenes)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${scene})
  file(READ ${scene} text)
  string(APPEND measured "${measured_comma}${text}")
  set(measured_comma ",")
endforeach()
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/measured_scenes.json @ONLY CONTENT "[@measured@]\n")
embed_text(${CMAKE_CURRENT_BINARY_DIR}/measured_scenes.json ${CMAKE_CURRENT_BINARY_DIR}/measured_scenes_json.cpp measured_scenes_json)
target_sources(hygroloom_core PRIVATE
  ${CMAKE_CURRENT_BINARY_DIR}/measured_scenes_json.cpp
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
