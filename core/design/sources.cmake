# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
include(${CMAKE_CURRENT_LIST_DIR}/../embed_text.cmake)
embed_text(${CMAKE_SOURCE_DIR}/resources/materials/fibres.json ${CMAKE_CURRENT_BINARY_DIR}/fibres_json.cpp fibres_json)
target_sources(hygroloom_core PRIVATE
  ${CMAKE_CURRENT_BINARY_DIR}/fibres_json.cpp
  design/design.cpp
  design/draft.cpp
  design/drawdown.cpp
  design/evenness.cpp
  design/experiment.cpp
  design/fabric_parts.cpp
  design/fabric_quantities.cpp
  design/fitted_fabric.cpp
  design/free_inputs.cpp
  design/flyaway.cpp
  design/garment.cpp
  design/holes.cpp
  design/interlacing.cpp
  design/jam.cpp
  design/liquid.cpp
  design/material.cpp
  design/spreading.cpp
  design/unknowns.cpp
  design/validate.cpp
  design/validate_experiment.cpp
  design/validate_fabric.cpp
  design/validate_garment.cpp
  design/validate_wear.cpp
  design/validate_weave.cpp
  design/weave.cpp
  design/weave_analysis.cpp
  design/weave_effects.cpp
  design/weave_grounds.cpp
  design/weave_patterns.cpp
  design/yarn_count.cpp
  design/yarn_quantities.cpp
  design/yarn_sections.cpp
)
