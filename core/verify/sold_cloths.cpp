// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/verify/sold_cloths.h"

#include "core/design/fitted_fabric.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {

double SoldCloth::sett(double place) const { return least_sett * std::pow(most_sett / least_sett, place); }

const std::vector<SoldCloth>& sold_cloths()
{
    static const std::vector<MaterialShare> cotton{{"cotton", 1}}, polyester{{"polyester", 1}}, wool{{"wool", 1}},
        half_each{{"cotton", 0.5}, {"polyester", 0.5}};
    static const std::vector<SoldCloth> cloths{
        {"gauze", cotton, "plain", 609.0 / 16, 4.0 / 16, 6, 15, {700}, {}}, // 16 layers
        {"batik", cotton, "plain", 123, 0.30, 36, 48, {900}, 60},
        {"downproof", cotton, "plain", 144, {}, 45, 66, {1000}, 169},
        {"flannel", cotton, "twill 2/2 Z", 176.3, 1.24, 15, 22, {500}, 27, true},
        {"quilting", cotton, "plain", 105, 0.26, 24, 30, {800}, 5},
        {"fine_sheeting", cotton, "plain", 121, 0.25, 40, 75, {1000}, 35},
        {"cotton_elastane_thick", cotton, "plain", 140, {}, 28, 45, {900}, 65},
        {"cotton_elastane", cotton, "plain", 144, 0.27, 30, 45, {900}, 64},
        {"polyester_satin", polyester, "satin 5/2", 86, 0.23, 35, 65, {100, 800}, 10},
        {"peel_ply", polyester, "plain", 65, 0.07, 18, 40, {50}, 64},
        {"polyester_crepe", polyester, "plain", 130, {}, 25, 45, {100, 1500}, 46.5},
        {"polycotton", half_each, "plain", 112, {}, 24, 42, {900}, 29},
        {"polyester_cotton", half_each, "plain", 125, 0.23, 34, 50, {900}, 57.5},
        {"raised_wool", wool, "plain", 417, 2.2, 8, 16, {400}, 3, true},
        {"melton", wool, "twill 2/2 Z", 440, {}, 10, 20, {300}, 20, true},
        {"silk", {{"silk", 1}}, "plain", 76, 0.18, 30, 60, {100, 1000}, 8},
        {"kona", cotton, "plain", 154, {}, 60 / 2.54, 60 / 2.54, {700}, 43}, // 60 x 60 per inch by trade lists
    };
    return cloths;
}

const SoldCloth& sold_cloth(const std::string& name)
{
    return *std::ranges::find_if(sold_cloths(), [&](const SoldCloth& cloth) { return cloth.name == name; });
}

Fabric fabric_of(const SoldCloth& cloth, double sett, double twist)
{
    Fabric fabric;
    fabric.name = cloth.name;
    fabric.weave = weave_from_pattern(cloth.weave);
    fabric.ends_per_cm = fabric.picks_per_cm = sett;
    fabric.warp.material = cloth.fibre;
    fabric.warp.twist_per_m = twist;
    fabric.warp.linear_density_tex = 5 * cloth.areal_density / sett;
    for (int i = 0; i < 5; ++i) { // crimp makes the cloth heavier
        fabric.weft = fabric.warp;
        *fabric.warp.linear_density_tex *= cloth.areal_density / derive_quantities({}, fabric).areal_density_g_m2;
    }
    fabric.weft = fabric.warp;
    return fabric;
}

} // namespace hygroloom
