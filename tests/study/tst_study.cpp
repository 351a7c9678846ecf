// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The study file: what it says is read, what is wrong with it is said.
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/project/project_value.h"
#include "core/study/points.h"
#include "tests/support/drop_design.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

using namespace hygroloom;

namespace {

std::string file_with(const std::string& factors, const std::string& design, const std::string& others = "")
{
    return R"({ "format": "hygroloom-study", "version": 1, "factors": [)" + factors + R"(], "design": )" + design +
           (others.empty() ? "" : ", " + others) + " }";
}

const std::string range = R"({ "path": "fabrics[0].ends_per_cm", "low": 20, "high": 30 })";
const std::string sobol = R"({ "type": "sobol", "points": 64 })";

QString refusal(const std::string& text)
{
    try {
        parse_study(text, "s.json");
        return "accepted";
    } catch (const FileError& error) {
        return error.what();
    }
}

QString issues_of(const std::string& text)
{
    QString all;
    for (const Issue& issue : validate(parse_study(text, "s.json"), drop_design()))
        all += QString::fromStdString(issue.where.text() + ": " + issue.text() + "\n");
    return all;
}

} // namespace

class TestStudy : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aStudyIsReadAsWritten()
    {
        const std::string text = file_with(
            range + R"(, { "path": "fabrics[0].warp.material", "values": ["cotton", "flax"], "base": "flax" },
                { "path": "fabrics[0].contact_angle_deg", "distribution": { "type": "normal", "mean": 40, "sd": 5, "low": 20 } },
                { "path": "fidelity.fibre_shells", "low": 2, "high": 8, "step": 2 })",
            sobol, R"("fidelity": "auto", "error": "5%", "replicates": 3, "seed": 18446744073709551615, "knobs": { "free_liquid": "cap" },
                      "metrics": ["absorbency_time_s"], "sensitivity": "sobol")");
        const Study study = parse_study(text, "s.json");
        QCOMPARE(study.factors.size(), std::size_t{4});
        QCOMPARE(study.factors[1].values[1].text, std::string("flax"));
        QCOMPARE(study.factors[2].distribution.sd, 5.0);
        QVERIFY(!study.fidelity);
        QCOMPARE(study.error, 0.05);
        QCOMPARE(study.seed, std::numeric_limits<std::uint64_t>::max());
        QVERIFY(study.sensitivity == Sensitivity::saltelli);
        QVERIFY(parse_study(format_study(study), "again") == study);
    }

    void whatIsWrongIsNamed_data()
    {
        QTest::addColumn<std::string>("text");
        QTest::addColumn<QString>("says");
        QTest::newRow("format") << std::string(R"({"format": "hygroloom-project"})") << R"(s.json: format: This must be "hygroloom-study")";
        QTest::newRow("version") << std::string(R"({"format": "hygroloom-study", "version": 2})")
                                 << "version: This program reads version 1; given is 2.";
        QTest::newRow("unknown key") << file_with(range, sobol, R"("replicats": 2)")
                                     << R"(s.json: The key "replicats" is not known here; did you mean "replicates"?)";
        QTest::newRow("no kind of factor") << file_with(R"({ "path": "a" })", sobol) << "factors[0].path: A factor needs one of";
        QTest::newRow("two kinds") << file_with(R"({ "path": "a", "low": 1, "high": 2, "values": [1] })", sobol) << "A factor needs one of";
        QTest::newRow("turned") << file_with(R"({ "path": "a", "low": 3, "high": 2 })", sobol)
                                << R"(factors[0].high: This must be above "low", which is 3; given is 2.)";
        QTest::newRow("spread") << file_with(R"({ "path": "a", "distribution": { "type": "normal", "mean": 1, "sd": 0 } })", sobol)
                                << "factors[0].distribution.sd: This must be above 0; given is 0.";
        QTest::newRow("type") << file_with(R"({ "path": "a", "distribution": { "type": "gauss" } })", sobol) << R"("lognormal")";
        QTest::newRow("mode") << file_with(R"({ "path": "a", "distribution": { "type": "triangular", "low": 1, "high": 2, "mode": 3 } })",
                                           sobol)
                              << "mode: This must be from 1 to 2; given is 3.";
        QTest::newRow("twice") << file_with(range + "," + range, sobol) << "have the same path";
        QTest::newRow("points") << file_with(range, R"({ "type": "sobol", "points": 0 })")
                                << "design.points: This must be from 1 to 1000000; given is 0.";
        QTest::newRow("few for indices") << file_with(range, R"({ "type": "sobol", "points": 23 })", R"("sensitivity": "sobol")")
                                         << "24 or more; given is 23";
        QTest::newRow("error alone") << file_with(range, sobol, R"("error": "5%")") << R"(error: This goes with "fidelity": "auto" only.)";
        QTest::newRow("no error") << file_with(range, sobol, R"("fidelity": "auto")") << "needs a largest numerical error";
        QTest::newRow("replicates") << file_with(range, sobol, R"("replicates": 1001)")
                                    << "replicates: This must be from 1 to 1000; given is 1001.";
        QTest::newRow("seed") << file_with(range, sobol, R"("seed": -1)") << "seed: This must be a whole number";
        QTest::newRow("knob") << file_with(range, sobol, R"("knobs": { "fibre_shell": 2 })") << "fibre_shells";
        QTest::newRow("line break") << file_with(R"({ "path": "a\nb", "low": 1, "high": 2 })", sobol) << "without line breaks";
    }
    void whatIsWrongIsNamed()
    {
        QFETCH(std::string, text);
        QFETCH(QString, says);
        const QString said = refusal(text);
        QVERIFY2(said.contains(says), qPrintable(said));
    }

    void whatDoesNotGoWithTheProjectIsAnIssue()
    {
        QVERIFY(issues_of(file_with(range, sobol)).isEmpty());
        QVERIFY(issues_of(file_with(range, sobol, R"("fabrics": ["clot"])"))
                    .contains("fabrics[0]: The project has no fabric \"clot\"; did you mean \"cloth\"?"));
        QVERIFY(issues_of(file_with(range, sobol, R"("metrics": ["ommc"])"))
                    .contains("metrics[0]: No experiment of the study has the metric \"ommc\""));
        QVERIFY(issues_of(file_with(R"({ "path": "fabrics[1].ends_per_cm", "low": 1, "high": 2 })", sobol))
                    .contains("factors[0].path: fabrics[1]"));
        QVERIFY(issues_of(file_with(R"({ "path": "fidelity.nothing", "low": 1, "high": 2 })", sobol)).contains("factors[0].path"));
    }

    void theSchemaHasTheKeysThatAreRead()
    {
        QFile file(HYGROLOOM_SOURCE_DIR "/resources/schema/hygroloom-study-1.schema.json");
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QJsonObject schema = QJsonDocument::fromJson(file.readAll()).object(), parts = schema["$defs"].toObject();
        const QString range_and = QString::fromStdString(range).chopped(1);
        const std::vector<std::tuple<QJsonObject, std::string, QStringList>> objects{
            {schema, file_with(range, sobol, R"("zzzzzzzz": 1)"), {}},
            {parts["design"].toObject(), file_with(range, R"({ "type": "grid", "zzzzzzzz": 1 })"), {}},
            {parts["factor"].toObject(), file_with(range_and.toStdString() + R"(, "zzzzzzzz": 1 })", sobol), {}},
            {parts["distribution"].toObject(),
             file_with(R"({ "path": "a", "distribution": { "type": "normal", "mean": 1, "sd": 1, "zzzzzzzz": 1 } })", sobol),
             {"mode"}}};
        for (const auto& [object, text, others] : objects) {
            QStringList known = refusal(text).section("Known are: ", 1).chopped(1).split(", ") + others;
            QStringList keys = object["properties"].toObject().keys();
            known.sort();
            keys.sort();
            QCOMPARE(known, keys);
        }
    }

    void bytesByChanceAreRefusedOrMakeFewPoints()
    {
        const std::string good = format_study(parse_study(file_with(range + R"(, { "path": "fabrics[0].contact_angle_deg", "distribution":
                { "type": "lognormal", "mean": 40, "sd": 5 } }, { "path": "fabrics[0].picks_per_cm", "low": 20, "high": 30, "step": 1 })",
                                                                    R"({ "type": "latin_hypercube", "points": 20 })"),
                                                          "s.json"));
        const Design design = drop_design();
        int read = 0;
        for (std::uint64_t trial = 0; trial < 4000; ++trial) {
            std::string text = good;
            for (std::uint64_t k = 0; k < 1 + trial % 3; ++k) {
                const std::size_t at = random_bits(trial, 1, k) % text.size();
                const std::string_view letters = "0123456789e.-{}[]\",:xs ";
                if (random_bits(trial, 3, k) % 3 == 0)
                    text.insert(at, 1, letters[random_bits(trial, 2, k) % letters.size()]);
                else
                    text[at] = letters[random_bits(trial, 2, k) % letters.size()];
            }
            try {
                const Study study = parse_study(text, "s.json");
                ++read;
                QVERIFY(parse_study(format_study(study), "again") == study);
                if (!has_error(validate(study, design)) && count_points(study) < 10000) study_points(study, design);
            } catch (const FileError&) {
            }
        }
        QVERIFY2(read > 100, qPrintable(QString::number(read)));
    }

    void numbersAtTheEndOfAllNumbersAreIssues()
    {
        for (const char* wide :
             {R"({ "path": "fabrics[0].ends_per_cm", "low": -1.7e308, "high": 1.7e308 })",
              R"({ "path": "fabrics[0].ends_per_cm", "distribution": { "type": "lognormal", "mean": 1, "sd": 1e200 } })"})
            QVERIFY(issues_of(file_with(wide, sobol)).contains("factors[0].path"));
    }

    void boundsBeyondTheDistributionAreAnIssue()
    {
        const auto issue = [](const char* distribution) {
            return issues_of(
                file_with(R"({ "path": "fabrics[0].contact_angle_deg", "distribution": )" + std::string(distribution) + "}", sobol));
        };
        QVERIFY(issue(R"({ "type": "normal", "mean": 40, "sd": 1, "low": 41, "high": 60 })").isEmpty());
        QCOMPARE(issue(R"({ "type": "normal", "mean": 40, "sd": 1, "low": 60, "high": 70 })"),
                 QString("factors[0].distribution.low: The distribution ends at about 45.9978, below which this must be; given is 60.\n"));
        QVERIFY(issue(R"({ "type": "lognormal", "mean": 5, "sd": 1, "high": 1 })")
                    .startsWith("factors[0].distribution.high: The distribution "));
    }

    void whatNoRunReadsIsAnIssue()
    {
        Design design = drop_design();
        design.fabrics.push_back(design.fabrics[0]);
        design.fabrics[1].name = "other";
        design.fabrics[1].warp.material = {{"mine", 1}};
        design.experiments.push_back(design.experiments[0]);
        design.experiments[1].name = "later";
        design.experiments[1].liquid = "oil";
        design.materials.push_back(*find_library_material("cotton"));
        design.materials[0].name = "mine";
        design.liquids.push_back({"oil", 30, 5, 900});
        const std::string first = design.fabrics[0].name, now = design.experiments[0].name;
        const auto said = [&](const std::string& path, const std::string& fabric, const std::string& experiment,
                              const std::string& more = "") {
            const std::string factors = "{ \"path\": \"" + path + "\", \"low\": 20, \"high\": 30 }" + more;
            const std::string runs = "\"fabrics\": [\"" + fabric + "\"], \"experiments\": [\"" + experiment + "\"]";
            QString all;
            for (const Issue& issue : validate(parse_study(file_with(factors, sobol, runs), "s.json"), design))
                all += QString::fromStdString(issue.where.text() + ": " + issue.text() + "\n");
            return all;
        };
        QCOMPARE(said("fabrics[1].ends_per_cm", first, now),
                 QString("factors[0].path: The study does not run the fabric \"other\", so this changes nothing. It runs \"%1\".\n")
                     .arg(QString::fromStdString(first)));
        QCOMPARE(said("fabrics[1].ends_per_cm", "other", now), QString());
        QVERIFY(said("fabrics.other.ends_per_cm", first, now).contains("does not run the fabric \"other\"")); // by its name
        QVERIFY(said("experiments[1].duration_s", first, now).contains("does not run the experiment \"later\""));
        QCOMPARE(said("experiments[1].duration_s", first, "later"), QString());
        QVERIFY(said("materials[0].fibre_radius_um", first, now).contains("No fabric of the study has \"mine\""));
        QCOMPARE(said("materials[0].fibre_radius_um", "other", now), QString());
        QVERIFY(said("liquids[0].viscosity_mpa_s", "other", now).contains("No experiment of the study has \"oil\""));
        QCOMPARE(said("liquids[0].viscosity_mpa_s", "other", "later"), QString());
        // Another factor may bring it in.
        QCOMPARE(
            said("materials[0].fibre_radius_um", first, now, R"(, { "path": "fabrics[0].warp.material", "values": ["cotton", "mine"] })"),
            QString());
        QCOMPARE(said("fidelity.fibre_shells", first, now), QString());
    }

    void twoPathsToOneValueAreAnIssue()
    {
        const std::string both = range + R"(, { "path": "fabrics.cloth.ends_per_cm", "low": 20, "high": 30 })";
        QVERIFY2(
            issues_of(file_with(both, sobol)).contains("factors[1].path: This is the same value as factors[0], \"fabrics[0].ends_per_cm\""),
            qPrintable(issues_of(file_with(both, sobol))));
        const std::string a = "fabrics[0].uncertainty.a"; // whose object the project lacks
        QVERIFY(!same_place(drop_design(), {"fabrics[0].ends_per_cm", a, "fabrics[0].picks_per_cm"}));
        QCOMPARE(same_place(drop_design(), {a, "fabrics[0].picks_per_cm", "fabrics.cloth.uncertainty.a"}).value().second, std::size_t{2});
    }

    void aHugeStudyIsRefusedWithoutBeingMade()
    {
        std::string factors;
        for (const char* path : {"fabrics[0].ends_per_cm", "fabrics[0].picks_per_cm", "fabrics[0].contact_angle_deg"}) {
            if (!factors.empty()) factors += ", ";
            factors += "{ \"path\": \"" + std::string(path) + "\", \"low\": 20, \"high\": 30, \"levels\": 10000 }";
        }
        QVERIFY(issues_of(file_with(factors, R"({ "type": "grid" })")).contains("more than 1000000 points"));
        QVERIFY(issues_of(file_with(range, R"({ "type": "sobol", "points": 1000000 })", R"("replicates": 2)"))
                    .contains("more than 1000000 rows"));
    }
};

QTEST_APPLESS_MAIN(TestStudy)
#include "tst_study.moc"
