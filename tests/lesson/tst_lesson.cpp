// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Lessons as files: those that ship can be read, strangers' are refused with the place and what is allowed, and steps know what counts.
#include "core/base/error.h"
#include "core/lesson/lesson.h"
#include "core/lesson/water_shares.h"
#include "core/project/atomic_file.h"

#include <QTest>

#include <filesystem>
#include <random>

using namespace hygroloom;

namespace {

const std::filesystem::path folder = HYGROLOOM_SOURCE_DIR "/resources/lessons";

std::string text_of(const std::string& name) { return read_file(folder / (name + ".json"), largest_lesson_bytes); }

std::string replaced(std::string text, const std::string& what, const std::string& by)
{
    const std::size_t at = text.find(what);
    if (at == std::string::npos) qFatal("there is no %s", what.c_str());
    return text.replace(at, what.size(), by);
}

/// What the reader says against it; empty: nothing.
QString refusal(const std::string& text)
{
    try {
        parse_lesson(text, "l.json");
        return {};
    } catch (const FileError& error) {
        return QString::fromStdString(error.what());
    }
}

const std::string small = R"({"format": "hygroloom-lesson", "version": 1, "title": "T",
  "cloths": [{"title": "a", "library": "Sheeting"}, {"title": "b", "library": "Voile", "material": "wool", "weave": "twill 2/2 Z"}],
  "steps": [{"text": "Look.", "seen": {"metric": "radius_mm", "cloth": 0, "greater_than_cloth": 1, "after_s": 2}}]})";

} // namespace

class TestLesson : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theFiveThatShipCanBeRead()
    {
        int found = 0;
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            if (entry.is_directory()) continue; // in another language
            const Lesson lesson = read_lesson(entry.path());
            QVERIFY2(lesson.cloths.size() >= 2 && lesson.steps.size() >= 3, entry.path().c_str());
            for (const LessonCloth& cloth : lesson.cloths) QCOMPARE(why_not_on_table(cloth.design), std::string());
            ++found;
        }
        QCOMPARE(found, 5);
    }
    void inGermanTheyAreTheSameButForTheirTexts()
    {
        int found = 0;
        for (const auto& entry : std::filesystem::directory_iterator(folder / "de")) {
            Lesson german = read_lesson(entry.path());
            const Lesson lesson = read_lesson(folder / entry.path().filename());
            const auto take = [](std::string& text, const std::string& from) {
                QVERIFY2(text != from || text.empty(), text.c_str());
                text = from;
            };
            take(german.title, lesson.title);
            QCOMPARE(german.steps.size(), lesson.steps.size());
            for (std::size_t k = 0; k < lesson.steps.size(); ++k) {
                take(german.steps[k].text, lesson.steps[k].text);
                take(german.steps[k].ask, lesson.steps[k].ask);
            }
            QCOMPARE(german.cloths.size(), lesson.cloths.size());
            for (std::size_t k = 0; k < lesson.cloths.size(); ++k)
                german.cloths[k].title = lesson.cloths[k].title; // Polyester is Polyester
            QVERIFY2(german == lesson, entry.path().c_str());
            ++found;
        }
        QCOMPARE(found, 5);
    }
    void whatALessonChangesOfAPresetIsChanged()
    {
        const Lesson lesson = parse_lesson(small, "l.json");
        const Fabric& fabric = lesson.cloths.at(1).design.fabrics.at(0);
        QCOMPARE(fabric.warp.material.at(0).name, std::string("wool"));
        QCOMPARE(fabric.weft.material.at(0).name, std::string("wool"));
        QCOMPARE(fabric.weave.pattern(), std::string("twill 2/2 Z"));
        QCOMPARE(lesson.cloths.at(0).design.fabrics.at(0).warp.material.at(0).name, std::string("cotton"));
        QCOMPARE(lesson.drop_ul, 5.0);
    }
    void whatIsWrongIsNamedWithItsPlace_data()
    {
        QTest::addColumn<QString>("what");
        QTest::addColumn<QString>("by");
        QTest::addColumn<QStringList>("words");
        const auto row = [](const char* name, const char* what, const char* by, const QStringList& words) {
            QTest::newRow(name) << what << by << words;
        };
        row("format", "hygroloom-lesson", "hygroloom-study", {"l.json", "format", "\"hygroloom-lesson\"", "\"hygroloom-study\""});
        row("version", "\"version\": 1", "\"version\": 2", {"version", "1", "2"});
        row("key", "\"title\": \"T\"", "\"titel\": \"T\"", {"titel"});
        row("one cloth", R"({"title": "a", "library": "Sheeting"}, )", "", {"cloths", "2 to 4", "given are 1"});
        row("fabric", "\"Voile\"", "\"Voyle\"", {"cloths[1].library", "Voyle", "Voile"});
        row("material", "\"wool\"", "\"wooll\"", {"cloths[1]", "wooll"});
        row("weave", "twill 2/2 Z", "twill 2/0", {"cloths[1].weave"});
        row("metric", "radius_mm", "radius", {"steps[0].seen.metric", "\"radius_mm\"", "\"radius\""});
        row("other", "\"greater_than_cloth\": 1", "\"greater_than_cloth\": 2", {"steps[0].seen.greater_than_cloth", "0 to 1", "2"});
        row("itself", "\"greater_than_cloth\": 1", "\"greater_than_cloth\": 0", {"steps[0].seen.cloth"});
        row("two limits", "\"after_s\": 2", "\"at_least\": 2", {"steps[0].seen.metric", "at_most"});
        row("time", "\"after_s\": 2", "\"after_s\": -1", {"steps[0].seen.after_s", "0 to 3600 s", "-1"});
        row("drop", "\"cloths\"", "\"drop_ul\": 50, \"cloths\"", {"drop_ul", "0.5 to 20", "50"});
        row("air", "\"cloths\"", "\"air\": {\"air_speed_m_s\": 9}, \"cloths\"", {"air.air_speed_m_s", "0 to 5", "9"});
        row("text", "\"Look.\"", "\"\"", {"steps[0].text", "1 to 1000"});
        row("dense", "\"library\": \"Voile\"", "\"library\": \"Voile\", \"contact_angle_deg\": 300", {"cloths[1]", "300"});
    }
    void whatIsWrongIsNamedWithItsPlace()
    {
        QFETCH(QString, what);
        QFETCH(QString, by);
        QFETCH(QStringList, words);
        QCOMPARE(refusal(small), QString());
        const QString said = refusal(replaced(small, what.toStdString(), by.toStdString()));
        QVERIFY(!said.isEmpty());
        for (const QString& word : words) QVERIFY2(said.contains(word), qPrintable(said));
    }
    /// Bytes changed, cut and doubled at random: a lesson or a FileError, nothing else.
    void anyBytesAreALessonOrRefused()
    {
        std::mt19937 random(7);
        const auto below = [&](std::size_t most) { return std::uniform_int_distribution<std::size_t>(0, most - 1)(random); };
        int read = 0, refused = 0;
        for (const std::string& seed : {small, text_of("contact-angle"), text_of("climate")})
            for (int k = 0; k < 400; ++k) {
                std::string text = seed;
                for (std::size_t changes = 1 + below(3); changes > 0 && !text.empty(); --changes) {
                    const std::size_t at = below(text.size());
                    if (const std::size_t kind = below(4); kind == 0)
                        text[at] = static_cast<char>(below(256));
                    else if (kind == 1)
                        text.erase(at, 1 + below(20));
                    else if (kind == 2)
                        text.insert(at, text.substr(below(text.size()), 1 + below(40)));
                    else if (const std::size_t digit = text.find_first_of("0123456789", at); digit != std::string::npos)
                        text.replace(digit, 1, std::string(1 + below(300), '9'));
                }
                try {
                    const Lesson lesson = parse_lesson(text, "fuzz.json");
                    QVERIFY(lesson.cloths.size() >= 2 && lesson.cloths.size() <= 4 && lesson.steps.size() <= most_lesson_steps);
                    ++read;
                } catch (const FileError& error) {
                    QVERIFY(std::string(error.what()).starts_with("fuzz.json"));
                    ++refused;
                }
            }
        QVERIFY2(read > 20 && refused > 100, qPrintable(QString("%1 read, %2 refused").arg(read).arg(refused)));
    }
    void aStepIsSeenByItsNumbers()
    {
        TableState state;
        state.cloths.resize(3);
        state.air.air_speed_m_s = 1;
        const auto goal = [](const char* key) {
            LessonGoal made;
            for (const LessonMetric& metric : lesson_metrics()) {
                ++made.metric;
                if (std::string(metric.key) == key) return made;
            }
            qFatal("there is no such metric");
        };
        LessonGoal drops = goal("drops");
        drops.limit = 1;
        QVERIFY(!is_seen(drops, state));
        state.cloths[0].drops = state.cloths[2].drops = 1;
        QVERIFY(!is_seen(drops, state)); // one cloth has none
        drops.cloth = 2;
        QVERIFY(is_seen(drops, state));
        LessonGoal wind = goal("air_speed_m_s");
        wind.limit = 2;
        QVERIFY(!is_seen(wind, state));
        state.air.air_speed_m_s = 2;
        QVERIFY(is_seen(wind, state));
        LessonGoal faster = goal("absorbed_s");
        faster.compare = LessonGoal::Compare::less_than_cloth;
        faster.cloth = 0;
        faster.other = 1;
        state.cloths[1].absorbed_s = 3;
        QVERIFY(!is_seen(faster, state)); // the first has not absorbed it yet
        state.cloths[0].absorbed_s = 2;
        QVERIFY(is_seen(faster, state));
        faster.after_s = 4;
        QVERIFY(!is_seen(faster, state));
        state.since_step_s = 4;
        QVERIFY(is_seen(faster, state));
        LessonGoal time_alone;
        time_alone.after_s = 4;
        QVERIFY(is_seen(time_alone, state));
    }
    void sharesOfDropsAddUp()
    {
        Ledger ledger;
        ledger.water_initial = 10;
        ledger.water_delivered = 3;
        ledger.water_free = 0.11;
        ledger.water_bound = 10.55; // 9.9 at the start
        ledger.water_evaporated = 0.32;
        ledger.water_vapour = 0.1;
        ledger.water_liquid = 13 - 0.11 - 10.55 - 0.32 - 0.1;
        const WaterShares found = water_shares(ledger, 9.9, 3);
        QCOMPARE(found, (WaterShares{3, 19, 7, 3, 1, 0})); // 19.2, 6.5, 3.2 and 1.1 tenths: one is left for the largest remainder
        ledger.water_bound = 9.8;                          // fibres gave 0.1 to the air
        ledger.water_evaporated = 0.32 + 0.75;
        const WaterShares given = water_shares(ledger, 9.9, 3);
        QCOMPARE(given.in_fibres, -1);
        QCOMPARE(given.in_yarns + given.in_fibres + given.in_air + given.standing + given.run_off, 30);
        QCOMPARE(water_shares(ledger, 9.9, 0), WaterShares{});
    }
};

QTEST_GUILESS_MAIN(TestLesson)
#include "tst_lesson.moc"
