// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The parts of a fabric that a designer names, which keys of the project each holds, and in which of them two fabrics differ.
#pragma once

#include "core/design/design.h"

#include <functional>
#include <string>
#include <vector>

namespace hygroloom {

/// Writes a number with its unit, which begins with the blank that is between them: 0.2 and " mm", 24 and " ends/cm", 35 and "°".
using NumberText = std::function<std::string(double number, const std::string& unit)>;

/// A key of a fabric in the project file.
struct PartField {
    std::string key;  ///< "warp.twist_per_m"; of an object or a list all that is in it
    std::string name; ///< "twist"; empty where the part's title says it
    std::function<bool(const Fabric&, const Fabric&)> same;
    std::function<void(Fabric& to, const Fabric& from)> copy;
    std::function<std::string(const Fabric&, const NumberText&)> text; ///< its value, with the unit
};

/// Whether the keys of a part change a run.
enum class PartActs { always, in_replicates, never };

struct FabricPart {
    std::string title; ///< "warp count"
    PartActs acts;
    std::vector<PartField> fields;
};

/// All keys of a fabric, each once, in an order in which people read them.
const std::vector<FabricPart>& fabric_parts();

/// A part in which two fabrics of a project differ.
struct PartDifference {
    std::string title;
    std::string first, second;            ///< what each has of it, where they differ: "twist 700 turns/m, 2 plies"
    std::vector<const PartField*> fields; ///< those that differ
};

/// number: an empty function writes the project's numbers. In the order of fabric_parts(). Fibres that differ only in their angles of water
/// count to the contact angle; weaves of the same matrix are the same weave. What acts in replicates alone is among them if there are
/// replicates. Precondition: validate() found no error.
std::vector<PartDifference> part_differences(const Design& design, const Fabric& first, const Fabric& second, bool replicates,
                                             const NumberText& number = {});

} // namespace hygroloom
