# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
target_sources(hygroloom_core PRIVATE
  laboratory/air_permeability.cpp
)
set_source_files_properties(laboratory/air_permeability.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
