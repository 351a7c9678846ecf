// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Every number of a project, one row each: see field.h.
#pragma once

#include "core/base/message.h"
#include "core/design/design.h"
#include "core/design/field.h"
#include "core/design/place.h"

namespace hygroloom {

template <> std::span<const Field<Material>> fields_of<Material>();
template <> std::span<const Field<GabIsotherm>> fields_of<GabIsotherm>();
template <> std::span<const Field<YarnCore>> fields_of<YarnCore>();
template <> std::span<const Field<Yarn>> fields_of<Yarn>();
template <> std::span<const Field<Flyaway>> fields_of<Flyaway>();
template <> std::span<const Field<Measured>> fields_of<Measured>();
template <> std::span<const Field<Uncertainty>> fields_of<Uncertainty>();
template <> std::span<const Field<Loom>> fields_of<Loom>();
template <> std::span<const Field<Fabric>> fields_of<Fabric>();
template <> std::span<const Field<Liquid>> fields_of<Liquid>();
template <> std::span<const Field<Climate>> fields_of<Climate>();
template <> std::span<const Field<Droplet>> fields_of<Droplet>();
/// Those of all types; which of them a type has, see uses_field().
template <> std::span<const Field<Experiment>> fields_of<Experiment>();
template <> std::span<const Field<WearExperiment>> fields_of<WearExperiment>();
template <> std::span<const Field<Activity>> fields_of<Activity>();
template <> std::span<const Field<BuiltInGarment>> fields_of<BuiltInGarment>();
/// Sizes beyond which nobody is dressed; assumptions. The longest leggings reach from the waist of the built-in body to its ankle.
struct SizeRange {
    double least = 0, most = 0; ///< mm
};
SizeRange size_range(const std::string& kind, const Field<BuiltInGarment>& size);
template <> std::span<const Field<PanelCut>> fields_of<PanelCut>();
template <> std::span<const Field<OwnZone>> fields_of<OwnZone>();
template <> std::span<const Field<Wearer>> fields_of<Wearer>();

/// What the number at a place of the project may be; nothing where no row says it. Places in experiments on garments begin with "wears".
std::optional<Message> allowed_at(const Place& place);

} // namespace hygroloom
