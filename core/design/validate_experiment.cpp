// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/base/units.h"
#include "core/design/issue_list.h"

#include <algorithm>

namespace hygroloom {

namespace {

constexpr std::size_t most_climates = 1000;

double drop_radius_mm(const Droplet& drop) { return std::cbrt(3 * drop.volume_ul / (4 * pi)); }

void validate_droplet(const Experiment& experiment, const Droplet& drop, const Place& where, IssueList& list)
{
    const bool sound = list.fields(where, drop);
    if (experiment.duration_s > 0 && drop.time_s >= experiment.duration_s)
        list.error("droplet_after_end", where / "time_s",
                   say("The droplet appears at {} s, not before the experiment's end at {} s.", drop.time_s, experiment.duration_s));
    bool reaches_over = false;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const double at = drop.at_mm[axis], half = 0.5 * experiment.sample_mm[axis];
        if (!(std::abs(at) <= half)) {
            list.error("droplet_off_sample", where / "at_mm" / axis,
                       say("The droplet must land on the sample, from {:.4g} {}; given is {:.4g}.", Between{-half, half, Stored::mm},
                           axis == 0 ? say("along the weft") : say("along the warp"), Bare{at, Stored::mm}));
            return;
        }
        reaches_over = reaches_over || (sound && std::abs(at) + drop_radius_mm(drop) > half);
    }
    if (reaches_over)
        list.add(Severity::warning, "droplet_over_edge", where / "at_mm",
                 say("The droplet, {:.3g} across, reaches over the sample's edge; some of it will miss the fabric.",
                     Amount{2 * drop_radius_mm(drop), Stored::mm}));
}

void validate_overlaps(const Experiment& experiment, const Place& where, IssueList& list)
{
    const auto& drops = experiment.droplets;
    for (std::size_t a = 0; a < drops.size(); ++a)
        for (std::size_t b = a + 1; b < drops.size(); ++b) {
            if (std::abs(drops[a].time_s - drops[b].time_s) > 1e-3) continue;
            const double apart = std::hypot(drops[a].at_mm[0] - drops[b].at_mm[0], drops[a].at_mm[1] - drops[b].at_mm[1],
                                            drops[a].height_mm + drop_radius_mm(drops[a]) - drops[b].height_mm - drop_radius_mm(drops[b]));
            const double needed = drop_radius_mm(drops[a]) + drop_radius_mm(drops[b]);
            if (apart < needed)
                list.error("droplets_overlap", where / "droplets" / b,
                           say("Droplets {} and {} appear at the same time and overlap: {:.3g} apart, {:.3g} needed.", a, b,
                               Amount{apart, Stored::mm}, Amount{needed, Stored::mm}));
        }
}

/// Falling liquid is counted in quanta; 64 bits hold half a kilogram of them.
void validate_fallen(const Design& design, const Experiment& experiment, const Place& where, IssueList& list)
{
    constexpr double most_g = 499;
    const Liquid* liquid = find_liquid(design, experiment.liquid);
    double volume_ul = 0;
    for (const Droplet& drop : experiment.droplets) volume_ul += drop.volume_ul;
    if (liquid && volume_ul * 1e-6 * liquid->density_kg_m3 > most_g)
        list.error("too_much_liquid", where / "droplets",
                   say("All drops together may have up to {} g; given are {:.4g}.", most_g, volume_ul * 1e-6 * liquid->density_kg_m3));
}

void validate_droplets(const Design& design, const Experiment& experiment, const Place& where, IssueList& list)
{
    const int before = list.errors();
    if (experiment.droplets.empty())
        list.add(Severity::warning, "no_droplet", where / "droplets", say("The experiment has no droplet; nothing will get wet."));
    if (experiment.droplets.size() > static_cast<std::size_t>(most_droplets)) {
        list.error("range", where / "droplets",
                   say("At most {} droplets are allowed; given are {}.", most_droplets, experiment.droplets.size()));
        return;
    }
    for (std::size_t i = 0; i < experiment.droplets.size(); ++i)
        validate_droplet(experiment, experiment.droplets[i], where / "droplets" / i, list);
    if (list.errors() == before) validate_fallen(design, experiment, where, list);
    if (list.errors() == before) validate_overlaps(experiment, where, list);
}

void validate_feed_drops(const Experiment& e, const Place& where, IssueList& list)
{
    if (!(e.drop_ul > 0)) return;
    constexpr double smallest = 0.5;
    if (e.drop_ul < smallest)
        return list.error("range", where / "drop_ul",
                          say("The volume of each drop of the feed must be 0 (the feed flows evenly) or at least {} ul; given is {}.",
                              smallest, e.drop_ul));
    if (e.volume_ul > most_drops_of_feed * e.drop_ul)
        list.error("too_many_drops", where / "drop_ul",
                   say("A feed of {} ul may come in at most {} drops, of {} ul or more; given are drops of {} ul.", e.volume_ul,
                       most_drops_of_feed, e.volume_ul / most_drops_of_feed, e.drop_ul));
}

void validate_climates(const Experiment& experiment, const Place& where, IssueList& list)
{
    if (experiment.climates.empty()) return validate_climate(experiment.climate, where / "climate", list);
    validate_climate(experiment.climate, where / "climate" / std::size_t{0}, list);
    if (experiment.climates.size() > most_climates)
        return list.error("range", where / "climate",
                          say("A changing climate has at most {} times; given are {}.", most_climates, experiment.climates.size() + 1));
    double before = 0;
    for (std::size_t i = 0; i < experiment.climates.size(); ++i) {
        const Place here = where / "climate" / (i + 1);
        const double time = experiment.climates[i].time_s;
        if (!(std::isfinite(time) && time > before && time <= 86400))
            list.error("range", here / "time_s",
                       say("The times of a climate must rise, up to 86400 s: after {} s; given is {}.", before, time));
        before = std::max(before, time);
        validate_climate(experiment.climates[i].climate, here, list);
    }
}

void validate_immersion(const Experiment& e, const Place& where, IssueList& list)
{
    if (e.immersion_mm > 0 && e.immersion_mm < e.sample_mm[1]) return;
    list.error("range", where / "immersion_mm",
               say("The strip must dip into the liquid by more than 0 and less than the strip's length of {:.4g}; given is {:.4g}.",
                   Amount{e.sample_mm[1], Stored::mm}, Bare{e.immersion_mm, Stored::mm}));
}

/// The fields that the type uses.
void validate_fields(const Design& design, const Experiment& e, const Place& where, IssueList& list)
{
    for (const Field<Experiment>& field : fields_of<Experiment>())
        if (uses_field(e.type, field.key)) list.field(where, field, e);
    if (uses_field(e.type, "initial")) validate_climate(e.initial, where / "initial", list);
    if (uses_field(e.type, "droplets")) validate_droplets(design, e, where, list);
    if (uses_field(e.type, "drop_ul")) validate_feed_drops(e, where, list);
    if (uses_field(e.type, "immersion_mm")) validate_immersion(e, where, list);
}

} // namespace

void validate_climate(const Climate& climate, const Place& where, IssueList& list)
{
    const auto range = [&](const char* key) { return list.field(where, field_named<Climate>(key), climate); };
    if (range("temperature_c") && climate.temperature_c < 0)
        list.add(Severity::warning, "supercooled", where / "temperature_c",
                 say("At {} the water is modelled as supercooled liquid; freezing is not modelled.",
                     Amount{climate.temperature_c, Stored::celsius}));
    const bool percent = climate.relative_humidity > most_humidity && climate.relative_humidity <= 100;
    if (percent)
        list.error("range", where / "relative_humidity",
                   say("The relative humidity must be from 0 to {}; given is {}. It is a fraction: {:.4g} for {:.4g} %.", most_humidity,
                       climate.relative_humidity, climate.relative_humidity / 100, climate.relative_humidity));
    else if (range("relative_humidity") && climate.relative_humidity > 1)
        list.add(Severity::warning, "supersaturated", where / "relative_humidity",
                 say("At a relative humidity of {} the air has more vapour than it can hold; it condenses on the cloth.",
                     climate.relative_humidity));
    range("air_speed_m_s");
}

void validate_liquid(const Liquid& liquid, const Place& where, IssueList& list) { list.fields(where, liquid); }

void validate_experiment(const Design& design, const Experiment& experiment, const Place& where, IssueList& list)
{
    validate_climates(experiment, where, list);
    if (!find_liquid(design, experiment.liquid)) {
        std::vector<std::string> known{"water", "saline", "sweat"};
        for (const Liquid& own : design.liquids) known.push_back(own.name);
        list.error("unknown_liquid", where / "liquid",
                   say("There is no liquid \"{}\"{} There are water, saline, sweat and the project's own.", experiment.liquid,
                       or_near(experiment.liquid, known)));
    }
    const ExperimentTypeInfo& type = info_of(experiment.type);
    const Message size = is_strip(experiment.type) ? say("strip's size") : say("sample's size");
    for (std::size_t axis = 0; axis < 2; ++axis)
        list.range(where / type.sample_key / axis, size, experiment.sample_mm[axis], 0.1, 2000, Stored::mm);
    if (list.field(where, field_named<Experiment>("duration_s"), experiment) && experiment.duration_s == 0)
        list.error("range", where / "duration_s", say("The duration must be more than 0 s; given is 0."));
    validate_fields(design, experiment, where, list);
}

} // namespace hygroloom
