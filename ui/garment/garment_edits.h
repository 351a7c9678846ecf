// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Changes of garments and of how they are worn, each as one step of the history.
#pragma once

#include "ui/document/document.h"

#include <QCoreApplication>

namespace hygroloom {

/// Adds a garment with an experiment on it, and a fabric of the library where the project has none. Returns its place.
int addBuiltInGarment(Document& document, const std::string& kind);
/// The same of a file, by its path relative to the project where that has one.
int addGarmentFile(Document& document, const QString& path);
/// With the experiments on it.
void removeGarment(Document& document, int garment);

/// Why a garment or an experiment cannot have a name, in a sentence; empty: it can. Its own it can have.
QString whyNotGarmentName(const Design& design, int garment, const QString& name);
QString whyNotWearName(const Design& design, int wear, const QString& name);
/// Nothing where the name cannot be had. Experiments follow a garment's name.
void renameGarment(Document& document, int garment, const QString& name);
void renameWear(Document& document, int wear, const QString& name);

/// Steps with the same field merge until the stroke ends.
void editGarment(Document& document, const QString& text, int garment, const std::string& field,
                 const std::function<void(Garment&)>& change);
/// Of a panel that is not named yet the cut is first copied from that of all others.
void editCut(Document& document, const QString& text, int garment, const std::string& panel, const std::string& field,
             const std::function<void(PanelCut&)>& change);
/// Cuts all panels from a fabric; their grain and faces stay.
void cutAllFrom(Document& document, int garment, const std::string& fabric);

/// The gap at a zone, or "shoulder", or "default"; none: that of all others.
void setGap(Garment& garment, const std::string& zone, std::optional<double> gap_mm);
/// Under which a project names the seam between two panels: in the order that it has, else in this one; "default" without names.
std::string seamKey(const Garment& garment, const std::string& one, const std::string& other);
/// The share of the water that a seam passes; none: that of all others.
void setSeam(Garment& garment, const std::string& one, const std::string& other, std::optional<double> share);

/// Why an own zone of a garment cannot have a name, in a sentence; empty: it can.
QString whyNotZoneName(const Garment& garment, int zone, const QString& name);
/// Under a name that is free, and sweating as the chest at exercise does: it is there to be changed. Returns its place.
int addOwnZone(Document& document, int garment, const std::string& panel, const std::vector<std::array<double, 2>>& outline_mm);
void removeOwnZone(Document& document, int garment, int zone);
void editOwnZone(Document& document, const QString& text, int garment, int zone, const std::string& field,
                 const std::function<void(OwnZone&)>& change);

/// An experiment on a garment, in the climate of the project's experiment. Returns its place.
int addWear(Document& document, const std::string& garment);
void removeWear(Document& document, int wear);
void editWear(Document& document, const QString& text, int wear, const std::string& field,
              const std::function<void(WearExperiment&)>& change);

} // namespace hygroloom
