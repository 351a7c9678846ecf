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
  sim/coarse_scene.cpp
  sim/cpu_backend.cpp
  sim/cpu_solver.cpp
  sim/droplet.cpp
  sim/expectation.cpp
  sim/fidelity.cpp
  sim/hdf5_file.cpp
  sim/host_cloth.cpp
  sim/model_plan.cpp
  sim/part_watch.cpp
  sim/plan_json.cpp
  sim/recording.cpp
  sim/runner.cpp
  sim/scene.cpp
)

# What depends on the particles' number type, once more in double precision.
add_library(hygroloom_core_double OBJECT sim/cpu_solver.cpp sim/droplet.cpp sim/host_cloth.cpp)
target_compile_definitions(hygroloom_core_double PRIVATE HYGROLOOM_DOUBLE)
target_link_libraries(hygroloom_core_double PRIVATE hygroloom_common Eigen3::Eigen TBB::tbb)
target_sources(hygroloom_core PRIVATE $<TARGET_OBJECTS:hygroloom_core_double>)
