// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The processors that runs may be computed on, to choose from; the preferred one first.
#pragma once

#include <QString>

#include <string>
#include <vector>

class QComboBox;

namespace hygroloom {

/// "auto", "cpu" or "cuda"; "auto" where what is preferred cannot be used on this machine. From any thread.
std::string preferredBackend();
/// That of several runs, some of which a GPU may not suit: "auto" or "cpu".
std::string backendOfMany();

struct DeviceLine {
    QString name;
    bool is_gpu = false;
    QString problem; ///< why it cannot be used, in a sentence; empty: it can
};
std::vector<DeviceLine> devicesOfThisMachine();

/// Lists the devices of this machine, with the reasons of those that cannot be used, and chooses the preferred one, again whenever the
/// preference changes.
void fillDevices(QComboBox& box);

} // namespace hygroloom
