// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What the user prefers, of the whole program: kept between sessions, and told to all that show or use it as soon as it changes.
#pragma once

#include <QObject>

namespace hygroloom {

enum class LengthUnit { millimetre, centimetre, inch };
enum class YarnUnit { tex, ne, nm, denier };
enum class SettUnit { per_centimetre, per_inch };
enum class TemperatureUnit { celsius, fahrenheit };
/// Which buttons of the mouse turn and move: as in this program, Blender, FreeCAD or CLO.
enum class Navigation { hygroloom, blender, freecad, clo };

/// Choices are stored as the numbers of their enums.
struct Preferences {
    int length = 0;  ///< LengthUnit
    int yarn = 0;    ///< YarnUnit
    int sett = 0;    ///< SettUnit
    int degrees = 0; ///< TemperatureUnit
    int water_colors = 0;
    int navigation = 0;       ///< Navigation
    int wheel_towards = 0;    ///< 0: forward comes nearer; 1: backward does
    int zoom_to_pointer = 1;  ///< 0: the middle of the picture stays
    int refine_at_rest = 1;   ///< whether pictures of cloth become finer while nothing moves
    int autosave_minutes = 0; ///< 0: after each change
    int runs_gigabytes = 20;  ///< of a project, before old runs are offered to go
    int threads = 0;          ///< of a run on the CPU; 0: all
    int backend = 0;          ///< 0: auto, 1: CPU, 2: GPU
    int start_page = 1;       ///< whether it is shown at the start
    bool operator==(const Preferences&) const = default;
};

constexpr int most_autosave_minutes = 60, most_runs_gigabytes = 10000, most_threads = 1024;

/// As saved; what is out of range counts as not saved. From any thread.
Preferences preferences();
/// Saves them and tells all.
void setPreferences(const Preferences& chosen);

class PreferenceNews : public QObject {
    Q_OBJECT
public:
    static PreferenceNews& instance();
Q_SIGNALS:
    void changed();
};

/// How much nearer a turn of the wheel comes.
double wheelZoom(int angle_delta);

} // namespace hygroloom
