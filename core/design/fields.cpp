// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/design/fields.h"

#include "core/design/field_labels.h"
#include "core/design/yarn_class.h"
#include "core/design/yarn_sections.h"

#include <cctype>

namespace hygroloom {
namespace {

constexpr const char* directions[] = {"S", "Z"};

constexpr auto class_words = [] {
    std::array<const char*, yarn_classes> words{};
    for (std::size_t i = 0; i < words.size(); ++i) words[i] = yarn_class_infos[i].name;
    return words;
}();

template <TwistDirection Yarn::*member> constexpr FieldChoice<Yarn> direction()
{
    return {directions, [](const Yarn& yarn) { return static_cast<int>(yarn.*member); },
            [](Yarn& yarn, int word) { yarn.*member = static_cast<TwistDirection>(word); }};
}

constexpr FieldChoice<Yarn> made_as{
    class_words, [](const Yarn& yarn) { return yarn.yarn_class ? static_cast<int>(*yarn.yarn_class) : -1; },
    [](Yarn& yarn, int word) { yarn.yarn_class = word < 0 ? std::nullopt : std::optional(static_cast<YarnClass>(word)); }, true};

constexpr const char *strip_sides[] = {"warp", "weft"}, *fed_sides[] = {"bottom", "top"}, *cut_faces[] = {"top_outside", "top_inside"};

/// A switch, whose words are those of off and on.
template <auto member> struct Switch;
template <typename Owner, bool Owner::*member> struct Switch<member> {
    static constexpr FieldChoice<Owner> with(std::span<const char* const> words)
    {
        return {words, [](const Owner& owner) { return static_cast<int>(owner.*member); },
                [](Owner& owner, int word) { owner.*member = word == 1; }};
    }
};
template <auto member> constexpr auto switched(std::span<const char* const> words) { return Switch<member>::with(words); }

/// A file of single yarns says nothing of plies.
bool is_plied(const Yarn& yarn)
{
    const Yarn single;
    return yarn.plies != single.plies || yarn.ply_twist_per_m != single.ply_twist_per_m ||
           yarn.ply_twist_direction != single.ply_twist_direction;
}

constexpr const char* replaces = "Measured. Replaces the calculated value. Leave empty to use the calculated one.";
constexpr const char* at_20 = "At 20 °C; at other temperatures it follows that of water.";
constexpr const char* shared_crimp =
    "How much longer the yarn is than the fabric. Leave empty to share the crimp between warp and weft by their spans. Without a thickness "
    "it gives way where yarns would be packed closer than 0.85.";
constexpr const char* one_face =
    "Contact angle of a finish on this face alone. Leave empty for the yarns' own. Acts in the closure “pores” only.";

} // namespace

template <> std::span<const Field<Material>> fields_of()
{
    using M = Material;
    static constexpr Field<M> rows[] = {
        {"density_kg_m3", &M::density_kg_m3, "Density", "density of a fibre", 500, 3000, "Of the dry fibre."},
        {"fibre_radius_um", &M::fibre_radius_um, "Radius", "radius of a fibre", least_fibre_radius_um, most_fibre_radius_um,
         "Of a circle of the fibre's area. A yarn's filament count takes its place.", "", Need::fibre_radius},
        {"standard_regain", &M::standard_regain, "Standard regain", "regain at 65 % relative humidity", 0, 0.5,
         "Water per dry fibre at 65 % relative humidity and 20 °C, absorption."},
        {"saturation_regain", &M::saturation_regain, "Saturation regain", "regain at 100 % relative humidity", 0, 2,
         "Water per dry fibre at 100 % relative humidity.", "", Need::sorption},
        {"contact_angle_deg", &M::contact_angle_deg, "Contact angle", "contact angle", 0, 180,
         "Of water that advances. A fabric's finish takes its place.", "", Need::liquid | Need::fibre_angle},
        {"receding_angle_deg", &M::receding_angle_deg, "Receding angle", "receding angle", 0, 180,
         "Of water that draws back; at most the contact angle. Leave empty for the assumed one: 0 on cotton, flax, hemp and viscose, else "
         "20° less than the contact angle. Acts in the closure “pores” only.",
         "", Need::pores | Need::liquid},
        {"thermal_conductivity_w_mk", &M::thermal_conductivity_w_mk, "Conductivity", "thermal conductivity of a fibre", 0.005, 10,
         "Of heat, across the fibre.", "", Need::heat},
        {"specific_heat_j_kgk", &M::specific_heat_j_kgk, "Specific heat", "specific heat of a fibre", 100, 10000, "Of the dry fibre.", "",
         Need::heat},
        {"heat_of_wetting_j_g", &M::heat_of_wetting_j_g, "Heat of wetting", "heat of wetting of a fibre", 0, 500,
         "From dry to saturated, per gram of fibre. 0: what the law of sorption heats gives.", "", Need::sorption | Need::heat,
         [](const M& material) { return material.heat_of_wetting_j_g != 0; }}};
    return rows;
}

template <> std::span<const Field<GabIsotherm>> fields_of()
{
    using G = GabIsotherm;
    static constexpr Field<G> rows[] = {{"monolayer_regain", &G::monolayer_regain, "Monolayer regain", "monolayer regain", 1e-5, 0.5},
                                        {"c", &G::c, "C", "isotherm's c", 0.01, 1000},
                                        {"k", &G::k, "K", "isotherm's k", 0.01, 0.99}};
    return rows;
}

template <> std::span<const Field<YarnCore>> fields_of()
{
    static constexpr Field<YarnCore> rows[] = {{"share", &YarnCore::share, "Core share", "share of the core in the yarn's mass",
                                                least_core_share, most_core_share, "Of the yarn's mass."}};
    return rows;
}

template <> std::span<const Field<Yarn>> fields_of()
{
    using Y = Yarn;
    static constexpr const char *count = "count", *construction = "construction", *look = "look";
    static constexpr Field<Y> rows[] = {
        {"diameter_mm", &Y::diameter_mm, "Diameter", "diameter of a yarn", 0.01, 10,
         "Of the free, round yarn. Typed here, it takes the place of the count.", count},
        {"linear_density_tex", &Y::linear_density_tex, "Linear density", "linear density of a yarn", least_tex, most_tex,
         "Of the whole yarn, with all its plies.", count},
        {"packing_factor", &Y::packing_factor, "Packing", "packing factor of a yarn", loosest_packing, densest_packing,
         "Fibre volume divided by yarn volume: 0.45 to 0.68 for spun yarns. Where it does not follow from the others, it is 0.5 of a given "
         "diameter, else that of the yarn's class.",
         construction},
        {"yarn_class", made_as, "Class", "", 0, 0,
         "How the yarn is made: packing, section and fibres that stand out follow from it where they are not given. Leave it out for what "
         "fibre, twist, plies and filaments make likely.",
         construction, Need::shape_by_class},
        {"filament_count", &Y::filament_count, "Filaments", "number of filaments", fewest_filaments, most_filaments,
         "Of a yarn of continuous filaments, all plies together. Their radius, and the pores between them, follow from it and the linear "
         "density. Leave empty for staple yarns: the material's fibre radius counts.",
         construction},
        {"fibres_per_yarn", &Y::fibres_per_yarn, "Fibres drawn", "number of drawn fibres", 1, 500,
         "Per yarn, in pictures and exports. Each represents a bundle of real fibres.", look},
        {"twist_per_m", &Y::twist_per_m, "Twist", "twist", 0, 5000, "Of the single yarn.", construction, Need::shape_by_twist},
        {"twist_direction", direction<&Y::twist_direction>(), "Twist direction", "", 0, 0, "", look},
        {"plies", &Y::plies, "Plies", "number of plies", 1, most_plies,
         "Single yarns twisted together. Diameter and linear density are those of the whole yarn.", construction, Need::shape_by_twist,
         is_plied},
        {"ply_twist_per_m", &Y::ply_twist_per_m, "Ply twist", "twist of the plies", 0, 5000, "Turns of the plies round each other.",
         construction, Need::pores | Need::liquid | Need::tortuosity, is_plied},
        {"ply_twist_direction", direction<&Y::ply_twist_direction>(), "Ply direction", "", 0, 0, "", look, {}, is_plied},
        {"irregularity_cv", &Y::irregularity_cv, "Irregularity", "coefficient of variation of the linear density", 0, 0.4,
         "Coefficient of variation of the linear density along the yarn (Uster CVm). Leave empty for what is usual of such a yarn. Acts in "
         "the closure “pores” only.",
         construction, Need::pores},
        {"price", &Y::price, "Price", "price of a yarn", 0, 1e6, "Of a kilogram. The card tells costs in the same currency.", look}};
    return rows;
}

template <> std::span<const Field<Flyaway>> fields_of()
{
    using F = Flyaway;
    static constexpr Field<F> rows[] = {
        {"loop_density_per_mm", &F::loop_density_per_mm, "Loops", "number of loops per mm", 0, 1000,
         "Fibres that leave the yarn and come back to it, per mm of yarn. With the closure “pores” they hold falling drops off dry yarns.",
         "", Need::pores | Need::drops},
        {"hair_density_per_mm", &F::hair_density_per_mm, "Hairs", "number of hairs per mm", 0, 1000,
         "Fibre ends that stand out of the yarn, per mm of yarn. With the closure “pores” they hold falling drops off dry yarns.", "",
         Need::pores | Need::drops},
        {"loop_height_mm", &F::loop_height_mm, "Loop height", "height of the loops", 0, 20,
         "Height of the highest loop above the yarn; the lowest is half as high. Loops make the cloth thicker, and the still air among "
         "them slows drying."},
        {"hair_length_mm", &F::hair_length_mm, "Hair length", "length of the hairs", 0, 50,
         "Mean length of the fibre ends; the shortest have half of it, the longest one and a half times.", "", Need::pores | Need::drops}};
    return rows;
}

template <> std::span<const Field<Measured>> fields_of()
{
    using M = Measured;
    static constexpr Field<M> rows[] = {{"porosity", &M::porosity, "Porosity", "porosity", 0.01, 0.999, replaces},
                                        {"areal_density_g_m2", &M::areal_density_g_m2, "Weight", "areal density", 1, 10000, replaces},
                                        {"tortuosity", &M::tortuosity, "Tortuosity", "tortuosity", 1, 20, replaces},
                                        {"crimp_percent", &M::crimp_percent, "Crimp", "crimp", 0, 100, replaces}};
    return rows;
}

template <> std::span<const Field<Uncertainty>> fields_of()
{
    using U = Uncertainty;
    static constexpr Field<U> rows[] = {
        {"contact_angle_deg", &U::contact_angle_deg, "Contact angle ±", "uncertainty of the contact angle", 0, 90},
        {"receding_angle_deg", &U::receding_angle_deg, "Receding angle ±", "uncertainty of the receding angle", 0, 90},
        {"packing_factor", &U::packing_factor, "Packing ±", "uncertainty of the packing factor", 0, 0.3}};
    return rows;
}

template <> std::span<const Field<Loom>> fields_of()
{
    using L = Loom;
    static constexpr Field<L> rows[] = {
        {"ends_per_cm", &L::ends_per_cm, "Ends in the reed", "number of ends per cm in the reed", 0.5, 500,
         "On the loom. Leave empty to compute it from the reed width."},
        {"picks_per_cm", &L::picks_per_cm, "Picks on the loom", "number of picks per cm on the loom", 0.5, 500,
         "On the loom. Leave empty where the cloth keeps its length."},
        {"reed_width_cm", &L::reed_width_cm, "Reed width", "width in the reed", 1, 2000,
         "Of the warp in the reed. Leave empty to compute it from the ends in the reed."},
        {"ends_per_dent", &L::ends_per_dent, "Ends a dent", "number of ends in a dent", 1, 40, "Of the reed."}};
    return rows;
}

template <> std::span<const Field<Fabric>> fields_of()
{
    using F = Fabric;
    static constexpr const char *crimp = "crimp", *finish = "depth of the finish";
    static constexpr Field<F> rows[] = {
        {"ends_per_cm", &F::ends_per_cm, "Ends", "number of ends per cm", 0.5, 500, "Warp yarns per centimetre. You can type “89 epi”.",
         "warp sett"},
        {"picks_per_cm", &F::picks_per_cm, "Picks", "number of picks per cm", 0.5, 500, "Weft yarns per centimetre. You can type “89 ppi”.",
         "weft sett"},
        {"thickness_mm", &F::thickness_mm, "Thickness", "thickness of a fabric", 0.01, 50,
         "With the loops on both faces. Leave empty to calculate it from the yarns.", "thickness"},
        {"warp_crimp_percent", &F::warp_crimp_percent, "Warp crimp", "crimp of the warp", 0, 100, shared_crimp, crimp},
        {"weft_crimp_percent", &F::weft_crimp_percent, "Weft crimp", "crimp of the weft", 0, 100, shared_crimp, crimp},
        {"contact_angle_deg", &F::contact_angle_deg, "Contact angle", "contact angle", 0, 180,
         "Advancing contact angle of water on the finished fabric. Leave empty to use that of each yarn's fibres. Above 90° the yarns do "
         "not absorb water.",
         "contact angle", Need::liquid},
        {"finish_face", &F::finish_face, "Finish, top face", "contact angle of the upper face's finish", 0, 180, one_face,
         "finish of the upper face", Need::pores | Need::liquid},
        {"finish_back", &F::finish_back, "Finish, back", "contact angle of the lower face's finish", 0, 180, one_face,
         "finish of the lower face", Need::pores | Need::liquid},
        {"finish_depth", &F::finish_depth, "Finish, depth", "depth of a face's finish, a share of the thickness,", 0, 1,
         "How deep the finish of a face reaches, of the fabric's thickness. The yarns wick below it. Leave empty for 10 %, which is "
         "assumed. 100 %: the yarns that lie on the face are finished through. Acts in the closure “pores” only.",
         finish, Need::pores | Need::finish | Need::liquid},
        {"finish_holes", &F::finish_holes, "Finish, untreated", "share of crowns and hairs that a finish leaves untreated", 0, 1,
         "Share of the crowns and hairs on the finished face that the finish leaves untreated: liquid passes there at once. Leave empty "
         "for none. Acts in the closure “pores” only.",
         finish, Need::pores | Need::finish | Need::spot | Need::liquid}};
    return rows;
}

template <> std::span<const Field<Liquid>> fields_of()
{
    using L = Liquid;
    static constexpr Field<L> rows[] = {
        {"surface_tension_mn_m", &L::surface_tension_mn_m, "Surface tension", "surface tension", 1, 500, at_20, "", Need::liquid},
        {"viscosity_mpa_s", &L::viscosity_mpa_s, "Viscosity", "viscosity", 0.05, 1000, at_20, "", Need::liquid},
        {"density_kg_m3", &L::density_kg_m3, "Density", "density", 500, 2000, at_20, "", Need::liquid}};
    return rows;
}

template <> std::span<const Field<Climate>> fields_of()
{
    using C = Climate;
    static constexpr Field<C> rows[] = {{"temperature_c", &C::temperature_c, "Temperature", "temperature", -10, 60},
                                        {"relative_humidity", &C::relative_humidity, "Humidity", "relative humidity", 0, most_humidity,
                                         "Relative humidity of the air, 1 where it is saturated. Over 1 vapour condenses on the cloth.", "",
                                         Need::vapour},
                                        {"air_speed_m_s", &C::air_speed_m_s, "Air speed", "air speed", 0, 20}};
    return rows;
}

template <> std::span<const Field<Droplet>> fields_of()
{
    using D = Droplet;
    static constexpr Field<D> rows[] = {
        {"volume_ul", &D::volume_ul, "Volume", "volume of a droplet", 1e-6, 5000},
        {"time_s", &D::time_s, "Time", "time when a droplet appears", 0, 86400, "Time at which the drop appears."},
        {"height_mm", &D::height_mm, "Height", "height of a droplet over the fabric", 0, 100,
         "Height of its lowest point above the fabric."},
        {"speed_m_s", &D::speed_m_s, "Speed", "droplet's speed", 0, fastest_droplet_m_s, "Downward speed when it appears."}};
    return rows;
}

template <> std::span<const Field<Experiment>> fields_of()
{
    using E = Experiment;
    static constexpr Field<E> rows[] = {
        {"duration_s", &E::duration_s, "Duration", "duration", 0, 86400},
        {"feed_s", &E::feed_s, "Feed time", "time the pump runs", 0.01, 86400, "Time for which the pump runs."},
        {"drop_ul", &E::drop_ul, "Drop volume", "volume of each drop of the feed", 0, 1000,
         "The feed comes in equal drops of at most this volume, each when the pump has delivered it. Drops join a pool that the cloth "
         "absorbs. 0: the feed flows evenly."},
        {"volume_ul", &E::volume_ul, "Volume", "volume of liquid", 1e-3, 1e5},
        {"direction", switched<&E::along_weft>(strip_sides), "Direction", "", 0, 0, "Of the strip's long side."},
        {"immersion_mm", &E::immersion_mm, "Immersion", "immersion", 0, 2000, "Depth of the strip's end below the liquid surface."},
        {"initial_water_g_m2", &E::initial_water_g_m2, "Initial water", "water at the start", 0, 1e5,
         "Liquid water in the fabric at the start, in addition to its regain in this climate."},
        {"rate_g_m2_h", &E::rate_g_m2_h, "Sweat rate", "rate of sweat", 0, 1e5},
        {"side", switched<&E::from_top>(fed_sides), "Face", "", 0, 0, "That is fed; the skin is at the bottom."}};
    return rows;
}

template <> std::span<const Field<WearExperiment>> fields_of()
{
    using W = WearExperiment;
    static constexpr Field<W> rows[] = {
        {"duration_s", &W::duration_s, "Duration", "duration", 1, 86400},
        {"initial_water_g_m2", &W::initial_water_g_m2, "Initial water", "water at the start", 0, 5000, "That the garment is wet with."}};
    return rows;
}

template <> std::span<const Field<Activity>> fields_of()
{
    using A = Activity;
    static constexpr Field<A> rows[] = {{"time_s", &A::time_s, "From", "time of the activity", 0, 1e6},
                                        {"factor", &A::factor, "Times", "factor of the activity", 0, largest_activity,
                                         "Of the rates that the wearer's table of zones gives."}};
    return rows;
}

template <> std::span<const Field<BuiltInGarment>> fields_of()
{
    using B = BuiltInGarment;
    static constexpr Field<B> rows[] = {
        {"chest_mm", &B::chest_mm, "Chest", "girth of the body", 500, 2000, "Girth of the body's chest; of leggings of its hip."},
        {"length_mm", &B::length_mm, "Length", "length", 300, 1200,
         "From the shoulder to the hem; of leggings from the waist to the ankle."},
        {"ease_mm", &B::ease_mm, "Ease", "ease of the girth", 0, 800, "How much longer the garment's girth is than the body's."},
        {"sleeve_mm",
         &B::sleeve_mm,
         "Sleeve",
         "length of a sleeve",
         50,
         700,
         "Of a tee, from the shoulder's point to the hem.",
         "",
         {},
         [](const B& garment) { return garment.kind == "tee"; }}};
    return rows;
}

SizeRange size_range(const std::string& kind, const Field<BuiltInGarment>& size)
{
    if (kind == "leggings" && size.key == std::string_view("length_mm")) return {500, 1100};
    return {size.least, size.most};
}

template <> std::span<const Field<PanelCut>> fields_of()
{
    using P = PanelCut;
    static constexpr Field<P> rows[] = {
        {"grain_deg", &P::grain_deg, "Grain", "angle of the grain", -360, 360,
         "Of the warp, from the pattern's +y, counter-clockwise as seen from outside."},
        {"face", switched<&P::top_inside>(cut_faces), "Face", "", 0, 0, "Whether the fabric's top face lies outside."},
        {"layers",
         &P::layers,
         "Layers",
         "number of layers",
         1,
         most_layers,
         "Of cloth that lie on each other, the last on the skin.",
         "",
         {},
         [](const P& cut) { return cut.layers != 1; }}};
    return rows;
}

template <> std::span<const Field<OwnZone>> fields_of()
{
    static constexpr Field<OwnZone> rows[] = {
        {"sweat_g_m2_h", &OwnZone::sweat_g_m2_h, "Sweat", "sweat of the zone", 0, 1e5, "Times the activity's factor."}};
    return rows;
}

template <> std::span<const Field<Wearer>> fields_of()
{
    static constexpr Field<Wearer> rows[] = {
        {"skin_temperature_c", &Wearer::skin_temperature_c, "Skin temperature", "temperature of the skin", 10, 45}};
    return rows;
}

namespace {

template <typename... Owners> std::string label_in(std::string_view key)
{
    std::string label;
    const auto look = [&](const auto& rows) {
        for (const auto& row : rows)
            if (label.empty() && row.key == key) label = row.label;
    };
    (look(fields_of<Owners>()), ...);
    if (!label.empty()) label[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(label[0])));
    return label;
}

template <typename Owner> std::optional<Message> allowed(const std::string& key)
{
    for (const Field<Owner>& field : fields_of<Owner>())
        if (field.key == key && field.is_number())
            return say("The {} must be from {}.", Title{field.title, field.label, field.unit()},
                       Between{field.least, field.most, field.unit()});
    return {};
}

/// The keys of lists and objects, and whose rows are in them.
constexpr std::pair<std::string_view, std::optional<Message> (*)(const std::string&)> holders[] = {{"materials", allowed<Material>},
                                                                                                   {"isotherm", allowed<GabIsotherm>},
                                                                                                   {"liquids", allowed<Liquid>},
                                                                                                   {"fabrics", allowed<Fabric>},
                                                                                                   {"fabrics", allowed<Measured>},
                                                                                                   {"flyaway", allowed<Flyaway>},
                                                                                                   {"uncertainty", allowed<Uncertainty>},
                                                                                                   {"loom", allowed<Loom>},
                                                                                                   {"warp", allowed<Yarn>},
                                                                                                   {"weft", allowed<Yarn>},
                                                                                                   {"extra_yarns", allowed<Yarn>},
                                                                                                   {"core", allowed<YarnCore>},
                                                                                                   {"experiments", allowed<Experiment>},
                                                                                                   {"wears", allowed<WearExperiment>},
                                                                                                   {"climate", allowed<Climate>},
                                                                                                   {"initial", allowed<Climate>},
                                                                                                   {"droplets", allowed<Droplet>},
                                                                                                   {"activity", allowed<Activity>},
                                                                                                   {"source", allowed<BuiltInGarment>},
                                                                                                   {"panels", allowed<PanelCut>},
                                                                                                   {"wearer", allowed<Wearer>},
                                                                                                   {"own_zones", allowed<OwnZone>}};

} // namespace

std::optional<Message> allowed_at(const Place& place)
{
    const std::size_t steps = place.steps().size();
    for (std::size_t step = steps; step-- > 0;)
        for (const auto& [holder, allowed_in] : holders)
            if (place.key(step) == holder)
                if (auto message = allowed_in(place.key(steps - 1))) return message;
    return {};
}

std::string label_of_key(std::string_view key)
{
    return label_in<Yarn, Fabric, Material, GabIsotherm, Flyaway, Measured, Liquid, Climate, Droplet, Experiment, WearExperiment, Activity,
                    BuiltInGarment, PanelCut, OwnZone, Wearer>(key);
}

} // namespace hygroloom
