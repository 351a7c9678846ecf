// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a card says of sold cloths is what verify finds of them.
#include "core/laboratory/numbers.h"
#include "core/solver/backend.h"
#include "core/verify/verify.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace hygroloom;

class TestSoldCloths : public QObject {
    Q_OBJECT

    static QString sentenceOf(const char* key)
    {
        const std::vector<LaboratoryNumber> numbers = numbers_of_cards();
        const auto found = std::find_if(numbers.begin(), numbers.end(), [key](const LaboratoryNumber& each) { return each.key == key; });
        return QString::fromStdString(found->model);
    }
    /// The computed values of the results whose names begin so.
    static std::vector<double> values_of(const VerifyReport& report, const std::string& begin)
    {
        std::vector<double> values;
        for (const VerifyResult& result : report.results)
            if (result.name.starts_with(begin)) values.push_back(result.computed);
        return values;
    }

private Q_SLOTS:
    void airIsAsFarOffAsTheCardSays()
    {
        const VerifyReport report = run_verify_case("measured_air", {}, *make_cpu_backend());
        const std::vector<double> off = values_of(report, "factor_off_"), inside = values_of(report, "inside_of_");
        const auto worst = std::max_element(off.begin(), off.end());
        const auto within_3 = std::count_if(off.begin(), off.end(), [](double factor) { return factor <= 3; });
        const auto near_half = static_cast<double>(within_3) / static_cast<double>(off.size());
        QVERIFY2(near_half == 0.5, qPrintable(QString::number(within_3)));
        QCOMPARE(sentenceOf("air_permeability_mm_s"),
                 QString("Air permeability was compared with %1 sold cloths: half of them came out within 3 times the measured value, "
                         "the worst %2 times off; %3 lay in their range.")
                     .arg(off.size())
                     .arg(std::lround(*worst))
                     .arg(inside.front()));
    }
    void thicknessIsAsFarOffAsTheCardSays()
    {
        const std::vector<double> ratios =
            values_of(run_verify_case("measured_thickness", {}, *make_cpu_backend()), "thickness_to_measured_");
        const auto of = [&](auto holds) { return std::count_if(ratios.begin(), ratios.end(), holds); };
        QCOMPARE(of([](double ratio) { return ratio < 0.5; }), 2);
        QCOMPARE(
            sentenceOf("thickness_mm"),
            QString("The thickness at 1 kPa was compared with %1 sold cloths: %2 came out within 25 %, two raised ones at less than half.")
                .arg(ratios.size())
                .arg(of([](double ratio) { return std::abs(ratio - 1) <= 0.25; })));
    }
};

QTEST_APPLESS_MAIN(TestSoldCloths)
#include "tst_sold_cloths.moc"
