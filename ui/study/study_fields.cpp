// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/study/study_fields.h"

#include "core/analysis/card.h"
#include "core/base/error.h"
#include "core/base/trade_units.h"
#include "core/design/field_labels.h"
#include "core/plan/fidelity.h"
#include "core/project/project_json.h"
#include "core/project/project_value.h"
#include "core/wear/wear_outcomes.h"

#include "ui/basics/core_words.h"
#include "ui/basics/language.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>

#include <algorithm>

namespace hygroloom {

namespace {

/// What a project may leave out of a fabric, and a study may set all the same.
constexpr const char* optional_fields[] = {"contact_angle_deg",   "thickness_mm",        "warp_crimp_percent",   "weft_crimp_percent",
                                           "warp.packing_factor", "weft.packing_factor", "warp.irregularity_cv", "weft.irregularity_cv"};

/// Objects and lists in which nothing is for a study.
bool isPassedOver(const std::string& key)
{
    for (const char* each : {"weave", "uncertainty", "calibrated", "warp_order", "weft_order", "color", "outline_mm"}) {
        if (key == each) { return true; }
    }
    return false;
}

/// As the trade writes it.
QString unitOf(const std::string& key) { return QString::fromUtf8(trade_units(stored_kind(key)).front().spellings.front()); }

/// The row's label; of a key that has no row its words, without the unit.
QString wordOf(const std::string& key)
{
    if (QString label = QString::fromStdString(label_of_key(key)); !label.isEmpty()) {
        label[0] = label[0].toUpper();
        return withinSentence(coreWord(label));
    }
    const Stored kind = stored_kind(key);
    std::size_t end = key.size();
    for (std::size_t at = key.rfind('_'); kind != Stored::number && end == key.size() && at != std::string::npos && at > 0;
         at = key.rfind('_', at - 1)) {
        if (stored_kind(key.substr(at)) == kind) { end = at; }
    }
    return coreWord(QString::fromStdString(key.substr(0, end)).replace('_', ' '));
}

/// "warp.twist_per_m" -> "warp, twist" and "/m"; "droplets[0].volume_ul" -> "droplets 1, volume" and "µl".
void nameField(StudyField& field, const QString& below)
{
    QStringList words;
    for (const QString& piece : below.split('.', Qt::SkipEmptyParts)) {
        static const QRegularExpression form(R"(^([^\[]*)(?:\[(\d+)\])?)");
        const auto match = form.match(piece);
        const std::string key = match.captured(1).toStdString();
        field.unit = unitOf(key);
        QString word = wordOf(key);
        if (!match.captured(2).isEmpty()) { word += QString(" %1").arg(match.captured(2).toInt() + 1); }
        words << word;
    }
    field.name = words.join(", ");
}

class FieldList {
public:
    explicit FieldList(const Design& design) : project_(json_from_design(design)) {}

    std::vector<StudyField> make()
    {
        for (const char* list : {"fabrics", "experiments", "garments", "materials", "liquids"}) {
            if (!project_.contains(list)) { continue; }
            const ProjectJson& members = project_[list];
            for (std::size_t i = 0; i < members.size(); ++i) {
                start_ = std::string(list) + "[" + std::to_string(i) + "]";
                group_ = QString::fromStdString(members[i].value("name", start_));
                add(members[i], "");
                if (std::string_view(list) == "fabrics") { addOptional(); }
            }
        }
        addKnobs();
        return std::move(fields_);
    }

private:
    void add(const ProjectJson& at, const std::string& below)
    {
        if (at.is_number()) {
            put(below, at.get<double>());
        } else if (at.is_object()) {
            for (const auto& [key, value] : at.items()) {
                if (!isPassedOver(key)) { add(value, below.empty() ? key : below + "." + key); }
            }
        } else if (at.is_array() && at.size() <= 8) { // longer ones are curves
            for (std::size_t i = 0; i < at.size(); ++i) { add(at[i], below + "[" + std::to_string(i) + "]"); }
        }
    }
    void put(const std::string& below, std::optional<double> value)
    {
        StudyField field{start_ + "." + below, group_, {}, {}, value};
        nameField(field, QString::fromStdString(below));
        fields_.push_back(std::move(field));
    }
    void addOptional()
    {
        for (const char* below : optional_fields) {
            const std::string path = start_ + "." + below;
            const auto is_it = [&path](const StudyField& field) { return field.path == path; };
            if (std::none_of(fields_.begin(), fields_.end(), is_it)) { put(below, std::nullopt); }
        }
    }
    void addKnobs()
    {
        for (const KnobInfo& knob : knob_table()) {
            if (!knob.words.empty()) { continue; }
            const QString group = QCoreApplication::translate("StudyFields", "Fidelity");
            fields_.push_back({std::string("fidelity.") + knob.name, group, coreWord(QString(knob.name).replace('_', ' ')), knob.unit, {}});
        }
    }

    ProjectJson project_;
    std::string start_;
    QString group_;
    std::vector<StudyField> fields_;
};

/// "panels/front/" -> "panel front", as outcomes name it.
std::string partOf(const std::string& prefix)
{
    const std::size_t kind = prefix.find('/');
    return kind == std::string::npos || kind < 2 ? std::string()
                                                 : prefix.substr(0, kind - 1) + " " + prefix.substr(kind + 1, prefix.size() - kind - 2);
}

/// The name of the member of a list that a path leads into.
QString groupOf(const Design& design, const QString& list, std::size_t index)
{
    const auto name = [index](const auto& members) {
        return index < members.size() ? QString::fromStdString(members[index].name) : QString();
    };
    if (list == "fabrics") { return name(design.fabrics); }
    if (list == "experiments") { // garments follow the samples
        const std::size_t samples = design.experiments.size();
        return index < samples                         ? name(design.experiments)
               : index - samples < design.wears.size() ? QString::fromStdString(design.wears[index - samples].name)
                                                       : QString();
    }
    if (list == "garments") { return name(design.garments); }
    if (list == "materials") { return name(design.materials); }
    return list == "liquids" ? name(design.liquids) : QString();
}

} // namespace

std::vector<StudyField> studyFields(const Design& design) { return FieldList(design).make(); }

StudyField fieldAt(const Design& design, const std::string& path)
{
    StudyField field{path, {}, {}, {}, {}};
    const QString whole = QString::fromStdString(path);
    static const QRegularExpression form(R"(^(\w+)\[(\d+)\]\.(.*)$)");
    const auto match = form.match(whole);
    field.group = match.hasMatch() ? groupOf(design, match.captured(1), match.captured(2).toULong()) : QString();
    if (!field.group.isEmpty()) {
        nameField(field, match.captured(3));
    } else {
        field.group = whole.section('.', 0, 0);
        nameField(field, whole.section('.', 1));
    }
    try {
        const ProjectJson value = value_at(design, path);
        if (value.is_number()) { field.value = value.get<double>(); }
    } catch (const Error&) { // as of a knob
    }
    return field;
}

UserUnit unitOfFactor(const QString& unit)
{
    const UserUnit user = userUnit(unit);
    return user.inverse ? UserUnit{unit, 1} : user;
}

StudyField inReadersUnit(StudyField field)
{
    const UserUnit user = unitOfFactor(field.unit);
    field.unit = user.unit;
    if (field.value) { field.value = user.of(*field.value); }
    return field;
}

QString fieldTitle(const StudyField& field, bool with_group)
{
    const QString name = titleWithUnit(field.name, field.unit);
    return with_group ? QString("%1: %2").arg(field.group, name) : name;
}

QString titleWithUnit(const QString& title, const QString& unit) { return unit.isEmpty() ? title : QString("%1 (%2)").arg(title, unit); }

QString metricTitle(const std::string& key)
{
    const MetricName name = metricName(key);
    return titleWithUnit(name.title, name.unit);
}

MetricName metricName(const std::string& key)
{
    for (int type = 0; type <= static_cast<int>(ExperimentType::sweat); ++type) {
        for (const OutcomeInfo& info : reported_by(static_cast<ExperimentType>(type))) {
            if (info.key != key) { continue; }
            return {coreTitle(info.title, info.part), QString::fromStdString(info.unit)};
        }
    }
    for (const OutcomeInfo& info : card_metrics()) {
        if (info.key == key) { return {coreWord(info.title), QString::fromStdString(info.unit)}; }
    }
    const std::size_t at = key.rfind('/') + 1; // behind its part, "panels/front/water_g"
    for (const WearNumber& number : wear_numbers()) {
        if (number.info.key == key.substr(at)) {
            return {coreTitle(number.info.title, partOf(key.substr(0, at))), QString::fromStdString(number.info.unit)};
        }
    }
    return {wordOf(key), unitOf(key)};
}

QString studyNumber(double number)
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(number, 'g', 4);
}

} // namespace hygroloom
