// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What runs from Python have in common: how they run, on which machine, and what they tell meanwhile.
#pragma once

#include "app/python/watched.h"

#include "core/queue/run_queue.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace hygroloom::python {

/// As the package hands them over.
struct RunArguments {
    std::string fidelity = "standard", backend = "auto", physics, recording;
    std::map<std::string, std::string> knobs;
    std::uint64_t seed = 1;
    int threads = 0;
    int at_once = 0;
    bool force = false;               ///< begins runs that take more memory than is free
    double cell_mm = 0, shown_mm = 0; ///< of worn garments, see RunOptions
    std::vector<std::string> detail;
};

/// Of a dictionary with the keys above. Throws Error.
RunArguments run_arguments(const py::dict& given);

/// What is said can be done where memory does not suffice; smaller: what of a run takes less.
MemoryRule memory_rule(const RunArguments& arguments, const char* smaller = "a smaller sample");

/// Without textile and fidelity's reason. Throws Error.
RunOptions run_options(const RunArguments& arguments);

/// Of a worn garment. Throws Error.
RunOptions garment_options(const RunArguments& arguments);

/// For scenes side by side, each of which takes some bytes. Throws DeviceError, Error.
std::shared_ptr<RunPlaces> open_places(const RunArguments& arguments, int at_once, int scenes, std::size_t bytes_each);
/// "cpu" or "cuda", where runs go. Throws Error.
std::string backend_of(const RunArguments& arguments);
std::unique_ptr<Backend> open_backend(const RunArguments& arguments);

/// "12.5 of 60 s"
std::string in_words(const RunProgress& progress);
double share_of(const RunProgress& progress);

/// Adds up the progress of runs side by side. Any thread may call it.
class ManyRuns {
public:
    ManyRuns(Watch& watch, std::size_t runs) : watch_(watch), shares_(runs) {}
    void tell(std::size_t run, double share);
    void end(std::size_t run) { tell(run, 1); }

private:
    Watch& watch_;
    std::mutex mutex_;
    std::vector<double> shares_;
};

} // namespace hygroloom::python
