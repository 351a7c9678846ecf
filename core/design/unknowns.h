// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a description leaves open of a cloth: inputs that are known only within a range, how uneven its yarns are, and where a drop falls
// on the weave. Replicates draw them.
#pragma once

#include "core/design/design.h"

#include <cstdint>

namespace hygroloom {

/// An input that lies somewhere between two values, as likely below the given one as above.
struct UnknownInput {
    std::string name; ///< "contact angle on cotton"; what has the same name in two fabrics is the same unknown
    double low = 0, given = 0, high = 0;
    std::string unit;
    std::string source; ///< of the range
    std::string key;    ///< of the fabric's `uncertainty`
};

/// Of a fabric, those with a width; one row for each fibre and each yarn. Precondition: validate() found no error.
std::vector<UnknownInput> unknown_inputs(const Design& design, const Fabric& fabric);

/// One of the cloths that the descriptions leave open.
struct Replicate {
    std::uint64_t seed = 1;
    int number = 0; ///< 0: all inputs as given
    int of = 1;     ///< how many there are; one alone is the design itself
};

/// Where an unknown of that name lies in a replicate: 0 at its lowest, 1/2 as given, 1 at its highest. The replicates but the first form a
/// Latin hypercube (McKay, Beckman and Conover 1979) over all names, in which each name has its own order.
double place_in_range(const Replicate& replicate, const std::string& name);

/// A design drawn for a replicate, and where in it the fabric's unknown inputs lie.
struct Drawn {
    Design design;
    std::uint64_t seed = 1;         ///< of the run
    std::vector<std::string> names; ///< of the unknowns; none where there is one replicate
    std::vector<double> places;     ///< of each, see place_in_range()
};

/// Every unknown of the fabric at its place, and the drops moved by up to half a repeat of the weave. A packing that does not fit the weave
/// stays as given. Of several, number 0 has the inputs and the drops as given; one alone is the design itself.
Drawn drawn(const Design& design, const std::string& fabric, const std::string& experiment, const Replicate& replicate);
/// The same of all fabrics of a garment, without drops. A fibre that two of them share is the same in both. Precondition: the design has
/// them.
Drawn drawn(const Design& design, const std::vector<std::string>& fabrics, const Replicate& replicate);

} // namespace hygroloom
