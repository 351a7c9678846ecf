# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
target_sources(hygroloom_core PRIVATE
  analysis/cell_map.cpp
  analysis/closed_forms.cpp
  analysis/comparison.cpp
  analysis/comparison_files.cpp
  analysis/comparison_report.cpp
  analysis/enclosing_circle.cpp
  analysis/intervals.cpp
  analysis/laboratory.cpp
  analysis/laboratory_table.cpp
  analysis/line_chart.cpp
  analysis/management.cpp
  analysis/map_image.cpp
  analysis/metrics.cpp
  analysis/metrics_json.cpp
  analysis/moisture_tester.cpp
  analysis/outcomes.cpp
  analysis/plots.cpp
  analysis/replicate_file.cpp
  analysis/report.cpp
  analysis/report_parts.cpp
  analysis/sweep.cpp
  analysis/tradeoff.cpp
  analysis/tradeoff_json.cpp
  analysis/tradeoff_plot.cpp
  analysis/vtk_files.cpp
)
