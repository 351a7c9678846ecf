// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// How yarns are shared out to bundles.
#include "core/plan/bundles.h"

#include <QTest>

#include <cmath>
#include <vector>

using namespace hygroloom;

class TestBundles : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void bundlesShareTheYarnsOutEvenly()
    {
        for (int yarns : {1, 2, 3, 7, 64, 101})
            for (int wanted = 1; wanted <= 8; ++wanted) {
                const Bundles bundles = bundles_of(yarns, {wanted});
                if (wanted > 1) QVERIFY(bundles.count == 1 || bundles.count % 2 == 0); // the middle lies between two
                QVERIFY(bundles.count == 1 || std::abs(double(yarns) / wanted - bundles.count) <= 1);
                std::vector<double> held(static_cast<std::size_t>(bundles.count), 0.0);
                for (int yarn = 0; yarn < yarns; ++yarn) {
                    QVERIFY(bundles.last_of(yarn) - bundles.first_of(yarn) <= 1);
                    double parts = 0;
                    for (int b = bundles.first_of(yarn); b <= bundles.last_of(yarn); ++b) {
                        parts += bundles.share(yarn, b);
                        held[static_cast<std::size_t>(b)] += bundles.share(yarn, b);
                        QVERIFY(bundles.share(yarn, b) > 0);
                    }
                    QVERIFY(std::abs(parts - 1) < 1e-14);
                }
                for (double yarns_held : held) QVERIFY(std::abs(yarns_held - bundles.size()) < 1e-13);
            }
        QCOMPARE(bundles_of(7, {1}).count, 7);
        QCOMPARE(bundles_of(7, {2}).count, 4);
        QCOMPARE(bundles_of(7, {2}).share(1, 0), 0.75); // 1.75 yarns each
        QCOMPARE(bundles_of(7, {2}).share(1, 1), 0.25);
    }
    void wholeBundlesLieAboutTheMiddle()
    {
        for (int yarns : {40, 84, 101, 104, 126, 127})
            for (int wanted : {2, 3, 4}) {
                const Bundles bundles = bundles_of(yarns, {wanted, true});
                if (std::abs(bundles.count * wanted - yarns) * 10 >= yarns) continue; // tried below
                QCOMPARE(bundles.size(), double(wanted));
                QCOMPARE(bundles.middle(bundles.count / 2 - 1) + 0.5 * wanted, 0.5 * yarns);
                std::vector<double> held(static_cast<std::size_t>(bundles.count), 0.0);
                for (int yarn = 0; yarn < yarns; ++yarn) {
                    double parts = 0;
                    for (int b = bundles.first_of(yarn); b <= bundles.last_of(yarn); ++b) {
                        parts += bundles.share(yarn, b);
                        held[static_cast<std::size_t>(b)] += bundles.share(yarn, b);
                    }
                    QCOMPARE(parts, 1.0);
                }
                for (int b = 0; b < bundles.count; ++b) {
                    QCOMPARE(bundles.held(b), held[static_cast<std::size_t>(b)]);
                    if (b > 0 && b + 1 < bundles.count) QCOMPARE(bundles.held(b), double(wanted));
                    QVERIFY(std::abs(bundles.held(b) - wanted) <= 0.5 * wanted);
                }
            }
        QCOMPARE(bundles_of(10, {4, true}).size(), 5.0); // 8 or 12 would be another sample
    }
};

QTEST_APPLESS_MAIN(TestBundles)
#include "tst_bundles.moc"
