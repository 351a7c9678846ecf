// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The angles that a drop shows on the upper face of a cloth, and what finishes of its faces leave of its yarns.
#pragma once

#include "core/geometry/textile.h"

namespace hygroloom {

/// Radian. The one to which a drop spreads, and the one at which it draws back.
struct FaceAngles {
    double advancing = 0, receding = 0;
};

/// Cassie and Baxter's (1944), of yarns and of the air between them. Where dry fibres take liquid in, there is liquid in a yarn's pores,
/// and behind a drop that draws back also between yarns; else air. Yarns count by the face that they cover.
FaceAngles angles_on_face(const Textile& textile);

/// Of a type's yarns where they lie on a face with a finish.
FinishedShares shares_in_finish(const Textile& textile, const YarnType& type);

/// Radian, of the pores that conduct where yarns lie on a face: those of a finish that goes through the yarns, else the yarns' own.
double angle_under_finish(const Textile& textile, const YarnType& type, const std::optional<double>& finish);

} // namespace hygroloom
