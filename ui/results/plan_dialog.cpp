// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/plan_dialog.h"

#include "core/base/text.h"
#include "ui/basics/core_words.h"
#include "ui/basics/language.h"
#include "ui/basics/quantity.h"

#include <QDialogButtonBox>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace hygroloom {

namespace {

/// Two digits that count: the scene that was measured is another one.
QString errorPercent(double error) { return shownNumber(100 * error, decimals_for(100 * error, 2)); }

/// That of the measured scene; Compare widens it for each number and for scenes that differ.
QString errorText(double error) { return PlanDialog::tr("numerical error about %1 %").arg(errorPercent(error)); }

QString escaped(const std::string& words) { return QString::fromStdString(words).toHtmlEscaped(); }

/// of: "The next run: %1".
QString heading(const QString& of, const ModelPlan& plan, const QString& fabric, const QString& experiment)
{
    const QString run =
        PlanDialog::tr("%1 on %2, %3").arg(experiment.toHtmlEscaped(), fabric.toHtmlEscaped(), withinSentence(fidelityName(plan.fidelity)));
    return "<h3>" + of.arg(run) + "</h3>";
}

/// The plan's parts, region, resolution and cost, as HTML.
QString inWords(const ModelPlan& plan)
{
    QString html = "<table cellpadding='4' width='100%'>";
    for (const PlannedPart& part : plan.parts) {
        QString state = part.on ? PlanDialog::tr("modelled") : PlanDialog::tr("left out");
        if (part.forced) { state += PlanDialog::tr(", set by you"); }
        if (part.watched) { state += PlanDialog::tr(", checked during the run"); }
        html += "<tr><td width='16%'><b>" + coreWord(part.name) + "</b></td><td width='18%'>" + state + "</td><td>" + escaped(part.reason) +
                "</td></tr>";
    }
    return html + "</table><p><b>" + PlanDialog::tr("Region.") + "</b> " +
           PlanDialog::tr("%1 × %2 crossings, %3 yarn segments.").arg(plan.region.ends).arg(plan.region.picks).arg(plan.segments) + " " +
           escaped(plan.region_reason) + "</p><p><b>" + PlanDialog::tr("Resolution.") + "</b> " +
           PlanDialog::tr("One frame every %1 s.").arg(shownNumber(plan.frame_interval, 4)) + " " + escaped(plan.resolution_reason) +
           "</p><p><b>" + PlanDialog::tr("Expected.") + "</b> " + expectation(plan) + "</p>";
}

} // namespace

QString fidelityName(Fidelity fidelity)
{
    switch (fidelity) {
    case Fidelity::live: return PlanDialog::tr("Live");
    case Fidelity::draft: return PlanDialog::tr("Draft");
    case Fidelity::standard: return PlanDialog::tr("Standard");
    case Fidelity::reference: break;
    }
    return PlanDialog::tr("Reference");
}

QString roughDuration(double seconds)
{
    if (seconds < 1) { return PlanDialog::tr("under 1 s"); }
    if (seconds < 100) { return PlanDialog::tr("about %1 s").arg(shownNumber(seconds, 0)); }
    if (seconds < 5400) { return PlanDialog::tr("about %1 min").arg(shownNumber(seconds / 60, 0)); }
    return PlanDialog::tr("about %1 h").arg(shownNumber(seconds / 3600, 1));
}

QString progressText(const RunProgress& progress, bool paused)
{
    const QString text = PlanDialog::tr("%1 of %2 simulated in %3 s")
                             .arg(momentText(progress.simulated, progress.duration), momentText(progress.duration, progress.duration),
                                  shownNumber(progress.wall, 0));
    if (paused) { return text + PlanDialog::tr(", paused."); }
    const auto left = time_left(progress.duration > 0 ? progress.simulated / progress.duration : 0, progress.wall);
    return left ? text + PlanDialog::tr(", %1 left.").arg(roughDuration(*left)) : text + ".";
}

QString expectation(const ModelPlan& plan)
{
    const QString error = !plan.expected_error                   ? PlanDialog::tr("numerical error not known")
                          : plan.fidelity == Fidelity::reference ? PlanDialog::tr("reference for numerical errors")
                                                                 : errorText(*plan.expected_error);
    return PlanDialog::tr("%1, %2 of memory, %3. %4")
        .arg(roughDuration(plan.expected_seconds), bytesText(plan.expected_bytes), error,
             QString::fromStdString(plan.expectation_source).toHtmlEscaped());
}

QString shortExpectation(const ModelPlan& plan)
{
    const QString cost = PlanDialog::tr("%1, %2").arg(roughDuration(plan.expected_seconds), bytesText(plan.expected_bytes));
    const bool known = plan.expected_error && plan.fidelity != Fidelity::reference; // whose own is none by definition
    return known ? PlanDialog::tr("%1, error ≈ %2 %").arg(cost, errorPercent(*plan.expected_error)) : cost;
}

QString expectedError(const ModelPlan& plan)
{
    if (!plan.expected_error) { return PlanDialog::tr("expected numerical error not known"); }
    return plan.fidelity == Fidelity::reference ? PlanDialog::tr("the reference for numerical errors")
                                                : PlanDialog::tr("expected %1").arg(errorText(*plan.expected_error));
}

PlanDialog::PlanDialog(const ModelPlan& plan, const QString& fabric, const QString& experiment, QWidget* parent) : QDialog(parent)
{
    setWindowTitle(tr("What the next run models, and why"));
    fill(heading(tr("The next run: %1"), plan, fabric, experiment) + inWords(plan));
}

PlanDialog::PlanDialog(const RunRecord& run, QWidget* parent) : QDialog(parent)
{
    setWindowTitle(tr("What was modelled, and why"));
    QString html =
        heading(tr("The run on screen: %1"), run.plan, QString::fromStdString(run.fabric), QString::fromStdString(run.experiment));
    for (const SwitchedPart& part : run.switched_on) { html += "<p>" + escaped(in_words(part)) + "</p>"; }
    fill(html + inWords(run.plan));
}

void PlanDialog::fill(const QString& html)
{
    auto* browser = new QTextBrowser;
    browser->setHtml(html);
    browser->setFrameShape(QFrame::NoFrame);
    browser->setAccessibleName(windowTitle());
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(browser);
    layout->addWidget(buttons);
    resize(640, 460);
}

} // namespace hygroloom
