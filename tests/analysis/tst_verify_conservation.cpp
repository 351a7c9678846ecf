// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Whatever the experiment, the cloth and the closure, verify's case of conservation finds water and energy where they went.
#include "core/design/experiment.h"
#include "core/verify/verify.h"

#include <QTest>

#include <set>

using namespace hygroloom;

class TestVerifyConservation : public QObject {
    Q_OBJECT
    static void row(const std::string& experiment, const char* fabric, double duration, const char* closure, const char* swelling)
    {
        QTest::addRow("%s on %s, %s, swelling %s", experiment.c_str(), fabric, closure, swelling)
            << QString("experiment=%1|fabric=%2|duration_s=%3|closure=%4|swelling=%5")
                   .arg(experiment.c_str(), fabric)
                   .arg(duration)
                   .arg(closure, swelling);
    }

private Q_SLOTS:
    void waterAndEnergyAreConserved_data()
    {
        QTest::addColumn<QString>("changes");
        const std::map<std::string, double> durations{{"droplet", 0.1}, {"conditioning", 300}, {"drying", 300}};
        const std::set<std::string> by_suction{"C", "F", "Denim"}; // each experiment with both kinds of closure
        std::vector<const char*> fabrics{"F", "Denim", "Silk habotai"};
        if (qEnvironmentVariableIsSet("HYGROLOOM_WHOLE_CASES")) fabrics.insert(fabrics.end(), {"A", "C", "E", "G"});
        for (int i = 0; i < experiment_types; ++i)
            for (const char* fabric : fabrics) {
                const std::string experiment = name_of(static_cast<ExperimentType>(i));
                const double duration = durations.count(experiment) ? durations.at(experiment) : 5;
                row(experiment, fabric, duration, by_suction.count(fabric) > 0 ? "pores" : "paper", "0");
            }
        for (const std::string experiment : {"droplet", "horizontal_wicking", "vertical_wicking", "drying"})
            for (const char* fabric : {"C", "Viscose challis"}) row(experiment, fabric, experiment == "droplet" ? 0.1 : 10, "pores", "1");
    }
    void waterAndEnergyAreConserved()
    {
        QFETCH(QString, changes);
        std::map<std::string, std::string> values;
        for (const QString& change : changes.split('|'))
            values[change.section('=', 0, 0).toStdString()] = change.section('=', 1).toStdString();
        const VerifyReport report = run_verify_case("conservation", values, *make_cpu_backend());
        QCOMPARE(report.results.size(), std::size_t(2));
        for (const VerifyResult& r : report.results)
            QVERIFY2(r.pass(), qPrintable(QString("%1: %2, at most %3").arg(r.name.c_str()).arg(r.computed).arg(r.tolerance)));
    }
};

QTEST_APPLESS_MAIN(TestVerifyConservation)
#include "tst_verify_conservation.moc"
