// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/basics/film.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QSaveFile>
#include <QStandardPaths>

#include <algorithm>
#include <filesystem>

namespace hygroloom {

namespace {

constexpr int most_waiting = 50;                       // pictures
constexpr qint64 most_waiting_bytes = qint64{1} << 28; // for ffmpeg
constexpr int longest_end_ms = 60000;

/// What is not whole yet.
QString partOf(const QString& movie) { return movie + ".part"; }

} // namespace

QString Film::whyNoMovie()
{
    return QStandardPaths::findExecutable("ffmpeg").isEmpty()
               ? tr("MP4 needs the program ffmpeg, which is not installed. Save pictures instead, or install it: apt install ffmpeg.")
               : QString();
}

Film::Film(const QString& stem, QObject* parent) : QObject(parent), stem_(stem) { writers_.setMaxThreadCount(1); }

Film::~Film()
{
    writers_.waitForDone();
    if (!ffmpeg_) { return; }
    ffmpeg_->disconnect(this);
    if (ffmpeg_->state() != QProcess::NotRunning) {
        ffmpeg_->closeWriteChannel();
        if (!ffmpeg_->waitForFinished(longest_end_ms)) {
            ffmpeg_->kill();
            ffmpeg_->waitForFinished(5000);
        }
        keepMovie(ffmpeg_->exitCode(), ffmpeg_->exitStatus());
    }
    QFile::remove(partOf(target_)); // what ffmpeg did not write to its end
}

void Film::begin(bool movie, const QString& target)
{
    runs_ = true;
    movie_ = movie;
    target_ = target;
    taken_ = left_out_ = before_ = 0;
    broken_ = false;
    size_ = {};
}

bool Film::startPictures(const QString& folder)
{
    if (busy()) { return false; }
    begin(false, folder);
    const QRegularExpression named(QString("^%1-(\\d{6,9})\\.png$").arg(QRegularExpression::escape(stem_)));
    for (const QString& name : QDir(folder).entryList(QDir::Files | QDir::Hidden)) {
        if (const auto match = named.match(name); match.hasMatch()) { before_ = std::max(before_, match.captured(1).toInt()); }
    }
    return true;
}

bool Film::startMovie(const QString& path)
{
    if (busy()) { return false; }
    if (const QString why = whyNoMovie(); !why.isEmpty()) {
        Q_EMIT failed(why);
        return false;
    }
    begin(true, path);
    ffmpeg_ = std::make_unique<QProcess>();
    ffmpeg_->setProgram(QStandardPaths::findExecutable("ffmpeg"));
    connect(ffmpeg_.get(), &QProcess::finished, this, &Film::endMovie);
    connect(ffmpeg_.get(), &QProcess::errorOccurred, this, &Film::failToStart);
    return true;
}

void Film::add(const QImage& picture)
{
    if (!runs_ || picture.isNull()) { return; }
    if (movie_) {
        feed(picture);
    } else {
        writePicture(picture);
    }
}

bool Film::full() const { return movie_ ? ffmpeg_ && ffmpeg_->bytesToWrite() > most_waiting_bytes : waiting_ >= most_waiting; }

void Film::writePicture(const QImage& picture)
{
    if (waiting_ >= most_waiting) {
        ++left_out_;
        return;
    }
    ++waiting_;
    const QString path = QDir(target_).filePath(QString("%1-%2.png").arg(stem_).arg(before_ + ++taken_, 6, 10, QChar('0')));
    writers_.start([this, picture, path] {
        QSaveFile file(path);
        if (!(file.open(QIODevice::WriteOnly) && picture.save(&file, "PNG", 80) && file.commit()) && !broken_.exchange(true)) {
            QMetaObject::invokeMethod(this, &Film::endPictures, Qt::QueuedConnection); // the disk is not there for more
        }
        --waiting_;
    });
}

/// Where one cannot be written, at once.
void Film::endPictures()
{
    if (!runs_ || movie_ || !broken_) { return; }
    finish();
}

void Film::startEncoder()
{
    const QString size = QString("%1x%2").arg(size_.width()).arg(size_.height());
    ffmpeg_->setArguments({"-hide_banner",
                           "-loglevel",
                           "error",
                           "-y",
                           "-f",
                           "rawvideo",
                           "-pixel_format",
                           "bgra",
                           "-video_size",
                           size,
                           "-framerate",
                           QString::number(pictures_per_second),
                           "-i",
                           "-",
                           "-pix_fmt",
                           "yuv420p",
                           "-movflags",
                           "+faststart",
                           "-f",
                           "mp4",
                           partOf(target_)});
    QFile::remove(partOf(target_)); // of a program that was killed
    ffmpeg_->start();
}

void Film::feed(const QImage& picture)
{
    if (size_.isEmpty()) {
        size_ = QSize(picture.width() / 2 * 2, picture.height() / 2 * 2); // players want even sides
        startEncoder();
        if (!ffmpeg_) { return; } // it did not start
    }
    if (ffmpeg_->state() == QProcess::NotRunning || ffmpeg_->bytesToWrite() > most_waiting_bytes) {
        ++left_out_;
        return;
    }
    QImage even = picture.convertToFormat(QImage::Format_ARGB32);
    if (even.size() != size_) {
        const bool cut = even.width() - size_.width() <= 1 && even.height() - size_.height() <= 1 && even.width() >= size_.width();
        even = cut ? even.copy(QRect(QPoint(), size_)) : even.scaled(size_, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    }
    for (int row = 0; row < even.height(); ++row) {
        ffmpeg_->write(reinterpret_cast<const char*>(even.constScanLine(row)), qint64{4} * even.width());
    }
    ++taken_;
}

void Film::finish()
{
    if (!runs_) { return; }
    runs_ = false;
    if (movie_) {
        if (size_.isEmpty()) {
            ffmpeg_.reset();
            Q_EMIT failed(tr("No picture was taken, so there is no film."));
        } else {
            ffmpeg_->closeWriteChannel();
        }
        return;
    }
    writers_.waitForDone();
    if (broken_) {
        Q_EMIT failed(tr("Some pictures cannot be written to %1. Is the disk full?").arg(target_));
    } else {
        Q_EMIT finished(
            left_out_ == 0
                ? tr("Saved %1 pictures to %2.").arg(taken_).arg(target_)
                : tr("Saved %1 pictures to %2; %3 were left out because the disk was too slow.").arg(taken_).arg(target_).arg(left_out_));
    }
}

void Film::cancel()
{
    runs_ = false;
    writers_.waitForDone();
    if (!ffmpeg_) { return; }
    ffmpeg_->disconnect(this);
    ffmpeg_->kill();
    ffmpeg_->waitForFinished(5000);
    ffmpeg_.reset();
    QFile::remove(partOf(target_));
}

/// False where there is nothing whole to keep.
bool Film::keepMovie(int code, QProcess::ExitStatus status) const
{
    const QString part = partOf(target_);
    if (status != QProcess::NormalExit || code != 0 || !QFile::exists(part)) { return false; }
    std::error_code problem;
    std::filesystem::rename(QFile::encodeName(part).toStdString(), QFile::encodeName(target_).toStdString(), problem);
    return !problem;
}

void Film::endMovie(int code, QProcess::ExitStatus status)
{
    runs_ = false;
    const QString said = QString::fromLocal8Bit(ffmpeg_->readAllStandardError()).trimmed().left(300);
    ffmpeg_.release()->deleteLater();
    if (keepMovie(code, status)) {
        Q_EMIT finished(
            left_out_ == 0
                ? tr("Saved %1.").arg(target_)
                : tr("Saved %1; %2 of its pictures were left out because ffmpeg was too slow.").arg(target_, QString::number(left_out_)));
        return;
    }
    QFile::remove(partOf(target_));
    Q_EMIT failed(said.isEmpty() ? tr("The film cannot be written to %1. Is the disk full?").arg(target_)
                                 : tr("The film cannot be written to %1. ffmpeg said: %2").arg(target_, said));
}

/// After other errors it ends.
void Film::failToStart(QProcess::ProcessError error)
{
    if (error != QProcess::FailedToStart) { return; }
    runs_ = false;
    const QString why = ffmpeg_->errorString(), program = ffmpeg_->program();
    ffmpeg_.release()->deleteLater();
    Q_EMIT failed(tr("There is no film because %1 cannot be started: %2").arg(program, why));
}

} // namespace hygroloom
