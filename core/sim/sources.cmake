# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
target_sources(hygroloom_core PRIVATE
  sim/cpu_backend.cpp
  sim/droplet.cpp
  sim/fidelity.cpp
  sim/hdf5_file.cpp
  sim/host_cloth.cpp
  sim/model_plan.cpp
  sim/plan_json.cpp
  sim/recording.cpp
  sim/runner.cpp
  sim/scene.cpp
)
