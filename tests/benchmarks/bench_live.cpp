// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// From an edit to its new wet map, as the live panel asks for it: 20 edits of the contact angle for each experiment of a project, after
// enough of them that simulated time and sample have settled. Nothing is drawn. The median is the aim's figure.
#include "core/project/project_file.h"
#include "ui/results/live_answer.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEventLoop>

#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

using namespace hygroloom;

namespace {

/// ms
double time_of_edit(LiveAnswer& live, const Design& design, int experiment, double& simulated, std::array<double, 2>& sample)
{
    QEventLoop waits;
    const auto stop = [&] { waits.quit(); };
    const auto answered = QObject::connect(&live, &LiveAnswer::answered, [&](const std::shared_ptr<const Answer>& answer) {
        simulated = answer->run->design.experiments[0].duration_s;
        sample = answer->run->design.experiments[0].sample_mm;
        waits.quit();
    });
    const auto refused = QObject::connect(&live, &LiveAnswer::refused, stop);
    QElapsedTimer clock;
    clock.start();
    live.ask(std::make_shared<const Design>(design), 0, experiment);
    waits.exec();
    QObject::disconnect(answered);
    QObject::disconnect(refused);
    return static_cast<double>(clock.nsecsElapsed()) * 1e-6;
}

} // namespace

int main(int argc, char** argv)
{
    constexpr int settling = 8, edits = 20;
    const QCoreApplication application(argc, argv);
    const Design read = read_project(argc > 1 ? argv[1] : HYGROLOOM_SOURCE_DIR "/resources/examples/laboratory.hygro");
    for (std::size_t k = 0; k < read.experiments.size(); ++k) {
        LiveAnswer live;
        std::vector<double> times;
        double simulated = 0;
        std::array<double, 2> sample{};
        for (int edit = 0; edit < settling + edits; ++edit) {
            Design design = read;
            design.fabrics[0].contact_angle_deg = 30.0 + edit;
            const double time = time_of_edit(live, design, static_cast<int>(k), simulated, sample);
            if (edit >= settling) times.push_back(time);
        }
        std::sort(times.begin(), times.end());
        std::printf("%-40s median %6.1f ms, longest %6.1f ms, of %g s on %g x %g mm\n", read.experiments[k].name.c_str(),
                    times[times.size() / 2], times.back(), simulated, sample[0], sample[1]);
    }
}
