// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A run that is shown, live or from its recording, at the time of one of its frames. Whatever it is of, a timeline goes through it, and a
// chart draws its curves.
#pragma once

#include "core/design/design.h"

#include <QList>
#include <QObject>
#include <QPointF>
#include <QString>

#include <optional>
#include <utility>
#include <vector>

namespace hygroloom {

/// Curves over time that are drawn together, in the reader's unit.
struct TimePlot {
    struct Line {
        QString name;          ///< in the legend; empty: it does not stand there
        QString told;          ///< what a point of it is, "Water, free"
        QList<QPointF> points; ///< s, and the value
    };
    QString title; ///< "Wetted radius, mm"
    QString unit;
    QString tip{};
    std::vector<Line> lines;  ///< at most four
    bool from_zero = true;    ///< whether the axis begins at 0
    double low = 0, high = 1; ///< of an axis that does not, while there is no point
};

class ShownRun : public QObject {
    Q_OBJECT
public:
    explicit ShownRun(QObject* parent = nullptr) : QObject(parent) {}

    virtual int frames() const = 0;
    /// s. Precondition: there is such a frame.
    virtual double timeOf(int index) const = 0;
    /// s, of the whole run, though it still goes on; 0: there is none.
    virtual double duration() const = 0;
    /// How many frames there will be when a live run has ended; frames() otherwise.
    virtual int expectedFrames() const = 0;
    /// Whether the run goes on.
    virtual bool live() const = 0;
    /// Its recording; empty: there is none.
    virtual QString path() const = 0;
    /// The design that was run; nullptr: no run is shown.
    virtual const Design* design() const = 0;
    /// Its fabric or garment, and its experiment. Precondition: a run is shown.
    virtual std::pair<std::string, std::string> names() const = 0;
    /// "poplin, one drop"
    QString title() const { return QString::fromStdString(names().first + ", " + names().second); }
    /// Reads a recording in the background; opened() or failed() follows.
    virtual void open(const QString& path) = 0;
    /// Opens nothing that is still being read.
    virtual void stopOpening() = 0;
    /// A live run is over; its recording is complete, or cut short, and can be read.
    virtual void end() = 0;
    /// Lets go of the run.
    virtual void discard() = 0;
    /// The same, and of what is kept to compare it with.
    virtual void clear() { discard(); }
    /// The recording lies at another path from now on.
    virtual void move(const QString& from, const QString& to) = 0;
    /// What had happened by the time shown, in words; none: nothing of its kind is told of such runs.
    virtual std::optional<QString> happened() const { return {}; }
    /// As many for each run.
    virtual std::vector<TimePlot> plots() const = 0;

    /// The last frame not after the time; -1 without frames.
    int frameAt(double time) const;
    /// The frame that is shown; -1: none.
    int current() const { return current_; }
    /// s, that is shown; 0 without frames.
    double time() const { return current_ >= 0 && current_ < frames() ? timeOf(current_) : 0; }
    /// At the last frame of a live run, the next ones are shown as they come.
    void show(int index);

Q_SIGNALS:
    /// Another run, or none.
    void runChanged();
    void framesChanged();
    /// What plots() gives.
    void metricsChanged();
    void frameShown();
    void opened(const QString& path);
    /// Its numbers are of all frames that there will be.
    void measured();
    void failed(const QString& sentence);

protected:
    /// The current frame is to be shown; frameShown() follows.
    virtual void bring() = 0;

    int current_ = -1;
    bool follow_ = true;
};

} // namespace hygroloom
