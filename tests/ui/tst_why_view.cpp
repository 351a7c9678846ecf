// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The Why view of Compare: which fabrics it proposes, what it runs, what it shows.
#include "compare_test.h"
#include "core/project/project_file.h"
#include "ui/basics/preferences.h"
#include "ui/compare/why_delegate.h"
#include "ui/compare/why_view.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>

using namespace hygroloom;

namespace {

/// A view with its parts.
struct Seen {
    WhyView& view;
    QPushButton* button = view.findChild<QPushButton*>();
    QTableWidget* table = view.findChild<QTableWidget*>();

    QString said() const
    {
        QString all;
        for (const QLabel* label : view.findChildren<QLabel*>()) { all += label->text() + "\n"; }
        return all;
    }
    QString cell(int row, int column) const { return table->item(row, column)->text(); }
    QComboBox* box(const QString& name) const
    {
        for (QComboBox* each : view.findChildren<QComboBox*>()) {
            if (each->accessibleName() == name) { return each; }
        }
        return nullptr;
    }
};

} // namespace

class TestWhyView : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QLocale::setDefault(QLocale::c());
        qputenv("XDG_DATA_HOME", folder_.path().toUtf8());
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder_.path());
        design_ = read_project(std::string(HYGROLOOM_SOURCE_DIR) + "/resources/examples/three-candidates.hygro");
        design_.experiments.resize(1);
        design_.experiments[0].duration_s = 0.2;
        design_.experiments[0].sample_mm = {16, 16};
        design_.experiments[0].droplets = {Droplet{5, 0, {0, 0}, 1, 0}};
        design_.fabrics.resize(1);
        design_.fabrics[0].name = "quick";
        design_.fabrics.push_back(design_.fabrics[0]);
        design_.fabrics[1].name = "slow";
        design_.fabrics[1].contact_angle_deg = 75;
        design_.fabrics[1].weft.twist_per_m += 100;
        design_.fabrics.push_back(design_.fabrics[0]);
        design_.fabrics[2].name = "copy";
    }

    void whatIsMissingIsSaidFirst()
    {
        Workplace place;
        open(place, "empty.hygro");
        Seen seen{*place.view.findChild<WhyView*>()};
        QVERIFY(!seen.button->isEnabled());
        QVERIFY2(seen.said().contains("Run the experiment on two fabrics"), qPrintable(seen.said()));
        place.view.showExperiment("");
        QVERIFY2(seen.said().contains("Choose an experiment"), qPrintable(seen.said()));
    }

    void theMixturesAreRunAndTheirContributionsShown()
    {
        Workplace place;
        open(place, "pair.hygro");
        place.view.bar()->runAll()->click();
        QTRY_VERIFY_WITH_TIMEOUT(!place.runs.running() && place.view.comparison().candidates.size() == 3, 120000);
        const std::size_t recorded = place.history.runs().size();
        auto& view = *place.view.findChild<WhyView*>();
        Seen seen{view};
        view.choose("quick", "slow", 0);
        QTRY_VERIFY_WITH_TIMEOUT(seen.button->isEnabled(), 20000);
        QVERIFY2(seen.said().contains("2 runs"), qPrintable(seen.said())); // the two mixtures of two parts
        QCOMPARE(seen.table->rowCount(), 2);
        QCOMPARE(seen.cell(0, 0), QString("Weft construction"));
        QVERIFY(seen.cell(0, 3).isEmpty() && !view.why());

        QTest::keyClick(seen.button, Qt::Key_Space);
        QVERIFY(place.runs.running() && seen.button->text().contains("Ca&ncel"));
        QTRY_VERIFY_WITH_TIMEOUT(!place.runs.running(), 120000);
        QTRY_VERIFY(view.why() != nullptr);
        const Why why = *view.why();
        QVERIFY2(why.nothing.empty(), why.nothing.c_str());
        double sum = 0;
        for (const Contribution& part : why.parts) { sum += part.compared.difference; }
        QVERIFY(std::abs(sum - why.whole->difference) <= 1e-12 * std::abs(why.whole->difference));
        QCOMPARE(seen.table->rowCount(), 3); // two parts and the difference
        QCOMPARE(seen.cell(0, 0), QString("Contact angle"));
        QVERIFY2(seen.cell(0, 4).contains("which is better"), qPrintable(seen.cell(0, 4)));
        QVERIFY(seen.table->item(0, 3)->data(WhyDelegate::value_role).isValid());
        QCOMPARE(seen.table->item(0, 3)->data(WhyDelegate::tone_role).toInt(), static_cast<int>(WhyDelegate::better));
        QVERIFY(!seen.button->isEnabled());
        QCOMPARE(place.history.runs().size(), recorded); // mixtures are no runs of the project

        // In the user's unit, at once.
        QVERIFY2(seen.cell(0, 3).endsWith(" mm") && seen.cell(0, 4).contains(" mm larger,"), qPrintable(seen.cell(0, 4)));
        const Preferences before = preferences();
        Preferences inches = before;
        inches.length = static_cast<int>(LengthUnit::inch);
        setPreferences(inches);
        QTRY_VERIFY_WITH_TIMEOUT(view.why() != nullptr, 20000); // the inputs, too
        QVERIFY2(seen.cell(0, 3).endsWith(" in") && seen.cell(0, 4).contains(" in larger,"), qPrintable(seen.cell(0, 4)));
        QVERIFY2(seen.said().contains(" in larger") && !seen.said().contains(" mm"), qPrintable(seen.said()));
        setPreferences(before);
        QTRY_VERIFY_WITH_TIMEOUT(view.why() != nullptr && seen.cell(0, 3).endsWith(" mm"), 20000);

        // Another question and back: it is known.
        view.choose("copy", "slow", 0);
        QTRY_VERIFY_WITH_TIMEOUT(seen.button->isEnabled(), 20000);
        view.choose("quick", "slow", 0);
        QTRY_VERIFY_WITH_TIMEOUT(view.why() != nullptr, 20000);
        QCOMPARE(seen.table->rowCount(), 3);
        // Another fabric does not matter to it, the fabric itself does.
        place.document.edit("angle", {}, [](Design& design) { design.fabrics[1].contact_angle_deg = 70; });
        QTRY_VERIFY_WITH_TIMEOUT(view.why() == nullptr, 20000);
    }

    void aCopyHasNoDifferenceAndNothingToRun()
    {
        Workplace place;
        open(place, "copy.hygro");
        place.view.bar()->runAll()->click();
        QTRY_VERIFY_WITH_TIMEOUT(!place.runs.running() && place.view.comparison().candidates.size() == 3, 120000);
        auto& view = *place.view.findChild<WhyView*>();
        Seen seen{view};
        view.choose("quick", "copy", 0);
        QTRY_VERIFY_WITH_TIMEOUT(view.why() != nullptr, 20000);
        QVERIFY(!seen.button->isEnabled() && seen.table->rowCount() == 0);
        QVERIFY2(seen.said().contains("all inputs that act are the same"), qPrintable(seen.said()));
    }

    void theBestIsProposedAgainstTheBaseline()
    {
        Workplace place;
        open(place, "proposed.hygro");
        place.view.bar()->runAll()->click();
        QTRY_VERIFY_WITH_TIMEOUT(!place.runs.running() && place.view.comparison().candidates.size() == 3, 120000);
        Seen seen{*place.view.findChild<WhyView*>()};
        const Comparison& numbers = place.view.comparison();
        QCOMPARE(seen.box("against")->currentText().toStdString(), numbers.baseline);
        const auto best = std::find_if(numbers.candidates.begin(), numbers.candidates.end(),
                                       [&](const Candidate& each) { return each.fabric != numbers.baseline; });
        QCOMPARE(seen.box("Why is")->currentText().toStdString(), best->fabric);
    }

private:
    void open(Workplace& place, const char* name)
    {
        const QString path = folder_.filePath(name);
        write_project(design_, path.toStdString());
        QVERIFY(place.document.open(path));
        place.view.resize(1000, 700);
        place.view.show();
        QTRY_VERIFY_WITH_TIMEOUT(place.view.bar()->runAll()->isEnabled(), 20000);
    }

    QTemporaryDir folder_;
    Design design_;
};

QTEST_MAIN(TestWhyView)
#include "tst_why_view.moc"
