# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
target_sources(hygroloom_core PRIVATE
  study/analysis.cpp
  study/analysis_module.cpp
  study/journal.cpp
  study/observed.cpp
  study/points.cpp
  study/quantiles.cpp
  study/results.cpp
  study/results_database.cpp
  study/slurm.cpp
  study/study.cpp
  study/study_check.cpp
  study/study_folder.cpp
  study/study_run.cpp
  study/suggest.cpp
)
