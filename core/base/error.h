// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Exceptions, cut by what the caller does with them. A wrong design is no exception: see design/validate.h.
#pragma once

#include <stdexcept>
#include <string>

namespace hygroloom {

/// Something failed; what() is a full sentence for people.
struct Error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A file cannot be read or written. what() names the file and, where known, the place in it.
struct FileError : Error {
    using Error::Error;
};

/// A device is missing, lost or out of memory; offer the CPU.
struct DeviceError : Error {
    using Error::Error;
};

/// The user cancelled; say nothing.
struct Cancelled : Error {
    Cancelled() : Error("Cancelled.") {}
};

} // namespace hygroloom
