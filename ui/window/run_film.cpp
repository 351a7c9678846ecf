// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/window/run_film.h"

#include "ui/basics/quantity.h"
#include "ui/results/playback.h"

#include <utility>

namespace hygroloom {

namespace {

constexpr int look_again_ms = 10;

} // namespace

RunFilm::RunFilm(Playback& playback, std::function<QImage(const QString& clock)> picture, const QString& stem, QWidget* window)
    : QObject(window), playback_(playback), picture_(std::move(picture)), film_(stem),
      progress_(tr("Saving pictures of the run"), tr("&Cancel"), 0, playback.frames(), window), generation_(playback.generation()),
      before_(playback.current())
{
    progress_.setWindowTitle(tr("Saving pictures"));
    progress_.setWindowModality(Qt::WindowModal);
    progress_.setAutoReset(false);
    progress_.setAutoClose(false);
    progress_.setMinimumDuration(0);
    timer_.setInterval(look_again_ms);
    connect(&timer_, &QTimer::timeout, this, &RunFilm::step);
    connect(&progress_, &QProgressDialog::canceled, this, &RunFilm::leave);
    connect(&film_, &Film::finished, this, [this](const QString& sentence) {
        Q_EMIT saved(sentence);
        end();
    });
    connect(&film_, &Film::failed, this, [this](const QString& sentence) {
        Q_EMIT failed(sentence);
        end();
    });
}

void RunFilm::savePictures(const QString& folder)
{
    film_.startPictures(folder);
    start();
}

void RunFilm::saveMovie(const QString& path)
{
    if (film_.startMovie(path)) { start(); }
}

void RunFilm::leave()
{
    film_.cancel();
    Q_EMIT saved(tr("Cancelled after %1 of %2 pictures.").arg(film_.pictures()).arg(playback_.frames()));
    end();
}

void RunFilm::start()
{
    progress_.setValue(0);
    timer_.start();
}

/// A frame that is not in memory is read in the background first.
void RunFilm::step()
{
    if (!film_.runs() || film_.full()) { return; }
    if (playback_.generation() != generation_) { // another run was opened
        film_.cancel();
        Q_EMIT saved(tr("Cancelled after %1 pictures.").arg(film_.pictures()));
        end();
        return;
    }
    if (next_ >= playback_.frames()) {
        timer_.stop();
        film_.finish();
        return;
    }
    if (!std::exchange(asked_, true)) { playback_.show(next_); }
    if (playback_.current() != next_) {
        asked_ = false; // frames that cannot be read were left out meanwhile
        return;
    }
    if (!playback_.frame() || playback_.frame()->time != playback_.timeOf(next_)) { return; }
    film_.add(picture_(momentText(playback_.frame()->time, playback_.duration())));
    ++next_;
    asked_ = false;
    progress_.setMaximum(playback_.frames());
    progress_.setValue(next_);
}

void RunFilm::end()
{
    timer_.stop();
    progress_.disconnect(this);
    progress_.close();
    if (playback_.generation() == generation_ && before_ >= 0 && before_ < playback_.frames()) { playback_.show(before_); }
    deleteLater();
}

} // namespace hygroloom
