// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/study/study_candidate.h"

#include "core/base/error.h"
#include "core/project/library.h"
#include "core/project/project_value.h"
#include "ui/basics/words.h"
#include "ui/document/document.h"
#include "ui/study/study_fields.h"

#include <QCoreApplication>

#include <algorithm>

namespace hygroloom {

namespace {

using Role = StudyColumnRole;

/// The fabric that a row ran: its own column says it where there are several.
std::string fabricOf(const StudyData& data, const Design& design, const Document& document, std::size_t row)
{
    if (const StudyColumn* column = data.table.find(Role::fabric)) { return column->word(row); }
    if (data.of) {
        const std::string own = fabrics_of(data.of->study, design).front();
        if (!own.empty()) { return own; }
        throw Error(QCoreApplication::translate("hygroloom",
                                                "The study leaves the garment as it is cut, so that no one fabric made this row. Tick "
                                                "fabrics in the study to take one along.")
                        .toStdString());
    }
    if (!document.fabric()) {
        throw Error(QCoreApplication::translate("hygroloom", "The project has no fabric to begin with; add one.").toStdString());
    }
    return document.fabric()->name;
}

/// "fabrics[2].…" or "fabrics.Name.…" of that fabric.
bool isOfFabric(const std::string& path, const Design& design, const std::string& fabric)
{
    const Fabric* found = find_fabric(design, fabric);
    return found && (path.starts_with("fabrics[" + std::to_string(found - design.fabrics.data()) + "].") ||
                     path.starts_with("fabrics." + fabric + ".") || path.starts_with("fabrics[" + fabric + "]."));
}

} // namespace

QString makeCandidate(Document& document, const StudyData& data, std::size_t row)
{
    const Design& base = data.of ? data.of->design : *document.design();
    const std::string name = fabricOf(data, base, document, row);
    std::vector<std::pair<std::string, std::string>> values;
    QStringList others;
    for (const StudyColumn* factor : data.table.all(Role::factor)) {
        if (isOfFabric(factor->name, base, name)) {
            values.emplace_back(factor->name, factor->text(row));
        } else {
            const QString title = fieldTitle(fieldAt(base, factor->name), true);
            others << tr("%1 = %2").arg(title, QString::fromStdString(factor->text(row)));
        }
    }
    const Design changed = with_values(base, values);
    const Fabric* found = find_fabric(changed, name);
    if (!found) { throw Error(tr("The study has no fabric “%1”.").arg(QString::fromStdString(name)).toStdString()); }
    Fabric fabric = *found;
    const StudyColumn* point = data.table.find(Role::point);
    const int number = point ? static_cast<int>(point->numbers[row]) : static_cast<int>(row);
    fabric.name = tr("%1, study %2").arg(QString::fromStdString(name)).arg(number).toStdString();
    std::string added;
    document.editState(tr("add %1").arg(QString::fromStdString(fabric.name)), [&](Design& design, DesignState& state) {
        state.fabric = static_cast<int>(add_preset(design, preset_of(changed, fabric, "", "")));
        added = design.fabrics[static_cast<std::size_t>(state.fabric)].name;
    });
    QString said = tr("Added the fabric “%1”.").arg(QString::fromStdString(added));
    if (!others.isEmpty()) { said += " " + tr("These factors are no part of it: %1.").arg(others.join(", ")); }
    return said;
}

} // namespace hygroloom
