# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
target_sources(hygroloom_core PRIVATE
  verify/cloth_cases.cpp
  verify/convergence_cases.cpp
  verify/drawn_pores.cpp
  verify/drop_set_ups.cpp
  verify/drop_shapes.cpp
  verify/heat_cases.cpp
  verify/laboratory_cases.cpp
  verify/liquid_cases.cpp
  verify/measured_cloth_cases.cpp
  verify/measured_fibre_cases.cpp
  verify/measured_wicking_cases.cpp
  verify/moisture_cases.cpp
  verify/morphology.cpp
  verify/pore_cases.cpp
  verify/pore_fabric_cases.cpp
  verify/pore_flow_cases.cpp
  verify/pore_set_ups.cpp
  verify/retention_column.cpp
  verify/set_ups.cpp
  verify/swing_fit.cpp
  verify/tester_case.cpp
  verify/verify.cpp
  verify/whole_run_cases.cpp
  verify/wicking_cases.cpp
  verify/yarn_drop_case.cpp
)
