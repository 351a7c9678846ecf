// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Films end whole: also where nobody ends them, where a second is asked for, and where the disk or ffmpeg gives up. A script stands in
// for ffmpeg.
#include "ui/basics/film.h"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace hygroloom;

class TestFilm : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        folder_ = std::make_unique<QTemporaryDir>();
        picture_ = QImage(41, 30, QImage::Format_RGB32);
        picture_.fill(Qt::darkCyan);
        path_ = qgetenv("PATH");
    }
    void cleanup() { qputenv("PATH", path_); }

    void aFilmThatNobodyEndedIsKept()
    {
        useProgram("/bin/cat > \"$last\"; sleep 0.2\n");
        {
            Film film("f");
            QVERIFY(film.startMovie(at("film.mp4")));
            for (int k = 0; k < 5; ++k) { film.add(picture_); }
        }
        QCOMPARE(QFile(at("film.mp4")).size(), qint64{5 * 40 * 30 * 4});
        QVERIFY(!QFile::exists(at("film.mp4.part")));
    }
    void whatFfmpegDidNotEndIsNotKept()
    {
        useProgram("/bin/cat > \"$last\"; exit 1\n");
        {
            Film film("f");
            QVERIFY(film.startMovie(at("film.mp4")));
            film.add(picture_);
        }
        QVERIFY(!QFile::exists(at("film.mp4")) && !QFile::exists(at("film.mp4.part")));
    }
    void noOtherFilmStartsWhileOneIsWritten()
    {
        useProgram("/bin/cat > \"$last\"; sleep 0.5\n");
        Film film("f");
        QSignalSpy finished(&film, &Film::finished);
        QVERIFY(film.startMovie(at("film.mp4")));
        film.add(picture_);
        film.finish();
        QVERIFY(!film.runs() && film.busy());
        QVERIFY(!film.startMovie(at("second.mp4")));
        QVERIFY(!film.startPictures(folder_->path()));
        QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 20000);
        QVERIFY(!film.busy());
        QVERIFY(QFile::exists(at("film.mp4")));
        QVERIFY(film.startPictures(folder_->path()));
    }
    void aSecondFilmOfPicturesFollowsTheFirst()
    {
        for (const int count : {3, 2}) {
            Film film("f");
            QVERIFY(film.startPictures(folder_->path()));
            for (int k = 0; k < count; ++k) { film.add(picture_); }
            film.finish();
        }
        const QStringList names = QDir(folder_->path()).entryList({"f-*.png"}, QDir::Files, QDir::Name);
        QCOMPARE(names, (QStringList{"f-000001.png", "f-000002.png", "f-000003.png", "f-000004.png", "f-000005.png"}));
    }
    void aFolderThatCannotBeWrittenEndsTheFilm()
    {
        Film film("f");
        QSignalSpy failed(&film, &Film::failed);
        QVERIFY(film.startPictures(at("none")));
        film.add(picture_);
        QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, 20000);
        QVERIFY2(failed[0][0].toString().contains(at("none")), qPrintable(failed[0][0].toString()));
        QVERIFY(!film.busy());
        film.finish();
        QCOMPARE(failed.count(), 1);
    }
    void anEncoderThatStopsEndsTheFilm()
    {
        useProgram("echo no space left >&2; exit 1\n");
        Film film("f");
        QSignalSpy failed(&film, &Film::failed);
        QVERIFY(film.startMovie(at("film.mp4")));
        film.add(picture_);
        QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, 20000);
        QVERIFY2(failed[0][0].toString().contains("no space left"), qPrintable(failed[0][0].toString()));
        QVERIFY(!film.busy());
    }
    void anEncoderThatCannotStartIsSaid()
    {
        useProgram({}, "#!/nowhere/sh\n");
        Film film("f");
        QSignalSpy failed(&film, &Film::failed);
        QVERIFY(film.startMovie(at("film.mp4")));
        film.add(picture_);
        QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, 20000);
        QVERIFY2(failed[0][0].toString().contains("cannot be started"), qPrintable(failed[0][0].toString()));
        QVERIFY(!film.busy());
    }
    void picturesLeftOutOfAMovieAreSaid()
    {
        useProgram("echo film > \"$last\"; sleep 1\n"); // slower than any disk: it reads nothing
        Film film("f");
        QSignalSpy finished(&film, &Film::finished);
        QVERIFY(film.startMovie(at("film.mp4")));
        QImage large(4000, 3000, QImage::Format_ARGB32);
        large.fill(Qt::black);
        for (int k = 0; k < 8; ++k) { film.add(large); } // 48 MB each; more than may wait
        QVERIFY(film.full());
        const int left_out = 8 - film.pictures();
        QVERIFY(left_out > 0);
        film.finish();
        QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 60000);
        QVERIFY2(finished[0][0].toString().contains(QString("%1 of its pictures").arg(left_out)), qPrintable(finished[0][0].toString()));
    }

private:
    QString at(const QString& name) const { return folder_->filePath(name); }

    void useProgram(const QByteArray& script, const QByteArray& first = "#!/bin/sh\nfor last; do :; done\n")
    {
        QFile program(at("ffmpeg"));
        QVERIFY(program.open(QIODevice::WriteOnly));
        program.write(first + script);
        program.close();
        QVERIFY(program.setPermissions(QFile::ReadOwner | QFile::ExeOwner | QFile::WriteOwner));
        qputenv("PATH", folder_->path().toUtf8() + ":" + path_);
    }

    std::unique_ptr<QTemporaryDir> folder_;
    QImage picture_;
    QByteArray path_;
};

QTEST_GUILESS_MAIN(TestFilm)
#include "tst_film.moc"
