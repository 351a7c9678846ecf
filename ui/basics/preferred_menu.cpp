// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/basics/preferred_menu.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QMenu>

namespace hygroloom {

void addPreferred(QMenu& menu, int Preferences::*choice, const QStringList& names)
{
    auto* group = new QActionGroup(&menu);
    for (int i = 0; i < names.size(); ++i) {
        QAction* action = group->addAction(menu.addAction(names[i]));
        action->setCheckable(true);
        QObject::connect(action, &QAction::triggered, &menu, [choice, i] {
            Preferences chosen = preferences();
            chosen.*choice = i;
            setPreferences(chosen);
        });
    }
    const auto tick = [group, choice] { group->actions().at(preferences().*choice)->setChecked(true); };
    QObject::connect(&PreferenceNews::instance(), &PreferenceNews::changed, group, tick);
    tick();
}

QStringList navigationNames()
{
    return {QCoreApplication::translate("hygroloom", "Hygroloom: left turns, middle moves"),
            QCoreApplication::translate("hygroloom", "Blender: middle turns, Shift and middle moves"),
            QCoreApplication::translate("hygroloom", "FreeCAD: middle moves, middle and left turns"),
            QCoreApplication::translate("hygroloom", "CLO: right turns, middle moves")};
}

QStringList waterColorNames()
{
    return {QCoreApplication::translate("hygroloom", "Blue"), QCoreApplication::translate("hygroloom", "Cividis"),
            QCoreApplication::translate("hygroloom", "Natural: wet yarns darken (maps stay blue)")};
}

} // namespace hygroloom
