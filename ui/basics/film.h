// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A film of pictures: as PNG files, or as MP4 by ffmpeg where that is installed.
#pragma once

#include <QImage>
#include <QObject>
#include <QProcess>
#include <QThreadPool>

#include <atomic>
#include <memory>

namespace hygroloom {

class Film : public QObject {
    Q_OBJECT
public:
    static constexpr int pictures_per_second = 25;

    /// Why there can be no MP4, in a sentence; empty: there can.
    static QString whyNoMovie();

    /// stem: of the pictures' names.
    explicit Film(const QString& stem, QObject* parent = nullptr);
    /// Ends a film that runs and keeps it: waits until what was taken is written, a minute at most for ffmpeg.
    ~Film() override;

    /// Pictures STEM-000001.png and so on, in a folder that is there; after those that are there already. False while the film is busy.
    bool startPictures(const QString& folder);
    /// False after failed(), where there is no ffmpeg, and while the film is busy.
    bool startMovie(const QString& path);
    /// Takes pictures.
    bool runs() const { return runs_; }
    /// It runs, or what it took is still being written: no other can start.
    bool busy() const { return runs_ || ffmpeg_; }
    void add(const QImage& picture);
    /// More pictures than can wait would be left out.
    bool full() const;
    /// Ends with finished() or failed(), which also come by themselves where a picture cannot be written or ffmpeg ends.
    void finish();
    /// Ends without either. Of a film nothing stays, of pictures those that are written.
    void cancel();
    int pictures() const { return taken_; }

Q_SIGNALS:
    /// A sentence: what was saved.
    void finished(const QString& sentence);
    void failed(const QString& sentence);

private:
    void begin(bool movie, const QString& target);
    void writePicture(const QImage& picture);
    void endPictures();
    void feed(const QImage& picture);
    void startEncoder();
    void endMovie(int code, QProcess::ExitStatus status);
    void failToStart(QProcess::ProcessError error);
    bool keepMovie(int code, QProcess::ExitStatus status) const;

    bool runs_ = false, movie_ = false;
    QString stem_;
    QString target_; ///< folder or file
    QSize size_;
    int taken_ = 0, left_out_ = 0;
    int before_ = 0; ///< the highest number in the folder
    std::atomic<int> waiting_ = 0;
    std::atomic<bool> broken_ = false;
    QThreadPool writers_;
    std::unique_ptr<QProcess> ffmpeg_; ///< until it has ended
};

} // namespace hygroloom
