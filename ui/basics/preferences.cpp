// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/basics/preferences.h"

#include <QSettings>

#include <cmath>
#include <mutex>
#include <optional>

namespace hygroloom {

namespace {

struct Kept {
    const char* key;
    int Preferences::*value;
    int most;
    int least = 0;
};

constexpr Kept all_kept[] = {{"units/length", &Preferences::length, 2},
                             {"units/yarn", &Preferences::yarn, 3},
                             {"units/sett", &Preferences::sett, 1},
                             {"units/temperature", &Preferences::degrees, 1},
                             {"view/colors", &Preferences::water_colors, 2},
                             {"view/mouse", &Preferences::navigation, 3},
                             {"view/wheel", &Preferences::wheel_towards, 1},
                             {"view/zoom_to_pointer", &Preferences::zoom_to_pointer, 1},
                             {"view/refine_at_rest", &Preferences::refine_at_rest, 1},
                             {"autosave/minutes", &Preferences::autosave_minutes, most_autosave_minutes},
                             {"runs/gigabytes", &Preferences::runs_gigabytes, most_runs_gigabytes, 1},
                             {"runs/threads", &Preferences::threads, most_threads},
                             {"runs/backend", &Preferences::backend, 2},
                             {"window/start_page", &Preferences::start_page, 1}};

std::mutex mutex;
std::optional<Preferences> current;

} // namespace

Preferences preferences()
{
    const std::lock_guard lock(mutex);
    if (!current) {
        current.emplace();
        const QSettings settings;
        for (const Kept& kept : all_kept) {
            bool is_number = false;
            const int saved = settings.value(kept.key).toInt(&is_number);
            if (is_number && saved >= kept.least && saved <= kept.most) { *current.*kept.value = saved; }
        }
    }
    return *current;
}

void setPreferences(const Preferences& chosen)
{
    const Preferences before = preferences();
    QSettings settings;
    for (const Kept& kept : all_kept) {
        if (chosen.*kept.value != before.*kept.value) { settings.setValue(kept.key, chosen.*kept.value); }
    }
    {
        const std::lock_guard lock(mutex);
        current = chosen;
    }
    if (before != chosen) { Q_EMIT PreferenceNews::instance().changed(); }
}

PreferenceNews& PreferenceNews::instance()
{
    static PreferenceNews news;
    return news;
}

double wheelZoom(int angle_delta) { return std::pow(1.0015, preferences().wheel_towards == 0 ? angle_delta : -angle_delta); }

} // namespace hygroloom
