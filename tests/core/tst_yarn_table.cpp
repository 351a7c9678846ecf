// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A library's yarns as tables.
#include "core/base/error.h"
#include "core/design/fitted_fabric.h"
#include "core/design/validate.h"
#include "core/project/library.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>

using namespace hygroloom;

class TestYarnTable : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void countsAreWrittenAsTheTradeWritesThem()
    {
        const auto back_and_forth = [](const std::string& count) {
            const LibraryYarn yarn = yarns_of_csv("name,count,material\na," + count + ",polyester\n", "c.csv").at(0);
            const std::string table = csv_of_yarns({yarn});
            if (yarns_of_csv(table, "again.csv").at(0).yarn() != yarn.yarn()) return std::string("another yarn");
            return size_text(yarn.yarn());
        };
        for (const char* count : {"Ne 60/2", "Nm 48/2", "14.8 tex × 2", "150/48 den", "167 dtex f48", "29.5 tex"})
            QCOMPARE(back_and_forth(count), std::string(count).starts_with("167") ? std::string("167/48 dtex") : std::string(count));
        QVERIFY(csv_of_yarns(yarns_of_csv("name,count,material\na,Ne 60/2,cotton\n", "c.csv")).find(",Ne 60/2,") != std::string::npos);
        QVERIFY(csv_of_yarns(yarns_of_csv("name,count,material\na,Ne 60/2,cotton\n", "c.csv"), true).find(",19.68") != std::string::npos);
        const std::string fine = "name,linear_density_tex,material\na,14.8123456,cotton\n"; // no count of four digits is it
        const std::vector<LibraryYarn> kept = yarns_of_csv(csv_of_yarns(yarns_of_csv(fine, "f.csv")), "again.csv");
        QCOMPARE(*kept.at(0).yarn().linear_density_tex, 14.8123456);
    }
    void countsAreWrittenAsTheTradeOfTheFibreDoes()
    {
        const auto again = [](const std::string& count, const std::string& fibres) {
            return size_text(yarns_of_csv("name,count,material\na," + count + "," + fibres + "\n", "c.csv").at(0).yarn());
        };
        QCOMPARE(again("Nm 40/2", "wool"), std::string("Nm 40/2"));
        QCOMPARE(again("Nm 50", "wool 55 + polyester 45"), std::string("Nm 50"));
        QCOMPARE(again("Nm 26", "flax"), std::string("Nm 26"));
        QCOMPARE(again("100 den", "silk"), std::string("100 den"));
        QCOMPARE(again("22 dtex", "silk"), std::string("22 dtex"));
        QCOMPARE(again("Ne 40/2", "cotton 60 + polyester 40"), std::string("Ne 40/2"));
        QCOMPARE(again("29.5 tex", "cotton"), std::string("29.5 tex")); // no Ne of four digits is it
    }
    void aNarrowerTableLeavesWhatItHasNoColumnFor()
    {
        LibraryYarn known = yarns_of_csv("name,count,material,twist_per_m,packing_factor,yarn_class,supplier,price,currency,colours\n"
                                         "fine,20 tex,cotton,800,0.6,rotor,Mill,6.5,EUR,navy #101a40\n",
                                         "t.csv")
                                .at(0);
        const auto reread = [&known](const std::string& table) { return yarns_of_csv(table, "t.csv", {known}).at(0); };
        const LibraryYarn same = reread("name,count\nfine,20 tex\n");
        QCOMPARE(same.yarn(), known.yarn());
        QCOMPARE(same.unsaid, known.unsaid);
        QVERIFY(same.supplier == "Mill" && same.currency == "EUR" && same.colours.size() == 1);
        const LibraryYarn cleared = reread("name,supplier,price,currency,colours,twist_per_m\nfine,,,,,\n");
        QVERIFY(cleared.supplier.empty() && !cleared.yarn().price && cleared.currency.empty() && cleared.colours.empty());
        QVERIFY(std::find(cleared.unsaid.begin(), cleared.unsaid.end(), "twist_per_m") != cleared.unsaid.end());
        QVERIFY(*cleared.yarn().linear_density_tex == 20 && *cleared.yarn().packing_factor == 0.6);
        for (const char* table : {"name,count\nfine,30 tex\n", "name,material\nfine,wool\n"}) { // spun otherwise
            const LibraryYarn other = reread(table);
            QCOMPARE(other.unsaid, unsaid_keys());
            QVERIFY(!other.yarn().packing_factor && !other.yarn().yarn_class && *other.yarn().price == 6.5);
        }
    }
    void tablesThatHoldNoYarnSaySo()
    {
        const auto said = [](const std::string& table) {
            try {
                yarns_of_csv(table, "t.csv");
            } catch (const Error& error) {
                return std::string(error.what());
            }
            return std::string();
        };
        QCOMPARE(said("name,count\n"), std::string("t.csv: The table holds no yarn: below the line that names the columns there is none."));
        QCOMPARE(said("name,count\na,Ne 20\nM\xfcller,Ne 30\n"),
                 std::string("t.csv: line 3: The text is not UTF-8; save the table as CSV in UTF-8."));
        QCOMPARE(said("name,count,material\na,Ne 20,cotton 60 + polyester 60\n"),
                 std::string("t.csv: line 2: material: The shares of the blend must sum to 100 %; they sum to 120 %."));
        const std::string of_class = said("name,count,yarn_class\na,Ne 20,3\n");
        QVERIFY2(of_class.find("rotor") != std::string::npos && of_class.find("quotes") == std::string::npos, of_class.c_str());
    }
    void yarnsGoThroughATable()
    {
        const std::string table = "name;supplier;count;material;core;colours;price\n"
                                  "fine;\"Mill; A\";Ne 60/2;cotton 60 + polyester 40;elastane 5;navy blue #101a40 + white #ffffff;6.5\n"
                                  "plain;;20 tex;wool;;;6,5\n";
        const std::vector<LibraryYarn> yarns = yarns_of_csv(table, "yarns.csv");
        QCOMPARE(yarns.size(), std::size_t{2});
        const Yarn& fine = yarns[0].yarn();
        QCOMPARE(fine.plies, 2);
        QVERIFY(std::abs(*fine.linear_density_tex - 2 * 590.5 / 60) < 0.01);
        QCOMPARE(fine.material, (std::vector<MaterialShare>{{"cotton", 0.6}, {"polyester", 0.4}}));
        QVERIFY(fine.core->material == "elastane" && std::abs(fine.core->share - 0.05) < 1e-12);
        QCOMPARE(yarns[0].colours.size(), std::size_t{2});
        QCOMPARE(yarns[0].colours[0].name, std::string("navy blue"));
        const std::vector<LibraryYarn> again = yarns_of_csv(csv_of_yarns(yarns), "again.csv");
        for (std::size_t i = 0; i < yarns.size(); ++i) QCOMPARE(again[i].yarn(), yarns[i].yarn());
        for (const Material& fibre : material_library()) {
            const std::vector<LibraryYarn> of_it =
                yarns_of_csv("name,material,linear_density_tex\n\"#1\"," + fibre.name + ",20\n", "fibres.csv");
            QCOMPARE(of_it[0].yarn().material, (std::vector<MaterialShare>{{fibre.name, 1.0}}));
            QCOMPARE(yarns_of_csv(csv_of_yarns(of_it), "again.csv")[0].yarn(), of_it[0].yarn());
        }
        QCOMPARE(
            yarns_of_csv("name;material;linear_density_tex\na;cotton 62,5 + polyester 37,5;29,5\n", "c.csv")[0].yarn().material[0].share,
            0.625);
        for (const char* wrong :
             {"name,material,tex\na,cotton,20\n", "name,material,linear_density_tex\na,cotton,20\na,cotton,21\n",
              "name,material,linear_density_tex\na,cotton,-5\n", "name,material,linear_density_tex\na,cotton,nan\n",
              "name,material,linear_density_tex\na,unobtainium,20\n", "name,material,linear_density_tex\na,cotton 50 + polyester 20,20\n"})
            QVERIFY_EXCEPTION_THROWN(yarns_of_csv(wrong, "w.csv"), Error);
        for (const char* wrong : {"name,count\na,Ne x\n", "name,core\na,elastane\n", "name,colours\na,navy\n", "name\n\"\"\n",
                                  "name,twist_direction\na,up\n", "supplier\nb\n"})
            QVERIFY_EXCEPTION_THROWN(yarns_of_csv(wrong, "w.csv"), Error);
    }
};

QTEST_APPLESS_MAIN(TestYarnTable)
#include "tst_yarn_table.moc"
