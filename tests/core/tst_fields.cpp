// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A row of fields is all that a number needs: it is read, written, checked, in the schema and in the parts of a fabric.
#include "core/base/error.h"
#include "core/design/fabric_parts.h"
#include "core/design/fields.h"
#include "core/design/issue_list.h"
#include "core/project/field_json.h"
#include "core/project/project_schema.h"

#include <QTest>

#include <set>

namespace hygroloom {

/// Stands for a new kind of object, with one number of each kind.
struct Shuttle {
    double length_mm = 300;
    int pirns = 1;
    std::optional<double> speed_m_s;
    bool felted = false;
};

template <> std::span<const Field<Shuttle>> fields_of()
{
    static constexpr const char* linings[] = {"bare", "felted"};
    static constexpr Field<Shuttle> rows[] = {
        {"length_mm", &Shuttle::length_mm, "Length", "length of a shuttle", 100, 600},
        {"pirns", &Shuttle::pirns, "Pirns", "number of pirns", 1, 4},
        {"speed_m_s", &Shuttle::speed_m_s, "Speed", "speed of a shuttle", 0, 30, "Leave empty for that of the loom."},
        {"lining",
         FieldChoice<Shuttle>{linings, [](const Shuttle& shuttle) { return static_cast<int>(shuttle.felted); },
                              [](Shuttle& shuttle, int word) { shuttle.felted = word == 1; }},
         "Lining", ""}};
    return rows;
}

} // namespace hygroloom

using namespace hygroloom;

namespace {

Shuttle read(const char* text)
{
    const ProjectJson json = ProjectJson::parse(text);
    ObjectReader object(json, "file", "shuttle");
    Shuttle shuttle;
    read_fields(object, shuttle);
    object.finish();
    return shuttle;
}

QString refusal(const char* text)
{
    try {
        read(text);
    } catch (const FileError& error) {
        return error.what();
    }
    return {};
}

/// Key, label, title and help of each row; that ranges make sense and keys differ.
template <typename Owner> void check_rows()
{
    std::set<std::string> keys;
    for (const Field<Owner>& field : fields_of<Owner>()) {
        QVERIFY2(keys.insert(field.key).second, field.key);
        QVERIFY2(*field.label && std::isupper(static_cast<unsigned char>(*field.label)), field.key);
        QVERIFY2(!*field.help || std::string_view(field.help).ends_with('.'), field.key);
        if (!field.is_number()) continue;
        QVERIFY2(*field.title && field.least < field.most, field.key);
        Owner owner{};
        set_field(field, owner, field.most);
        QCOMPARE(field_value(field, owner), std::optional(field.most));
        IssueList list;
        QVERIFY2(list.field("here", field, owner), field.key);
        set_field(field, owner, field.most + std::max(1.0, 0.01 * field.most));
        QVERIFY2(!list.field("here", field, owner), field.key);
    }
}

} // namespace

class TestFields : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void anObjectIsReadAndWrittenByItsRows()
    {
        const Shuttle shuttle = read(R"({"length_mm": 420.5, "pirns": 2, "lining": "felted"})");
        QCOMPARE(shuttle.length_mm, 420.5);
        QCOMPARE(shuttle.pirns, 2);
        QVERIFY(!shuttle.speed_m_s && shuttle.felted);
        QCOMPARE(QString::fromStdString(json_of_fields(shuttle).dump()), QString(R"({"length_mm":420.5,"pirns":2,"lining":"felted"})"));
        QCOMPARE(refusal(R"({"lining": "felt"})"),
                 QString("file: shuttle.lining: This must be \"bare\" or \"felted\"; given is \"felt\"; did you mean \"felted\"?"));
        QVERIFY(refusal(R"({"pirns": 1.5})").startsWith("file: shuttle.pirns: "));
        QVERIFY(refusal(R"({"pirn": 1})").contains("\"pirns\""));
    }
    void whatIsAsInItsBaseIsNotWritten()
    {
        const Shuttle base;
        Shuttle shuttle;
        shuttle.pirns = 3;
        ProjectJson json = ProjectJson::object();
        write_fields(json, shuttle, &base);
        QCOMPARE(QString::fromStdString(json.dump()), QString(R"({"pirns":3})"));
    }
    void rangesAreSaidWithUnitAndValue()
    {
        Shuttle shuttle;
        shuttle.length_mm = 99;
        shuttle.speed_m_s = 31;
        IssueList list;
        QVERIFY(!list.fields("shuttle", shuttle));
        QCOMPARE(list.issues.size(), std::size_t{2});
        QCOMPARE(QString::fromStdString(list.issues[0].where.text()), QString("shuttle.length_mm"));
        QCOMPARE(QString::fromStdString(list.issues[0].text()),
                 QString("The length of a shuttle must be from 100 to 600 mm; given is 99."));
        QCOMPARE(QString::fromStdString(list.issues[1].text()), QString("The speed of a shuttle must be from 0 to 30 m/s; given is 31."));
    }
    void aPlaceSaysWhatItsNumberMayBe()
    {
        const auto allowed = [](const Place& place) {
            const auto message = allowed_at(place);
            return message ? english(*message) : "";
        };
        const Place droplet = Place("experiments") / std::size_t{1} / "droplets" / std::size_t{0};
        QCOMPARE(droplet.text(), std::string("experiments[1].droplets[0]"));
        QCOMPARE(allowed(droplet / "volume_ul"), std::string("The volume of a droplet must be from 1e-06 to 5000 ul."));
        QCOMPARE(allowed(Place("experiments") / std::size_t{1} / "volume_ul"),
                 std::string("The volume of liquid must be from 0.001 to 100000 ul."));
        QCOMPARE(allowed(Place("garments") / std::size_t{0} / "panels" / "front" / "grain_deg"),
                 std::string("The angle of the grain must be from -360 to 360 degrees."));
        QCOMPARE(allowed(droplet / "at_mm" / std::size_t{0}), std::string());
        QCOMPARE(allowed(Place()), std::string());
    }
    void nothingTakesBackAnOptionalNumberAlone()
    {
        Shuttle shuttle{400, 2, 12, true};
        for (const Field<Shuttle>& field : fields_of<Shuttle>()) set_field(field, shuttle, {});
        QVERIFY(shuttle.length_mm == 400 && shuttle.pirns == 2 && !shuttle.speed_m_s && shuttle.felted);
    }
    void eachRowHasWordsAndARange()
    {
        check_rows<Material>();
        check_rows<GabIsotherm>();
        check_rows<Yarn>();
        check_rows<YarnCore>();
        check_rows<Fabric>();
        check_rows<Flyaway>();
        check_rows<Measured>();
        check_rows<Uncertainty>();
        check_rows<Loom>();
        check_rows<Liquid>();
        check_rows<Climate>();
        check_rows<Droplet>();
        check_rows<Experiment>();
        check_rows<WearExperiment>();
        check_rows<Activity>();
        check_rows<BuiltInGarment>();
        check_rows<PanelCut>();
        check_rows<OwnZone>();
        check_rows<Wearer>();
    }
    void theSchemaHasTheRows()
    {
        const ProjectJson twist = project_schema().at("$defs").at("yarn").at("properties").at("twist_per_m");
        QCOMPARE(twist.at("type").get<std::string>(), std::string("number"));
        QCOMPARE(twist.at("maximum").get<double>(), field_named<Yarn>("twist_per_m").most);
        QCOMPARE(twist.at("title").get<std::string>(), std::string("Twist"));
        QCOMPARE(twist.at("default").get<double>(), Yarn().twist_per_m);
        QVERIFY(!QString::fromStdString(project_schema().dump()).contains("x-fields"));
    }
    void eachRowOfAYarnIsInAPart()
    {
        std::set<std::string> keys;
        for (const FabricPart& part : fabric_parts())
            for (const PartField& field : part.fields) keys.insert(field.key);
        for (const Field<Yarn>& field : fields_of<Yarn>()) QVERIFY2(keys.contains(std::string("weft.") + field.key), field.key);
        for (const Field<Fabric>& field : fields_of<Fabric>()) QVERIFY2(keys.contains(field.key), field.key);
    }
};

QTEST_APPLESS_MAIN(TestFields)
#include "tst_fields.moc"
