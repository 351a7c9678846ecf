// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The recording of a worn garment: cells instead of yarns. Written and read as recordings of samples are.
#pragma once

#include "core/run/answers_code.h"
#include "core/wear/wear_layout.h"
#include "core/wear/wear_run.h"

#include <filesystem>

namespace hygroloom {

/// What a wear recording says of its run.
struct WearRecord {
    Design design;
    WearLayout layout;
    std::string fidelity, backend, device, date;
    std::string answers = answers_code; ///< as of a RunRecord
};

/// Throws FileError, also when another run writes to the path. After an error the frames before it can be read.
class WearWriter {
public:
    WearWriter(const std::filesystem::path& path, const WearRecord& record);
    ~WearWriter();
    WearWriter(const WearWriter&) = delete;
    WearWriter& operator=(const WearWriter&) = delete;
    void append(const WearFrame& frame);
    /// Where the run went on when its device failed, once.
    void note_device(const std::string& device);
    /// Notes the wall time, s, above 0, and closes.
    void finish(double wall);

private:
    struct File;
    std::unique_ptr<File> file_;
};

/// Reads one; nothing in it is trusted.
class WearRecording {
public:
    /// Whether the file is a recording of a garment; false for whatever cannot be read.
    static bool is_one(const std::filesystem::path& path);
    /// Throws FileError with a sentence.
    explicit WearRecording(const std::filesystem::path& path);
    ~WearRecording();
    WearRecording(WearRecording&&) noexcept;

    const WearRecord& record() const;
    /// s, that the run took; 0: it did not come to its end.
    double wall() const;
    bool finished() const { return wall() > 0; }
    /// Whether a run writes it now.
    bool is_being_written() const;
    int frames() const;
    double time_of(int frame) const;
    /// Throws FileError, which names the frame.
    WearFrame frame(int index) const;

private:
    struct File;
    std::unique_ptr<File> file_;
};

} // namespace hygroloom
