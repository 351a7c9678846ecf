// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How a segment's fibres answer to a step: diffusion on their shells, eliminated to the regain of the skin.
#pragma once

#include "core/solver/steps/yarn_lines.h"

namespace hygroloom {

/// The fibre's answer to this step: bound water at the end = base + slope x equilibrium regain at its skin.
struct Fibre {
    double dry_mass, bound, base, slope;
    double per_mass; ///< 1 / dry_mass
    RegainLaw law;
};
/// Shells at the step's end, from the skin inwards: each is known + follows x the regain of the next one outwards, which over the
/// last one is the skin's.
struct ShellRows {
    double known[largest_shell_count], follows[largest_shell_count];
};

/// Flow into a fibre of radius 1 and diffusivity 1 at its skin: from_skin x (the skin's regain - the last shell's) - from_last x (the last
/// shell's - that of the one within).
struct SkinFlow {
    double from_skin, from_last;
};
/// The slope at the skin of the parabola over the fibre's section, as the square of the radius goes, that has the skin's regain and the
/// means of the two last shells; of a single shell, that of the straight line.
HL_FN SkinFlow skin_flow(int shells, double ratio)
{
    const double wider = plain_inverse(ratio), part = 8.0 * plain_inverse(wider - 1.0), both = plain_inverse(1.0 + wider);
    return shells > 1 ? SkinFlow{part * (2.0 + wider) * both, part * both * both} : SkinFlow{8.0, 0.0};
}

/// Implicit Euler on shells (see ShellWalk) with the skin held at a regain, eliminated from the middle outwards. Between shells water flows
/// as if regain were linear in the section within, which is exact for the late, parabolic profile.
HL_FN Fibre prepare_fibre(const Segments& s, int i, const YarnParameters& yarn, double temperature, double dt, ShellRows& rows)
{
    const int n = s.shells;
    const double* regain = s.regain + i * n;
    const double dry_mass = s.fibre_length(i, yarn) * yarn.fibre_area * yarn.fibre_density;
    Fibre fibre{dry_mass, s.bound[i], 0, 0, plain_inverse(dry_mass), regain_law(yarn.isotherm)};
    const double scale = dt * plain_inverse(yarn.fibre_radius * yarn.fibre_radius);
    const bool constant = yarn.diffusivity.law == DiffusionLaw::constant;
    const double everywhere = constant ? fibre_diffusivity(yarn.diffusivity, 0.0, temperature) : 0.0;
    ShellWalk walk = from_the_middle(n);
    const SkinFlow at_skin = skin_flow(n, walk.ratio);
    const double apart = 0.5 * (plain_inverse(walk.ratio) - walk.ratio); // middles of shells, over what is left at the face between them
    double base = 0, slope = 0; // base + slope x the shell's regain: what it and those within hold at the end
    double inner = 0, known = 0, follows = 0;
    double here = regain[0];
    for (int k = 0; k < n; ++k) {
        const bool skin = k == n - 1;
        const double next = skin ? here : regain[k + 1];
        const double diffusivity = constant ? everywhere : fibre_diffusivity(yarn.diffusivity, 0.5 * (here + next), temperature);
        const double share = walk.outwards();
        const double outer = scale * diffusivity * (skin ? at_skin.from_skin : 4.0 * (2.0 - walk.left) * plain_inverse(apart * walk.left));
        if (skin) inner += scale * diffusivity * at_skin.from_last;
        const double pivot = plain_inverse(share + inner - inner * follows + outer);
        base += slope * known; // of the shell before
        slope = share + slope * follows;
        known = (share * here + inner * known) * pivot;
        follows = outer * pivot;
        rows.known[k] = known;
        rows.follows[k] = follows;
        inner = outer;
        here = next;
    }
    fibre.base = (base + slope * known) * dry_mass;
    fibre.slope = slope * follows * dry_mass;
    return fibre;
}

} // namespace hygroloom
