// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/base/error.h"
#include "core/design/fitted_fabric.h"
#include "core/design/validate.h"
#include "core/project/atomic_file.h"
#include "core/project/library.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <thread>

using namespace hygroloom;

class TestLibrary : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyPresetIsSound()
    {
        QVERIFY(shipped_presets().size() >= 24);
        for (const Preset& preset : shipped_presets())
            for (const Issue& issue : validate(preset.design))
                QVERIFY2(issue.severity != Severity::error, (preset.fabric().name + ": " + issue.text()).c_str());
    }
    void yarnsStandBesidePresetsInOneFile()
    {
        const QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath("own.hygrolib").toStdString();
        QVERIFY(read_yarns(path).empty()); // no file yet
        Design design;
        design.materials = {*find_library_material("cotton")};
        design.materials[0].name = "our cotton";
        design.materials[0].based_on = "cotton";
        design.materials[0].standard_regain = 0.09;
        Yarn yarn;
        yarn.material = {{"our cotton"}};
        yarn.linear_density_tex = 14.8;
        yarn.price = 6.5;
        std::vector<LibraryYarn> yarns{library_yarn(design, yarn, "fine")};
        yarns[0].supplier = "Mill \"A\", north";
        yarns[0].currency = "EUR";
        yarns[0].colours = {{"navy blue", {16, 26, 64}}};
        write_yarns(yarns, path);
        write_library({shipped_presets()[0]}, path);          // leaves them
        keep_yarn(yarns, library_yarn(design, yarn, "fine")); // in place of the first
        QCOMPARE(yarns.size(), std::size_t{1});
        const LibraryYarn read = read_yarns(path).at(0);
        QCOMPARE(read_library(path).size(), std::size_t{1});
        QCOMPARE(read.yarn(), yarn);
        QVERIFY(read.unsaid.empty());
        QCOMPARE(read.supplier, std::string("Mill \"A\", north"));
        QVERIFY(read.colours.at(0).name == "navy blue" && read.colours[0].color == (Color{16, 26, 64}));
        Design other;
        other.materials = {*find_library_material("flax")};
        other.materials[0].name = "our cotton"; // another fibre of that name
        QCOMPARE(take_yarn(other, read).material[0].name, std::string("our cotton 2"));
        QCOMPARE(other.materials.size(), std::size_t{2});
    }
    void aYarnIsReplacedInAllFabrics()
    {
        Design design;
        for (const char* name : {"a", "b", "c", "d"}) {
            design.fabrics.emplace_back();
            design.fabrics.back().name = name;
        }
        const LibraryYarn old = library_yarn({}, design.fabrics[0].warp, "old");
        design.fabrics[0].warp.color = Color{1, 2, 3}; // dyed and priced, it is the same yarn
        design.fabrics[0].warp.price = 5;
        design.fabrics[1].warp.twist_per_m = 1; // another one
        for (Fabric* each : {&design.fabrics[3]}) each->warp.plies = each->weft.plies = 2;
        Yarn finer = old.yarn();
        finer.linear_density_tex = 10;
        QCOMPARE(fabrics_with(design, old), (std::vector<std::string>{"a", "b", "c"}));
        QCOMPARE(replace_yarn(design, old, library_yarn({}, finer, "finer")).size(), std::size_t{5});
        QCOMPARE(design.fabrics[0].warp.linear_density_tex, finer.linear_density_tex);
        QVERIFY(design.fabrics[0].warp.color == (Color{1, 2, 3}));
        QCOMPARE(design.fabrics[1].warp.twist_per_m, 1.0);
        finer.library_yarn = "finer";
        QCOMPARE(design.fabrics[1].weft, finer);
        QCOMPARE(design.fabrics[3].warp.plies, 2);
        QVERIFY(fabrics_with(design, old).empty());
    }
    void fibresAreComparedByWhatTheyAre()
    {
        Design design;
        design.fabrics.emplace_back();
        design.materials = {*find_library_material("cotton")};
        design.materials[0].name = "our cotton"; // the same fibre, of another name
        Yarn named = design.fabrics[0].warp;
        named.material = {{"our cotton", 1.0}};
        design.fabrics[0].weft = named;
        const LibraryYarn cotton = library_yarn({}, design.fabrics[0].warp, "cotton");
        QVERIFY(same_yarn(design, named, cotton));
        design.materials[0].contact_angle_deg = 30;
        QVERIFY(!same_yarn(design, named, cotton));
        design.materials[0] = *find_library_material("flax");
        design.materials[0].name = "cotton"; // another fibre, of the same name
        QVERIFY(!same_yarn(design, design.fabrics[0].warp, cotton));
        QVERIFY(changes_of_yarn(design, design.fabrics[0].warp, cotton).at(0).key == "material");
    }
    void yarnsAreBroughtUpToDate()
    {
        Design design;
        for (const char* name : {"a", "b", "c"}) {
            design.fabrics.emplace_back();
            design.fabrics.back().name = name;
        }
        Yarn fine;
        fine.linear_density_tex = 14.8;
        LibraryYarn library = library_yarn(design, fine, "fine");
        design.fabrics[0].warp = take_yarn(design, library);
        design.fabrics[1].weft = take_yarn(design, library);
        design.fabrics[1].weft.color = Color{1, 2, 3};
        design.fabrics[2].warp = fine; // the same, but it refers to none
        QVERIFY(update_yarns(design, {library}).empty());
        library.design.fabrics[0].warp.linear_density_tex = 15.2;
        library.design.fabrics[0].warp.price = 7;
        design.fabrics[1].warp.library_yarn = "gone";
        const Design before = design;
        const std::vector<YarnUpdate> updates = update_yarns(design, {library});
        QCOMPARE(updates.size(), std::size_t{3});
        QVERIFY(updates[0].fabric == "a" && updates[0].key == "warp" && updates[0].changes.size() == 2);
        QVERIFY(updates[0].changes[0].label == "Linear density" && updates[0].changes[0].before == "14.8 tex" &&
                updates[0].changes[0].after == "15.2 tex");
        QVERIFY(updates[0].changes[1].key == "price" && updates[0].changes[1].before.empty());
        QVERIFY(updates[1].is_missing && updates[1].library_yarn == "gone");
        QVERIFY(updates[2].fabric == "b" && updates[2].key == "weft");
        QCOMPARE(*design.fabrics[0].warp.linear_density_tex, 15.2);
        QCOMPARE(*design.fabrics[1].weft.linear_density_tex, 15.2);
        QVERIFY(design.fabrics[1].weft.color == (Color{1, 2, 3}));
        QCOMPARE(design.fabrics[1].warp, before.fabrics[1].warp);
        QCOMPARE(design.fabrics[2], before.fabrics[2]);
    }
    void whatATableDoesNotSayMakesNoOtherYarn()
    {
        const LibraryYarn read = yarns_of_csv("name,count,material\nfine,20 tex,cotton\n", "t.csv").at(0);
        Design design;
        design.fabrics.emplace_back();
        Yarn& own = design.fabrics[0].warp;
        own.linear_density_tex = 20;
        own.twist_per_m = 950;
        own.packing_factor = 0.6;
        own.library_yarn = "fine";
        QVERIFY(same_yarn(design, own, read));
        QVERIFY(update_yarns(design, {read}).empty());
        own.linear_density_tex = 21;
        QCOMPARE(update_yarns(design, {read}).size(), std::size_t{1});
        QCOMPARE(own.twist_per_m, 950.0); // the library does not say it
        QCOMPARE(*own.packing_factor, 0.6);
        const QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath("own.hygrolib").toStdString();
        write_yarns({read}, path);
        QCOMPARE(read_yarns(path).at(0).unsaid, read.unsaid);
        QCOMPARE(yarns_of_csv(csv_of_yarns({read}), "again.csv").at(0).unsaid, read.unsaid);
        const LibraryYarn said = yarns_of_csv("name,count,material,twist_per_m\nfine,20 tex,cotton,800\n", "t.csv", {read}).at(0);
        QVERIFY(!same_yarn(design, own, said));
        QCOMPARE(yarns_of_csv("name,count,material\nfine,20 tex,cotton\n", "t.csv", {said}).at(0).yarn().twist_per_m, 800.0);
    }
    void aYarnInAnothersPlaceKeepsWhatItsTableDoesNotSay()
    {
        const LibraryYarn read = yarns_of_csv("name,count,material\nfine,20 tex,cotton\n", "t.csv").at(0);
        Design design;
        design.fabrics.emplace_back();
        Yarn& own = design.fabrics[0].warp;
        own.linear_density_tex = 21;
        own.twist_per_m = 1046;
        own.packing_factor = 0.6;
        own.irregularity_cv = 0.12;
        const std::vector<YarnUpdate> replaced = replace_yarn(design, library_yarn({}, own, "old"), read);
        QVERIFY(replaced.at(0).key == "warp" && replaced[0].changes.at(0).after == "20 tex" && replaced[0].changes.size() == 1);
        QCOMPARE(own.library_yarn, std::string("fine"));
        QCOMPARE(*own.linear_density_tex, 20.0);
        QCOMPARE(own.twist_per_m, 1046.0);
        QCOMPARE(*own.packing_factor, 0.6);
        QCOMPARE(*own.irregularity_cv, 0.12);
    }
    void aFibreThatBearsAShippedNameStaysApart()
    {
        const LibraryYarn cotton = yarns_of_csv("name,count,material\nfine,20 tex,cotton\n", "t.csv").at(0);
        Design design;
        design.fabrics.emplace_back();
        design.materials = {*find_library_material("flax")};
        design.materials[0].name = "cotton"; // another fibre, of a shipped one's name
        Yarn &warp = design.fabrics[0].warp, &weft = design.fabrics[0].weft;
        warp.linear_density_tex = weft.linear_density_tex = 20;
        warp.material = weft.material = {{"cotton", 1.0}};
        warp.library_yarn = "fine";
        QCOMPARE(update_yarns(design, {cotton}).size(), std::size_t{1});
        QCOMPARE(warp.material[0].name, std::string("cotton 2"));
        QCOMPARE(find_material(design, "cotton 2")->contact_angle_deg, find_library_material("cotton")->contact_angle_deg);
        QVERIFY(update_yarns(design, {cotton}).empty());
        QCOMPARE(take_yarn(design, cotton).material[0].name, std::string("cotton 2"));
        QCOMPARE(design.materials.size(), std::size_t{2});
        const LibraryYarn other = library_yarn(design, weft, "other"); // its "cotton" is flax
        Design empty;
        empty.fabrics.emplace_back();
        empty.fabrics[0].weft.material = {{"cotton", 1.0}};
        empty.fabrics[0].warp = take_yarn(empty, other);
        QCOMPARE(find_material(empty, "cotton"), find_library_material("cotton")); // the weft's is as it was
        QVERIFY(update_yarns(empty, {other}).empty());
    }
    void anUpdateKeepsTheNamesOfTheSameFibres()
    {
        Design design;
        design.fabrics.emplace_back();
        design.materials = {*find_library_material("cotton")};
        design.materials[0].name = "our cotton"; // the same fibre
        Yarn& own = design.fabrics[0].warp;
        own.linear_density_tex = 20;
        own.library_yarn = "mixed";
        own.material = {{"polyester", 1.0 / 3}, {"our cotton", 2.0 / 3}};
        const std::string head = "name,material,linear_density_tex\nmixed,cotton 66.66667 + polyester 33.33333,";
        QVERIFY(update_yarns(design, yarns_of_csv(head + "20\n", "t.csv")).empty()); // another order, and rounded
        const std::vector<YarnUpdate> updates = update_yarns(design, yarns_of_csv(head + "22\n", "t.csv"));
        QCOMPARE(updates.at(0).changes.size(), std::size_t{1});
        QCOMPARE(*own.linear_density_tex, 22.0);
        QCOMPARE(own.material, (std::vector<MaterialShare>{{"polyester", 1.0 / 3}, {"our cotton", 2.0 / 3}}));
    }
    void aShippedFabricIsFoundByItsCount()
    {
        const LibraryYarn read = yarns_of_csv("name,count,material\nfine,Ne 80,cotton\n", "t.csv").at(0);
        const auto voile = std::find_if(shipped_presets().begin(), shipped_presets().end(),
                                        [](const Preset& preset) { return preset.fabric().name == "Voile"; });
        QCOMPARE(fabrics_with(voile->design, read), std::vector<std::string>{"Voile"});
        const LibraryYarn coarser = yarns_of_csv("name,count,material\ncoarser,Ne 79.9,cotton\n", "t.csv").at(0);
        QVERIFY(fabrics_with(voile->design, coarser).empty());
    }
    void whoChangesALibraryWaitsForOthers()
    {
        const QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath("own.hygrolib").toStdString();
        const auto keep = [path] { keep_in_library(library_yarn({}, Yarn(), "fine"), path); };
        std::thread other;
        {
            const ChangeLock alone(path);
            other = std::thread(keep);
            std::this_thread::sleep_for(std::chrono::milliseconds(200));
            write_yarns({library_yarn({}, Yarn(), "of the first")}, path);
        }
        other.join();
        QCOMPARE(read_yarns(path).size(), std::size_t{2}); // neither is lost
    }
    void presetsWeighWhatTheirConstructionsDo()
    {
        // g/m2 by hand: (ends/cm x tex x (1 + crimp) + picks/cm x tex x (1 + crimp)) / 10, rounded; crimp as calculated, or as typed.
        const std::map<std::string, double> expected{{"Poplin shirting", 134},
                                                     {"Sheeting", 107},
                                                     {"Drill", 251},
                                                     {"Denim", 403},
                                                     {"Oxford", 123},
                                                     {"Voile", 47},
                                                     {"Cotton sateen", 121},
                                                     {"Wool serge", 274},
                                                     {"Tropical worsted", 161},
                                                     {"Hemp canvas", 289},
                                                     {"Linen cloth", 153},
                                                     {"Polyester taffeta", 70},
                                                     {"Sports micro-twill", 85},
                                                     {"Pongee", 70},
                                                     {"Nylon taslan", 98},
                                                     {"Silk habotai", 53},
                                                     {"Viscose challis", 106}};
        std::size_t found = 0;
        for (const Preset& preset : shipped_presets()) {
            const auto weight = expected.find(preset.fabric().name);
            if (weight == expected.end()) continue;
            ++found;
            const FabricQuantities q = derive_quantities(preset.design, preset.fabric());
            QVERIFY2(std::abs(q.areal_density_g_m2 - weight->second) < 1.5 + 0.01 * weight->second,
                     qPrintable(QString("%1: %2").arg(preset.fabric().name.c_str()).arg(q.areal_density_g_m2)));
            const auto typed = [&](const std::optional<double>& crimp, double calculated) {
                return !crimp || std::abs(calculated - *crimp) < 1;
            };
            QVERIFY2(
                typed(preset.fabric().warp_crimp_percent, q.warp.crimp_percent) &&
                    typed(preset.fabric().weft_crimp_percent, q.weft.crimp_percent),
                qPrintable(
                    QString("%1: crimps %2, %3").arg(preset.fabric().name.c_str()).arg(q.warp.crimp_percent).arg(q.weft.crimp_percent)));
        }
        QCOMPARE(found, expected.size());
    }
    void aUsersLibraryComesBackAsItWas()
    {
        QTemporaryDir folder;
        const std::filesystem::path path = folder.filePath("mine.hygrolib").toStdString();
        QVERIFY(read_library(path).empty());
        Design design = shipped_presets()[0].design;
        design.materials.push_back(*find_material({}, "cotton"));
        design.materials[0].name = "my cotton";
        design.materials[0].based_on = "cotton";
        design.fabrics[0].warp.material = {{"my cotton", 1}};
        std::vector<Preset> mine{preset_of(design, design.fabrics[0], "Mine", "With a note."), shipped_presets()[3]};
        QCOMPARE(mine[0].design.materials.size(), std::size_t(1));
        write_library(mine, path);
        const std::vector<Preset> back = read_library(path);
        QCOMPARE(back.size(), mine.size());
        for (std::size_t i = 0; i < mine.size(); ++i) {
            QVERIFY(back[i].design == mine[i].design);
            QVERIFY(back[i].group == mine[i].group && back[i].note == mine[i].note);
        }
    }
    void aPresetBringsItsMaterialsAndGetsAFreeName()
    {
        Design design = shipped_presets()[0].design;
        Preset preset = shipped_presets()[0];
        Material own = *find_material({}, "cotton");
        own.name = "my cotton";
        preset.design.materials = {own};
        preset.design.fabrics[0].warp.material = {{"my cotton", 1}};
        Material other = own;
        other.contact_angle_deg = 80;
        design.materials = {other};
        QCOMPARE(add_preset(design, preset), std::size_t(1));
        QVERIFY(design.fabrics[1].name == "Poplin shirting 2");
        QVERIFY(design.fabrics[1].warp.material[0].name == "my cotton 2");
        QCOMPARE(design.materials[0].contact_angle_deg, 80.0);
        QVERIFY(!has_error(validate(design)));
        add_preset(design, preset);
        QCOMPARE(design.materials.size(), std::size_t(2)); // the same substance is there already
    }
    void aBrokenLibraryIsRefusedWithItsPlace()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath("mine.hygrolib");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(
            R"({"format":"hygroloom-library","version":1,"presets":[{"group":"x","project":{"format":"hygroloom-project","version":1,"fabrics":[]}}]})");
        file.close();
        try {
            read_library(path.toStdString());
            QFAIL("nothing was thrown");
        } catch (const FileError& error) {
            QVERIFY2(QString(error.what()).contains("presets[0].project"), error.what());
        }
    }
    void finishesAreWithinTheAnglesThereAre()
    {
        QVERIFY(finishes().size() >= 6);
        for (const Finish& finish : finishes())
            QVERIFY(finish.contact_angle_deg >= 0 && finish.contact_angle_deg <= 180 && !finish.note.empty());
    }
};

QTEST_APPLESS_MAIN(TestLibrary)
#include "tst_library.moc"
