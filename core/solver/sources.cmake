# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
# What is the same for particles of any number type.
set(yarn_sources
  solver/cap_air.cpp
  solver/cap_shapes.cpp
  solver/caps.cpp
  solver/cpu_backend.cpp
  solver/drop_shapes.cpp
  solver/yarn_network_cpu.cpp
  solver/yarn_start.cpp
)

# What depends on the particles' number type, in single and once more in double precision.
set(solver_sources
  solver/cpu_solver.cpp
  solver/droplet.cpp
  solver/host_cloth.cpp
  solver/liquid_start.cpp
  solver/stock.cpp
)
target_sources(hygroloom_core PRIVATE ${yarn_sources} ${solver_sources})
add_library(hygroloom_core_double OBJECT ${solver_sources})
target_compile_definitions(hygroloom_core_double PRIVATE HYGROLOOM_DOUBLE)
target_compile_options(hygroloom_core_double PRIVATE -fPIC -fno-semantic-interposition) # as the rest of the core
target_link_libraries(hygroloom_core_double PRIVATE hygroloom_common Eigen3::Eigen TBB::tbb)
target_sources(hygroloom_core PRIVATE $<TARGET_OBJECTS:hygroloom_core_double>)

# Compiled alone whatever HYGROLOOM_UNITY says: what is inlined into stages decides which products are added unrounded.
set_source_files_properties(${yarn_sources} ${solver_sources}
  PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON COMPILE_OPTIONS "$<$<CONFIG:Release>:-O3>")
