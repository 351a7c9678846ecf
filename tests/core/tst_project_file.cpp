// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The project file in words: every key there and back, wrong text with its place, migrations, one value by its path.
#include "core/design/validate.h"
#include "core/project/project_json.h"
#include "core/project/project_schema.h"
#include "tests/core/rich_project.h"

#include <QRegularExpression>
#include <QTest>

#include <clocale>

using namespace hygroloom;
namespace fs = std::filesystem;

namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    const auto at = text.find(from);
    if (at == std::string::npos) qFatal("no %s", from.c_str());
    return text.replace(at, from.size(), to);
}

} // namespace

class TestProjectFile : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void examplesAreWrittenBackByteForByte()
    {
        int count = 0;
        for (const auto& entry : fs::recursive_directory_iterator(examples)) {
            if (entry.path().extension() != ".hygro") continue;
            QCOMPARE(QString::fromStdString(format_project(read_project(entry.path()))), QString::fromStdString(bytes_of(entry.path())));
            ++count;
        }
        QVERIFY(count >= 17);
    }
    void everythingSurvivesARoundTrip()
    {
        const Design design = rich();
        const std::string text = format_project(design);
        QVERIFY(parse_project(text, "text") == design);
        QCOMPARE(format_project(parse_project(text, "text")), text);
    }
    void theContractsExampleIsRead()
    {
        const Design design = parse_project(bytes_of(std::string(HYGROLOOM_SOURCE_DIR) + "/tests/data/contract.hygro"), "contract");
        QCOMPARE(design.materials.at(0).density_kg_m3, 1550.0);
        QCOMPARE(design.materials.at(0).contact_angle_deg, 35.0);
        QCOMPARE(*design.fabrics.at(0).weft.linear_density_tex, 18.0);
        QCOMPARE(*design.fabrics.at(0).contact_angle_deg, 30.0);
        QCOMPARE(design.fabrics.at(0).flyaway.hair_density_per_mm, 10.0);
        QCOMPARE(design.experiments.at(0).droplets.at(0).volume_ul, 15.0);
    }
    void climatesMayTakeACourse()
    {
        const std::string good = format_project(rich());
        const Experiment e = parse_project(good, "text").experiments.at(1);
        QCOMPARE(e.climates.size(), std::size_t(2));
        QCOMPARE(climate_at(e, 30).temperature_c, 25.5);
        QCOMPARE(climate_at(e, 75.25).relative_humidity, 0.6);
        QCOMPARE(climate_at(e, 1000), (Climate{30, 0.4, 0.5}));
        const std::string course =
            "\"climate\": [{\"temperature_c\": 30}, {\"time_s\": 9, \"relative_humidity\": 0.1}], \"type\": \"sweat\", \"name\": \"s\"";
        const std::string project = "{\"format\": \"hygroloom-project\", \"version\": 1, \"experiments\": [{" + course + "}]}";
        const Experiment sweat = parse_project(project, "text").experiments.at(0);
        QCOMPARE(sweat.climates.at(0).climate.temperature_c, 30.0); // what a moment does not say stays
        const auto refusal = [&](const std::string& from, const std::string& to) {
            return QString::fromStdString(message_of([&] { parse_project(replaced(project, from, to), "text"); }));
        };
        QVERIFY(refusal("\"time_s\": 9, ", "").contains("climate[1]: The key \"time_s\" is missing"));
        QVERIFY(refusal("{\"temperature_c\": 30}", "{\"time_s\": 1}").contains("begins at 0 s; given is 1"));
        QVERIFY(refusal("{\"temperature_c\": 30}, ", "").contains("begins at 0 s"));
    }
    void aFeedComesInDrops()
    {
        Design design;
        design.experiments = {standard_experiment(ExperimentType::moisture_management)};
        design.experiments[0].name = "feed";
        QVERIFY(has(format_project(design), "\"drop_ul\": 25.0"));
        QVERIFY(parse_project(replaced(format_project(design), "\"drop_ul\": 25.0,", ""), "text") == design);
        design.experiments[0].drop_ul = 12.5;
        const std::string text = format_project(design);
        QVERIFY(has(text, "\"drop_ul\": 12.5"));
        QVERIFY(parse_project(text, "text") == design);
        for (const char* wrong : {"\"12.5\"", "null", "[12.5]", "true"})
            QVERIFY2(has(message_of([&] { parse_project(replaced(text, "12.5", wrong), "text"); }), "experiments[0].drop_ul"), wrong);
        const std::string droplet = replaced(text, "moisture_management", "horizontal_wicking");
        QVERIFY(has(message_of([&] { parse_project(replaced(droplet, "\"feed_s\": 20.0,", ""), "text"); }), "drop_ul")); // not of this type
    }
    void theSchemaNamesEveryKey()
    {
        const std::string schema = project_schema().dump();
        const ProjectJson project = json_from_design(rich()).flatten();
        for (const auto& [path, value] : project.items()) {
            std::string key = path;
            while (std::isdigit(static_cast<unsigned char>(key.back()))) key.resize(key.rfind('/'));
            key = key.substr(key.rfind('/') + 1);
            if (has(path, "/seams/") || has(path, "/gap_mm/")) continue; // names that are free
            QVERIFY2(has(schema, "\"" + key + "\":{"), key.c_str());
        }
    }
    void theSchemaAsksForWhatTheReaderAsksFor()
    {
        const ProjectJson schema = project_schema();
        const ProjectJson& experiment = schema.at("$defs").at("experiment");
        QVERIFY(experiment.at("if").at("properties").at("type").at("const") == "droplet");
        std::vector<std::string> asked = experiment.at("required");
        for (const auto& key : experiment.at("then").at("required")) asked.push_back(key);
        QVERIFY(asked.size() >= 4);
        const ProjectJson good = json_from_design(read_project(examples + "textile-F.hygro"));
        for (const auto& [key, value] : good.at("experiments").at(0).items()) {
            ProjectJson without = good;
            without["experiments"][0].erase(key);
            const std::string message = message_of([&] { parse_project(text_from_json(without), "text"); });
            const bool needed = std::find(asked.begin(), asked.end(), key) != asked.end();
            QVERIFY2(has(message, "The key \"" + key + "\" is missing.") == needed && message.empty() != needed, key.c_str());
        }
    }
    void theSchemaPromisesNoClimateThatATypeDoesNotHave()
    {
        const ProjectJson schema = project_schema();
        const ProjectJson& moment =
            schema.at("$defs").at("experiment").at("properties").at("climate").at("oneOf").at(1).at("items").at("properties");
        for (int type = 0; type < experiment_types; ++type) {
            const Climate usual = standard_experiment(static_cast<ExperimentType>(type)).climate;
            for (const ProjectJson& keys : {schema.at("$defs").at("climate").at("properties"), moment}) {
                QCOMPARE(keys.at("temperature_c").value("default", usual.temperature_c), usual.temperature_c);
                QCOMPARE(keys.at("relative_humidity").value("default", usual.relative_humidity), usual.relative_humidity);
                QCOMPARE(keys.at("air_speed_m_s").value("default", usual.air_speed_m_s), usual.air_speed_m_s);
            }
        }
    }
    void theSchemasLimitsAreThoseOfTheReader_data()
    {
        QTest::addColumn<QString>("schema");
        QTest::addColumn<QString>("object");
        QTest::newRow("climate") << "/$defs/climate"
                                 << "/experiments/0/climate";
        QTest::newRow("moment of a climate") << "/$defs/experiment/properties/climate/oneOf/1/items"
                                             << "/experiments/1/climate/1";
        QTest::newRow("droplet") << "/$defs/experiment/properties/droplets/items"
                                 << "/experiments/0/droplets/0";
        QTest::newRow("material") << "/$defs/material"
                                  << "/materials/1";
        QTest::newRow("fabric") << "/$defs/fabric"
                                << "/fabrics/0";
        QTest::newRow("yarn") << "/$defs/yarn"
                              << "/fabrics/0/warp";
        QTest::newRow("liquid") << "/$defs/liquid"
                                << "/liquids/0";
    }
    void theSchemasLimitsAreThoseOfTheReader()
    {
        QFETCH(QString, schema);
        QFETCH(QString, object);
        const ProjectJson all = project_schema();
        QString where = object;
        where = where.replace(QRegularExpression("/(\\d+)"), "[\\1]").replace('/', '.').mid(1) + "."; // as issues have it
        int limits = 0;
        for (const auto& [key, value] : all.at(ProjectJson::json_pointer(schema.toStdString() + "/properties")).items()) {
            if (key == "time_s" || key == "sorption_heat_j_g") continue; // depend on their neighbours; have another name
            const ProjectJson& property = value.contains("oneOf") ? value.at("oneOf").back() : value;
            for (const auto& [limit, outwards] : {std::pair("minimum", -1), std::pair("maximum", 1)}) {
                if (!property.contains(limit)) continue;
                const double most = property.at(limit);
                const double beyond = most + outwards * (most == 0 || property.at("type") == "integer" ? 1 : 0.01 * std::abs(most));
                const auto is_refused = [&](double number) {
                    ProjectJson project = json_from_design(rich());
                    project["materials"][1]["standard_regain"] = 0; // or saturation_regain could not be
                    project[ProjectJson::json_pointer(object.toStdString())][key] = number;
                    const auto issues = validate(parse_project(text_from_json(project), "text"));
                    return std::any_of(issues.begin(), issues.end(), [&](const Issue& issue) {
                        return issue.severity == Severity::error && issue.where.text() == where.toStdString() + key &&
                               issue.code == "range";
                    });
                };
                QVERIFY2(!is_refused(most), (key + " " + limit).c_str());
                QVERIFY2(is_refused(beyond), (key + " " + limit).c_str());
                ++limits;
            }
        }
        QVERIFY(limits >= 5);
    }
    void aFibresShapeIsANameOrANumber()
    {
        const std::string text = format_project(rich());
        QVERIFY(has(text, "\"cross_section\": \"trilobal\""));
        QVERIFY(has(text, "\"cross_section\": 1.375"));
        const auto with = [&](const char* shape) { return replaced(text, "\"trilobal\"", shape); };
        QCOMPARE(parse_project(with("\"channelled\""), "text").materials.at(0).cross_section.perimeter_factor, 1.2);
        QVERIFY(!has(format_project(parse_project(with("\"round\""), "text")), "\"trilobal\""));
        const std::string wrong = message_of([&] { parse_project(with("\"beam\""), "text"); });
        QVERIFY2(has(wrong,
                     "materials[0].cross_section: This must be one of \"round\", \"trilobal\", \"bean\", \"channelled\", or a number "
                     "from 1 to 3, perimeter over that of a circle of the same area; given is \"beam\"."),
                 wrong.c_str());
        QVERIFY(has(message_of([&] { parse_project(with("true"), "text"); }), "given is true."));
        const ProjectJson schema = project_schema();
        std::vector<std::string> names;
        for (const CrossSection& shape : cross_sections()) names.push_back(shape.shape);
        QVERIFY(schema.at("$defs").at("material").at("properties").at("cross_section").at("oneOf").at(0).at("enum") == names);
    }
    void theHeatOfWettingHasTwoNames()
    {
        const std::string text = format_project(rich()), key = "\"heat_of_wetting_j_g\": 12.5", other = "\"sorption_heat_j_g\": 12.5";
        QVERIFY(parse_project(replaced(text, key, other), "text") == rich());
        const std::string both = message_of([&] { parse_project(replaced(text, key, key + ", " + other), "text"); });
        QVERIFY2(has(both, "materials[1].sorption_heat_j_g: This is another name of heat_of_wetting_j_g"), both.c_str());
    }
    void rowsDrawTheWeaveWithTheLastPickOnTop()
    {
        const std::string text = replaced(bytes_of(examples + "textile-F.hygro"), "\"pattern\": \"plain\"", "\"rows\": [\"001\", \"110\"]");
        const Weave weave = parse_project(text, "text").fabrics[0].weave;
        QCOMPARE(weave.ends(), 3);
        QVERIFY(weave.warp_up(2, 1) && !weave.warp_up(0, 1) && weave.warp_up(0, 0) && !weave.warp_up(2, 0));
    }
    void numbersKeepTheirPointInAnyLocale()
    {
        const std::string before = std::setlocale(LC_ALL, nullptr);
        for (const char* locale : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"}) std::setlocale(LC_ALL, locale);
        const std::string text = format_project(rich());
        const bool same = parse_project(text, "text") == rich();
        std::setlocale(LC_ALL, before.c_str());
        QVERIFY(same);
        QVERIFY(has(text, "0.635"));
    }
    void badTextIsRefusedWithItsPlace_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("says");
        const std::string good = bytes_of(examples + "textile-F.hygro");
        const auto row = [](const char* name, const std::string& text, const char* says) {
            QTest::newRow(name) << QByteArray(text.data(), static_cast<qsizetype>(text.size())) << QString(says);
        };
        row("empty", "", "empty");
        row("blank", " \n\t ", "empty");
        row("truncated", good.substr(0, 200), "line 11, column 8");
        row("comma too many", replaced(good, "0.2,", "0.2,,"), "line 10, column 28");
        row("two documents", good + "{}", "not valid JSON");
        row("a picture", "\x89PNG\r\n\x1a\n", "This is a PNG picture, not JSON text.");
        row("a recording", "SQLite format 3", "an SQLite database, such as a recording, not JSON text");
        row("not utf-8", replaced(good, "Textile F", "Textile \xff"), "line 7, column");
        row("a number too large", replaced(good, "0.635", "1e400"),
            "line 27, column 23: fabrics[0].thickness_mm: The number 1e400 is beyond those that there are, up to 1.8e+308. "
            "The thickness of a fabric must be from 0.01 to 50 mm.");
        row("a coordinate too large", replaced(good, "[0.0, 0.0]", "[0.0, -1e400]"),
            "experiments[0].droplets[0].at_mm[1]: The number -1e400 is beyond those that there are, up to 1.8e+308.");
        row("a number of a part too large", replaced(good, "\"temperature_c\": 25.0", "\"temperature_c\": 1e400"),
            "experiments[0].climate.temperature_c: The number 1e400 is beyond those that there are, up to 1.8e+308. "
            "The temperature must be from -10 to 60 C.");
        row("two numbers too large", replaced(replaced(good, "0.635", "1e400"), "\"diameter_mm\": 0.2", "\"diameter_mm\": 1e400"),
            "fabrics[0].warp.diameter_mm: The number 1e400 is beyond those that there are, up to 1.8e+308. "
            "The diameter of a yarn must be from 0.01 to 10 mm.");
        row("a count too large", replaced(good, "\"fibres_per_yarn\": 30", "\"fibres_per_yarn\": 1e400"),
            "fabrics[0].warp.fibres_per_yarn: The number 1e400 is beyond");
        row("a garment's time too large", R"({"experiments": [{"type": "wear", "duration_s": 1e999}]})",
            "experiments[0].duration_s: The number 1e999 is beyond those that there are, up to 1.8e+308. "
            "The duration must be from 1 to 86400 s.");
        row("nothing but a number too large", "1e400", "the project: The number 1e400 is beyond");
        row("NaN", replaced(good, "0.635", "NaN"), "line");
        row("a list", "[1, 2]", "must be an object");
        row("unknown key", replaced(good, "\"diameter_mm\"", "\"diametr_mm\""),
            "fabrics[0].warp: The key \"diametr_mm\" is not known here; did you mean \"diameter_mm\"?");
        row("required key misspelt", replaced(good, "\"picks_per_cm\"", "\"pick_per_cm\""),
            "fabrics[0]: The key \"pick_per_cm\" is not known here; did you mean \"picks_per_cm\"?");
        row("required key in another unit", replaced(good, "\"ends_per_cm\"", "\"ends_per_inch\""),
            "The key \"ends_per_inch\" is not known here; did you mean \"ends_per_cm\"?");
        row("unknown key far from all", replaced(good, "\"thickness_mm\"", "\"q\""), "Known are: name, warp, weft");
        row("twice", replaced(good, "\"ends_per_cm\"", "\"picks_per_cm\""), "stands twice");
        row("text for number", replaced(good, "0.635", "\"0.635\""), "fabrics[0].thickness_mm: This must be a number; given is \"0.635\"");
        row("null for number", replaced(good, "0.635", "null"), "given is null");
        row("number for text", replaced(good, "\"Textile F\"", "12"), "fabrics[0].name");
        row("fraction for count", replaced(good, "\"fibres_per_yarn\": 30", "\"fibres_per_yarn\": 30.5"), "whole number");
        row("huge count", replaced(good, "\"fibres_per_yarn\": 30", "\"fibres_per_yarn\": 1e300"), "whole number");
        row("three coordinates", replaced(good, "[0.0, 0.0]", "[0, 0, 0]"), "list of 2 numbers");
        row("missing name", replaced(good, "\"name\": \"Textile F\",", ""), "fabrics[0]: The key \"name\" is missing");
        row("missing weave", replaced(replaced(good, "\"weave\": {", ""), "\"pattern\": \"plain\"\n      },", ""), "\"weave\" is missing");
        row("missing format", replaced(good, "\"format\": \"hygroloom-project\",", ""), "\"format\" is missing");
        row("missing version", replaced(good, "\"version\": 1,", ""), "\"version\" is missing");
        row("other format", replaced(good, "hygroloom-project", "something"), "must be \"hygroloom-project\"");
        row("newer version", replaced(good, "\"version\": 1", "\"version\": 2"), "newer Hygroloom (format 2)");
        row("version zero", replaced(good, "\"version\": 1", "\"version\": 0"), "Versions begin at 1");
        row("bad pattern", replaced(good, "\"plain\"", "\"satin 8/2\""), "fabrics[0].weave.pattern");
        row("no pattern", replaced(good, "\"pattern\": \"plain\"", ""), "one of \"pattern\", \"rows\" and \"draft\"");
        row("ragged rows", replaced(good, "\"pattern\": \"plain\"", "\"rows\": [\"01\", \"1\"]"), "rows[1]");
        row("rows of letters", replaced(good, "\"pattern\": \"plain\"", "\"rows\": [\"0x\", \"10\"]"), "0 and 1");
        row("no rows", replaced(good, "\"pattern\": \"plain\"", "\"rows\": []"), "from 1 to 2000");
        row("a draft", replaced(good, "\"pattern\": \"plain\"", "\"draft\": {}"), "fabrics[0].weave.draft: The key \"shafts\" is missing.");
        row("twist direction", replaced(good, "\"Z\"", "\"X\""), "\"S\" or \"Z\"");
        const std::string type = "\"type\": \"droplet\"";
        row("experiment of never", replaced(good, type, "\"type\": \"x\""), "must be one of \"droplet\", \"moisture_management\", ");
        row("experiment misspelt", replaced(good, type, "\"type\": \"dryng\""), "did you mean \"drying\"?");
        row("key of another type", replaced(good, type, type + ", \"feed_s\": 3"), "The key \"feed_s\" is not known here");
        row("closure", replaced(good, type, type + ", \"closure\": \"kissa\""), "must be \"paper\" or \"pores\"; given is \"kissa\"");
        row("swelling", replaced(good, type, type + ", \"swelling\": 1"), "must be true or false; given is 1");
        row("liquid of nothing", replaced(good, "\"materials\": []", "\"liquids\": [{}]"), "liquids[0]: The key \"name\" is missing");
        row("material on nothing", replaced(good, "\"materials\": []", "\"materials\": [{\"name\": \"m\", \"based_on\": \"coton\"}]"),
            "has no material \"coton\"");
        row("material of nothing", replaced(good, "\"materials\": []", "\"materials\": [{\"name\": \"m\"}]"),
            "\"density_kg_m3\" is missing");
        row("garments", replaced(good, "\"materials\": []", "\"garments\": [{}]"), "garments[0]: The key \"name\" is missing");
        row("deep", std::string(100000, '['), "deeper than 32");
        row("deep objects", "{\"materials\": " + std::string(5000, '['), "deeper than 32");
        row("binary", std::string("\x01\x02\0\xfe", 4), "line 1, column 1");
    }
    void badTextIsRefusedWithItsPlace()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, says);
        const std::string message = message_of([&] { parse_project({text.data(), static_cast<std::size_t>(text.size())}, "cloth.hygro"); });
        QVERIFY2(has(message, says.toStdString()), message.c_str());
        QVERIFY2(message.rfind("cloth.hygro: ", 0) == 0, message.c_str());
        QVERIFY2(QString::fromStdString(message).toUtf8() == QByteArray::fromStdString(message), "the message is not UTF-8");
        QVERIFY(message.size() < 1000);
    }
    void olderVersionsMigrateStepByStep()
    {
        // As if version 2 had renamed a key and version 3 changed a unit.
        const std::vector<Migration> steps{[](ProjectJson& project) {
                                               project["fabrics"] = project.at("cloths");
                                               project.erase("cloths");
                                           },
                                           [](ProjectJson& project) {
                                               for (auto& fabric : project["fabrics"])
                                                   fabric["ends_per_cm"] = fabric["ends_per_cm"].get<double>() / 2;
                                           }};
        ProjectJson old = json_from_design(read_project(examples + "textile-F.hygro"));
        old["cloths"] = old["fabrics"];
        old.erase("fabrics");
        QCOMPARE(design_from_json(old, "old", steps).fabrics.at(0).ends_per_cm, 17.5);
        ProjectJson newer = json_from_design(read_project(examples + "textile-F.hygro"));
        newer["version"] = 2;
        QCOMPARE(design_from_json(newer, "newer", steps).fabrics.at(0).ends_per_cm, 17.5);
        newer["version"] = 4;
        QVERIFY(has(message_of([&] { design_from_json(newer, "newest", steps); }), "newer Hygroloom"));
    }
    void everyVersionHasItsMigration() { QCOMPARE(int(project_migrations().size()), project_version - 1); }
    void oneValueIsSetByItsPath()
    {
        const Design design = rich();
        QCOMPARE(*with_value(design, "fabrics[0].contact_angle_deg", "60").fabrics[0].contact_angle_deg, 60.0);
        QCOMPARE(with_value(design, "experiments.one drop.duration_s", "5").experiments[0].duration_s, 5.0);
        QCOMPARE(with_value(design, "experiments[one drop].duration_s", "5").experiments[0].duration_s, 5.0);
        QCOMPARE(with_value(design, "experiments.one\\ drop.duration_s", "5").experiments[0].duration_s, 5.0); // quoted twice
        QCOMPARE(with_value(design, "experiments[one\\ drop].duration_s", "5").experiments[0].duration_s, 5.0);
        QCOMPARE(with_value(design, "materials.free.sorption_heat_j_g", "30").materials[1].heat_of_wetting_j_g, 30.0);
        QCOMPARE(with_value(design, "materials.free.sorption_heat_j_g", "null").materials[1].heat_of_wetting_j_g, 0.0);
        QCOMPARE(with_value(design, "fabrics.Textile F.weave.pattern", "twill 2/1 S").fabrics[0].weave.pattern(),
                 std::string("twill 2/1 S"));
        QCOMPARE(with_value(design, "fabrics.satin.weave.pattern", "plain").fabrics[1].weave, Weave());
        QCOMPARE(with_value(design, "fabrics[0].name", "60").fabrics[0].name, std::string("60"));
        QCOMPARE(with_value(design, "experiments[0].droplets[1].at_mm", "[1, -2]").experiments[0].droplets[1].at_mm[1], -2.0);
        QCOMPARE(with_value(design, "experiments[0].droplets[1].at_mm[0]", "3").experiments[0].droplets[1].at_mm[0], 3.0);
        QCOMPARE(with_value(design, "materials.free.density_kg_m3", "1400").materials[1].density_kg_m3, 1400.0);
        QVERIFY(!with_value(design, "fabrics[0].thickness_mm", "null").fabrics[0].thickness_mm);
        QCOMPARE(with_value(design, "fabrics[0].warp.material", "wool").fabrics[0].warp.material.at(0).name, std::string("wool"));
    }
    void namesMayHoldDots()
    {
        Design design = rich();
        design.fabrics[0].name = "nylon 6.6";
        design.fabrics[1].name = "nylon 6";
        QCOMPARE(with_value(design, "fabrics.nylon 6.6.ends_per_cm", "9").fabrics[0].ends_per_cm, 9.0);
        QCOMPARE(with_value(design, "fabrics.nylon 6.ends_per_cm", "9").fabrics[1].ends_per_cm, 9.0);
    }
    void wrongPathsAndValuesAreRefused()
    {
        const Design design = rich();
        const auto says = [&](const char* path, const char* value, const char* part) {
            const std::string message = message_of([&] { with_value(design, path, value); });
            return has(message, part) || (qWarning("%s", message.c_str()), false);
        };
        QVERIFY(says("", "1", "empty"));
        QVERIFY(says("fabrics[9].ends_per_cm", "1", "There is no fabrics[9]; this project has "));
        QVERIFY(says("fabrics[0.ends_per_cm", "1", "\"]\" is missing"));
        QVERIFY(says("fabrics.no.ends_per_cm", "1", "\"Textile F\""));
        QVERIFY(says("fabrics[0].ends_per_cmm", "1", "did you mean \"ends_per_cm\""));
        QVERIFY(says("fabrics[0].wrap.diameter_mm", "1", "did you mean \"warp\""));
        QVERIFY(says("fabrics[0].ends_per_cm", "many", "must be a number"));
        QVERIFY(says("fabrics[0].ends_per_cm", "nan", "must be a number"));
        QVERIFY(says("fabrics[0].ends_per_cm", "1e400", "must be a number up to 1.8e+308; given is 1e400"));
        QVERIFY(says("experiments.one\\ drap.duration_s", "1", "There are: \"one drop\""));
        QVERIFY(says("fabrics[0].ends_per_cm.x", "1", "plain value"));
        QVERIFY(says("fabrics[0].ends_per_cm", "null", "missing"));
        QVERIFY(says("fabrics[0].weave.pattern", "twil", "Forms:"));
        QVERIFY(says("fabrics[0].warp.fibres_per_yarn", "2.5", "whole number"));
        QVERIFY(says("version", "9", "newer"));
        QVERIFY(says("fabrics", "1", "list"));
        QVERIFY(says("fabrics[0].contact_angle_deg", std::string(50000, '[').c_str(), "must be a number"));
    }
};

QTEST_APPLESS_MAIN(TestProjectFile)
#include "tst_project_file.moc"
