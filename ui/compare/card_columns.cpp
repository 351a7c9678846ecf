// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/compare/card_columns.h"

#include "core/analysis/card.h"
#include "core/base/error.h"
#include "ui/basics/core_words.h"
#include "ui/basics/quantity.h"
#include "ui/document/document.h"

#include <QMenu>
#include <QPushButton>
#include <QSettings>

#include <algorithm>

namespace hygroloom {
namespace {

constexpr const char* setting = "compare/card_numbers";

} // namespace

CardColumns::CardColumns(Document& document, QPushButton* button, QObject* parent)
    : QObject(parent), document_(document), menu_(new QMenu(button))
{
    const QStringList before = QSettings().value(setting).toStringList();
    chosen_ = QSet<QString>(before.begin(), before.end());
    button->setMenu(menu_);
    connect(menu_, &QMenu::aboutToShow, this, &CardColumns::fillMenu);
}

bool CardColumns::isKnown(const std::string& fabric) const
{
    const auto found = kept_.find(fabric);
    const Fabric* now = find_fabric(*document_.design(), fabric);
    return found != kept_.end() && now && found->second.fabric == *now && found->second.materials == document_.design()->materials;
}

void CardColumns::addTo(Comparison& comparison)
{
    comparison.cards.clear();
    if (chosen_.isEmpty()) { return; }
    for (const auto& [name, kept] : kept_) {
        if (!isKnown(name)) { continue; }
        LaboratoryNumbers& numbers = comparison.cards[name];
        for (const LaboratoryNumber& number : kept.numbers.found) {
            if (chosen_.contains(QString::fromStdString(number.key))) { numbers.found.push_back(number); }
        }
    }
    compute();
}

void CardColumns::compute()
{
    const auto design = document_.design();
    if (computed_ == design) { return; }
    computed_ = design;
    std::vector<std::string> wanted;
    for (const Fabric& fabric : design->fabrics) {
        if (!isKnown(fabric.name)) { wanted.push_back(fabric.name); }
    }
    job_.drop(); // of a design that is gone
    if (wanted.empty()) { return; }
    job_.run([this, design, wanted](const NewestJob::Turn& turn) {
        const Validation found = validate_and_fit(*design);
        for (std::size_t i = 0; i < design->fabrics.size() && !turn.outdated(); ++i) {
            const Fabric& fabric = design->fabrics[i];
            if (!found.fabrics[i] || std::find(wanted.begin(), wanted.end(), fabric.name) == wanted.end()) { continue; }
            Kept kept{design->materials, fabric, {}};
            try {
                kept.numbers = compared_numbers(*design, fabric, *found.fabrics[i]);
            } catch (const Error&) { // its card says why
            }
            turn.deliver([this, kept = std::move(kept)] {
                kept_[kept.fabric.name] = kept;
                Q_EMIT changed();
            });
        }
    });
}

void CardColumns::choose(const QString& key, bool on)
{
    if (on) {
        chosen_.insert(key);
    } else {
        chosen_.remove(key);
    }
    QSettings().setValue(setting, QStringList(chosen_.begin(), chosen_.end()));
    Q_EMIT changed();
}

void CardColumns::fillMenu()
{
    menu_->clear();
    for (const OutcomeInfo& info : card_metrics()) {
        const QString key = QString::fromStdString(info.key), unit = userUnit(QString::fromStdString(info.unit)).unit;
        QAction* action = menu_->addAction(coreWord(info.title) + (unit.isEmpty() ? QString() : ", " + unit));
        action->setCheckable(true);
        action->setChecked(chosen_.contains(key));
        connect(action, &QAction::toggled, this, [this, key](bool on) { choose(key, on); });
    }
}

} // namespace hygroloom
