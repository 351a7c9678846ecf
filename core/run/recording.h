// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The recording .hygrorec of a sample: an SQLite database, a row per frame, whole after each so that a killed run leaves a readable file.
#pragma once

#include "core/run/run_record.h"
#include "core/scene/frame.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <span>

namespace hygroloom {

/// Writes a recording frame by frame. It stands beside the path until its first frame is whole. A recording that was there before stays
/// until the second is, or the run has ended.
/// Throws FileError, also when another run writes to the path. After an error the frames before it can be read.
class RecordingWriter {
public:
    /// in_bundles: frames are those of the bundles that yarns go in, with the faces' totals of the single yarns; see YarnsOfBundles.
    RecordingWriter(const std::filesystem::path& path, const RunRecord& run, bool in_bundles = false);
    ~RecordingWriter();
    RecordingWriter(const RecordingWriter&) = delete;
    RecordingWriter& operator=(const RecordingWriter&) = delete;

    void append(const Frame& frame);
    /// Lets the frames that were added take effect, where that has waited long enough: while nothing is added. From any thread; does
    /// nothing while another one adds.
    void commit_when_due();
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

/// Reads a recording, finished, cut short, or as a run that writes it has it so far. Nothing in it is trusted. Frames are read one at a
/// time; those that are wrong before their values are read are left out.
class Recording {
public:
    /// Throws FileError with a sentence when it is no recording, is damaged, or is newer than this program.
    explicit Recording(const std::filesystem::path& path);
    ~Recording();
    Recording(Recording&&) noexcept;

    const RunRecord& run() const;
    bool finished() const;
    /// Whether a run was writing it when it was opened.
    bool is_being_written() const;
    int frames() const;
    /// Which frames were left out and why, as sentences that begin with the file's name.
    const std::vector<std::string>& problems() const;
    /// With these values of each segment. Throws FileError, which names the frame. 0 <= index < frames().
    Frame frame(int index, std::span<const FrameField> fields = frame_fields) const;
    /// Each in order, until it returns false. One that cannot be read is left out, and is no frame any more.
    void read_frames(const std::function<bool(const Frame&)>& see);
    /// The ledger of every frame, without reading the fields.
    const std::vector<Ledger>& ledgers() const;

private:
    struct File;
    std::unique_ptr<File> file_;
};

} // namespace hygroloom
