// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Shapes of drops on a face for many looks: Young and Laplace's, tabled once.
#pragma once

#include <vector>

namespace hygroloom {

/// A drop on a circle, lengths in m.
struct CapShape {
    double angle = 0;     ///< rad, between liquid and face
    double height = 0;    ///< of its top over the face
    double curvature = 0; ///< 1/m, of its top
};

/// What drops have beside balls' caps of the same volume and angle, in lengths of the capillary length, over their logarithm of volume and
/// their angle. Bases within 0.3 %, heights within 1 % of the integrated outlines for volumes from 1e-4 to 100 cubed capillary lengths (of
/// water 2 nl to 2 ml) and angles from 5 to 160 degrees; bases within 6 % up to 175 degrees.
class CapShapes {
public:
    /// The only one; the first call makes it, in some 30 ms.
    static const CapShapes& table();

    /// m, radius of the base; volume in m3, angle in rad, weight as in drop_of_top(), over 0.
    double base(double volume, double angle, double weight) const;
    /// Of a volume on a base of a radius, m.
    CapShape shape(double volume, double base, double weight) const;

private:
    CapShapes();
    /// Logarithms of a drop's numbers over those of the ball's cap.
    struct Beside {
        double base = 0, height = 0, curvature = 0;
    };
    static Beside between(const Beside& a, const Beside& b, double part);
    Beside beside(double cubed, double angle) const;

    std::vector<std::vector<Beside>> rows_; ///< of each volume, of each angle
};

} // namespace hygroloom
