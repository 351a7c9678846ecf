// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The built-in body: heights and lengths in shares of the stature, standing on the floor, arms away from the trunk.
#pragma once

namespace hygroloom::body {

constexpr double stature = 1.75; ///< m, an assumption: about the mean of men's and women's tall half

// Drillis and Contini 1966, as printed in Winter, Biomechanics and Motor Control of Human Movement.
constexpr double chin = 0.870 * stature;
constexpr double shoulder = 0.818 * stature;
constexpr double knee = 0.285 * stature;
constexpr double ankle = 0.039 * stature;
constexpr double half_shoulders = 0.129 * stature; ///< from the middle to the joint
constexpr double upper_arm = 0.186 * stature;      ///< from the shoulder to the elbow
constexpr double forearm = 0.146 * stature;        ///< from the elbow to the wrist

// Assumptions.
constexpr double lower_rib = 0.64 * stature;
constexpr double waist = 0.61 * stature;
constexpr double crotch = 0.47 * stature;   ///< also where the buttocks end
constexpr double sole = 0.01;               ///< m: cloth that low lies under the foot
constexpr double shoulder_reach = 0.1;      ///< m: cloth rests on the shoulder so far below its top
constexpr double floor_below_origin = 1.15; ///< m: of bodies whose origin is in the pelvis, as older patterns have it

} // namespace hygroloom::body
