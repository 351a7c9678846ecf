// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A running scene on the CPU. Compiled twice, for particles in single and in double precision: see HL_PRECISION.
#include "core/solver/cpu_solver.h"

#include "core/solver/cpu_executor.h"
#include "core/solver/solver.h"

namespace hygroloom {

extern template class YarnNetwork<CpuExecutor>; // yarn_network_cpu.cpp

inline namespace HL_PRECISION {

struct CpuSolver::Parts {
    Solver<CpuExecutor> solver;
};

CpuSolver::CpuSolver() : parts_(std::make_unique<Parts>()) {}
CpuSolver::~CpuSolver() = default;
void CpuSolver::set_threads(int threads) { parts_->solver.executor().set_threads(threads); }
void CpuSolver::load(const Scene& scene) { parts_->solver.load(scene); }
double CpuSolver::advance(double until, double wall_seconds) { return parts_->solver.advance(until, wall_seconds); }
Frame CpuSolver::frame() { return parts_->solver.frame(); }
void CpuSolver::stay() { parts_->solver.stay(); }
std::vector<std::byte> CpuSolver::state() { return parts_->solver.state(); }
void CpuSolver::go_on_from(const std::vector<std::byte>& state) { parts_->solver.go_on_from(state); }
void CpuSolver::squeeze(double share) { parts_->solver.squeeze(share); }
long CpuSolver::liquid_steps() const { return parts_->solver.liquid_steps(); }
int CpuSolver::particles() const { return parts_->solver.particles(); }
void CpuSolver::time_stages() { parts_->solver.time_stages(); }
std::vector<StageTime> CpuSolver::stage_times() { return parts_->solver.executor().stage_times(); }
long CpuSolver::listings() const { return parts_->solver.listings(); }
int CpuSolver::visited_segments() { return parts_->solver.visited_segments(); }

std::unique_ptr<Backend> make_cpu_solver() { return std::make_unique<CpuSolver>(); }

} // namespace HL_PRECISION
} // namespace hygroloom
