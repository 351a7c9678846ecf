// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A lesson as a film: its pictures as PNG files, or as MP4 by ffmpeg where that is installed.
#pragma once

#include <QImage>
#include <QObject>
#include <QProcess>
#include <QThreadPool>

#include <atomic>

namespace hygroloom {

class LessonFilm : public QObject {
    Q_OBJECT
public:
    static constexpr int pictures_per_second = 25;

    explicit LessonFilm(QObject* parent = nullptr);
    /// Waits until what was taken is written.
    ~LessonFilm() override;

    /// Pictures lesson-000001.png and so on, in a folder that is there.
    void startPictures(const QString& folder);
    /// False after failed(), where there is no ffmpeg.
    bool startMovie(const QString& path);
    bool runs() const { return runs_; }
    void add(const QImage& picture);
    /// Ends with finished() or failed().
    void finish();
    int pictures() const { return taken_; }

Q_SIGNALS:
    /// A sentence: what was saved.
    void finished(const QString& sentence);
    void failed(const QString& sentence);

private:
    void writePicture(const QImage& picture);
    void feed(const QImage& picture);
    void endMovie(int code, QProcess::ExitStatus status);

    bool runs_ = false, movie_ = false;
    QString target_; ///< folder or file
    QSize size_;
    int taken_ = 0, left_out_ = 0;
    std::atomic<int> waiting_ = 0;
    std::atomic<bool> broken_ = false;
    QThreadPool writers_;
    std::unique_ptr<QProcess> ffmpeg_;
};

} // namespace hygroloom
