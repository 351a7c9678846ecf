// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/geometry/face_angles.h"

#include "core/physics/scattered_gate.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace hygroloom {
namespace {

/// Of what covers so much of a face, with liquid or air beside it.
double cosine_beside(double cosine, double cover, bool liquid) { return cover * cosine + (liquid ? 1.0 : -1.0) * (1.0 - cover); }

} // namespace

FaceAngles angles_on_face(const Textile& textile)
{
    constexpr double least_gate = 0.01; // of fibres that are wet before a drop's edge reaches them; an assumption
    double advancing = 0, receding = 0, covered = 0;
    bool takes_in = false;
    for (YarnKind kind : {YarnKind::warp, YarnKind::weft}) {
        const YarnSystem& system = textile.system(kind);
        std::vector<bool> type_wets;
        for (const YarnType& type : system.types)
            type_wets.push_back(gate_of_dry_fibres(type.packing_round_core(), textile.face_angle.value_or(type.contact_angle)) >
                                least_gate);
        for (std::uint8_t own : system.order) {
            const YarnType& type = system.types[own];
            const double angle = textile.face_angle.value_or(type.contact_angle);
            const double back = std::max(0.0, angle - std::max(0.0, type.contact_angle - type.receding_angle));
            const bool wets = type_wets[own];
            takes_in = takes_in || wets;
            const double covers = type.section.width / (system.pitch * static_cast<double>(system.order.size()));
            advancing += covers * cosine_beside(std::cos(angle), type.packing_round_core(), wets);
            receding += covers * cosine_beside(std::cos(back), type.packing_round_core(), wets);
            covered += covers;
        }
    }
    const double cover = std::min(1.0, textile.quantities.cover_factor);
    const auto angle_of = [](double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)); };
    const double spreads = angle_of(cosine_beside(advancing / covered, cover, false));
    return {spreads, std::min(spreads, angle_of(cosine_beside(receding / covered, cover, takes_in)))};
}

FinishedShares shares_in_finish(const Textile& textile, const YarnType& type)
{
    return shares_in_finish(type.under_finish(), textile.thickness, textile.quantities.finish_depth * textile.thickness);
}

double angle_under_finish(const Textile& textile, const YarnType& type, const std::optional<double>& finish)
{
    return finish && shares_in_finish(textile, type).goes_through() ? *finish : type.contact_angle;
}

} // namespace hygroloom
