// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Why one fabric is better: which parts are exchanged, and that what they make adds up to the difference.
#include "core/analysis/why.h"
#include "core/base/random.h"
#include "core/design/validate.h"
#include "tests/support/drop_design.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace hygroloom;

namespace {

constexpr const char* key = "absorbency_time_s"; // less is better

OutcomeInfo metric()
{
    for (const OutcomeInfo& each : compared_by(ExperimentType::droplet))
        if (each.key == key) return each;
    return {};
}

/// Two fabrics, of which the second differs by what change() does.
template <typename Act> Design pair_of(Act change)
{
    Design design = drop_design();
    design.fabrics.push_back(design.fabrics[0]);
    design.fabrics[1].name = "other";
    change(design.fabrics[1]);
    return design;
}

WhyPlan plan_of(const Design& design, bool replicates = false)
{
    return plan_why(design, "cloth", "other", design.experiments[0].name, replicates);
}

std::string titles_of(const WhyPlan& plan)
{
    std::string titles;
    for (const Exchange& part : plan.parts) titles += part.title + ";";
    return titles;
}

/// Runs that gave these numbers, with that numerical error.
Candidate ran(const std::vector<std::optional<double>>& values, double numerical)
{
    Candidate all;
    for (std::size_t i = 0; i < values.size(); ++i) {
        Candidate run;
        run.fabric = "cloth";
        run.numerical[key] = numerical;
        run.replicates = {ReplicateRun{}};
        if (values[i]) run.replicates[0]->numbers[key] = *values[i];
        add_replicate(all, run, static_cast<int>(i));
    }
    return all;
}

using Cost = std::function<std::optional<double>(Mixture, std::size_t)>; // of a replicate

Why explained(const WhyPlan& plan, int replicates, double numerical, const Cost& cost)
{
    const auto runs_of = [&](Mixture mixture) {
        std::vector<std::optional<double>> values;
        for (int r = 0; r < replicates; ++r) values.push_back(cost(mixture, static_cast<std::size_t>(r)));
        return ran(values, numerical);
    };
    std::map<Mixture, Candidate> mixtures;
    for (const Mixture mixture : plan.mixtures) mixtures[mixture] = runs_of(mixture);
    const Mixture all = (Mixture{1} << plan.parts.size()) - 1;
    return explain(plan, metric(), runs_of(0), runs_of(all), mixtures, replicates);
}

double sum_of(const Why& why)
{
    double sum = why.together ? why.together->difference : 0;
    for (const Contribution& part : why.parts) sum += part.compared.difference;
    return sum;
}

/// Of so many parts, without a design.
WhyPlan made_up(std::size_t parts)
{
    WhyPlan plan{"cloth", "other", "drop", {}, parts <= most_parts_in_all_orders, {}, {}};
    const Mixture all = (Mixture{1} << parts) - 1;
    for (std::size_t i = 0; i < parts; ++i) plan.parts.push_back({"part " + std::to_string(i), "1", "2", {}, false});
    for (Mixture m = 1; m < all; ++m) {
        const bool single = (m & (m - 1)) == 0, rest = ((all ^ m) & ((all ^ m) - 1)) == 0;
        if (plan.all_orders || single || rest) plan.mixtures.push_back(m);
    }
    return plan;
}

} // namespace

class TestWhy : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void sharesInAllOrdersAreShapleys()
    {
        // Two have a left glove, the third the right one; a pair is worth 1. Shapley: 1/6, 1/6, 4/6.
        const auto gloves = [](Mixture m) { return -((m & 4U) && (m & 3U) ? 1.0 : 0.0); };
        const std::vector<double> shares = contributions_of(3, true, gloves);
        QVERIFY(std::abs(shares[0] - 1.0 / 6) < 1e-15 && std::abs(shares[1] - 1.0 / 6) < 1e-15 && std::abs(shares[2] - 4.0 / 6) < 1e-15);
        // One at a time: the first glove makes nothing, the last one without which there is no pair all of it, half of which counts.
        const std::vector<double> alone = contributions_of(3, false, gloves);
        QCOMPARE(alone, (std::vector<double>{0, 0, 0.5}));
    }

    void whatPartsDoByThemselvesIsTheirsEitherWay()
    {
        const auto sum = [](Mixture m) { return 10 - 3.0 * (m & 1U) + 0.5 * (m >> 1U & 1U) - 0.25 * (m >> 2U & 1U); };
        for (const bool all_orders : {true, false}) {
            const std::vector<double> shares = contributions_of(3, all_orders, sum);
            QVERIFY(std::abs(shares[0] - 3) < 1e-14 && std::abs(shares[1] + 0.5) < 1e-14 && std::abs(shares[2] - 0.25) < 1e-14);
        }
    }

    void contributionsAndWhatIsTogetherAddUp_data()
    {
        QTest::addColumn<int>("parts");
        QTest::addColumn<int>("replicates");
        for (const int parts : {1, 2, 3, 4, 5, 7, 12})
            for (const int replicates : {1, 6}) QTest::addRow("%d parts, %d runs", parts, replicates) << parts << replicates;
    }
    void contributionsAndWhatIsTogetherAddUp()
    {
        QFETCH(int, parts);
        QFETCH(int, replicates);
        const WhyPlan plan = made_up(static_cast<std::size_t>(parts));
        const Mixture all = (Mixture{1} << static_cast<unsigned>(parts)) - 1;
        const Why why = explained(plan, replicates, 1e-6, [&](Mixture m, std::size_t r) {
            return (m == 0 ? 5 : m == all ? 2 : 0) + random_uniform(3, m, r); // nothing adds up by itself
        });
        QVERIFY2(why.nothing.empty(), why.nothing.c_str());
        QCOMPARE(why.parts.size(), static_cast<std::size_t>(parts));
        QVERIFY(std::abs(sum_of(why) - why.whole->difference) < 1e-13);
        QCOMPARE(why.together.has_value(), parts > 4);
        QCOMPARE(why.fabrics, 2 + static_cast<int>(plan.mixtures.size()));
        QVERIFY(parts > 4 ? why.fabrics == 2 + 2 * parts : why.fabrics == 1 << parts);
    }

    void anEffectWithinItsIntervalIsNone()
    {
        const Why why = explained(made_up(2), 1, 0.1, [](Mixture m, std::size_t) { return 5 - (m & 1U ? 0 : 2.0) - (m & 2U ? 0 : 0.05); });
        QCOMPARE(why.parts[0].compared.verdict, Verdict::better); // the fabric has a smaller time through it
        QCOMPARE(why.parts[0].compared.difference, -2.0);
        QVERIFY(std::abs(why.parts[0].compared.high + 1.9) < 1e-12);
        QCOMPARE(why.parts[1].compared.verdict, Verdict::no_difference);
        const auto sentences = sentences_of(why);
        QVERIFY2(sentences[0].find("makes it 2.00 ± 0.10 s shorter, which is better") != std::string::npos, sentences[0].c_str());
        QVERIFY2(sentences[1].find("no effect that this simulation can show") != std::string::npos, sentences[1].c_str());
    }

    void inputsAreInTheReadersUnits()
    {
        const Design design = pair_of([](Fabric& fabric) {
            fabric.warp.diameter_mm = 0.254;
            fabric.ends_per_cm = 20;
            fabric.contact_angle_deg = 50;
        });
        const ReaderUnits inches = [](const std::string& unit) {
            return unit == "mm" ? ReaderUnit{"in", 1 / 25.4} : unit == "/cm" ? ReaderUnit{"/in", 2.54} : ReaderUnit{unit};
        };
        std::string texts, own;
        for (const Exchange& part : plan_why(design, "cloth", "other", design.experiments[0].name, false, inches).parts)
            texts += part.second + ";";
        for (const Exchange& part : plan_of(design).parts) own += part.second + ";";
        for (const char* text : {"0.01 in", "50.8 /in", "50°"}) QVERIFY2(texts.find(text) != std::string::npos, texts.c_str());
        for (const char* text : {"0.254 mm", "20 /cm", "50°"}) QVERIFY2(own.find(text) != std::string::npos, own.c_str());
    }

    void contributionsAreInTheReadersUnits()
    {
        const ReaderUnits minutes = [](const std::string& unit) { return unit == "s" ? ReaderUnit{"min", 1.0 / 60} : ReaderUnit{unit}; };
        const Why why =
            explained(made_up(2), 1, 6, [](Mixture m, std::size_t) { return 300 - (m & 1U ? 0 : 120.0) - (m & 2U ? 0 : 60.0); });
        QVERIFY2(sentences_of(why)[0].find("120.0 ± 6.0 s shorter") != std::string::npos, sentences_of(why)[0].c_str());
        for (const std::string& text : {sentences_of(why, minutes)[0], heading_of(why, minutes), html_of({"", why_blocks(why, minutes)})})
            QVERIFY2(text.find(" min") != std::string::npos && text.find(" s,") == std::string::npos, text.c_str());
        QVERIFY2(with_unit(why.metric, why.parts[0].compared, minutes).starts_with("-2.0"), sentences_of(why, minutes)[0].c_str());
        // A difference has no zero of its own: 1.8 °F for each °C, and no 32.
        OutcomeInfo warmth = why.metric;
        warmth.unit = "°C";
        const ReaderUnits fahrenheit = [](const std::string& unit) { return ReaderUnit{unit == "°C" ? "°F" : unit, 1.8, 32}; };
        Compared warmer;
        warmer.difference = warmer.low = warmer.high = 10;
        QCOMPARE(with_unit(warmth, warmer, fahrenheit), std::string("18 °F"));
        const Why none =
            explained(made_up(2), 1, 6, [](Mixture m, std::size_t) { return 300 + (m & 1U ? 120.0 : 0) - (m & 2U ? 123.0 : 0); });
        QVERIFY2(none.nothing.find(" s)") != std::string::npos, none.nothing.c_str());
        QVERIFY2(nothing_of(none, minutes).find(" min)") != std::string::npos, nothing_of(none, minutes).c_str());
    }

    void whereOnlyAnExchangeAloneShowsItIsSaid()
    {
        // Either part alone makes nearly all of the difference in the fabric, the other then little: a mean of 0.6 with an error of 0.7.
        const auto either = [](Mixture m, std::size_t) { return m == 0 ? 5.0 : m == 3 ? 6.2 : 6.0; };
        const Why why = explained(made_up(2), 1, 0.7, either);
        for (const Contribution& part : why.parts) {
            QCOMPARE(part.compared.verdict, Verdict::no_difference);
            QVERIFY(part.alone_in_fabric && !part.alone_in_other);
            QCOMPARE(part.alone_in_fabric->difference, -1.0);
        }
        const auto says = [](const Why& of, const char* words) {
            const auto sentences = sentences_of(of);
            return std::any_of(sentences.begin(), sentences.end(), [&](const auto& s) { return s.find(words) != std::string::npos; });
        };
        QVERIFY(says(why, "Exchanged alone in cloth, the part 0 (1 instead of 2) makes it 1.00 ± 0.70 s shorter, which is better."));
        QVERIFY(!says(why, "No part by itself"));
        const Why none = explained(made_up(2), 1, 0.7, [](Mixture m, std::size_t) { return m == 0 ? 5.0 : m == 3 ? 6.2 : 5.6; });
        QVERIFY(says(none, "No part by itself") && !says(none, "Exchanged alone"));
    }

    void aDifferenceIsSaidInTheWordsOfItsNumber()
    {
        const auto heading = [](ExperimentType type, const char* key) {
            Why why = explained(made_up(2), 1, 0.1, [](Mixture m, std::size_t) { return 5 - (m & 1U ? 0 : 2.0); });
            why.metric = criterion_named(compared_by(type), key);
            return QString::fromStdString(heading_of(why) + "; " + effect_words(why.metric, why.parts[0].compared));
        };
        const QString time = heading(ExperimentType::droplet, "absorbency_time_s");
        QVERIFY2(time.contains(" shorter; makes it shorter, better"), qPrintable(time));
        const QString radius = heading(ExperimentType::droplet, "maximum_wetted_radius_top_mm");
        QVERIFY2(radius.contains(" mm smaller; makes it smaller"), qPrintable(radius));
        const QString height = heading(ExperimentType::vertical_wicking, "wick_height_mm");
        QVERIFY2(height.contains(" mm lower; makes it lower"), qPrintable(height));
        const QString rate = heading(ExperimentType::drying, "drying_rate_g_m2_h");
        QVERIFY2(rate.contains(" lower; makes it lower"), qPrintable(rate));
    }

    void aDifferenceThatIsNoneHasNoCauses()
    {
        // The parts do much, against each other.
        const Why why = explained(made_up(2), 1, 0.1, [](Mixture m, std::size_t) { return 5 + (m & 1U ? 2.0 : 0) - (m & 2U ? 2.05 : 0); });
        QCOMPARE(why.whole->verdict, Verdict::no_difference);
        QVERIFY(why.parts.empty() && !why.together);
        QVERIFY(why.nothing.find("No difference") == 0);
        QVERIFY(why_text(why).find("shorter") == std::string::npos && why_text(why).find("longer") == std::string::npos);
    }

    void aMixtureWithoutTheNumberIsNamed()
    {
        const Why why = explained(made_up(3), 1, 0.1, [](Mixture m, std::size_t) {
            return m == 5 ? std::nullopt : std::optional<double>(5 + static_cast<double>(m));
        });
        QVERIFY(why.parts.empty());
        QVERIFY2(why.nothing.find("part 0, part 2") != std::string::npos, why.nothing.c_str());
        // Of six replicates one lacks it: the others count.
        const Why most = explained(made_up(3), 6, 0.1, [](Mixture m, std::size_t r) {
            return m == 5 && r == 2 ? std::nullopt : std::optional<double>(5 + static_cast<double>(m) + 0.01 * static_cast<double>(r));
        });
        QCOMPARE(most.parts.size(), std::size_t{3});
        QCOMPARE(most.parts[0].compared.pairs, 5);
        QVERIFY(std::abs(sum_of(most) - most.whole->difference) < 1e-13);
    }

    void whatOnlyOneFabricHasIsSaidInsteadOfShared()
    {
        const Why why = explained(made_up(2), 1, 0.1, [](Mixture m, std::size_t) { return m == 3 ? std::nullopt : std::optional(5.0); });
        QVERIFY(why.parts.empty() && !why.whole);
        QVERIFY2(why.nothing.find("cloth absorbs all of the liquid") == 0, why.nothing.c_str());
    }

    void replicatesWidenTheInterval()
    {
        const Cost cost = [](Mixture m, std::size_t r) { return 5 - 2.0 * (m & 1U) + 0.3 * random_uniform(5, m, r); };
        const Why one = explained(made_up(2), 1, 0.01, cost), six = explained(made_up(2), 6, 0.01, cost);
        QCOMPARE(six.parts[0].compared.pairs, 6);
        const auto width = [](const Compared& c) { return c.high - c.low; };
        QVERIFY(width(six.parts[0].compared) > 2 * width(one.parts[0].compared));
        QCOMPARE(six.parts[1].compared.verdict, Verdict::no_difference); // scatter alone
    }

    void aCopyHasNothingToExplain()
    {
        const Design design = pair_of([](Fabric&) {});
        const WhyPlan plan = plan_of(design, true);
        QVERIFY(plan.parts.empty() && plan.mixtures.empty());
        const Why why = why_of(plan, metric(), ran({1.0}, 0.1), ran({1.0}, 0.1), 1);
        QCOMPARE(why.whole->verdict, Verdict::no_difference);
        QVERIFY(why.nothing.find("all inputs that act are the same") != std::string::npos);
    }

    void aContactAngleAloneIsAllOfTheDifference()
    {
        const Design design = pair_of([](Fabric& other) { other.contact_angle_deg = 70; });
        const WhyPlan plan = plan_of(design);
        QCOMPARE(titles_of(plan), std::string("contact angle;"));
        QVERIFY(plan.mixtures.empty());
        const Why why = explained(plan, 1, 0.01, [](Mixture m, std::size_t) { return m == 0 ? 1.0 : 4.0; });
        QCOMPARE(why.parts[0].compared.difference, why.whole->difference);
        QCOMPARE(why.parts[0].keys, std::vector<std::string>{"contact_angle_deg"});
    }

    void mixturesHaveTheirPartsOfTheOther()
    {
        const Design design = pair_of([](Fabric& other) {
            other.weft.twist_per_m = 300;
            other.weave = weave_from_pattern("twill 2/2 Z");
            other.contact_angle_deg = 60;
            other.warp.color = Color{1, 2, 3};
        });
        const WhyPlan plan = plan_of(design);
        QCOMPARE(titles_of(plan), std::string("weft construction;weave;contact angle;"));
        const Fabric &one = design.fabrics[0], &other = design.fabrics[1];
        QVERIFY(mixed(design, plan, 0).fabrics[0] == one);
        const Fabric some = mixed(design, plan, 5).fabrics[0];
        QVERIFY(some.weft == other.weft && some.weave == one.weave && some.contact_angle_deg == other.contact_angle_deg);
        QVERIFY(part_differences(design, mixed(design, plan, 7).fabrics[0], other, true).empty());
    }

    void whatDoesNotFitAloneIsExchangedTogether()
    {
        // Finer yarns in a denser sett: the fabric's own yarns are too thick for it.
        const Design design = pair_of([](Fabric& other) {
            for (Yarn* yarn : {&other.warp, &other.weft}) yarn->diameter_mm = 0.25 * *yarn->diameter_mm;
            other.ends_per_cm *= 3.5;
            other.picks_per_cm *= 3.5;
            other.contact_angle_deg = 60;
        });
        QVERIFY(!has_error(validate(design)));
        const WhyPlan plan = plan_of(design);
        QVERIFY2(!plan.notes.empty(), titles_of(plan).c_str());
        QVERIFY2(plan.notes[0].find("exchanged together") != std::string::npos, plan.notes[0].c_str());
        QVERIFY(std::any_of(plan.parts.begin(), plan.parts.end(),
                            [](const Exchange& part) { return part.several && part.title.find("warp sett") != std::string::npos; }));
        QCOMPARE(plan.parts.back().title, std::string("contact angle")); // it fits by itself
        for (const Mixture mixture : plan.mixtures) QVERIFY(!has_error(validate(mixed(design, plan, mixture))));
    }

    void rangesOfWhatIsNotKnownCountInReplicates()
    {
        const Design design = pair_of([](Fabric& other) {
            other.uncertainty.contact_angle_deg = 2;
            other.contact_angle_deg = 50;
        });
        QCOMPARE(plan_of(design, false).parts.size(), std::size_t{1});
        QCOMPARE(plan_of(design, true).parts.size(), std::size_t{2});
    }
};

QTEST_GUILESS_MAIN(TestWhy)
#include "tst_why.moc"
