// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The recording .hygrorec: an HDF5 file, one group per frame, flushed after each so that a killed run leaves a readable file.
#pragma once

#include "core/run/run_record.h"
#include "core/scene/frame.h"

#include <filesystem>
#include <memory>
#include <span>

namespace hygroloom {

/// Writes a recording frame by frame. Throws FileError.
class RecordingWriter {
public:
    RecordingWriter(const std::filesystem::path& path, const RunRecord& run);
    ~RecordingWriter();
    RecordingWriter(const RecordingWriter&) = delete;
    RecordingWriter& operator=(const RecordingWriter&) = delete;

    void append(const Frame& frame);
    /// Where the run went on when its device failed, once.
    void note_device(const std::string& device);
    /// A part that is modelled from here on.
    void note_switched_on(const SwitchedPart& part);
    /// Notes the wall time and closes; a recording that was never finished reads as one that was cut short.
    void finish(double wall);

private:
    struct File;
    std::unique_ptr<File> file_;
};

/// Reads a recording, finished or cut short. Frames are read one at a time.
class Recording {
public:
    /// Throws FileError with a sentence when it is no recording, is damaged, or is newer than this program.
    explicit Recording(const std::filesystem::path& path);
    ~Recording();
    Recording(Recording&&) noexcept;

    const RunRecord& run() const;
    bool finished() const;
    int frames() const;
    /// With these values of each segment. Throws FileError. 0 <= index < frames().
    Frame frame(int index, std::span<const FrameField> fields = frame_fields) const;
    /// The ledger of every frame, without reading the fields.
    const std::vector<Ledger>& ledgers() const;

private:
    struct File;
    std::unique_ptr<File> file_;
};

} // namespace hygroloom
