// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/device_choice.h"

#include "gpu/backends.h"
#include "ui/basics/preferences.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QStandardItemModel>

#include <algorithm>
#include <memory>
#include <utility>

namespace hygroloom {

namespace {

void choosePreferred(QComboBox& box)
{
    box.setCurrentIndex(std::max(0, box.findData(QString::fromStdString(expected_backend(preferredBackend())))));
}

/// "CPU: AMD EPYC, 2 threads"; where no device was found, "CUDA".
QString nameOf(const BackendInfo& info)
{
    const QString name = QString::fromStdString(info.name).toUpper();
    return info.device.empty() ? name : name + ": " + QString::fromStdString(info.device);
}

} // namespace

std::string preferredBackend()
{
    const char* words[] = {"auto", "cpu", "cuda"};
    const std::string wanted = words[preferences().backend];
    if (wanted != "cuda") { return wanted; }
    const std::vector<BackendInfo> all = find_backends();
    const bool usable = std::any_of(all.begin(), all.end(), [&](const BackendInfo& info) { return info.name == wanted && info.usable; });
    return usable ? wanted : words[0];
}

std::string backendOfMany() { return preferredBackend() == "cpu" ? "cpu" : "auto"; }

std::vector<DeviceLine> devicesOfThisMachine()
{
    std::vector<DeviceLine> lines;
    for (const BackendInfo& info : find_backends()) {
        const QString name = nameOf(info);
        lines.push_back({name, info.name != "cpu", info.usable ? QString() : QString::fromStdString(info.reason)});
    }
    return lines;
}

void fillDevices(QComboBox& box)
{
    for (const BackendInfo& info : find_backends()) {
        const QString name = nameOf(info);
        box.addItem(info.usable ? name : QCoreApplication::translate("hygroloom", "%1 (not usable)").arg(name),
                    QString::fromStdString(info.name));
        const int row = box.count() - 1;
        box.setItemData(row, info.usable ? name : QString::fromStdString(info.reason), Qt::ToolTipRole);
        if (auto* model = qobject_cast<QStandardItemModel*>(box.model()); model && !info.usable) { model->item(row)->setEnabled(false); }
    }
    choosePreferred(box);
    const auto before = std::make_shared<int>(preferences().backend);
    QObject::connect(&PreferenceNews::instance(), &PreferenceNews::changed, &box, [&box, before] {
        if (std::exchange(*before, preferences().backend) != *before) { choosePreferred(box); }
    });
}

} // namespace hygroloom
