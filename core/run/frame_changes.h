// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Frames of recordings that hold how far each value moved since the frame before, in steps of its rounding and over what its neighbour
// moved: half as many bytes as the values. Every 16th frame has the values, so that each is found from 15 others at most.
//
// In the file: a value is a whole number, of steps where its field's number "changes/FIELD" is one (at most 1), else of the leading bits of
// a float of which that number is significant. A change is what it moved since the frame before, less what the value "changes/back" places
// before moved, as 0, 1, 2, 3 … for 0, -1, 1, -2 …. A frame that has such changes in the place of its values says so in "follows".
#pragma once

#include "core/run/run_file.h"
#include "core/scene/frame.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace hygroloom {

/// How the values of a field are numbered: by how many steps they are, or by their leading bits.
struct ValueCodes {
    float step = 0; ///< 0: by bits
    int bits = 0;   ///< significant ones
    /// None where frames do not show such a value.
    std::optional<std::int32_t> of(float value) const;
    std::int64_t most() const; ///< the largest code; the least is 0
    float value(std::int32_t code) const;
};

/// Writes the fields of frames, in their order.
class ChangesWriter {
public:
    /// Notes in the file what readers need to know. Throws FileError.
    ChangesWriter(RunFileWriter& file, bool in_bundles);
    /// Into the frame's row, if its changes tell what it holds. Else it is to be written whole. Throws FileError.
    bool write(RunRow& row, const Frame& frame);

private:
    bool follow(const Frame& frame);

    std::size_t back_;                             ///< how many segments before lies the one that changes alike
    int since_whole_ = 0;                          ///< frames
    std::vector<std::vector<std::int32_t>> codes_; ///< of the last frame, by field; empty: it has values without
    std::vector<std::int32_t> change_;             ///< of a field
    std::vector<std::uint32_t> changes_;           ///< as they are written: n of the first field, n of the next
};

/// Reads them, of which none is trusted.
class ChangesReader {
public:
    /// Throws FileError where what is said of the changes cannot be.
    explicit ChangesReader(const RunFileReader& file);
    /// Of a frame whose row says that it follows. Throws FileError.
    std::vector<float> values(const RunFileReader& file, std::int64_t number, const std::string& field, std::size_t count);

private:
    struct Field {
        ValueCodes how;
        std::int64_t number = -1;        ///< of the frame that was found last; less than 0: none was
        std::int64_t whole = -1;         ///< of the frame from which that was found, which has its values
        std::vector<std::int32_t> codes; ///< its values
    };
    void begin(Field& field, const std::string& name, const RunFileReader& file, std::int64_t number, std::size_t count);
    void add(Field& field, const std::string& name, const RunFileReader& file, std::int64_t number, std::size_t count);

    std::size_t back_ = 1;
    std::map<std::string, Field> fields_;
    std::vector<std::int64_t> change_; ///< of one field
};

/// The column that says whether a frame's fields hold changes.
constexpr const char* follows_column = "follows";

/// Whether the frames of a recording are kept so: not where a few values or cells are shown.
bool keeps_changes(std::size_t values, bool shows_cells);

} // namespace hygroloom
