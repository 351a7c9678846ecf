# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
target_sources(hygroloom_core PRIVATE
  laboratory/air_permeability.cpp
  laboratory/heat_vapour.cpp
  laboratory/numbers.cpp
  laboratory/technical.cpp
  laboratory/wet_cloth.cpp
)
