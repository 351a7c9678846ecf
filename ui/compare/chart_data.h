// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the charts of the compare workspace draw, without the drawing.
#pragma once

#include "core/analysis/replicate_range.h"
#include "core/wear/wear_outcomes.h"
#include "ui/basics/quantity.h"

#include <QPointF>
#include <QString>
#include <QStringList>

#include <vector>

namespace hygroloom {

/// The points that no other is better than in one number and as good in the other, from left to right.
std::vector<std::size_t> paretoFront(const std::vector<QPointF>& points, Better x, Better y);

/// A curve that runs have in common.
struct CurveChoice {
    const Plot* plot = nullptr; ///< nullptr: of a garment
    Curve curve{};
    OutcomeInfo worn{}; ///< of a garment, the number
    QString title;      ///< "Wetted radius, top (mm)"
    UserUnit unit{};
    bool fromZero() const { return plot ? plot->from_zero : !worn.may_be_negative; }
};
/// Those of which there is something to see in any of the runs; the experiment's own first.
std::vector<CurveChoice> curvesOf(ExperimentType type, const std::vector<std::shared_ptr<const Metrics>>& runs);

/// Of garments, those of the whole or of a part.
std::vector<CurveChoice> curvesOf(const WearPartName& part);

struct CurvePoints {
    std::vector<QPointF> values;   ///< of several replicates their middle
    std::vector<double> low, high; ///< of the band at each; empty: there is none
    int replicates = 0;            ///< that the band is of; 0: it is the numerical error of the run alone
};
/// candidate: with the run's replicates; fewer than two that keep the curve do not count.
CurvePoints pointsOf(const RunRecord& run, const Metrics& metrics, const CurveChoice& choice, const Candidate* candidate = nullptr);
/// The same of a garment.
CurvePoints pointsOf(const Candidate& garment, const CurveChoice& choice);
/// The number whose error the band of a run alone is; empty: none is measured.
QString bandText(const CurveChoice& choice);

/// Spokes, and for each run how far it lies on each; less than 0: it has no such number.
struct Fingerprint {
    QStringList spokes;
    std::vector<std::vector<double>> runs;
    std::vector<QStringList> numbers; ///< of each run, what stands for it on each spoke: "grade 4 (75 %/s)", "3.25 ± 0.04 mm"
    double most = 1;                  ///< at the rim
    bool grades = false;              ///< 1 to 5, else from the worst to the best of all candidates
};
/// Of the candidates of these names.
Fingerprint fingerprintOf(const Comparison& comparison, const std::vector<std::string>& names);
/// For each run, how many later ones lie on it along a whole side. near: how far apart lines are still drawn on each other, a share of
/// the way to the rim.
std::vector<int> laterOn(const Fingerprint& fingerprint, double near);

} // namespace hygroloom
