// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Calibrating in the window: what it asks for, the fit of a strip that the program made, taken over and taken back, cancelled, refused.
#include "core/analysis/measured_run.h"
#include "core/solver/backend.h"
#include "ui/results/calibrate_dialog.h"

#include <QCheckBox>
#include <QFile>
#include <QPushButton>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

using namespace hygroloom;

class TestCalibrateDialog : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        QVERIFY(document_.openExample(HYGROLOOM_SOURCE_DIR "/resources/examples/one-drop-on-cotton.hygro"));
        document_.edit("a strip", {}, [](Design& design) {
            design.fabrics[0].contact_angle_deg = 35;
            design.fabrics[0].uncertainty.contact_angle_deg = 20;
            Experiment strip = standard_experiment(ExperimentType::vertical_wicking);
            strip.name = "strip";
            strip.sample_mm = {1, 40};
            strip.duration_s = 4;
            design.experiments = {strip};
        });
        QVERIFY(!document_.hasError());
        dialog_ = std::make_unique<CalibrateDialog>(document_, queue_, Fidelity::draft, "cpu");
        dialog_->show();
    }
    void cleanup() { dialog_.reset(); }

    void itSaysWhatItNeeds()
    {
        QVERIFY(dialog_->message().contains("Choose a file"));
        QVERIFY(!button("Run")->isEnabled() && !button("Apply")->isEnabled() && !button("Save Report…")->isEnabled());
        dialog_->setFile(file("wrong.csv", "time_s,height\n1,2\n"));
        QVERIFY2(dialog_->message().contains("one of"), qPrintable(dialog_->message()));
        dialog_->setFile(file("one.csv", "time_s,wick_height_mm\n4,20\n"));
        QVERIFY2(dialog_->message().contains("nothing to judge the error by"), qPrintable(dialog_->message()));
        dialog_->setFile(madeAt(44));
        QVERIFY(button("Run")->isEnabled());
        box("Contact angle")->setChecked(false);
        QVERIFY(dialog_->message().contains("Tick") && !button("Run")->isEnabled());
        QVERIFY(!box("Receding angle")->isEnabled()); // 0 on cotton
    }
    void aFitIsTakenOverAsOneStep()
    {
        dialog_->setFile(madeAt(44));
        button("Run")->click();
        QVERIFY(dialog_->run().running() && button("Cancel"));
        QTRY_VERIFY_WITH_TIMEOUT(!dialog_->run().running(), 60000);
        QVERIFY2(button("Apply")->isEnabled() && button("Save Report…")->isEnabled(), qPrintable(dialog_->message()));
        QVERIFY(dialog_->message().startsWith("Residual"));
        const auto* table = dialog_->findChild<QTableWidget*>();
        QCOMPARE(table->rowCount(), 1);
        QVERIFY(table->item(0, 0)->text() == "35°" && table->item(0, 1)->text().contains("±"));
        const int steps = document_.history()->count();
        button("Apply")->click();
        QCOMPARE(document_.history()->count(), steps + 1);
        const Fabric& fabric = *document_.fabric();
        QVERIFY(fabric.calibrated && fabric.calibrated->file == "strip.csv");
        QVERIFY(std::abs(*fabric.contact_angle_deg - 44) <= *fabric.uncertainty.contact_angle_deg);
        QVERIFY(!document_.hasError() && !dialog_->isVisible());
        document_.history()->undo();
        QVERIFY(!document_.fabric()->calibrated && *document_.fabric()->contact_angle_deg == 35);
    }
    void closingWhileItRunsCancels()
    {
        dialog_->setFile(madeAt(44));
        dialog_->startOrCancel();
        dialog_->reject();
        QVERIFY(dialog_->isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(!dialog_->run().running(), 5000);
        QCOMPARE(dialog_->message(), QString("Cancelled."));
        QVERIFY(!button("Apply")->isEnabled());
    }

private:
    QPushButton* button(const QString& text) const
    {
        for (auto* one : dialog_->findChildren<QPushButton*>())
            if (one->text().remove('&') == text) { return one; }
        return nullptr;
    }
    QCheckBox* box(const QString& begin) const
    {
        for (auto* one : dialog_->findChildren<QCheckBox*>())
            if (one->text().startsWith(begin)) { return one; }
        return nullptr;
    }
    QString file(const QString& name, const QByteArray& text) const
    {
        QFile out(folder_.filePath(name));
        out.open(QIODevice::WriteOnly);
        out.write(text);
        return out.fileName();
    }
    /// What a run at an angle gives.
    QString madeAt(double angle) const
    {
        Design design = *document_.design();
        design.fabrics[0].contact_angle_deg = angle;
        RunOptions how;
        how.fidelity = Fidelity::draft;
        RunControl control;
        const auto backend = make_cpu_backend();
        const FinishedRun run = run_and_measure(design, design.fabrics[0].name, "strip", how, *backend, control);
        QByteArray text = "time_s,wick_height_mm,spread\n";
        for (std::size_t i = 1; i < run.metrics.series.time.size(); i += 5)
            text += QByteArray::number(run.metrics.series.time[i]) + "," + QByteArray::number(1e3 * run.metrics.series.wick_height[i]) +
                    ",0.3\n";
        return file("strip.csv", text);
    }

    QTemporaryDir folder_;
    Document document_;
    WindowQueue queue_;
    std::unique_ptr<CalibrateDialog> dialog_;
};

QTEST_MAIN(TestCalibrateDialog)
#include "tst_calibrate_dialog.moc"
