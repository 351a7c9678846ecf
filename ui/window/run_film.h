// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The picture of a run over all its frames, as numbered PNG files or as MP4. The window shows what is being written.
#pragma once

#include "ui/basics/film.h"

#include <QProgressDialog>
#include <QTimer>

#include <functional>

namespace hygroloom {

class Playback;

/// Takes pictures as fast as they are drawn and written, until the last frame or Cancel. Deletes itself.
class RunFilm : public QObject {
    Q_OBJECT
public:
    /// picture: of the frame that the playback shows, with its time in a corner. stem: of the pictures' names.
    RunFilm(Playback& playback, std::function<QImage(const QString& clock)> picture, const QString& stem, QWidget* window);

    void savePictures(const QString& folder);
    void saveMovie(const QString& path);
    /// Ends it as Cancel does.
    void leave();

Q_SIGNALS:
    /// A sentence: what was saved, or how far it came.
    void saved(const QString& sentence);
    void failed(const QString& sentence);

private:
    void start();
    void step();
    void end();

    Playback& playback_;
    std::function<QImage(const QString& clock)> picture_;
    Film film_;
    QProgressDialog progress_;
    QTimer timer_;
    long generation_;
    int before_; ///< the frame to come back to
    int next_ = 0;
    bool asked_ = false;
};

} // namespace hygroloom
